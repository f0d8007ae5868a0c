// Fields of the bearing and its cage.
#include "app/case/field_table.hpp"

namespace orbearing::app::table {

namespace {

Field length(std::string path, std::string meaning, unsigned required_by) {
  return {.path = std::move(path),
          .kind = Kind::quantity,
          .meaning = std::move(meaning),
          .required_by = required_by,
          .dimension = dimension::length,
          .range = {.least = 0.0, .most = 1e4, .least_allowed = false}};
}

void add_rollers(std::vector<Field>& fields) {
  fields.push_back({.path = "bearing.rollers",
                    .kind = Kind::integer,
                    .meaning = "number of rollers",
                    .required_by = with_rollers,
                    .range = {3, 500}});
  fields.push_back(length("bearing.roller_diameter", "diameter of a roller", with_rollers));
  fields.push_back(length("bearing.roller_length", "effective contact length of a roller", with_rollers));
  fields.push_back(length("bearing.pitch_diameter", "diameter of the circle of centres of rollers or balls",
                          with_rollers | ball_bearing));
  fields.back().models = with_rollers | ball_bearing;
  fields.push_back({.path = "bearing.radial_clearance",
                    .kind = Kind::quantity,
                    .meaning = "internal clearance in diametral measure (ISO 5753); negative is interference",
                    .models = with_rollers | ball_bearing,
                    .required_by = with_rollers | ball_bearing,
                    .dimension = dimension::small_length,
                    .range = {-100.0, 2000.0}});
}

void add_cage(std::vector<Field>& fields) {
  constexpr unsigned drivetrain = planetary_drivetrain;
  fields.push_back(length("bearing.cage.inner_diameter", "inner diameter of the cage", drivetrain));
  fields.push_back(length("bearing.cage.outer_diameter", "outer diameter of the cage", drivetrain));
  fields.push_back(length("bearing.cage.width", "axial width of the cage", drivetrain));
  fields.push_back({.path = "bearing.cage.density",
                    .kind = Kind::quantity,
                    .meaning = "density of the cage",
                    .required_by = drivetrain,
                    .dimension = dimension::density,
                    .range = {.least = 0.0, .most = 25000.0, .least_allowed = false}});
  fields.push_back(
      length("bearing.cage.guide_land_diameter", "diameter of the land that guides the cage", no_model));
  fields.push_back({.path = "bearing.cage.guidance",
                    .kind = Kind::choice,
                    .meaning = "ring that guides the cage",
                    .models = drivetrain,
                    .choices = {"outer", "inner"},
                    .default_text = "outer",
                    .default_reason = "inertia of the carrier frame throws the cage outward"});
  fields.push_back({.path = "bearing.cage.pocket_clearance",
                    .kind = Kind::quantity,
                    .meaning = "play of a roller in its pocket, in diametral measure",
                    .models = drivetrain,
                    .dimension = dimension::length,
                    .range = {.least = 0.0, .most = 10.0, .least_allowed = false},
                    .default_text = "0.1 mm",
                    .default_reason = "a usual play for rollers of a few millimetres"});
}

}  // namespace

void add_bearing_fields(std::vector<Field>& fields) {
  fields.push_back({.path = "bearing.type",
                    .kind = Kind::choice,
                    .meaning = "kind of bearing",
                    .required_by = with_rollers,
                    .choices = {"cylindrical-roller"}});
  fields.push_back({.path = "bearing.per_planet",
                    .kind = Kind::integer,
                    .meaning = "bearings side by side in a planet",
                    .models = planetary_drivetrain,
                    .required_by = planetary_drivetrain,
                    .range = {1, 8}});
  add_rollers(fields);
  fields.push_back(length("bearing.bore", "bore of the inner ring", planetary_drivetrain));
  fields.push_back(
      length("bearing.outside_diameter", "outside diameter of the outer ring", planetary_drivetrain));
  fields.push_back(length("bearing.width", "width of the rings", planetary_drivetrain));
  add_cage(fields);
}

}  // namespace orbearing::app::table
