// Interface of the ball bearing's equations for one instruction set. No header of a library here, since files
// compiled for special instruction sets include it.
#pragma once

#include "bearing/motion/balls/numbers.hpp"

namespace orbearing::bearing::balls {

/// Unknown velocities of a body: its centre's and those of two components of its axis; the cage's spin besides.
inline constexpr int kRingUnknowns = 5;
inline constexpr int kCageUnknowns = 6;

/// Order of the padded state: [ r | theta | z | r' | theta' | z' | spin r | spin theta | spin z ] of lanes()
/// entries each, then cage x y z a_x a_y psi and their rates (its spin instead of psi'), inner ring x y z a_x
/// a_y and rates, outer ring likewise, and of each scratch of a ball the direction of its middle x y z.
/// Entries beyond the balls are at rest.
struct StateLayout {
  static constexpr int kGroups = 9;

  int balls = 0;
  int spots = 0;

  int lanes() const { return (balls + kPadding - 1) / kPadding * kPadding; }
  int cage() const { return kGroups * lanes(); }
  int inner() const { return cage() + 2 * kCageUnknowns; }
  int outer() const { return inner() + 2 * kRingUnknowns; }
  int spot(int i) const { return outer() + 2 * kRingUnknowns + 3 * i; }
  int end() const { return spot(spots); }
  /// Length of the arrays: a multiple of kPadding.
  int size() const { return (end() + kPadding - 1) / kPadding * kPadding; }
};

/// External load on a ring, by its unknowns: force x y z [N], then moments about y and -x [N m].
struct RingLoad {
  double by[kRingUnknowns]{};
};

/// Prescribed motions and loads at one instant.
struct Surroundings {
  double inner_spin = 0.0;  // [rad/s]
  double outer_spin = 0.0;  // [rad/s]
  double inner_turn = 0.0;  // [rad]  turned since the start: where its defects are
  double outer_turn = 0.0;  // [rad]
  RingLoad on_inner;
  RingLoad on_outer;
};

/// Loads of all contacts at the last evaluation [N], lanes() entries each.
struct ContactLoads {
  const double* inner;
  const double* outer;
  const double* pocket;
};

/// Equations and linear algebra. Not for use by two threads at once; nothing is allocated after construction.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Rate `dx` of the padded state `x`.
  virtual void derivative(const double* x, const Surroundings& now, double* dx) = 0;
  /// As derivative(), and keeps the slopes at `x`.
  virtual void linearise(const double* x, const Surroundings& now, double* dx) = 0;
  /// Prepares solve() for 1 - g J, `g` in seconds, at the last linearisation. J holds what is stiff: contacts,
  /// friction, lands; not the slow terms of turning axes. False where it is singular.
  virtual bool factor(double g) = 0;
  /// `k` = (1 - g J)^-1 `rhs`, both padded and apart.
  virtual void solve(const double* rhs, double* k) const = 0;
  virtual ContactLoads loads() const = 0;
};

Engine* baseline_engine(const BallNumbers& numbers);
Engine* avx2_engine(const BallNumbers& numbers);
Engine* avx512_engine(const BallNumbers& numbers);
/// The same in packs of eight, for numbers of balls that leave more lanes of packs of sixteen empty.
Engine* short_avx512_engine(const BallNumbers& numbers);

}  // namespace orbearing::bearing::balls
