// Fields of the profile of a roller and of the laminae its contacts are cut into.
#include "app/case/field_table.hpp"

namespace orbearing::app::table {

namespace {

Field parameter(const Dimension& dimension, std::string path, std::string meaning, Range range,
                std::string text, std::string reason) {
  return {.path = std::move(path),
          .kind = Kind::quantity,
          .meaning = std::move(meaning),
          .models = roller_bearing,
          .dimension = dimension,
          .range = range,
          .default_text = std::move(text),
          .default_reason = std::move(reason)};
}

Field ratio(std::string path, std::string meaning, Range range, std::string text, std::string reason) {
  return {.path = std::move(path),
          .kind = Kind::number,
          .meaning = std::move(meaning),
          .models = roller_bearing,
          .range = range,
          .default_text = std::move(text),
          .default_reason = std::move(reason)};
}

Field points(std::string path, std::string meaning, const Dimension& dimension, Range range) {
  return {.path = std::move(path),
          .kind = Kind::list,
          .meaning = std::move(meaning),
          .models = roller_bearing,
          .dimension = dimension,
          .range = range,
          .element = Kind::quantity};
}

void add_shapes(std::vector<Field>& fields) {
  const std::string usual = "a usual relief of small rollers";
  fields.push_back(parameter(dimension::small_length, "bearing.profile.drop",
                             "radial relief of one roller at its end: chamfer, circular, straight-circular, "
                             "fujiwara-kawase",
                             {.least = 0.0, .most = 5000.0, .least_allowed = false}, "10 um", usual));
  fields.push_back(parameter(dimension::length, "bearing.profile.chamfer_length",
                             "length of one chamfer along the axis: chamfer",
                             {.least = 0.0, .most = 1e4, .least_allowed = false}, "0.5 mm", usual));
  fields.push_back(ratio("bearing.profile.straight_share",
                         "straight part of the length between the circular ends: straight-circular",
                         {.least = 0.0, .most = 1.0, .most_allowed = false}, "0.6", usual));
  fields.push_back(ratio("bearing.profile.scale", "factor on all drops: iso16281, table",
                         {.least = 0.0, .most = 1000.0, .least_allowed = false}, "1.0",
                         "the profile as it is"));
}

void add_logarithms(std::vector<Field>& fields) {
  fields.push_back(parameter(dimension::force, "bearing.profile.design_load",
                             "roller load for which the profile is laid out: lundberg, johns-gohar, "
                             "fujiwara-kawase; 0 N: 4.08 F/Z",
                             {0.0, 1e9}, "0 N", "4.08 F/Z, the largest roller load without clearance"));
  fields.push_back(ratio("bearing.profile.k1", "factor on the depth: fujiwara-kawase",
                         {.least = 0.0, .most = 1000.0, .least_allowed = false}, "1.0", "as laid out"));
  fields.push_back(ratio("bearing.profile.k2", "crowned share of the length: fujiwara-kawase",
                         {.least = 0.0, .most = 1.0, .least_allowed = false}, "1.0", "crowned all along"));
}

}  // namespace

void add_profile_fields(std::vector<Field>& fields) {
  fields.push_back({.path = "bearing.laminae",
                    .kind = Kind::integer,
                    .meaning = "laminae into which the contacts of a roller are cut",
                    .models = roller_bearing,
                    .range = {1, 200},
                    .default_text = "40",
                    .default_reason = "ISO/TS 16281 asks for at least 30"});
  fields.push_back({.path = "bearing.profile.kind",
                    .kind = Kind::choice,
                    .meaning = "profile of the rollers",
                    .models = roller_bearing,
                    .choices = {"straight", "chamfer", "circular", "straight-circular", "lundberg",
                                "johns-gohar", "iso16281", "fujiwara-kawase", "table"},
                    .default_text = "straight",
                    .default_reason = "none is stated"});
  add_shapes(fields);
  add_logarithms(fields);
  fields.push_back(points("bearing.profile.places", "places from the middle along the axis: table",
                          dimension::length, {-1e4, 1e4}));
  fields.push_back(points("bearing.profile.drops", "drops at these places: table", dimension::small_length,
                          {0.0, 5000.0}));
}

}  // namespace orbearing::app::table
