#include "app/study/static_study.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "app/study/static_ratings.hpp"
#include "bearing/contact/line_contact.hpp"
#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/reference_life.hpp"

namespace orbearing::app {

namespace {

using bearing::Race;
namespace rating = bearing::rating;
namespace equilibrium = bearing::equilibrium;

void require_balance(const ResolvedCase& in, const equilibrium::BalanceReport& report) {
  if (report.converged) return;
  throw ComputationFailed(fmt::format("{}: {} ({} iterations, {:.2g} N unbalanced)", in.text("name"),
                                      report.message, report.iterations, report.residual));
}

// Hertz's pressure of the most heavily loaded lamina on the inner race, where the curvature is largest.
double roller_pressure(const StaticStudy& study, const rating::RollerSet& set,
                       const bearing::Material& material) {
  const double most = study.lamina_load.size() > 0 ? study.lamina_load.maxCoeff() : 0.0;
  const double lamina = set.length / static_cast<double>(study.lamina_load.rows());
  const double radius = 0.5 * set.diameter * (1.0 - rating::gamma(set));
  return bearing::hertz_pressure(most, radius, lamina, material);
}

// What balls and rollers have in common.
StaticStudy study_of(const ResolvedCase& in, const equilibrium::RingState& state) {
  require_balance(in, state.report);
  StaticStudy study{.model = in.choice("model"),
                    .radial = state.radial,
                    .axial = state.axial,
                    .tilt = state.tilt,
                    .moment = state.moment,
                    .contact_load = state.contact_load,
                    .lamina_load = state.lamina_load};
  study.ratings = ratings_of(in);
  return study;
}

StaticStudy roller_study(const ResolvedCase& in) {
  const bearing::CylindricalRollerBearing rollers = lamina_bearing_of(in);
  StaticStudy study =
      study_of(in, equilibrium::balance_ring(equilibrium::RollerRow(rollers), ring_load_of(in)));
  const rating::RaceMotions motions = race_motions_of(in);
  study.largest_pressure = roller_pressure(study, roller_set_of(in), rollers.material);
  study.equivalent_load = in.quantity("load.radial");
  study.reference_life =
      rating::lamina_reference_life(study.ratings.contacts, study.lamina_load, study.lamina_load, motions);
  study.lundberg_palmgren = bearing::lundberg_palmgren_life(
      rollers, in.number("life.lambda"),
      motions.inner == bearing::RaceMotion::standing ? Race::inner : Race::outer, study.contact_load,
      study.contact_load);
  rate(in, rating::RollingElement::roller, study);
  return study;
}

StaticStudy ball_study(const ResolvedCase& in) {
  const bearing::BallBearing bearing = ball_bearing_of(in);
  const equilibrium::BallRow row(bearing);
  const equilibrium::RingState state = equilibrium::balance_ring(row, ring_load_of(in));
  StaticStudy study = study_of(in, state);
  study.contact_angle = state.contact_angle;
  for (const Race race : {Race::inner, Race::outer})
    study.largest_pressure =
        std::max(study.largest_pressure,
                 bearing::point_pressure(row.contact(race), study.contact_load.maxCoeff()).pressure);
  if (bearing.contact_angle == 0.0)
    study.equivalent_load = rating::deep_groove_equivalent_load(
        rating::ball_set(bearing), in.quantity("load.radial"), in.quantity("load.axial"));
  study.reference_life = rating::ball_reference_life(study.ratings.contacts, study.contact_load,
                                                     study.contact_load, race_motions_of(in));
  rate(in, rating::RollingElement::ball, study);
  return study;
}

}  // namespace

bool is_static_bearing(const ResolvedCase& resolved) {
  return resolved.model() == roller_bearing || resolved.model() == ball_bearing;
}

StaticStudy static_study(const ResolvedCase& resolved) {
  if (resolved.model() == roller_bearing) return roller_study(resolved);
  if (resolved.model() == ball_bearing) return ball_study(resolved);
  throw BadInput(resolved.origin("model") + ": model: found " + resolved.choice("model") +
                 "; required: roller-bearing or ball-bearing");
}

double static_property(const StaticStudy& study, const std::string& quantity) {
  const auto among = [&](const char* name, double value) {
    return quantity == name ? std::optional<double>(value) : std::nullopt;
  };
  for (const auto& value :
       {among("radial_um", 1e6 * study.radial), among("axial_um", 1e6 * study.axial),
        among("tilt_mrad", 1e3 * study.tilt), among("contact_load_max_N", study.contact_load.maxCoeff()),
        among("f_c", study.ratings.capacity_factor), among("C_r_N", study.ratings.dynamic_capacity),
        among("L10_Mrev", 1e-6 * study.basic_life), among("L10r_Mrev", 1e-6 * study.reference_life.bearing),
        among("life_Mrev", 1e-6 * study.life)})
    if (value) return *value;
  for (Eigen::Index j = 0; j < study.contact_load.size(); ++j)
    if (quantity == fmt::format("contact_load_{}_N", j)) return study.contact_load[j];
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace orbearing::app
