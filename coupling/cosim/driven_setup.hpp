// What is fixed before a run of a driven bearing, its inputs, and the model that follows.
#pragma once

#include "bearing/motion/bore_motion.hpp"
#include "bearing/motion/model.hpp"
#include "bearing/motion/parameters.hpp"
#include "bearing/parameters.hpp"
#include "coupling/cosim/course.hpp"
#include "coupling/cosim/participant.hpp"

namespace orbearing::cosim {

/// The race at rest relative to the load: the pin's.
inline constexpr bearing::Race kStanding = bearing::Race::inner;

/// All that is fixed before a run.
struct DrivenBearingSetup {
  bearing::CylindricalRollerBearing bearing;
  bearing::dynamics::DynamicsParameters dynamics;  // no run-up, no ripple: the inputs bring them
  double orbit_radius = 0.0;                       // [m]    from the carrier's axis to the pin's
  double first_roller = 0.0;                       // [rad]  place of the first roller at the start
  double lambda = 0.83;                            // [-]    of the Lundberg-Palmgren life
  /// Inclination [rad] of the bore's axis against the pin's, which stays: it runs along (x, y, 1). Felt by
  /// laminae only, and refused without them.
  Eigen::Vector2d bore_tilt = Eigen::Vector2d::Zero();
  double allowed_length_error = 2e-10;  // [m]    of one step; all other variables follow from it
  long places = 72;                     // [-]    bins on the races, for the life
  long most_steps = 10'000'000;         // [-]    in one call of advance() before it gives up
};

/// Of a drivetrain too.
inline described::Row<double> lambda_row(double& lambda) {
  using namespace described;
  return field(lambda, "life.lambda", Felt::life,
               "reduction factor of the capacity: the product lambda nu of ISO/TR 1281-1",
               {.models = with_rollers,
                .range = positive(1.0),
                .reason = "the product for cylindrical roller bearings in ISO/TR 1281-1",
                .fmu = InFmu::parameter});
}

/// Inputs over a window.
struct BoreCourse {
  Course x, y;                  // [m]
  Course v_x, v_y;              // [m/s]  slopes of the above
  Course speed;                 // [rad/s]  of the bore, relative to the carrier
  Course carrier_speed;         // [rad/s]
  Course carrier_acceleration;  // [rad/s^2]

  /// All but the angle of the bore, which the bearing itself sums up.
  bearing::dynamics::BoreMotion at(double since) const;
};

/// The model of a bearing that others drive. Throws std::invalid_argument, with what was found and what is
/// required, where a number has no meaning or where something is asked for that follows from speeds or loads
/// before they are known: a run-up, a mesh ripple, the film as printed.
bearing::dynamics::BearingModel driven_model(const DrivenBearingSetup& setup);

/// Throw std::runtime_error with what was found where a number is not finite, or a window has no length.
void require_finite(const BoreCourse& inputs);
void require_finite(const bearing::dynamics::BoreMotion& motion);
void require_length(const Window& window);

}  // namespace orbearing::cosim
