#include "coupling/analysis/bearing_under_load.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace {

using described::Record;
using mechanics::significant;
namespace dimension = described::dimension;

namespace equilibrium = bearing::equilibrium;
namespace rating = bearing::rating;
using bearing::Race;

// Races of balls in motion carry different loads.
bool balls_move(const equilibrium::RingState& state) {
  return state.outer_load.size() > 0;
}

const Eigen::ArrayXd& load_on(Race race, const BearingUnderLoad& study) {
  const equilibrium::RingState& state = study.state;
  return race == Race::outer && balls_move(state) ? state.outer_load : state.contact_load;
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

void describe_elements(Record& record, const BearingUnderLoad& study) {
  const equilibrium::RingState& state = study.state;
  const auto of_elements = [&](const char* name, const described::Dimension& of, const char* meaning,
                               const Eigen::ArrayXd& values) -> described::Entry& {
    return record.array(name, of, meaning, {"element"}, values);
  };
  if (balls_move(state)) {
    of_elements("outer_contact_loads_N", dimension::force, "of each ball on the outer race", state.outer_load)
        .variable = "outer_contact_load";
    of_elements("outer_contact_angles_deg", dimension::angle, "of each ball on the outer race",
                state.outer_angle);
    record.value("gyroscopic_friction", dimension::ratio, "traction over load that holds the balls, at most",
                 state.friction);
  }
  if (study.films) record.table("film", "film", "under each loaded ball", *study.films);
  if (study.over_speed) describe(record, *study.over_speed);
  record.child("lundberg_palmgren", "life by Lundberg and Palmgren", study.lundberg_palmgren, describe_life)
      .detail = true;
  if (state.contact_angle.size() > 0)
    of_elements("contact_angles_deg", dimension::angle, "of each ball on the inner race",
                state.contact_angle);
  if (state.lamina_load.size() > 0)
    record
        .array("lamina_loads_N", dimension::force, "load of each lamina of each roller",
               {"element", "lamina"}, state.lamina_load.transpose().eval())
        .variable = "lamina_load";
}

// Values of each race that have columns in the table of a sweep.
void describe_races(Record& record, const BearingUnderLoad& study) {
  const auto of_race = [&](const std::string& race, const Eigen::ArrayXd& loads, double life) {
    record.value(race + "_load_max_N", dimension::force, "largest load of an element", loads.maxCoeff())
        .detail = true;
    record
        .value(race + "_load_rms_N", dimension::force, "root mean square over the elements",
               std::sqrt(loads.square().mean()))
        .detail = true;
    record.value(race + "_life_Mrev", dimension::revolutions, "by Lundberg and Palmgren", life).detail = true;
  };
  of_race("inner", load_on(Race::inner, study), study.lundberg_palmgren.inner);
  of_race("outer", load_on(Race::outer, study), study.lundberg_palmgren.outer);
}

// Under the names that files of arrays have had.
void describe_for_files(Record& record, const BearingUnderLoad& study) {
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

void describe_displacement(Record& record, const BearingUnderLoad& study) {
  record.value("radial_um", dimension::small_length, "inner ring along the radial load", study.radial)
      .variable = "radial_displacement";
  record.value("axial_um", dimension::small_length, "inner ring along the axis", study.state.axial).variable =
      "axial_displacement";
}

void describe_race(Record& record, const bearing::PointContact& contact) {
  record.value("curvature_sum_per_mm", dimension::curvature, "of both bodies", contact.curvature.sum);
  record.value("curvature_difference", dimension::ratio, "F(rho)", contact.curvature.difference);
  record.value("axis_ratio", dimension::ratio, "of the ellipse", contact.ellipse.axis_ratio);
  record.value("elliptic_K", dimension::ratio, "first complete integral", contact.ellipse.first);
  record.value("elliptic_E", dimension::ratio, "second complete integral", contact.ellipse.second);
}

// The numbers between a bearing and its reference rating life, [ISO16281]: what anyone who computes the same
// by another program compares step by step (cases/iso16281_worked_set).

// Constants of contacts have units of their own: N/mm^(10/9) and N/mm^(3/2).
constexpr double kPerMetre = 1e3;  // [mm/m]

// Values of both kinds of elements.
struct ElementSteps {
  Eigen::ArrayXd approach;  // [m]  (elements)
  Eigen::ArrayXd inner_equivalent,
      outer_equivalent;  // [N]  (laminae), the stress riser in them; of balls one
};

// Rollers cut into laminae: Eq. (6) of bearing/equilibrium/README.md, Eqs. (4) and (5) of
// bearing/life/README.md.
ElementSteps describe_row(Record& record, const BearingUnderLoad& study, const equilibrium::RollerRow& row) {
  constexpr described::Dimension line_constant{"contact constant", "1", "N/mm^(10/9)", ""};
  const equilibrium::RingPosition position = equilibrium::position_of(study.state, row.lever());
  const auto& contact = row.contact();
  const int laminae = contact.laminae();
  const Eigen::Index rollers = study.state.contact_load.size();
  Eigen::ArrayXd approach(rollers), tilt(rollers);
  for (Eigen::Index j = 0; j < rollers; ++j) {
    const Eigen::Vector2d at = row.coordinates(j, position);
    approach[j] = at[0];
    tilt[j] = -std::atan(at[1] / row.lever());
  }
  record.value("c_L_N_per_mm_10_9", line_constant, "of both contacts in series",
               contact.whole().constant() * std::pow(kPerMetre, -bearing::LineLaw::kExponent));
  record.array("lamina_places_mm", dimension::length, "from the middle", {"lamina"},
               (row.lever() * contact.positions()).eval());
  record.array("drops_um", dimension::small_length, "of both contacts: 2 P(x_k)", {"lamina"},
               contact.drops());
  record.array("element_tilts_mrad", dimension::small_angle, "of the races against each other", {"element"},
               tilt);
  record.array("stress_riser", dimension::ratio, "f_k", {"lamina"},
               rating::stress_riser(laminae, study.stress_riser));
  record.array("lamina_capacities_N", dimension::force, "of each race", {{"race", {"inner", "outer"}}},
               std::array{rating::lamina_capacity(study.ratings.contacts.inner, laminae),
                          rating::lamina_capacity(study.ratings.contacts.outer, laminae)});
  const Eigen::ArrayXXd stressed = rating::with_stress_riser(study.state.lamina_load, study.stress_riser);
  const auto& motions = study.bearing.motions;
  return {approach, rating::equivalent_lamina_loads(stressed, motions.inner),
          rating::equivalent_lamina_loads(stressed, motions.outer)};
}

// Balls: Eqs. (7) and (8) of bearing/equilibrium/README.md.
ElementSteps describe_row(Record& record, const BearingUnderLoad& study, const equilibrium::BallRow& row) {
  constexpr described::Dimension point_constant{"contact constant", "1", "N/mm^(3/2)", ""};
  const equilibrium::RingPosition position = equilibrium::position_of(study.state, row.lever());
  record.child("inner_contact", "of a ball on the inner race", row.contact(Race::inner), describe_race);
  record.child("outer_contact", "of a ball on the outer race", row.contact(Race::outer), describe_race);
  record.value("c_P_N_per_mm_3_2", point_constant, "of both contacts in series",
               row.constant() * std::pow(kPerMetre, -1.5));
  record.value("groove_distance_mm", dimension::length, "A", row.groove_distance());
  record.value("tilt_radius_mm", dimension::length, "R_i", row.lever());
  record.value("free_angle_deg", dimension::angle, "contact angle without load", row.free_angle());
  const Eigen::ArrayXd& load = study.state.contact_load;
  const auto& motions = study.bearing.motions;
  ElementSteps steps{Eigen::ArrayXd(load.size()),
                     Eigen::ArrayXd::Constant(1, rating::equivalent_ball_load(load, motions.inner)),
                     Eigen::ArrayXd::Constant(1, rating::equivalent_ball_load(load, motions.outer))};
  for (Eigen::Index j = 0; j < load.size(); ++j) steps.approach[j] = row.position_of(j, position).approach;
  return steps;
}

void describe_steps(Record& record, const BearingUnderLoad& study) {
  record.value("gamma", dimension::ratio, "D cos(alpha)/d_m", study.ratings.gamma);
  const ElementSteps steps = study.bearing.has_rollers()
                                 ? describe_row(record, study, equilibrium::RollerRow(study.bearing))
                                 : describe_row(record, study, equilibrium::BallRow(study.bearing));
  record.child("ring", "displacement of the inner ring", study.state,
               [](Record& ring, const equilibrium::RingState& of) {
                 ring.value("radial_um", dimension::small_length, "along the radial load", of.radial);
                 ring.value("lateral_um", dimension::small_length, "across it", of.lateral);
                 ring.value("axial_um", dimension::small_length, "along the axis", of.axial);
                 ring.value("tilt_mrad", dimension::small_angle, "in the plane of the load", of.tilt);
                 ring.value("lateral_tilt_mrad", dimension::small_angle, "in that across it",
                            of.lateral_tilt);
                 ring.value("moment_across_N_m", dimension::torque, "in that plane", of.lateral_moment);
               });
  record.array("element_angles_deg", dimension::angle, "from the radial load", {"element"},
               equilibrium::element_angles(study.bearing));
  record.array("approaches_um", dimension::small_length, "negative: clearance of the rings", {"element"},
               steps.approach);
  record.child(
      "equivalent_loads_N", "of each lamina, of balls one", steps, [](Record& loads, const ElementSteps& of) {
        loads.array("inner", dimension::force, "on the inner race", {"equivalent"}, of.inner_equivalent);
        loads.array("outer", dimension::force, "on the outer race", {"equivalent"}, of.outer_equivalent);
      });
}

}  // namespace

LifeTable BearingUnderLoad::life_table() const {
  using rating::RollingElement;
  return {
      value_by_name(all_lives()),
      {bearing.has_rollers() ? RollingElement::roller : RollingElement::ball, reduction_factor, governing}};
}

void describe(Record& record, const BearingUnderLoad& study) {
  record.child("displacement", "from the concentric position", study, describe_displacement).variable = "";
  record.value("tilt_mrad", dimension::small_angle, "inner ring in the plane of the load", study.tilt);
  record.value("contact_load_max_N", dimension::force, "largest of both races",
               std::max(study.state.contact_load.maxCoeff(), load_on(Race::outer, study).maxCoeff()));
  record
      .array("contact_loads_N", dimension::force,
             "load of each rolling element, the first at bearing.first_element_angle from the load line",
             {"element"}, study.state.contact_load)
      .variable = "contact_load";
  describe(record, study.all_lives());
  record.entry("life_h").variable = "life_hours";  // `life` is that in revolutions
  record.value("moment_N_m", dimension::torque, "on the inner ring in the plane of the load",
               study.state.moment);
  record.value("pressure_max_MPa", dimension::pressure, "after Hertz", study.state.largest_pressure)
      .variable = "largest_pressure";
  record.value("equivalent_load_N", dimension::force,
               study.bearing.contact_angle() > 0.0
                   ? "P of ISO 281, by X and Y of one row; a pair that its maker rates has others"
                   : "P of ISO 281",
               study.lives.dynamic_load);
  record.child("ratings", "by the standards", study.ratings, describe_ratings);
  record.child("factors", "of the modified lives", study.lives, describe_factors).detail = true;
  record.child("reference_life", "by ISO/TS 16281", study.lives.reference, describe_life).detail = true;
  record
      .child("modified_reference_life", "by ISO/TS 16281 with a_ISO", study.lives.modified_reference,
             describe_life)
      .detail = true;
  record.child("life_table", "comparison of lives", study.life_table()).detail = true;
  if (!study.over_positions.empty())
    record.table("over_cage_positions", "range",
                 "least and greatest over the positions of the cage in a pitch; results are those at "
                 "bearing.first_element_angle",
                 study.over_positions, [](Record& row, const PositionRange& range) {
                   row.value("result", "its key", range.result);
                   row.value("least", {}, "in the unit that the key ends in", range.least);
                   row.value("most", {}, "the same", range.most);
                 });
  if (!balls_move(study.state))
    record.child("steps", "between the bearing and its reference life", study, describe_steps).detail = true;
  record.array("stiffness", {}, "of the inner ring: x, y, z, tilt about x, tilt about y; SI",
               {"freedom", "freedom_beside"}, equilibrium::stiffness_by_axes(study.state));
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

// Life by Lundberg and Palmgren: for rollers from their capacities, lamina by lamina; for balls the life of
// [ISO16281], which uses the same capacities.
bearing::BearingLife lundberg_palmgren(const BearingUnderLoad& study) {
  if (!study.bearing.has_rollers()) return study.lives.reference;
  return bearing::life::lamina_life(bearing::life::lamina_rating(study.bearing, study.reduction_factor),
                                    study.state.lamina_load, study.state.lamina_load);
}

// Shoulders are not stated; one at 70 degrees is a third of a ball's diameter high.
void warn_of_steep_contacts(BearingUnderLoad& study) {
  const equilibrium::RingState& state = study.state;
  if (state.contact_angle.size() == 0) return;
  constexpr double degree = constants::degree, normal_end = 70.0 * degree;
  const Eigen::ArrayXd loaded_angle = (state.contact_load > 0.0).select(state.contact_angle.abs(), 0.0);
  const auto beyond = (loaded_angle > normal_end).count();
  if (beyond == 0) return;
  study.warnings.push_back(
      "load: " + std::to_string(beyond) + " of " + std::to_string(loaded_angle.size()) +
      " balls touch the inner race at more than 70 degrees (up to " +
      mechanics::with_decimals(loaded_angle.maxCoeff() / degree, 1) +
      "), beyond the end of a typical groove. The equilibrium assumes grooves up to 90 degrees");
}

// One loaded element does not hold the ring across its line. Cylindrical rollers never hold it along the
// axis.
void warn_of_loose_rings(BearingUnderLoad& study) {
  const Eigen::Vector3d held = study.state.stiffness.diagonal().head<3>();
  constexpr double nothing = 1e-9;
  const int axes = study.bearing.has_rollers() ? 2 : 3;
  for (int axis = 0; axis < axes; ++axis)
    if (held[axis] < nothing * held.maxCoeff())
      study.warnings.push_back(std::string("stiffness: nothing holds the ring along ") + "xyz"[axis] +
                               ": its position there is not determined, and the matrix is singular");
}

// P and P0 of ISO 281 and ISO 76 are by factors X and Y of grooves up to these radii.
void warn_of_open_grooves(BearingUnderLoad& study) {
  constexpr double inner_limit = 0.52, outer_limit = 0.53;  // groove radius over ball diameter
  if (study.bearing.has_rollers()) return;
  const double inner = study.bearing.inner.osculation, outer = study.bearing.outer.osculation;
  if (inner <= inner_limit && outer <= outer_limit) return;
  study.warnings.push_back(
      "bearing.inner_osculation, bearing.outer_osculation: " + significant(inner, 4) + " and " +
      significant(outer, 4) + "; the factors X and Y of ISO 281 hold for at most " +
      mechanics::with_decimals(inner_limit, 2) + " and " + mechanics::with_decimals(outer_limit, 2) +
      ", as rolling bearings have: prefer L10r to L10");
}

void warn(const StatedCapacities& stated, BearingUnderLoad& study) {
  const rating::Ratings& ratings = study.ratings;
  warn_of_open_grooves(study);
  if (ratings.gamma > ratings.slenderness_limit && !stated.dynamic_capacity)
    study.warnings.push_back("bearing: D cos(alpha)/d_m is " + significant(ratings.gamma, 3) +
                             "; the table of f_c in ISO 281 ends at " +
                             significant(ratings.slenderness_limit, 2) + ": its formula is used beyond");
  if (std::isnan(study.lives.dynamic_load))
    study.warnings.emplace_back(
        "L10: ISO 281 has factors X and Y for nominal contact angles of 0, 15, 20, 25, 30, 35, 40 and 45 "
        "degrees; L10r does not require them");
  if (study.bearing.has_rollers() &&
      rating::has_too_few_laminae(study.bearing, rating::StressRiser::position))
    study.warnings.push_back("bearing.laminae: " + std::to_string(study.bearing.rollers().laminae) +
                             " laminae of straight rollers; " +
                             (study.stress_riser == rating::StressRiser::position
                                  ? "L10r and L10mr are left out, for which "
                                  : "") +
                             "ISO/TS 16281 requires at least " + std::to_string(rating::kLeastRatedLaminae));
  constexpr double slipping = 0.1;  // of lubricated steel
  if (study.state.friction > slipping)
    study.warnings.push_back(
        "operation: the gyroscopic moment of a ball requires a friction coefficient of " +
        significant(study.state.friction, 2) +
        " on a race. The ball will slip, which the equilibrium does not include");
  warn_of_steep_contacts(study);
  warn_of_loose_rings(study);
}

// Puts all lives into a result whose loads and ratings are known, and warns where the standard's ranges are
// left.
void rate(const LoadedBearing& in, const rating::StatedRatings& stated, BearingUnderLoad& study) {
  const bearing::Bearing& bearing = study.bearing;
  study.speed = in.rotation.relative();
  if (bearing.has_rollers()) study.reduction_factor = stated.reduction_factor.value();
  const auto loads_on = [&](Race race) -> rating::ElementLoads {
    return {load_on(race, study), study.state.lamina_load};
  };
  study.stress_riser = stated.stress_riser;
  study.governing = governing_life(in);
  study.lives = rating::rating_lives(rating::bearing_rating(bearing, stated), rating_condition(in),
                                     loads_on(Race::inner), loads_on(Race::outer));
  study.lundberg_palmgren = lundberg_palmgren(study);
  warn(in.capacities, study);
}

// Results that depend on the position of the cage, by their keys.
std::vector<std::pair<std::string, double>> results_by_position(const BearingUnderLoad& study) {
  const LifeValue lives = value_by_name(study.all_lives());
  std::vector<std::pair<std::string, double>> found{
      {"contact_load_max_N", study.state.contact_load.maxCoeff()}};
  for (const char* key : {"contact_pressure_max_MPa", "L10r_Mrev", "L10rh", "L10mrh", "life_h"})
    if (const double value = lives(key); std::isfinite(value)) found.emplace_back(key, value);
  return found;
}

// Rollers and balls pass the load: what is found with the first one where it is stated, beside other
// positions.
void put_ranges(const LoadedBearing& in, const rating::StatedRatings& stated,
                const equilibrium::RowMotion& motion, BearingUnderLoad& study) {
  constexpr int positions = 8;
  for (const auto& [key, value] : results_by_position(study))
    study.over_positions.push_back({key, value, value});
  for (int k = 1; k < positions; ++k) {
    BearingUnderLoad turned{.bearing = study.bearing, .state = {}, .ratings = study.ratings};
    turned.bearing.first_element += constants::two_pi / study.bearing.element_count() * k / positions;
    try {
      turned.state = balanced(turned.bearing, motion, in.load);
    } catch (const NoResult&) {  // no range without all positions
      study.over_positions.clear();
      return;
    }
    rate(in, stated, turned);
    const auto found = results_by_position(turned);
    for (std::size_t i = 0; i < found.size() && i < study.over_positions.size(); ++i) {
      PositionRange& range = study.over_positions[i];
      range.least = std::min(range.least, found[i].second);
      range.most = std::max(range.most, found[i].second);
    }
  }
}

// Resultant of both planes. Where load and elements are symmetric about the plane of the radial load, the
// component across it is zero, and the one along it keeps its sign.
double resultant(double along, double across, bool mirrored) {
  return mirrored ? along : std::hypot(along, across);
}

// Equilibrium, ratings and lives of either kind.
BearingUnderLoad under_load(const LoadedBearing& in, const rating::StatedRatings& stated,
                            const equilibrium::RowMotion& motion) {
  const bearing::Bearing bearing = rotating_bearing(in);
  BearingUnderLoad study{.bearing = bearing, .state = balanced(bearing, motion, in.load)};
  const equilibrium::RingState& state = study.state;
  const bool mirrored = in.load.moment_across == 0.0 && bearing.first_element == 0.0;
  study.radial = resultant(state.radial, state.lateral, mirrored);
  study.tilt = resultant(state.tilt, state.lateral_tilt, mirrored);
  study.ratings = rating::ratings_of(bearing, stated);
  rate(in, stated, study);
  if (study.speed != 0.0)
    study.passing =
        bearing::defect::passing_frequencies(bearing, in.rotation.shaft_speed, in.rotation.outer_speed);
  return study;
}

void put_friction(const LoadedBearing& in, std::optional<BearingFriction> friction, BearingUnderLoad& study) {
  study.rolling_friction = std::move(friction);
  if (!study.rolling_friction) return;
  if (study.rolling_friction->oil_temperature)
    study.warnings.push_back("the friction heats the oil to " +
                             mechanics::with_decimals(*study.rolling_friction->oil_temperature, 0) +
                             " degC; lives and kappa keep the stated viscosity");
  study.friction_by_standards =
      friction_by_standards(in, study.rolling_friction->ours(), study.ratings.static_capacity);
}

}  // namespace

BearingUnderLoad rollers_under_load(const RollersUnderLoad& in) {
  const rating::StatedRatings stated = stated_ratings(in);
  const equilibrium::RowMotion motion{.speeds = in.loaded.rotation.speeds()};
  BearingUnderLoad study = under_load(in.loaded, stated, motion);
  put_ranges(in.loaded, stated, motion, study);
  put_friction(in.loaded, rolling_friction(in, study.state), study);
  return study;
}

BearingUnderLoad balls_under_load(const BallsUnderLoad& in) {
  const rating::StatedRatings stated = in.loaded.capacities.ratings();
  const equilibrium::RowMotion motion = row_motion(in.loaded.rotation, in.balls, in.loaded.oil.lubricant);
  BearingUnderLoad study = under_load(in.loaded, stated, motion);
  if (motion.film && study.state.inner_rolling.size() > 0) {
    study.films = ball_films(study.bearing, *motion.film, study.state);
    for (std::string& warning : film_warnings(study.bearing, *study.films))
      study.warnings.push_back(std::move(warning));
  }
  put_ranges(in.loaded, stated, motion, study);
  put_friction(in.loaded, rolling_friction(in, study.state), study);
  study.over_speed = speed_table(in);
  if (study.over_speed)
    for (const std::string& warning : study.over_speed->warnings) study.warnings.push_back(warning);
  return study;
}

namespace {

// Lives that need the load on the bearing alone; none where P is not known.
BearingQuantities quantities(const LoadedBearing& in, const rating::StatedRatings& stated) {
  const bearing::Bearing bearing = rotating_bearing(in);
  BearingQuantities found{.ratings = rating::ratings_of(bearing, stated),
                          .stated = in.capacities,
                          .speed = in.rotation.relative()};
  const rating::RatingCondition condition = rating_condition(in);
  if (!condition.dynamic_load || !(*condition.dynamic_load > 0.0)) return found;
  const rating::ElementLoads nothing{Eigen::ArrayXd::Zero(1), Eigen::ArrayXXd::Zero(1, 1)};
  found.lives = rating::rating_lives(rating::bearing_rating(bearing, stated), condition, nothing, nothing);
  found.has_static_load = condition.static_load.has_value();
  return found;
}

void describe_lives_by_load(Record& record, const BearingQuantities& of) {
  const rating::RatingLives& lives = *of.lives;
  record.value("equivalent_load_N", dimension::force, "P of ISO 281", lives.dynamic_load);
  record.value("load_ratio", dimension::ratio, "C/P", lives.load_ratio());
  if (of.has_static_load)
    record.value("static_safety", dimension::ratio, "S_0 = C_0/P_0 of ISO 76", lives.static_safety());
  record.value("L10_Mrev", dimension::revolutions, "basic rating life of ISO 281", lives.basic);
  if (of.speed != 0.0)
    record.value("L10h", dimension::hours, "the same at the speed of the rings",
                 bearing::hours(lives.basic, of.speed));
  if (!lives.oil) return;
  record.value("kappa", dimension::ratio, "viscosity ratio of ISO 281", lives.oil->viscosity_ratio);
  record.value("e_C", dimension::ratio, "contamination factor of ISO 281", lives.oil->contamination_factor);
  record.value("a_ISO", dimension::ratio, "life modification factor of ISO 281, by C_u/P",
               lives.life_modification);
  record.value("L10m_Mrev", dimension::revolutions, "modified rating life of ISO 281: a_1 a_ISO L10",
               lives.modified);
  if (of.speed != 0.0)
    record.value("L10mh", dimension::hours, "the same at the speed of the rings",
                 bearing::hours(lives.modified, of.speed));
}

}  // namespace

void describe(Record& record, const BearingQuantities& of) {
  record.child("bearing", "of the bearing", of, [](Record& bearing, const BearingQuantities& found) {
    const rating::Ratings& ratings = found.ratings;
    bearing.value("slenderness", dimension::ratio, "D cos(alpha)/d_m", ratings.gamma);
    bearing.value("capacity_factor", dimension::ratio, "f_c of ISO 281, in N and mm",
                  ratings.capacity_factor);
    bearing.value("inner_contact_capacity_N", dimension::force, "of one rolling element, ISO/TS 16281",
                  ratings.contacts.inner);
    bearing.value("outer_contact_capacity_N", dimension::force, "of one rolling element, ISO/TS 16281",
                  ratings.contacts.outer);
    if (!found.stated.static_capacity)
      bearing.value("static_capacity_N", dimension::force, "C_0r of ISO 76", ratings.static_capacity);
    if (!found.stated.dynamic_capacity)
      bearing.value("dynamic_capacity_N", dimension::force, "C_r of ISO 281", ratings.dynamic_capacity);
    if (!found.stated.fatigue_load_limit)
      bearing.value("fatigue_load_limit_N", dimension::force, "C_u of ISO 281, by C_0r",
                    ratings.fatigue_load_limit);
    if (!found.groove_distance) return;
    bearing.value("groove_distance_mm", dimension::length, "A, of the groove centres", found.groove_distance);
    bearing.value("free_contact_angle_deg", dimension::angle, "without load", found.free_contact_angle);
  });
  if (of.lives) record.child("life", "by the load on the bearing", of, describe_lives_by_load);
}

BearingQuantities quantities_of(const RollerBearing& machine) {
  return quantities(machine.run.loaded, stated_ratings(machine.run));
}

BearingQuantities quantities_of(const BallBearing& machine) {
  const LoadedBearing& in = machine.run.loaded;
  BearingQuantities found = quantities(in, in.capacities.ratings());
  const equilibrium::BallRow row(in.bearing);
  found.groove_distance = row.groove_distance();
  found.free_contact_angle = row.free_angle();
  return found;
}

}  // namespace orbearing::analysis
