// What a version of the vectorised bearing for one instruction set offers. No header of a library here, since
// files compiled for special instruction sets include it.
#pragma once

#include "bearing/fast/constants.hpp"

namespace orbearing::bearing::fast {

/// Order of the padded state: [ r | theta | r' | theta' | spin ] of lanes() entries each, then cage x y psi
/// x' y' psi', bore x y x' y', pin x y x' y' as in dynamics/layout.hpp. Entries beyond the rollers are at
/// rest.
struct PaddedLayout {
  int rollers = 0;

  int lanes() const { return (rollers + kPadding - 1) / kPadding * kPadding; }
  int cage() const { return 5 * lanes(); }
  int bore() const { return cage() + 6; }
  int pin() const { return bore() + 4; }
  int end() const { return pin() + 4; }
  /// Length of the arrays: a multiple of kPadding.
  int size() const { return (end() + kPadding - 1) / kPadding * kPadding; }
};

/// Loads of all contacts at the last evaluation [N], lanes() entries each.
struct ContactLoads {
  const double* inner;
  const double* outer;
};

/// What each roller brings along, lanes() entries each.
struct RollerConstants {
  const double* pocket_cosine;  // [-]  of the pocket's angle from the first
  const double* pocket_sine;    // [-]
  const double* radius;         // [m]
};

/// Equations and linear algebra. Not for use by two threads at once; nothing is allocated after construction.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Rate `dx` of the padded state `x` under the load (`load_x`, `load_y`) [N] on the bore.
  virtual void derivative(const double* x, double load_x, double load_y, double* dx) = 0;
  /// As derivative(), and keeps the Jacobian J at `x`.
  virtual void linearise(const double* x, double load_x, double load_y, double* dx) = 0;
  /// Prepares solve() for 1 - g J, `g` in seconds, at the last linearisation. False where it is singular.
  virtual bool factor(double g) = 0;
  /// `k` = (1 - g J)^-1 `rhs`, both padded and apart.
  virtual void solve(const double* rhs, double* k) const = 0;
  virtual ContactLoads loads() const = 0;
};

}  // namespace orbearing::bearing::fast
