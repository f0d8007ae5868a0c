#include "app/study/static_result.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bearing/contact/line_law.hpp"

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
  record.value("kappa", dimension::ratio, "viscosity ratio", lives.oil->viscosity_ratio);
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
  record.array("approaches_um", dimension::small_length, "negative where the rings leave play", {"element"},
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
  record.child("life_table", "lives side by side", study.life_table()).detail = true;
  if (study.steps)
    record.child("steps", "between the bearing and its reference life", *study.steps).detail = true;
  record.array("stiffness", {}, "of the inner ring: x, y, z, tilt about x, tilt about y; SI",
               {"freedom", "freedom_beside"}, study.stiffness);
  describe_elements(record, study);
  describe_races(record, study);
  describe_for_files(record, study);
}

}  // namespace orbearing::app
