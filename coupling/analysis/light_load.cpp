#include "coupling/analysis/light_load.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "bearing/contact/line_contact.hpp"
#include "bearing/motion/drag_slip.hpp"
#include "bearing/motion/model.hpp"
#include "coupling/analysis/planet_stiffness.hpp"
#include "coupling/analysis/rated_bearing.hpp"

namespace orbearing::analysis {

using bearing::motion::WindowStatistics;

MeansAtRest means_at_rest(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          const std::vector<BearingDuty>& duties) {
  PlanetaryDrivetrain like = drivetrain;
  like.bearing = of_like_rollers(drivetrain.bearing);
  MeansAtRest all(duties.size());
  for (std::size_t i = 0; i < duties.size(); ++i) try {
      all[i] = BearingsAtRest(like, geometry).one(duties[i]).means;
    } catch (const std::exception&) {  // invalid input of the motion is reported by the motion itself
    }
  return all;
}

namespace {

// `of` a bearing's model and its loads, where drag and traction can be compared.
template <class Function>
std::optional<double> under_loads_at_rest(const PlanetaryDrivetrain& drivetrain,
                                          const DrivetrainGeometry& geometry, const BearingDuty& duty,
                                          const std::optional<WindowStatistics>& at_rest,
                                          const Function& of) {
  const bearing::motion::DynamicsParameters parameters = bearing_dynamics(drivetrain, geometry);
  if (!at_rest || nature_of(parameters.race.traction).shears_oil ||
      parameters.race.lubrication != bearing::motion::Lubrication::full ||
      duty.point.inner_speed == duty.point.outer_speed)
    return std::nullopt;
  try {
    return of(bearing_model(drivetrain.bearing, duty.point, parameters),
              bearing::motion::LoadsOfOrbit{at_rest->inner.mean_load * at_rest->inner.passages,
                                            at_rest->outer.mean_load * at_rest->outer.passages});
  } catch (const std::exception&) {  // as above
    return std::nullopt;
  }
}

}  // namespace

std::optional<double> drag_over_traction(const PlanetaryDrivetrain& drivetrain,
                                         const DrivetrainGeometry& geometry, const BearingDuty& duty,
                                         const std::optional<WindowStatistics>& at_rest) {
  return under_loads_at_rest(drivetrain, geometry, duty, at_rest, [](const auto& model, const auto& loads) {
    return bearing::motion::drag_over_traction(model, loads);
  });
}

std::optional<double> slip_by_drag(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                   const BearingDuty& duty, const std::optional<WindowStatistics>& at_rest) {
  if (!drivetrain.bearing.has_cage()) return std::nullopt;
  return under_loads_at_rest(drivetrain, geometry, duty, at_rest, [](const auto& model, const auto& loads) {
    return bearing::motion::drag_slip(model, loads);
  });
}

PlanetaryDrivetrain with_error_of_load(PlanetaryDrivetrain drivetrain, const MeansAtRest& at_rest) {
  system::SteadyStateOptions& options = drivetrain.steady_state;
  if (options.load_error_share == 0.0) return drivetrain;
  const bearing::LineContact contact =
      bearing::roller_race_contact(drivetrain.bearing.contact_law, drivetrain.bearing.rollers().length);
  double approach = std::numeric_limits<double>::infinity();
  for (const std::optional<WindowStatistics>& means : at_rest) {
    if (!means) return drivetrain;
    approach = std::min(approach, contact.approach(means->inner.load_max));
  }
  options.allowed_length_error = std::max(options.allowed_length_error, options.load_error_share * approach);
  return drivetrain;
}

}  // namespace orbearing::analysis
