#include "coupling/study/light_load.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "bearing/contact/line_contact.hpp"
#include "bearing/motion/drag_slip.hpp"
#include "bearing/motion/model.hpp"
#include "coupling/study/planet_stiffness.hpp"
#include "coupling/study/rated_bearing.hpp"

namespace orbearing::study {

using bearing::motion::WindowStatistics;

namespace {

// Of one bearing: at rest rollers are equal, and no wave turns. Throws std::runtime_error without a balance.
WindowStatistics means_at_rest(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                               const BearingDuty& duty) {
  PlanetaryDrivetrain like = drivetrain;
  like.bearing = of_like_rollers(drivetrain.bearing);
  return BearingsAtRest(like, geometry).one(duty).means;
}

}  // namespace

std::optional<double> slip_by_drag(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                   const BearingDuty& duty) {
  const bearing::motion::DynamicsParameters parameters = bearing_dynamics(drivetrain, geometry);
  if (parameters.race.traction != bearing::motion::TractionLaw::regularised_coulomb ||
      parameters.race.lubrication != bearing::motion::Lubrication::full ||
      duty.point.inner_speed == duty.point.outer_speed)
    return std::nullopt;
  try {
    const WindowStatistics means = means_at_rest(drivetrain, geometry, duty);
    const Eigen::ArrayXd both =
        (means.inner.mean_load * means.inner.passages).min(means.outer.mean_load * means.outer.passages);
    return drag_slip(bearing_model(drivetrain.bearing, duty.point, parameters),
                     drivetrain.bearing.rollers().count * both.mean());
  } catch (const std::exception&) {  // what the motion itself does not take, it says
    return std::nullopt;
  }
}

PlanetaryDrivetrain with_error_of_load(PlanetaryDrivetrain drivetrain, const DrivetrainGeometry& geometry,
                                       const std::vector<BearingDuty>& duties) {
  system::SteadyStateOptions& options = drivetrain.steady_state;
  if (options.load_error_share == 0.0) return drivetrain;
  const bearing::LineContact contact =
      bearing::roller_race_contact(drivetrain.bearing.contact_law, drivetrain.bearing.rollers().length);
  double approach = std::numeric_limits<double>::infinity();
  try {
    for (const BearingDuty& duty : duties)
      approach =
          std::min(approach, contact.approach(means_at_rest(drivetrain, geometry, duty).inner.load_max));
  } catch (const std::exception&) {  // what the motion itself does not take, it says
    return drivetrain;
  }
  options.allowed_length_error = std::max(options.allowed_length_error, options.load_error_share * approach);
  return drivetrain;
}

}  // namespace orbearing::study
