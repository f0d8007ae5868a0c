#include "coupling/study/light_load.hpp"

#include <stdexcept>

#include "bearing/motion/drag_slip.hpp"
#include "bearing/motion/model.hpp"
#include "coupling/study/planet_stiffness.hpp"
#include "coupling/study/rated_bearing.hpp"

namespace orbearing::study {

using bearing::motion::WindowStatistics;

std::optional<double> slip_by_drag(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                   const BearingDuty& duty) {
  const bearing::motion::DynamicsParameters parameters = bearing_dynamics(drivetrain, geometry);
  if (parameters.race.traction != bearing::motion::TractionLaw::regularised_coulomb ||
      parameters.race.lubrication != bearing::motion::Lubrication::full ||
      duty.point.inner_speed == duty.point.outer_speed)
    return std::nullopt;
  try {
    PlanetaryDrivetrain like = drivetrain;  // at rest rollers are equal, and no wave turns
    like.bearing = of_like_rollers(drivetrain.bearing);
    const WindowStatistics means = BearingsAtRest(like, geometry).one(duty).means;
    const Eigen::ArrayXd both =
        (means.inner.mean_load * means.inner.passages).min(means.outer.mean_load * means.outer.passages);
    return drag_slip(bearing_model(drivetrain.bearing, duty.point, parameters),
                     drivetrain.bearing.rollers().count * both.mean());
  } catch (const std::exception&) {  // what the motion itself does not take, it says
    return std::nullopt;
  }
}

}  // namespace orbearing::study
