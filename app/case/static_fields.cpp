// Fields of one bearing under a static load: balls and grooves, loads, and what the standard life asks.
#include "app/case/field_table.hpp"

namespace orbearing::app::table {

namespace {

constexpr unsigned single_bearing = roller_bearing | ball_bearing;

const Use& by_static_load() {
  static const Use use(use::static_load, 0);
  return use;
}

Field optional_quantity(const Dimension& dimension, std::string path, std::string meaning, unsigned models,
                        Range range) {
  return {.path = std::move(path),
          .kind = Kind::quantity,
          .meaning = std::move(meaning),
          .use = by_static_load(),
          .models = models,
          .dimension = dimension,
          .range = range};
}

Field ball_number(std::string path, std::string meaning, Range range, std::string text, std::string reason) {
  return {.path = std::move(path),
          .kind = Kind::number,
          .meaning = std::move(meaning),
          .use = by_static_load(),
          .models = ball_bearing,
          .range = range,
          .default_text = std::move(text),
          .default_reason = std::move(reason)};
}

void add_balls(std::vector<Field>& fields) {
  fields.push_back({.path = "bearing.balls",
                    .kind = Kind::integer,
                    .meaning = "number of balls",
                    .use = by_static_load(),
                    .models = ball_bearing,
                    .required_by = ball_bearing,
                    .range = {3, 500}});
  Field diameter = optional_quantity(dimension::length, "bearing.ball_diameter", "diameter of a ball",
                                     ball_bearing, {.least = 0.0, .most = 1e4, .least_allowed = false});
  diameter.required_by = ball_bearing;
  fields.push_back(diameter);
  Field angle = optional_quantity(dimension::angle, "bearing.contact_angle", "nominal contact angle",
                                  ball_bearing, {0.0, 85.0});
  angle.default_text = "0 deg";
  angle.default_reason = "a deep-groove bearing";
  fields.push_back(angle);
  constexpr Range osculation{.least = 0.5, .most = 1.0, .least_allowed = false};
  const std::string usual = "the grooves for which ISO 281 states f_c";
  fields.push_back(ball_number("bearing.inner_osculation", "radius of the inner groove over ball diameter",
                               osculation, "0.52", usual));
  fields.push_back(ball_number("bearing.outer_osculation", "radius of the outer groove over ball diameter",
                               osculation, "0.53", usual));
}

void add_capacities(std::vector<Field>& fields) {
  constexpr Range above_zero{.least = 0.0, .most = 1e9, .least_allowed = false};
  fields.push_back(optional_quantity(dimension::force, "bearing.dynamic_capacity",
                                     "basic dynamic load rating C; without it that of ISO 281",
                                     single_bearing, above_zero));
  fields.push_back(optional_quantity(dimension::force, "bearing.fatigue_load_limit",
                                     "fatigue load limit C_u; without it that of ISO 281 by C_0",
                                     single_bearing, above_zero));
}

void add_loads(std::vector<Field>& fields) {
  Field axial = optional_quantity(dimension::force, "load.axial", "axial load on the bearing", ball_bearing,
                                  {0.0, 1e9});
  axial.default_text = "0 N";
  axial.default_reason = "a radial load alone";
  fields.push_back(axial);
  Field moment = optional_quantity(dimension::torque, "load.moment",
                                   "moment on the inner ring in the plane of the radial load", single_bearing,
                                   {-1e9, 1e9});
  moment.default_text = "0 N.m";
  moment.default_reason = "the shaft does not hold the ring against tilting";
  fields.push_back(moment);
  fields.push_back(optional_quantity(dimension::angle, "load.tilt",
                                     "tilt of the inner ring in the plane of the radial load, in place of "
                                     "its moment",
                                     single_bearing, {-10.0, 10.0}));
}

Field life_number(std::string path, std::string meaning, Range range) {
  return {.path = std::move(path),
          .kind = Kind::number,
          .meaning = std::move(meaning),
          .use = by_static_load(),
          .models = single_bearing,
          .range = range};
}

void add_life(std::vector<Field>& fields) {
  Field reliability = life_number("life.reliability", "share of bearings that reach the life",
                                  {.least = 0.0, .most = 1.0, .least_allowed = false, .most_allowed = false});
  reliability.default_text = "0.9";
  reliability.default_reason = "rating lives are those of 90 %";
  fields.push_back(reliability);
  fields.push_back(life_number("life.viscosity_ratio", "kappa of ISO 281; with it the life takes a_ISO",
                               {.least = 0.1, .most = 1000.0}));
  fields.push_back(life_number("life.contamination_factor", "e_C of ISO 281", {0.0, 1.0}));
  fields.push_back({.path = "life.lubrication",
                    .kind = Kind::choice,
                    .meaning = "how the bearing is lubricated, for the contamination factor",
                    .use = by_static_load().when(where_given({"life.cleanliness"})),
                    .models = single_bearing,
                    .choices = {"circulating-oil", "oil-bath", "grease"},
                    .default_text = "circulating-oil",
                    .default_reason = "oil with a filter in its line"});
  fields.push_back({.path = "life.cleanliness",
                    .kind = Kind::choice,
                    .meaning = "level of cleanliness, in place of the contamination factor",
                    .use = by_static_load(),
                    .models = single_bearing,
                    .choices = {"highest", "high", "medium", "low", "lowest"}});
  fields.push_back(optional_quantity(dimension::kinematic_viscosity, "lubricant.kinematic_viscosity",
                                     "kinematic viscosity at running temperature, in place of kappa",
                                     single_bearing, {.least = 0.0, .most = 1e6, .least_allowed = false}));
}

}  // namespace

void add_static_fields(std::vector<Field>& fields) {
  add_balls(fields);
  add_capacities(fields);
  add_loads(fields);
  add_life(fields);
}

}  // namespace orbearing::app::table
