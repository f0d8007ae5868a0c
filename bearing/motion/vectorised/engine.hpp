// Interface of the vectorised bearing for one instruction set. No header of a library here, since files
// compiled for special instruction sets include it.
#pragma once

#include "bearing/motion/vectorised/constants.hpp"

namespace orbearing::bearing::vectorised {

/// Order of the state of a bearing: as in motion/layout.hpp, groups of entries of the rollers first. Each group
/// and the whole are as long as a multiple of kMultiple; entries beyond the rollers are at rest.
template <class Int, int kMultiple>
struct Layout {
  /// So many fit in without more entries.
  static constexpr int kMostFollowed = 2;

  Int rollers = 0;
  Int followed = 0;      // rollers whose turning is followed, since it carries scratches round
  bool tilting = false;  // rollers tilt: contacts cut into laminae that are not level
  Int waves = 0;         // of an elastic outer race, in the order of equilibrium/elastic_waves.hpp
  bool caged = true;     // else a full complement: rollers touch one another

  /// Variables of each roller.
  Int groups() const { return tilting ? 6 : 5; }
  Int lanes() const { return (rollers + kMultiple - 1) / kMultiple * kMultiple; }
  Int cage() const { return groups() * lanes(); }
  Int bore() const { return cage() + (caged ? 6 : 0); }
  Int pin() const { return bore() + 4; }
  Int wave() const { return pin() + 4; }
  Int wave_speed() const { return wave() + waves; }
  Int turned() const { return wave_speed() + waves; }
  Int end() const { return turned() + followed; }
  Int size() const { return (end() + kMultiple - 1) / kMultiple * kMultiple; }
};

using PaddedLayout = Layout<int, kPadding>;

[[gnu::always_inline]] inline PaddedLayout layout_of(const Constants& constants) {
  const LaminaConstants& laminae = constants.laminae;
  return {constants.rollers, constants.followed, laminae.count > 0 && !laminae.upright, constants.rim.count,
          constants.caged};
}

/// Loads of all contacts at the last evaluation [N], lanes() entries each; of contacts cut into laminae also
/// their approaches.
struct ContactLoads {
  const double* inner;
  const double* outer;
  const double* inner_approach = nullptr;  // [m]  elastic, in the middle of the roller; null: not cut
  const double* outer_approach = nullptr;  // [m]
  const double* end_displacement =
      nullptr;  // [m]  displacement of the roller at x = l/2 further outward than in the middle
};

/// Constants of each roller, lanes() entries each.
struct RollerConstants {
  const double* pocket_cosine;  // [-]  of the pocket's angle from the first
  const double* pocket_sine;    // [-]
  const double* radius;         // [m]
};

/// Rotation of a race.
struct RaceTurn {
  double speed = 0.0;   // [rad/s]
  double turned = 0.0;  // [rad]  since the start
};

/// Prescribed motions and loads at one instant.
struct Surroundings {
  CarrierFrame frame;
  RaceTurn pin;
  RaceTurn bore;
  double meshes = 1.0;              // [-]  Constants::meshes
  PlaneAcceleration gravity{0, 0};  // [m/s^2]
};

[[gnu::always_inline]] inline void put_surroundings(const Surroundings& now, Constants& constants) {
  constants.frame = now.frame;
  constants.inner.speed = now.pin.speed;
  constants.inner.turned = now.pin.turned;
  constants.outer.speed = now.bore.speed;
  constants.outer.turned = now.bore.turned;
  constants.meshes = now.meshes;
  constants.gravity = now.gravity;
}

/// Forces of rollers and land on the bore.
struct BoreForces {
  double x = 0.0, y = 0.0;  // [N]
  double moment = 0.0;      // [N m]  about its axis
};

/// Slopes of the force on the bore by its own position [N/m] and velocity [N s/m], all else held; rows x and
/// y.
struct BoreSlopes {
  double by_position[2][2]{};
  double by_velocity[2][2]{};
};

/// Matrix of the bearing for a stage of the bore once all else is eliminated: force and moment on the bore in
/// g J k are reduced - matrix rate, with `rate` that of the bore's velocity [m/s^2] and of its rotation
/// [rad/s^2], and `reduced` from Engine::reduce. Row and column of the rotation are zero where it is left
/// out.
struct PortMatrix {
  double a[3][3]{};  // [kg], [kg m], [kg m^2]
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

  /// From here on; to be called before the first evaluation.
  virtual void set_surroundings(const Surroundings& surroundings) = 0;
  /// At the last evaluation.
  virtual BoreForces bore_forces() const = 0;
  /// At the last linearisation.
  virtual BoreSlopes bore_slopes() const = 0;
  /// As factor(), for all but the bore's velocity and, with a cage and if it is `rotating` at a speed that
  /// changes in a step, its rotation, whose rates remain to be found or are given. That takes a quarter
  /// longer.
  virtual bool factor_open(double g, bool rotating, PortMatrix& port) = 0;
  /// First part of a solution after factor_open(): begins `k` and gives the reduced force [N] and moment
  /// [N m] on the bore.
  virtual void reduce(const double* rhs, double* k, double (&force)[3]) = 0;
  /// The rest, once the rates of the bore's velocity [m/s^2] and rotation [rad/s^2] are known: `rhs` and `k`
  /// as in reduce().
  virtual void complete(const double* rhs, const double (&rate)[3], double* k) const = 0;
};

// Makers of engines for each instruction set; each is in its own file with its own compiler options.

Engine* baseline_engine(const Constants& constants, const RollerConstants& rollers);
Engine* avx2_engine(const Constants& constants, const RollerConstants& rollers);
Engine* avx512_engine(const Constants& constants, const RollerConstants& rollers);

}  // namespace orbearing::bearing::vectorised
