// The numbers between a bearing and its reference rating life, [ISO16281]: what anyone who computes the same
// by another program compares step by step (cases/iso16281_worked_set).
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "bearing/contact/point_contact.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/life/standard_life.hpp"

namespace orbearing::app {

/// Of rollers cut into laminae: Eq. (6) of bearing/equilibrium/README.md, Eqs. (4) and (5) of
/// bearing/life/README.md.
struct RollerSteps {
  double constant = 0.0;               // [N/m^(10/9)]  c_L of both contacts in series
  Eigen::ArrayXd lamina_place;         // [m]    (laminae)  x_k from the middle
  Eigen::ArrayXd drop;                 // [m]    (laminae)  of both contacts: 2 P(x_k)
  Eigen::ArrayXd tilt;                 // [rad]  (rollers)  psi_j of the races against each other
  Eigen::ArrayXd stress_riser;         // [-]    (laminae)  f_k
  double inner_lamina_capacity = 0.0;  // [N]
  double outer_lamina_capacity = 0.0;  // [N]
};

/// Of balls: Eqs. (7) and (8) of bearing/equilibrium/README.md.
struct BallSteps {
  bearing::PointContact inner, outer;
  double constant = 0.0;         // [N/m^(3/2)]  c_P of both contacts in series
  double groove_distance = 0.0;  // [m]    A
  double tilt_radius = 0.0;      // [m]    R_i, where the centres of the inner groove lie
  double free_angle = 0.0;       // [rad]  contact angle of the concentric rings, all axial play taken up
};

/// All that a balance by the standard goes through.
struct StaticSteps {
  double gamma = 0.0;                     // [-]  D cos(alpha)/d_m
  double radial = 0.0, lateral = 0.0;     // [m]  of the inner ring along the radial load and across it
  double axial = 0.0;                     // [m]
  double tilt = 0.0, lateral_tilt = 0.0;  // [rad]  in the axial planes along the load and across it
  double lateral_moment = 0.0;            // [N m]
  Eigen::ArrayXd angle;                   // [rad]  (elements)  from the radial load
  /// [m] (elements): negative where the rings leave play; of rollers in the middle and without drop.
  Eigen::ArrayXd approach;
  /// [N] (laminae), the stress riser in them; of balls one.
  Eigen::ArrayXd inner_equivalent;
  Eigen::ArrayXd outer_equivalent;
  std::optional<RollerSteps> rollers;
  std::optional<BallSteps> balls;
};

/// Of a state that a search without motion of the balls has found; none where balls turn, whose races bear
/// unlike loads.
std::optional<StaticSteps> static_steps(const bearing::Bearing& bearing,
                                        const bearing::rating::Ratings& ratings,
                                        const bearing::equilibrium::RingState& state);

/// As `run --json` has it, below `steps`.
nlohmann::ordered_json steps_json(const StaticSteps& steps);

}  // namespace orbearing::app
