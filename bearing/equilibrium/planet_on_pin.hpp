// A planet on its pin: bearings side by side share its load and moment, the planet finds its own tilt, the
// pin bends.
//
//             z ^    ___________            u + t z         of the bore at z
//       wall ---|---|  bearing  |---        p(z), p'(z)     of the pin, a beam with shear
//               |    -----------   planet   a bearing at z_k has
//               |    ___________              u + t z_k - p_k and the tilt t - p'_k
//       wall ---|---|  bearing  |---
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/quasi_static.hpp"

namespace orbearing::bearing::laminae {

/// Planet, pin and the bearings between them. All bearings on laminae, each with its own clearance.
struct PlanetOnPin {
  std::vector<LaminaBearing> bearings;
  std::vector<double> position;    // [m]  (bearings)  of their middles, from that of the face
  Eigen::MatrixXd pin_compliance;  // [m/N], ...  pin_compliance() at these positions
  /// The same along y, with what the carrier adds there; empty: as along x.
  Eigen::MatrixXd tangential_compliance{};
  std::vector<Eigen::Vector2d>
      pin_error{};  // [m]    (bearings)  of an unloaded pin from its position; empty: none
  std::vector<Eigen::Vector2d> pin_inclination{};  // [rad]  (bearings)  of an unloaded pin; empty: none
  Eigen::Matrix2d tilt_stiffness = Eigen::Matrix2d::Zero();  // [N m/rad]  by which the meshes hold the planet
};

/// Balance at one cage angle, the same of all bearings.
struct PlanetOnPinState {
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  // [m]    of the planet in the middle of its face
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();          // [rad]  its axis runs along (x, y, 1)
  std::vector<Eigen::Vector2d> bearing_tilt;               // [rad]  (bearings)  of bore against pin
  std::vector<QuasiStaticState>
      bearings;           // displacement of the bore against the pin there; moment on the bore
  Eigen::VectorXd waves;  // [m]  of an elastic planet, common to all bearings; elastic_waves.hpp
  /// [m/N], [m/(N m)], [rad/N], [rad/(N m)]  of shift_on_seats() and tilt by load and moment on the planet
  Eigen::Matrix4d compliance = Eigen::Matrix4d::Zero();
  SolverReport report;
};

/// Balance with the first rollers at `first_roller` [rad]. `point`: its load is that of the whole planet [N],
/// in the middle of the face; its tilt has no meaning; its outer race bends as one over the whole width, the
/// same at all bearings, with the compliance that one of them has where all press alike. `moment` [N m]: what
/// tilts the planet besides, along its tilt. `near`: where the search starts.
PlanetOnPinState planet_on_pin(const PlanetOnPin& planet, const OperatingPoint& point,
                               const Eigen::Vector2d& moment, const QuasiStaticOptions& options,
                               double first_roller, const PlanetOnPinState* near = nullptr);

/// By how much the middle of the planet's face is displaced against the mean of its seats on the bent pin
/// [m]: what the support of the pin does not have already.
Eigen::Vector2d shift_on_seats(const PlanetOnPin& planet, const PlanetOnPinState& state);

/// Balances over one roller pitch: one result for each bearing, and means of the planet over the cage angles.
struct PlanetOnPinResult {
  std::vector<QuasiStaticResult> bearings;
  std::vector<Eigen::Vector2d> bearing_tilt;             // [rad]  mean over the cage angles
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();        // [rad]
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();       // [m]  shift_on_seats()
  Eigen::Matrix4d compliance = Eigen::Matrix4d::Zero();  // as of a state
  SolverReport report;
  std::vector<PlanetOnPinState> states;  // (cage angles)
};

/// `near`: the same planet under another load, where one is known. Throws std::invalid_argument as
/// quasi_static_bearing() does.
PlanetOnPinResult planet_on_pin_over_a_pitch(const PlanetOnPin& planet, const OperatingPoint& point,
                                             const Eigen::Vector2d& moment, const QuasiStaticOptions& options,
                                             const PlanetOnPinResult* near = nullptr);

}  // namespace orbearing::bearing::laminae
