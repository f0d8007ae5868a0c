// Fields of a pair of gears on two shafts.
#include "app/case/field_table.hpp"

namespace orbearing::app::table {

namespace {

const char* const rack = "the basic rack of ISO 53";

Field length(std::string path, std::string meaning, double most) {
  return {.path = std::move(path),
          .kind = Kind::quantity,
          .meaning = std::move(meaning),
          .use = Use(use::mesh, 0),
          .models = gear_pair,
          .required_by = gear_pair,
          .dimension = dimension::length,
          .range = {.least = 0.0, .most = most, .least_allowed = false}};
}

Field of_rack(std::string path, std::string meaning, Range range, std::string default_text) {
  return {.path = std::move(path),
          .kind = Kind::number,
          .meaning = std::move(meaning),
          .use = Use(use::mesh, 0),
          .models = gear_pair,
          .range = range,
          .default_text = std::move(default_text),
          .default_reason = rack};
}

}  // namespace

void add_pair_fields(std::vector<Field>& fields) {
  fields.push_back({.path = "pair.teeth",
                    .kind = Kind::list,
                    .meaning = "teeth of both gears, the driving one first",
                    .use = Use(use::mesh, 0),
                    .models = gear_pair,
                    .required_by = gear_pair,
                    .range = {5, 2000},
                    .element = Kind::integer});
  fields.push_back(length("pair.module", "normal module", 100.0));
  fields.push_back(length("pair.face_width", "width of the teeth", 1e4));
  fields.push_back(length("pair.bore", "bore of both gears, held by a rigid shaft", 1e5));
  fields.push_back({.path = "pair.pressure_angle",
                    .kind = Kind::quantity,
                    .meaning = "normal pressure angle of the basic rack",
                    .use = Use(use::mesh, 0),
                    .models = gear_pair,
                    .dimension = dimension::angle,
                    .range = {10.0, 35.0},
                    .default_text = "20 deg",
                    .default_reason = rack});
  fields.push_back(of_rack("pair.addendum", "addendum of the basic rack, in modules", {0.5, 1.5}, "1.0"));
  fields.push_back(
      of_rack("pair.clearance", "bottom clearance of the basic rack, in modules", {0.0, 0.6}, "0.25"));
  fields.push_back(of_rack("pair.root_fillet_radius", "root fillet radius of the basic rack, in modules",
                           {0.0, 0.6}, "0.38"));
  fields.push_back({.path = "pair.profile_shift",
                    .kind = Kind::list,
                    .meaning = "profile shifts of both gears, in modules",
                    .use = Use(use::mesh, 0),
                    .models = gear_pair,
                    .range = {-2.0, 2.0},
                    .default_text = "[0, 0]",
                    .default_reason = "standard gears"});
}

}  // namespace orbearing::app::table
