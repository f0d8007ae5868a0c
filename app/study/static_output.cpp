#include "app/study/static_output.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

#include "app/results/json_number.hpp"
#include "app/study/stiffness_output.hpp"
#include "app/units.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kMillion = 1e-6;  // of revolutions

Json list(const Eigen::Ref<const Eigen::ArrayXd>& values, double unit = 1.0) {
  Json array = Json::array();
  for (const double value : values) array.push_back(unit * value);
  return array;
}

// By roller, each a list over laminae.
Json by_roller(const Eigen::ArrayXXd& loads) {
  Json rollers = Json::array();
  for (Eigen::Index j = 0; j < loads.cols(); ++j) rollers.push_back(list(loads.col(j)));
  return rollers;
}

Json lives(const bearing::BearingLife& life) {
  return {{"inner_Mrev", number_or_null(kMillion * life.inner)},
          {"outer_Mrev", number_or_null(kMillion * life.outer)},
          {"bearing_Mrev", number_or_null(kMillion * life.bearing)}};
}

Json ratings_json(const bearing::rating::Ratings& ratings) {
  return {{"f_c", ratings.capacity_factor},
          {"C_r_N", ratings.dynamic_capacity},
          {"C_0r_N", ratings.static_capacity},
          {"C_u_N", ratings.fatigue_load_limit},
          {"inner_contact_N", ratings.contacts.inner},
          {"outer_contact_N", ratings.contacts.outer}};
}

Json factors_json(const bearing::rating::RatingLives& lives) {
  Json factors{{"a_1", lives.reliability_factor}, {"a_ISO", number_or_null(lives.life_modification)}};
  if (!lives.oil) return factors;
  factors["kappa"] = lives.oil->viscosity_ratio;
  factors["e_C"] = lives.oil->contamination_factor;
  return factors;
}

bool has_balls(const StaticStudy& study) {
  return study.contact_angle.size() > 0;
}

LifeWords words_of(const StaticStudy& study) {
  using bearing::rating::RollingElement;
  return {has_balls(study) ? RollingElement::ball : RollingElement::roller, study.reduction_factor};
}

std::string loads_of_elements(const StaticStudy& study) {
  std::string text = fmt::format("{:>8} {:>12}\n", "element", "load [N]");
  for (Eigen::Index j = 0; j < study.contact_load.size(); ++j)
    text += fmt::format("{:>8} {:>12.6g}\n", j, study.contact_load[j]);
  return text;
}

std::string loads_on_both_races(const StaticStudy& study) {
  std::string text = fmt::format("{:>8} {:>12} {:>12} {:>12} {:>12}\n", "ball", "inner [N]", "inner [deg]",
                                 "outer [N]", "outer [deg]");
  for (Eigen::Index j = 0; j < study.contact_load.size(); ++j)
    text +=
        fmt::format("{:>8} {:>12.6g} {:>12.4f} {:>12.6g} {:>12.4f}\n", j, study.contact_load[j],
                    kDegree * study.contact_angle[j], study.outer_load[j], kDegree * study.outer_angle[j]);
  return text;
}

}  // namespace

Json static_json(const StaticStudy& study) {
  Json object{{"displacement", {{"radial_um", 1e6 * study.radial}, {"axial_um", 1e6 * study.axial}}},
              {"tilt_mrad", 1e3 * study.tilt},
              {"contact_load_max_N", largest_load(study)},
              {"contact_loads_N", list(study.contact_load)}};
  for (const auto& [name, value] : life_values(study.all_lives())) object[name] = number_or_null(value);
  object.update(Json{{"moment_N_m", study.moment},
                     {"pressure_max_MPa", 1e-6 * study.largest_pressure},
                     {"equivalent_load_N", number_or_null(study.lives.dynamic_load)},
                     {"ratings", ratings_json(study.ratings)},
                     {"factors", factors_json(study.lives)},
                     {"reference_life", lives(study.lives.reference)},
                     {"modified_reference_life", lives(study.lives.modified_reference)}});
  object["life_table"] = lives_record(value_by_name(life_values(study.all_lives())), words_of(study));
  if (study.steps) object["steps"] = steps_json(*study.steps);
  object["stiffness"] = stiffness_json(study.stiffness);
  if (study.outer_load.size() > 0) {
    object["outer_contact_loads_N"] = list(study.outer_load);
    object["outer_contact_angles_deg"] = list(study.outer_angle, kDegree);
    object["gyroscopic_friction"] = study.friction;
  }
  if (study.films) object["film"] = films_json(*study.films);
  if (study.over_speed) object.update(speeds_json(*study.over_speed));
  object["lundberg_palmgren"] = lives(study.lundberg_palmgren);
  if (has_balls(study)) object["contact_angles_deg"] = list(study.contact_angle, kDegree);
  if (study.lamina_load.size() > 0) object["lamina_loads_N"] = by_roller(study.lamina_load);
  return object;
}

std::string static_text(const StaticStudy& study) {
  std::string text = lives_text(value_by_name(life_values(study.all_lives())), words_of(study));
  text += fmt::format("\ndisplacement: radial {:.5g} um, axial {:.5g} um, tilt {:.5g} mrad\n", 1e6 * study.radial,
                      1e6 * study.axial, 1e3 * study.tilt);
  text += fmt::format("largest contact load {:.6g} N\n\n", largest_load(study));
  return text + (study.outer_load.size() > 0 ? loads_on_both_races(study) : loads_of_elements(study));
}

PointContent static_content(const StaticStudy& study) {
  PointContent content;
  content.add_dimension("element", study.contact_load.size());
  content.add("radial_displacement", "m", "inner ring along the radial load", study.radial);
  content.add("axial_displacement", "m", "inner ring along the axis", study.axial);
  content.add("tilt", "rad", "inner ring in the plane of the load", study.tilt);
  content.add("moment", "N m", "on the inner ring in the plane of the load", study.moment);
  content.add("largest_pressure", "Pa", "after Hertz", study.largest_pressure);
  content.add("dynamic_capacity", "N", "C_r", study.ratings.dynamic_capacity);
  const bearing::rating::RatingLives& lives = study.lives;
  content.add("basic_life", "1", "L10, revolutions", lives.basic);
  content.add("reference_life", "1", "L10r, revolutions", lives.reference.bearing);
  content.add("modified_life", "1", "L10m = a_1 a_ISO L10, revolutions", lives.modified);
  content.add("modified_reference_life", "1", "L10mr, revolutions", lives.modified_reference.bearing);
  content.add("life", "1", "by Lundberg and Palmgren, revolutions", study.lundberg_palmgren.bearing);
  content.add("contact_load", {"element"}, "N",
              "load of each rolling element, the first at bearing.first_element_angle from the load line",
              study.contact_load);
  if (study.outer_load.size() > 0)
    content.add("outer_contact_load", {"element"}, "N", "load of each ball on the outer race",
                study.outer_load);
  if (study.over_speed) add_speeds(*study.over_speed, content);
  for (NamedArray& array : content.arrays)
    for (double& value : array.values)
      if (!std::isfinite(value)) value = std::numeric_limits<double>::quiet_NaN();
  if (study.lamina_load.size() == 0) return content;
  content.add_dimension("lamina", study.lamina_load.rows());
  content.add("lamina_load", {"element", "lamina"}, "N", "load of each lamina of each roller",
              study.lamina_load.transpose());
  return content;
}

}  // namespace orbearing::app
