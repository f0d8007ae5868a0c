// One bearing under a static load: displacement, contact loads and standard lives.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/results/life_table.hpp"
#include "app/study/film_study.hpp"
#include "app/study/friction_study.hpp"
#include "bearing/contact/point_contact.hpp"
#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/equilibrium/ring_balance.hpp"

namespace orbearing::app {

// What comes out of one bearing under a static load.

// The numbers between a bearing and its reference rating life, [ISO16281]: what anyone who computes the same
// by another program compares step by step (cases/iso16281_worked_set).

/// Of rollers cut into laminae: Eq. (6) of bearing/equilibrium/README.md, Eqs. (4) and (5) of
/// bearing/life/README.md.
struct RollerSteps {
  double constant = 0.0;               // [N/m^(10/9)]  c_L of both contacts in series
  Eigen::ArrayXd lamina_position;      // [m]    (laminae)  x_k from the middle
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

void describe(described::Record& record, const RollerSteps& rollers);
void describe(described::Record& record, const BallSteps& balls);
void describe(described::Record& record, const StaticSteps& steps);

/// Results; lives in revolutions, infinite where nothing is loaded.
struct StaticStudy {
  std::string model;
  double radial = 0.0;           // [m]    displacement across the axis, of both planes
  double axial = 0.0;            // [m]
  double tilt = 0.0;             // [rad]  of both planes
  double moment = 0.0;           // [N m]  on the inner ring, in the plane of the radial load
  Eigen::ArrayXd contact_load;   // [N]    (rolling elements)  on the inner race
  Eigen::ArrayXd contact_angle;  // [rad]  (balls)  there; empty for rollers
  Eigen::ArrayXd outer_load;     // [N]    (balls)  of rings that turn; else empty
  Eigen::ArrayXd outer_angle;    // [rad]  (balls)  the same
  double friction = 0.0;         // [-]    traction over load that holds the balls, at most
  /// Of the inner ring: x along the radial load, y, z, tilts about x and y; [N/m], [N/rad], [N m/rad].
  Eigen::Matrix<double, 5, 5> stiffness = Eigen::Matrix<double, 5, 5>::Zero();
  Eigen::ArrayXXd lamina_load;    // [N]    (laminae, rollers); empty for balls
  double largest_pressure = 0.0;  // [Pa]  after Hertz, without what edges add
  bearing::rating::Ratings ratings;
  bearing::rating::RatingLives lives;          // by the standards
  bearing::BearingLife lundberg_palmgren;      // [rev]
  double reduction_factor = 0.0;               // [-]      in its capacities; of rollers
  double speed = 0.0;                          // [rad/s]  of the rings against each other; 0: not known
  std::optional<std::vector<BallFilm>> films;  // of balls whose film takes part
  std::optional<bearing::defect::PassingFrequencies> passing;  // at pure rolling; none without a speed
  std::optional<SpeedTable> over_speed;
  std::optional<FrictionStudy> rolling_friction;             // none without speed and oil
  std::optional<FrictionByStandards> friction_by_standards;  // none without boundary dimensions
  std::optional<StaticSteps> steps;  // none where balls turn
  std::vector<std::string> warnings;

  BearingLives all_lives() const { return {lives, lundberg_palmgren.bearing, speed, largest_pressure}; }
  LifeTable life_table() const;
};

void describe(described::Record& record, const StaticStudy& study);

/// Of both races [N].
double largest_load(const StaticStudy& study);

// Factors of the life of the bearing of a case, and what `orbearing check` tells of its ratings.

/// P, P_0, oil and a_1 of a single bearing, at rest or in time. Throws BadInput where kappa is below the
/// range of a_ISO.
bearing::rating::RatingCondition rating_condition_of(const ResolvedCase& resolved,
                                                     const bearing::Bearing& bearing);

/// What follows from the inputs, for `orbearing check`.
std::vector<Derived> static_quantities(const ResolvedCase& resolved);

/// Whether a case is that of one bearing under a static load.
bool is_static_bearing(const ResolvedCase& resolved);

/// Throws ComputationFailed where no balance is found, BadInput for another model.
StaticStudy static_study(const ResolvedCase& resolved);

}  // namespace orbearing::app
