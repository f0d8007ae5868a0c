#include "app/study/static_study.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "app/study/static_ratings.hpp"
#include "bearing/equilibrium/ring_axes.hpp"
#include "bearing/equilibrium/static_bearing.hpp"

namespace orbearing::app {

namespace {

namespace rating = bearing::rating;
namespace equilibrium = bearing::equilibrium;

void require_balance(const ResolvedCase& in, const equilibrium::BalanceReport& report) {
  if (report.converged) return;
  throw ComputationFailed(fmt::format("{}: {} ({} iterations, {:.2g} N unbalanced)", in.text("name"),
                                      report.message, report.iterations, report.residual));
}

// Of both planes. Where load and elements are mirrored in that of the radial load, nothing moves across it,
// and what moves along it keeps its sign.
double resultant(double along, double across, bool mirrored) {
  return mirrored ? along : std::hypot(along, across);
}

}  // namespace

bool is_static_bearing(const ResolvedCase& resolved) {
  return resolved.model() == roller_bearing || resolved.model() == ball_bearing;
}

StaticStudy static_study(const ResolvedCase& in) {
  if (!is_static_bearing(in))
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   "; required: roller-bearing or ball-bearing");
  const bearing::Bearing bearing = bearing_of(in);
  const equilibrium::RingLoad load = ring_load_of(in);
  const equilibrium::RowMotion motion = row_motion_of(in);
  const equilibrium::RingState state = equilibrium::balance_bearing(bearing, motion, load);
  require_balance(in, state.report);
  const bool mirrored = load.moment_across == 0.0 && bearing.first_element == 0.0;
  StaticStudy study{.model = in.choice("model"),
                    .radial = resultant(state.radial, state.lateral, mirrored),
                    .axial = state.axial,
                    .tilt = resultant(state.tilt, state.lateral_tilt, mirrored),
                    .moment = state.moment,
                    .contact_load = state.contact_load,
                    .contact_angle = state.contact_angle,
                    .outer_load = state.outer_load,
                    .outer_angle = state.outer_angle,
                    .friction = state.friction,
                    .stiffness = equilibrium::stiffness_by_axes(state),
                    .lamina_load = state.lamina_load,
                    .largest_pressure = state.largest_pressure};
  study.ratings = rating::ratings_of(bearing, stated_ratings_of(in));
  study.steps = static_steps(bearing, study.ratings, state);
  rate(in, bearing, study);
  if (motion.film && state.inner_rolling.size() > 0) {
    study.films = ball_films(bearing, *motion.film, state);
    for (const std::string& warning : film_warnings(bearing, *study.films)) study.warnings.push_back(warning);
  }
  study.over_speed = speed_table(in);
  if (study.over_speed)
    for (const std::string& warning : study.over_speed->warnings) study.warnings.push_back(warning);
  return study;
}

}  // namespace orbearing::app
