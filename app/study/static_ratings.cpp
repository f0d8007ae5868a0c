#include "app/study/static_ratings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "app/study/rated_oil.hpp"
#include "app/units.hpp"
#include "bearing/equilibrium/balls.hpp"
#include "bearing/life/lamina_life.hpp"
#include "bearing/life/rating_lives.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

namespace rating = bearing::rating;

// [rad/s]  of the rings against each other
double relative_speed(const ResolvedCase& in) {
  return in.quantity("operation.shaft_speed") - in.quantity("operation.outer_speed");
}

std::optional<rating::OilCondition> oil_of(const ResolvedCase& in) {
  const std::optional<rating::StatedOil> stated = stated_oil(in);
  if (!stated) return {};
  if (!stated->viscosity_ratio && relative_speed(in) == 0.0) {
    const char* path = in.has("lubricant.grade") ? "lubricant.grade" : "lubricant.kinematic_viscosity";
    throw BadInput(fmt::format("{}: {}: an oil for rings that do not rotate; operation.shaft_speed is required, from "
                               "which the viscosity ratio follows",
                               in.origin(path), path));
  }
  const rating::OilCondition oil =
      rating::oil_condition(*stated, relative_speed(in), in.quantity("bearing.pitch_diameter"));
  if (oil.viscosity_ratio >= rating::kLeastViscosityRatio) return oil;
  throw BadInput(fmt::format("{}: lubricant.kinematic_viscosity: viscosity ratio kappa: found {:.3g}; required: at "
                             "least {:g}, where a_ISO begins",
                             in.origin("lubricant.kinematic_viscosity"), oil.viscosity_ratio,
                             rating::kLeastViscosityRatio));
}

rating::ElementLoads loads_on(bearing::Race race, const StaticStudy& study) {
  const bool own = race == bearing::Race::outer && study.outer_load.size() > 0;
  return {own ? study.outer_load : study.contact_load, study.lamina_load};
}

// Of rollers by the capacities of Lundberg and Palmgren, lamina by lamina; of balls those of [ISO16281] are theirs.
bearing::BearingLife lundberg_palmgren(const bearing::Bearing& bearing, const StaticStudy& study) {
  if (!bearing.has_rollers()) return study.lives.reference;
  return bearing::life::lamina_life(
      bearing::life::lamina_rating(bearing, bearing::life::LifeMeasure::lundberg_palmgren, study.reduction_factor),
      study.lamina_load, study.lamina_load);
}

// Shoulders are not stated; one at 70 degrees is a third of a ball's diameter high.
void warn_of_steep_contacts(StaticStudy& study) {
  if (study.contact_angle.size() == 0) return;
  constexpr double degree = constants::degree, normal_end = 70.0 * degree;
  const Eigen::ArrayXd loaded_angle = (study.contact_load > 0.0).select(study.contact_angle.abs(), 0.0);
  const auto beyond = (loaded_angle > normal_end).count();
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

void warn(const ResolvedCase& in, StaticStudy& study) {
  const rating::Ratings& ratings = study.ratings;
  for (std::string& text : oil_warnings(in)) study.warnings.push_back(std::move(text));
  if (ratings.gamma > ratings.slenderness_limit && !in.has("bearing.dynamic_capacity"))
    study.warnings.push_back(fmt::format(
        "bearing: D cos(alpha)/d_m is {:.3g}; the table of f_c in ISO 281 ends at {:.2g}: its formula is "
        "used beyond",
        ratings.gamma, ratings.slenderness_limit));
  if (std::isnan(study.lives.dynamic_load))
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
}

}  // namespace

rating::RatingCondition rating_condition_of(const ResolvedCase& in, const bearing::Bearing& bearing) {
  const bearing::equilibrium::RingLoad load = ring_load_of(in);
  return {.dynamic_load = rating::equivalent_load(bearing, load.radial, load.axial),
          .static_load = rating::static_equivalent_load(bearing, load.radial, load.axial),
          .oil = oil_of(in),
          .reliability_factor = rating::reliability_factor(in.number("life.reliability"))};
}

void rate(const ResolvedCase& in, const bearing::Bearing& bearing, StaticStudy& study) {
  study.speed = relative_speed(in);
  if (bearing.has_rollers()) study.reduction_factor = in.number("life.reduction_factor");
  study.lives = rating::rating_lives(rating::bearing_rating(bearing, stated_ratings_of(in)),
                                     rating_condition_of(in, bearing), loads_on(bearing::Race::inner, study),
                                     loads_on(bearing::Race::outer, study));
  study.lundberg_palmgren = lundberg_palmgren(bearing, study);
  warn(in, study);
}

namespace {

// Lives that need the load on the bearing alone; none where P is not known or the oil is too thin for a_ISO.
void add_lives_by_load(const ResolvedCase& in, const bearing::Bearing& bearing, std::vector<Derived>& rows) {
  rating::RatingCondition condition;
  try {
    condition = rating_condition_of(in, bearing);
  } catch (const BadInput&) {
    return;  // the run says it
  }
  if (!condition.dynamic_load || !(*condition.dynamic_load > 0.0)) return;
  const rating::ElementLoads nothing{Eigen::ArrayXd::Zero(1), Eigen::ArrayXXd::Zero(1, 1)};
  const rating::RatingLives lives =
      rating::rating_lives(rating::bearing_rating(bearing, stated_ratings_of(in)), condition, nothing, nothing);
  const double speed = relative_speed(in), million = 1e-6;
  rows.push_back({"life.equivalent_load", lives.dynamic_load, "N", "P of ISO 281"});
  rows.push_back({"life.load_ratio", lives.load_ratio(), "1", "C/P"});
  if (condition.static_load) rows.push_back({"life.static_safety", lives.static_safety(), "1", "S_0 = C_0/P_0 of ISO 76"});
  rows.push_back({"life.L10", million * lives.basic, "Mrev", "basic rating life of ISO 281"});
  if (speed != 0.0) rows.push_back({"life.L10h", bearing::hours(lives.basic, speed), "h", "the same at the speed of the rings"});
  if (!lives.oil) return;
  rows.push_back({"life.kappa", lives.oil->viscosity_ratio, "1", "viscosity ratio of ISO 281"});
  rows.push_back({"life.e_C", lives.oil->contamination_factor, "1", "contamination factor of ISO 281"});
  rows.push_back({"life.a_ISO", lives.life_modification, "1", "life modification factor of ISO 281, by C_u/P"});
  rows.push_back({"life.L10m", million * lives.modified, "Mrev", "modified rating life of ISO 281: a_1 a_ISO L10"});
  if (speed != 0.0) rows.push_back({"life.L10mh", bearing::hours(lives.modified, speed), "h", "the same at the speed of the rings"});
}

}  // namespace

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
  add_lives_by_load(in, bearing, rows);
  if (bearing.has_rollers()) return rows;
  const bearing::equilibrium::BallRow row(bearing);
  rows.push_back({"bearing.groove_distance", 1e3 * row.groove_distance(), "mm", "A, of the groove centres"});
  rows.push_back({"bearing.free_contact_angle", kDegree * row.free_angle(), "deg", "without load"});
  return rows;
}

}  // namespace orbearing::app
