// Ball bearing under a static load, without inertia: ring with five freedoms, [ISO16281].
#pragma once

#include <Eigen/Core>
#include <optional>

#include "bearing/parameters.hpp"
#include "bearing/point_contact.hpp"
#include "bearing/rating/ball_capacity.hpp"
#include "bearing/static_load/convex_balance.hpp"

namespace orbearing::bearing::static_load {

/// One row of balls between two grooved races.
struct BallBearing {
  int balls = 0;                   // [-]
  double ball_diameter = 0.0;      // [m]
  double pitch_diameter = 0.0;     // [m]
  double inner_osculation = 0.52;  // [-]    groove radius over ball diameter
  double outer_osculation = 0.53;  // [-]
  double contact_angle = 0.0;      // [rad]  nominal: without load where the clearance is zero
  double radial_clearance = 0.0;   // [m]    diametral; beyond what the nominal contact angle takes
  Material material;
};

/// The rating's view of the bearing.
rating::BallSet ball_set(const BallBearing& bearing);

/// What follows from the parameters.
struct BallBearingGeometry {
  double groove_distance = 0.0;  // [m]  A: distance of the groove centres, just touching
  double radial_distance = 0.0;  // [m]  of the groove centres in the concentric position: A cos(alpha) - s/2
  double axial_distance = 0.0;   // [m]  likewise: A sin(alpha)
  double lever = 0.0;            // [m]  of the tilt: half the pitch diameter
  double constant = 0.0;         // [N/m^1.5]  of both contacts of a ball in series
  PointContact inner;
  PointContact outer;
};

/// Throws std::invalid_argument where grooves are no wider than balls or the clearance leaves no contact.
BallBearingGeometry geometry_of(const BallBearing& bearing);

/// Load on the inner ring. The radial load points to the first ball; a positive tilt moves the ring forward
/// along the axis there.
struct BallBearingLoad {
  double radial = 0.0;         // [N]
  double axial = 0.0;          // [N]
  double moment = 0.0;         // [N m]  in the plane of the radial load
  std::optional<double> tilt;  // [rad]  given in place of the moment; none: free
};

/// Displacement of the inner ring from the concentric position, and ball loads. Where a nominal angle of zero
/// leaves no side preferred, that position is axially centred.
struct BallBearingState {
  double radial = 0.0;           // [m]    along the radial load
  double lateral = 0.0;          // [m]    across it
  double axial = 0.0;            // [m]
  double tilt = 0.0;             // [rad]  in the plane of the radial load
  double lateral_tilt = 0.0;     // [rad]
  double moment = 0.0;           // [N m]  on the ring in that plane: given, or holding the given tilt
  Eigen::ArrayXd ball_load;      // [N]    (balls)  the same on both races
  Eigen::ArrayXd contact_angle;  // [rad]  (balls)
  BalanceReport report;
};

BallBearingState static_state(const BallBearing& bearing, const BallBearingLoad& load);

/// Load on the ring's coordinates (radial, lateral, axial, lever x tilt, lever x lateral tilt) at `place`
/// [m], and its stiffness; for tests of their consistency, with the energy [J] they derive from.
RingForces<5> ring_forces(const BallBearing& bearing, const BallBearingGeometry& geometry,
                          const Eigen::Vector<double, 5>& place);
double stored_energy(const BallBearing& bearing, const BallBearingGeometry& geometry,
                     const Eigen::Vector<double, 5>& place);

}  // namespace orbearing::bearing::static_load
