#include "app/study/static_ratings.hpp"

#include <fmt/format.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "app/study/rated_oil.hpp"
#include "app/units.hpp"
#include "bearing/equilibrium/balls.hpp"
#include "bearing/life/life_modification.hpp"

namespace orbearing::app {

namespace {

namespace rating = bearing::rating;

std::optional<FilmState> film_of(const ResolvedCase& in, rating::RollingElement element,
                                 const StaticStudy& study) {
  const std::optional<rating::StatedOil> stated = stated_oil(in);
  if (!stated) return {};
  const double speed = in.quantity("operation.shaft_speed") - in.quantity("operation.outer_speed");
  const rating::OilCondition oil =
      rating::oil_condition(*stated, speed, in.quantity("bearing.pitch_diameter"));
  FilmState film{oil.viscosity_ratio, oil.contamination_factor};
  const double load =
      rating::reference_load(element, study.ratings.dynamic_capacity, study.reference_life.bearing);
  const double ratio = load > 0.0 ? film.contamination_factor * study.ratings.fatigue_load_limit / load
                                  : std::numeric_limits<double>::infinity();
  try {
    film.life_modification = rating::life_modification_factor(element, film.viscosity_ratio, ratio);
  } catch (const std::invalid_argument& error) {
    throw BadInput(fmt::format("{}: lubricant.kinematic_viscosity: {}",
                               in.origin("lubricant.kinematic_viscosity"), error.what()));
  }
  return film;
}

// Shoulders are not stated; one at 70 degrees is a third of a ball's diameter high.
void warn_of_steep_contacts(StaticStudy& study) {
  if (study.contact_angle.size() == 0) return;
  constexpr double degree = boost::math::double_constants::degree, usual_end = 70.0 * degree;
  const Eigen::ArrayXd loaded_angle = (study.contact_load > 0.0).select(study.contact_angle.abs(), 0.0);
  const auto beyond = (loaded_angle > usual_end).count();
  if (beyond == 0) return;
  study.warnings.push_back(fmt::format(
      "load: {} of {} balls bear on the inner race at more than 70 degrees (up to {:.1f}), where a usual "
      "groove has ended; the balance takes grooves up to 90 degrees",
      beyond, loaded_angle.size(), loaded_angle.maxCoeff() / degree));
}

// One loaded element does not hold the ring across its line. Cylindrical rollers never hold it along the
// axis.
void warn_of_loose_rings(StaticStudy& study) {
  const Eigen::Vector3d held = study.stiffness.diagonal().head<3>();
  constexpr double nothing = 1e-9;
  const int axes = study.contact_angle.size() > 0 ? 3 : 2;
  for (int axis = 0; axis < axes; ++axis)
    if (held[axis] < nothing * held.maxCoeff())
      study.warnings.push_back(
          fmt::format("stiffness: nothing holds the ring along {}: its place there is not determined, and "
                      "the matrix is singular",
                      "xyz"[axis]));
}

void warn(const ResolvedCase& in, rating::RollingElement element, StaticStudy& study) {
  const rating::Ratings& ratings = study.ratings;
  for (std::string& text : oil_warnings(in)) study.warnings.push_back(std::move(text));
  if (ratings.gamma > ratings.slenderness_limit && !in.has("bearing.dynamic_capacity"))
    study.warnings.push_back(fmt::format(
        "bearing: D cos(alpha)/d_m is {:.3g}; the table of f_c in ISO 281 ends at {:.2g}: its formula is "
        "used beyond",
        ratings.gamma, ratings.slenderness_limit));
  if (!study.equivalent_load)
    study.warnings.push_back(
        "L10: the factors X and Y of ISO 281 are held for a nominal contact angle of zero; L10r has no need "
        "of them");
  if (in.model() == roller_bearing && !in.has("bearing.laminae"))
    study.warnings.push_back(fmt::format(
        "bearing.laminae: not given; {} are taken, and lives depend on their number", default_laminae));
  if (study.lamina_load.rows() > 0 && study.lamina_load.rows() < 30)
    study.warnings.push_back(fmt::format(
        "bearing.laminae: {} laminae; ISO/TS 16281 asks for at least 30, and its stress riser depends on "
        "their number",
        study.lamina_load.rows()));
  constexpr double slipping = 0.1;  // of lubricated steel
  if (study.friction > slipping)
    study.warnings.push_back(
        fmt::format("operation: the gyroscopic moment of a ball asks for a friction of {:.2g} on a race; it "
                    "will slip, which "
                    "the balance does not know",
                    study.friction));
  warn_of_steep_contacts(study);
  warn_of_loose_rings(study);
  if (study.largest_pressure > rating::static_pressure(element))
    study.warnings.push_back(
        fmt::format("load: a contact pressure of {:.0f} MPa, which leaves permanent marks",
                    1e-6 * study.largest_pressure));
}

}  // namespace

void rate(const ResolvedCase& in, rating::RollingElement element, StaticStudy& study) {
  study.basic_life =
      study.equivalent_load
          ? rating::basic_rating_life(element, study.ratings.dynamic_capacity, *study.equivalent_load)
          : std::numeric_limits<double>::quiet_NaN();
  study.reliability_factor = rating::reliability_factor(in.number("life.reliability"));
  study.film = film_of(in, element, study);
  study.life = study.reliability_factor * (study.film ? study.film->life_modification : 1.0) *
               study.reference_life.bearing;
  warn(in, element, study);
}

std::vector<Derived> static_quantities(const ResolvedCase& in) {
  const bearing::Bearing bearing = bearing_of(in);
  const rating::Ratings ratings = rating::ratings_of(bearing, stated_ratings_of(in));
  std::vector<Derived> rows{
      {"bearing.slenderness", ratings.gamma, "1", "D cos(alpha)/d_m"},
      {"bearing.capacity_factor", ratings.capacity_factor, "1", "f_c of ISO 281, in N and mm"},
      {"bearing.inner_contact_capacity", ratings.contacts.inner, "N", "of one rolling element, ISO/TS 16281"},
      {"bearing.outer_contact_capacity", ratings.contacts.outer, "N",
       "of one rolling element, ISO/TS 16281"}};
  if (!in.has("bearing.static_capacity"))
    rows.push_back({"bearing.static_capacity", ratings.static_capacity, "N", "C_0r of ISO 76"});
  if (!in.has("bearing.dynamic_capacity"))
    rows.push_back({"bearing.dynamic_capacity", ratings.dynamic_capacity, "N", "C_r of ISO 281"});
  if (!in.has("bearing.fatigue_load_limit"))
    rows.push_back(
        {"bearing.fatigue_load_limit", ratings.fatigue_load_limit, "N", "C_u of ISO 281, by C_0r"});
  if (bearing.has_rollers()) return rows;
  const bearing::equilibrium::BallRow row(bearing);
  rows.push_back({"bearing.groove_distance", 1e3 * row.groove_distance(), "mm", "A, of the groove centres"});
  rows.push_back({"bearing.free_contact_angle", kDegree * row.free_angle(), "deg", "without load"});
  return rows;
}

}  // namespace orbearing::app
