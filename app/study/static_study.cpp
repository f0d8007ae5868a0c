#include "app/study/static_study.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/units.hpp"
#include "bearing/contact/line_law.hpp"
#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/ring_axes.hpp"
#include "bearing/equilibrium/rollers.hpp"
#include "bearing/equilibrium/row_group.hpp"
#include "bearing/life/lamina_life.hpp"
#include "bearing/life/rating_lives.hpp"
#include "bearing/life/reference_life.hpp"
#include "bearing/life/roller_capacity.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

using described::Record;
namespace dimension = described::dimension;

bool has_balls(const StaticStudy& study) {
  return study.contact_angle.size() > 0;
}

void describe_life(Record& record, const bearing::BearingLife& life) {
  record.value("inner_Mrev", dimension::revolutions, "of the inner race", life.inner);
  record.value("outer_Mrev", dimension::revolutions, "of the outer race", life.outer);
  record.value("bearing_Mrev", dimension::revolutions, "of both", life.bearing);
}

void describe_ratings(Record& record, const bearing::rating::Ratings& ratings) {
  record.value("f_c", dimension::ratio, "capacity factor of ISO 281, in N and mm", ratings.capacity_factor);
  record.value("C_r_N", dimension::force, "basic dynamic load rating", ratings.dynamic_capacity);
  record.value("C_0r_N", dimension::force, "basic static load rating", ratings.static_capacity);
  record.value("C_u_N", dimension::force, "fatigue load limit", ratings.fatigue_load_limit);
  record.value("inner_contact_N", dimension::force, "of one element, ISO/TS 16281", ratings.contacts.inner);
  record.value("outer_contact_N", dimension::force, "of one element, ISO/TS 16281", ratings.contacts.outer);
}

void describe_factors(Record& record, const bearing::rating::RatingLives& lives) {
  record.value("a_1", dimension::ratio, "for reliability", lives.reliability_factor);
  record.value("a_ISO", dimension::ratio, "life modification factor", lives.life_modification);
  if (!lives.oil) return;
  record.value("kappa", dimension::ratio, "viscosity ratio; a_ISO takes at most 4",
               lives.oil->viscosity_ratio);
  record.value("e_C", dimension::ratio, "contamination factor", lives.oil->contamination_factor);
}

void describe_elements(Record& record, const StaticStudy& study) {
  const auto of_elements = [&](const char* name, const described::Dimension& of, const char* meaning,
                               const Eigen::ArrayXd& values) -> described::Entry& {
    return record.array(name, of, meaning, {"element"}, values);
  };
  if (study.outer_load.size() > 0) {
    of_elements("outer_contact_loads_N", dimension::force, "of each ball on the outer race", study.outer_load)
        .variable = "outer_contact_load";
    of_elements("outer_contact_angles_deg", dimension::angle, "of each ball on the outer race",
                study.outer_angle);
    record.value("gyroscopic_friction", dimension::ratio, "traction over load that holds the balls, at most",
                 study.friction);
  }
  if (study.films) record.table("film", "film", "under each loaded ball", *study.films);
  if (study.over_speed) describe(record, *study.over_speed);
  record.child("lundberg_palmgren", "life by Lundberg and Palmgren", study.lundberg_palmgren, describe_life)
      .detail = true;
  if (has_balls(study))
    of_elements("contact_angles_deg", dimension::angle, "of each ball on the inner race",
                study.contact_angle);
  if (study.lamina_load.size() > 0)
    record
        .array("lamina_loads_N", dimension::force, "load of each lamina of each roller",
               {"element", "lamina"}, study.lamina_load.transpose().eval())
        .variable = "lamina_load";
}

// What the table of a sweep has columns for.
void describe_races(Record& record, const StaticStudy& study) {
  const Eigen::ArrayXd& inner = study.contact_load;
  const Eigen::ArrayXd& outer = study.outer_load.size() > 0 ? study.outer_load : study.contact_load;
  const auto of_race = [&](const std::string& race, const Eigen::ArrayXd& loads, double life) {
    record.value(race + "_load_max_N", dimension::force, "largest load of an element", loads.maxCoeff())
        .detail = true;
    record
        .value(race + "_load_rms_N", dimension::force, "root mean square over the elements",
               std::sqrt(loads.square().mean()))
        .detail = true;
    record.value(race + "_life_Mrev", dimension::revolutions, "by Lundberg and Palmgren", life).detail = true;
  };
  of_race("inner", inner, study.lundberg_palmgren.inner);
  of_race("outer", outer, study.lundberg_palmgren.outer);
}

// Under the names that files of arrays have had.
void describe_for_files(Record& record, const StaticStudy& study) {
  const bearing::rating::RatingLives& lives = study.lives;
  const auto add = [&](const char* name, const described::Dimension& of, const char* meaning, double value) {
    record.value(name, of, meaning, value).in_files_alone = true;
  };
  add("dynamic_capacity", dimension::force, "C_r", study.ratings.dynamic_capacity);
  add("basic_life", dimension::ratio, "L10, revolutions", lives.basic);
  add("reference_life", dimension::ratio, "L10r, revolutions", lives.reference.bearing);
  add("modified_life", dimension::ratio, "L10m = a_1 a_ISO L10, revolutions", lives.modified);
  add("modified_reference_life", dimension::ratio, "L10mr, revolutions", lives.modified_reference.bearing);
  add("life", dimension::ratio, "by Lundberg and Palmgren, revolutions", study.lundberg_palmgren.bearing);
}

void describe_displacement(Record& record, const StaticStudy& study) {
  record.value("radial_um", dimension::small_length, "inner ring along the radial load", study.radial)
      .variable = "radial_displacement";
  record.value("axial_um", dimension::small_length, "inner ring along the axis", study.axial).variable =
      "axial_displacement";
}

void describe_race(Record& record, const bearing::PointContact& contact) {
  record.value("curvature_sum_per_mm", dimension::curvature, "of both bodies", contact.curvature.sum);
  record.value("curvature_difference", dimension::ratio, "F(rho)", contact.curvature.difference);
  record.value("axis_ratio", dimension::ratio, "of the ellipse", contact.ellipse.axis_ratio);
  record.value("elliptic_K", dimension::ratio, "first complete integral", contact.ellipse.first);
  record.value("elliptic_E", dimension::ratio, "second complete integral", contact.ellipse.second);
}

// Constants of contacts have units of their own: N/mm^(10/9) and N/mm^(3/2).
constexpr double kPerMetre = 1e3;  // [mm/m]

}  // namespace

LifeTable StaticStudy::life_table() const {
  using bearing::rating::RollingElement;
  return {value_by_name(all_lives()),
          {has_balls(*this) ? RollingElement::ball : RollingElement::roller, reduction_factor}};
}

double largest_load(const StaticStudy& study) {
  const double inner = study.contact_load.maxCoeff();
  return study.outer_load.size() > 0 ? std::max(inner, study.outer_load.maxCoeff()) : inner;
}

void describe(Record& record, const RollerSteps& rollers) {
  constexpr described::Dimension line_constant{"contact constant", "1", "N/mm^(10/9)", ""};
  record.value("c_L_N_per_mm_10_9", line_constant, "of both contacts in series",
               rollers.constant * std::pow(kPerMetre, -bearing::kLineExponent));
  record.array("lamina_places_mm", dimension::length, "from the middle", {"lamina"}, rollers.lamina_position);
  record.array("drops_um", dimension::small_length, "of both contacts: 2 P(x_k)", {"lamina"}, rollers.drop);
  record.array("element_tilts_mrad", dimension::small_angle, "of the races against each other", {"element"},
               rollers.tilt);
  record.array("stress_riser", dimension::ratio, "f_k", {"lamina"}, rollers.stress_riser);
  record.array("lamina_capacities_N", dimension::force, "of each race", {{"race", {"inner", "outer"}}},
               std::array{rollers.inner_lamina_capacity, rollers.outer_lamina_capacity});
}

void describe(Record& record, const BallSteps& balls) {
  constexpr described::Dimension point_constant{"contact constant", "1", "N/mm^(3/2)", ""};
  record.child("inner_contact", "of a ball on the inner race", balls.inner, describe_race);
  record.child("outer_contact", "of a ball on the outer race", balls.outer, describe_race);
  record.value("c_P_N_per_mm_3_2", point_constant, "of both contacts in series",
               balls.constant * std::pow(kPerMetre, -1.5));
  record.value("groove_distance_mm", dimension::length, "A", balls.groove_distance);
  record.value("tilt_radius_mm", dimension::length, "R_i", balls.tilt_radius);
  record.value("free_angle_deg", dimension::angle, "contact angle without load", balls.free_angle);
}

void describe(Record& record, const StaticSteps& steps) {
  record.value("gamma", dimension::ratio, "D cos(alpha)/d_m", steps.gamma);
  if (steps.rollers) describe(record, *steps.rollers);
  if (steps.balls) describe(record, *steps.balls);
  record.child("ring", "displacement of the inner ring", steps, [](Record& ring, const StaticSteps& of) {
    ring.value("radial_um", dimension::small_length, "along the radial load", of.radial);
    ring.value("lateral_um", dimension::small_length, "across it", of.lateral);
    ring.value("axial_um", dimension::small_length, "along the axis", of.axial);
    ring.value("tilt_mrad", dimension::small_angle, "in the plane of the load", of.tilt);
    ring.value("lateral_tilt_mrad", dimension::small_angle, "in that across it", of.lateral_tilt);
    ring.value("moment_across_N_m", dimension::torque, "in that plane", of.lateral_moment);
  });
  record.array("element_angles_deg", dimension::angle, "from the radial load", {"element"}, steps.angle);
  record.array("approaches_um", dimension::small_length, "negative: clearance of the rings", {"element"},
               steps.approach);
  record.child(
      "equivalent_loads_N", "of each lamina, of balls one", steps, [](Record& loads, const StaticSteps& of) {
        loads.array("inner", dimension::force, "on the inner race", {"equivalent"}, of.inner_equivalent);
        loads.array("outer", dimension::force, "on the outer race", {"equivalent"}, of.outer_equivalent);
      });
}

void describe(Record& record, const StaticStudy& study) {
  record.child("displacement", "from the concentric position", study, describe_displacement).variable = "";
  record.value("tilt_mrad", dimension::small_angle, "inner ring in the plane of the load", study.tilt);
  record.value("contact_load_max_N", dimension::force, "largest of both races", largest_load(study));
  record
      .array("contact_loads_N", dimension::force,
             "load of each rolling element, the first at bearing.first_element_angle from the load line",
             {"element"}, study.contact_load)
      .variable = "contact_load";
  describe(record, study.all_lives());
  record.entry("life_h").variable = "life_hours";  // `life` is that in revolutions
  record.value("moment_N_m", dimension::torque, "on the inner ring in the plane of the load", study.moment);
  record.value("pressure_max_MPa", dimension::pressure, "after Hertz", study.largest_pressure).variable =
      "largest_pressure";
  record.value("equivalent_load_N", dimension::force, "P of ISO 281", study.lives.dynamic_load);
  record.child("ratings", "by the standards", study.ratings, describe_ratings);
  record.child("factors", "of the modified lives", study.lives, describe_factors).detail = true;
  record.child("reference_life", "by ISO/TS 16281", study.lives.reference, describe_life).detail = true;
  record
      .child("modified_reference_life", "by ISO/TS 16281 with a_ISO", study.lives.modified_reference,
             describe_life)
      .detail = true;
  record.child("life_table", "comparison of lives", study.life_table()).detail = true;
  if (study.steps)
    record.child("steps", "between the bearing and its reference life", *study.steps).detail = true;
  record.array("stiffness", {}, "of the inner ring: x, y, z, tilt about x, tilt about y; SI",
               {"freedom", "freedom_beside"}, study.stiffness);
  if (study.passing)
    record.child("defect_frequencies", "at pure rolling, by their names in condition monitoring",
                 *study.passing);
  if (study.rolling_friction) record.child("friction", "at pure rolling, by cause", *study.rolling_friction);
  if (study.friction_by_standards)
    record.child("friction_by_standards", "by formulas of others", *study.friction_by_standards);
  describe_elements(record, study);
  describe_races(record, study);
  describe_for_files(record, study);
}

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
    throw BadInput(
        fmt::format("{}: {}: an oil for rings that do not rotate; operation.shaft_speed is required, from "
                    "which the viscosity ratio follows",
                    in.origin(path), path));
  }
  const rating::OilCondition oil =
      rating::oil_condition(*stated, relative_speed(in), in.quantity("bearing.pitch_diameter"));
  if (oil.viscosity_ratio >= rating::kLeastViscosityRatio) return oil;
  throw BadInput(fmt::format(
      "{}: lubricant.kinematic_viscosity: viscosity ratio kappa: found {:.3g}; required: at "
      "least {:g}, where a_ISO begins",
      in.origin("lubricant.kinematic_viscosity"), oil.viscosity_ratio, rating::kLeastViscosityRatio));
}

rating::ElementLoads loads_on(bearing::Race race, const StaticStudy& study) {
  const bool own = race == bearing::Race::outer && study.outer_load.size() > 0;
  return {own ? study.outer_load : study.contact_load, study.lamina_load};
}

// Of rollers by the capacities of Lundberg and Palmgren, lamina by lamina; of balls those of [ISO16281] are
// theirs.
bearing::BearingLife lundberg_palmgren(const bearing::Bearing& bearing, const StaticStudy& study) {
  if (!bearing.has_rollers()) return study.lives.reference;
  return bearing::life::lamina_life(
      bearing::life::lamina_rating(bearing, bearing::life::LifeMeasure::lundberg_palmgren,
                                   study.reduction_factor),
      study.lamina_load, study.lamina_load);
}

// Shoulders are not stated; one at 70 degrees is a third of a ball's diameter high.
void warn_of_steep_contacts(StaticStudy& study) {
  if (study.contact_angle.size() == 0) return;
  constexpr double degree = constants::degree, normal_end = 70.0 * degree;
  const Eigen::ArrayXd loaded_angle = (study.contact_load > 0.0).select(study.contact_angle.abs(), 0.0);
  const auto beyond = (loaded_angle > normal_end).count();
  if (beyond == 0) return;
  study.warnings.push_back(
      fmt::format("load: {} of {} balls touch the inner race at more than 70 degrees (up to {:.1f}), beyond "
                  "the end of a typical groove. The equilibrium assumes grooves up to 90 degrees",
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
          fmt::format("stiffness: nothing holds the ring along {}: its position there is not determined, and "
                      "the matrix is singular",
                      "xyz"[axis]));
}

// P and P0 of ISO 281 and ISO 76 are by factors X and Y of grooves up to these radii.
void warn_of_open_grooves(const ResolvedCase& in, StaticStudy& study) {
  constexpr double inner_limit = 0.52, outer_limit = 0.53;  // groove radius over ball diameter
  if (!in.has("bearing.inner_osculation")) return;
  const double inner = in.number("bearing.inner_osculation"), outer = in.number("bearing.outer_osculation");
  if (inner <= inner_limit && outer <= outer_limit) return;
  study.warnings.push_back(fmt::format(
      "bearing.inner_osculation, bearing.outer_osculation: {:.4g} and {:.4g}; the factors X and Y of ISO "
      "281 hold for at most {:.2f} and {:.2f}, as rolling bearings have: prefer L10r to L10",
      inner, outer, inner_limit, outer_limit));
}

void warn(const ResolvedCase& in, StaticStudy& study) {
  const rating::Ratings& ratings = study.ratings;
  for (std::string& text : oil_warnings(in)) study.warnings.push_back(std::move(text));
  warn_of_open_grooves(in, study);
  if (ratings.gamma > ratings.slenderness_limit && !in.has("bearing.dynamic_capacity"))
    study.warnings.push_back(fmt::format(
        "bearing: D cos(alpha)/d_m is {:.3g}; the table of f_c in ISO 281 ends at {:.2g}: its formula is "
        "used beyond",
        ratings.gamma, ratings.slenderness_limit));
  if (std::isnan(study.lives.dynamic_load))
    study.warnings.push_back(
        "L10: ISO 281 has factors X and Y for nominal contact angles of 0, 15, 20, 25, 30, 35, 40 and 45 "
        "degrees; L10r does not require them");
  if (in.model() == roller_bearing && !in.has("bearing.laminae"))
    study.warnings.push_back(fmt::format(
        "bearing.laminae: not given; {} are used, and lives depend on their number", default_laminae));
  if (study.lamina_load.rows() > 0 && study.lamina_load.rows() < 30)
    study.warnings.push_back(
        fmt::format("bearing.laminae: {} laminae; ISO/TS 16281 requires at least 30, and its stress riser "
                    "depends on their number",
                    study.lamina_load.rows()));
  constexpr double slipping = 0.1;  // of lubricated steel
  if (study.friction > slipping)
    study.warnings.push_back(
        fmt::format("operation: the gyroscopic moment of a ball requires a friction coefficient of {:.2g} on "
                    "a race. The ball will slip, which the equilibrium does not include",
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

namespace {

// Puts all lives into a study whose loads and ratings are known, and warns where the standard's ranges are
// left.
void rate(const ResolvedCase& in, const bearing::Bearing& bearing, StaticStudy& study) {
  study.speed = relative_speed(in);
  if (bearing.has_rollers()) study.reduction_factor = in.number("life.reduction_factor");
  study.lives = rating::rating_lives(rating::bearing_rating(bearing, stated_ratings_of(in)),
                                     rating_condition_of(in, bearing), loads_on(bearing::Race::inner, study),
                                     loads_on(bearing::Race::outer, study));
  study.lundberg_palmgren = lundberg_palmgren(bearing, study);
  warn(in, study);
}

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
  const rating::RatingLives lives = rating::rating_lives(
      rating::bearing_rating(bearing, stated_ratings_of(in)), condition, nothing, nothing);
  const double speed = relative_speed(in), million = 1e-6;
  rows.push_back({"life.equivalent_load", lives.dynamic_load, "N", "P of ISO 281"});
  rows.push_back({"life.load_ratio", lives.load_ratio(), "1", "C/P"});
  if (condition.static_load)
    rows.push_back({"life.static_safety", lives.static_safety(), "1", "S_0 = C_0/P_0 of ISO 76"});
  rows.push_back({"life.L10", million * lives.basic, "Mrev", "basic rating life of ISO 281"});
  if (speed != 0.0)
    rows.push_back(
        {"life.L10h", bearing::hours(lives.basic, speed), "h", "the same at the speed of the rings"});
  if (!lives.oil) return;
  rows.push_back({"life.kappa", lives.oil->viscosity_ratio, "1", "viscosity ratio of ISO 281"});
  rows.push_back({"life.e_C", lives.oil->contamination_factor, "1", "contamination factor of ISO 281"});
  rows.push_back(
      {"life.a_ISO", lives.life_modification, "1", "life modification factor of ISO 281, by C_u/P"});
  rows.push_back(
      {"life.L10m", million * lives.modified, "Mrev", "modified rating life of ISO 281: a_1 a_ISO L10"});
  if (speed != 0.0)
    rows.push_back(
        {"life.L10mh", bearing::hours(lives.modified, speed), "h", "the same at the speed of the rings"});
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

namespace {

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

struct StepsOf {
  const bearing::Bearing& bearing;
  const rating::Ratings& ratings;
  const equilibrium::RingState& state;
  StaticSteps& steps;

  void operator()(const equilibrium::RollerRow& row) const {
    const equilibrium::RingPosition position = equilibrium::position_of(state, row.lever());
    const auto& contact = row.contact();
    const int laminae = contact.laminae();
    RollerSteps rollers{.constant = contact.constant(),
                        .lamina_position = row.lever() * contact.positions(),
                        .drop = contact.drops(),
                        .tilt = steps.angle,
                        .stress_riser = rating::stress_riser(laminae),
                        .inner_lamina_capacity = rating::lamina_capacity(ratings.contacts.inner, laminae),
                        .outer_lamina_capacity = rating::lamina_capacity(ratings.contacts.outer, laminae)};
    for (Eigen::Index j = 0; j < steps.angle.size(); ++j) {
      const Eigen::Vector2d at = row.coordinates(j, position);
      steps.approach[j] = at[0];
      rollers.tilt[j] = -std::atan(at[1] / row.lever());
    }
    const Eigen::ArrayXXd stressed = rating::with_stress_riser(state.lamina_load);
    steps.inner_equivalent = rating::equivalent_lamina_loads(stressed, bearing.motions.inner);
    steps.outer_equivalent = rating::equivalent_lamina_loads(stressed, bearing.motions.outer);
    steps.rollers = std::move(rollers);
  }

  void operator()(const equilibrium::BallRow& row) const {
    const equilibrium::RingPosition position = equilibrium::position_of(state, row.lever());
    for (Eigen::Index j = 0; j < steps.angle.size(); ++j)
      steps.approach[j] = row.position_of(j, position).approach;
    const auto equivalent = [&](bearing::RaceMotion motion) {
      return Eigen::ArrayXd::Constant(1, rating::equivalent_ball_load(state.contact_load, motion)).eval();
    };
    steps.inner_equivalent = equivalent(bearing.motions.inner);
    steps.outer_equivalent = equivalent(bearing.motions.outer);
    steps.balls = BallSteps{.inner = row.contact(bearing::Race::inner),
                            .outer = row.contact(bearing::Race::outer),
                            .constant = row.constant(),
                            .groove_distance = row.groove_distance(),
                            .tilt_radius = row.lever(),
                            .free_angle = row.free_angle()};
  }
};

// Of a state that a search without motion of the balls has found; none where balls turn, whose races bear
// unlike loads.
std::optional<StaticSteps> static_steps(const bearing::Bearing& bearing, const rating::Ratings& ratings,
                                        const equilibrium::RingState& state) {
  if (state.outer_load.size() > 0) return {};
  StaticSteps steps{.gamma = ratings.gamma,
                    .radial = state.radial,
                    .lateral = state.lateral,
                    .axial = state.axial,
                    .tilt = state.tilt,
                    .lateral_tilt = state.lateral_tilt,
                    .lateral_moment = state.lateral_moment,
                    .angle = equilibrium::element_angles(bearing),
                    .approach = Eigen::ArrayXd::Zero(bearing.element_count())};
  const StepsOf put{bearing, ratings, state, steps};
  bearing.has_rollers() ? put(equilibrium::RollerRow(bearing)) : put(equilibrium::BallRow(bearing));
  return steps;
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
  if (study.speed != 0.0)
    study.passing = bearing::defect::passing_frequencies(bearing, in.quantity("operation.shaft_speed"),
                                                         in.quantity("operation.outer_speed"));
  if (motion.film && state.inner_rolling.size() > 0) {
    study.films = ball_films(bearing, *motion.film, state);
    for (const std::string& warning : film_warnings(bearing, *study.films)) study.warnings.push_back(warning);
  }
  study.rolling_friction = friction_study(in, bearing, state);
  if (study.rolling_friction && study.rolling_friction->oil_temperature)
    study.warnings.push_back(
        fmt::format("the friction heats the oil to {:.0f} degC; lives and kappa keep the stated viscosity",
                    *study.rolling_friction->oil_temperature));
  if (study.rolling_friction)
    study.friction_by_standards = friction_by_standards(
        in, {.speed = study.rolling_friction->speed,
             .torque = study.rolling_friction->torque(),
             .rolling = study.rolling_friction->loss.rolling / study.rolling_friction->speed,
             .isothermal = study.rolling_friction->loss.isothermal_rolling / study.rolling_friction->speed,
             .viscosity = study.rolling_friction->viscosity,
             .static_capacity = study.ratings.static_capacity});
  study.over_speed = speed_table(in);
  if (study.over_speed)
    for (const std::string& warning : study.over_speed->warnings) study.warnings.push_back(warning);
  return study;
}

}  // namespace orbearing::app
