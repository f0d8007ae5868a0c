// Rows of designation, class, cage material and complement, and the conditions that they put on the rows
// before them.
#include "app/case/catalogue_fields.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "app/case/field_table.hpp"
#include "app/case/resolved_case.hpp"
#include "bearing/catalogue/classes.hpp"

namespace orbearing::app {

namespace {

namespace catalogue = bearing::catalogue;

const Use& use_of_row(const std::vector<Field>& fields, const std::string& path) {
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.path == path; });
  if (found == fields.end()) throw std::logic_error("no field '" + path + "'");
  return found->use;
}

Use either_of(const Use& one, const Use& other) {
  const unsigned by = one.by | other.by, refused = (one.refused_by | other.refused_by) & ~by;
  Use any{by, (one.not_modelled_by | other.not_modelled_by) & ~(by | refused), refused};
  any.ways = one.ways;
  any.ways.insert(any.ways.end(), other.ways.begin(), other.ways.end());
  return any;
}

// Used wherever one of `paths` is.
Use use_of_any(const std::vector<Field>& fields, const std::vector<std::string>& paths) {
  Use any{0, 0};
  for (const std::string& path : paths) any = either_of(any, use_of_row(fields, path));
  return any;
}

// Without inner ring the pin differs, without any the planet's bore as well.
Use use_of_rings(const std::vector<Field>& fields) {
  const Use planet = use_of_row(fields, "bearing.outside_diameter")
                         .limited(use::all, {where(catalogue_keys::kRings, {"none"})});
  return either_of(use_of_row(fields, "bearing.bore"), planet);
}

void add_condition(std::vector<Field>& fields, const std::string& path, const Condition& condition) {
  for (Field& field : fields)
    if (field.path == path) field.use = field.use.when(condition);
}

std::vector<std::string> names_of_classes() {
  std::vector<std::string> names;
  for (const auto& one : names_of(catalogue::ClearanceClass{})) names.emplace_back(one.text);
  return names;
}

Field choice(std::string path, std::string meaning, const Use& use, unsigned models,
             std::vector<std::string> choices) {
  return {.path = std::move(path),
          .kind = Kind::choice,
          .meaning = std::move(meaning),
          .use = use,
          .models = models,
          .choices = std::move(choices)};
}

// As the number of rollers, which it makes where a bearing is bought. The frequencies of a scratched bearing
// are those of its cage.
Use use_of_complement(const std::vector<Field>& fields) {
  constexpr unsigned moving = use::planet_defect;
  Use rollers = use_of_row(fields, catalogue_keys::kRollers);
  for (unsigned* status : {&rollers.by, &rollers.not_modelled_by, &rollers.refused_by}) *status &= ~moving;
  rollers.refused_by |= moving;
  return rollers.used_only(use::single_bearing_equilibrium, {where_given({catalogue_keys::kDesignation})});
}

}  // namespace

std::vector<Condition> given_by(std::string_view path) {
  const std::vector<std::string>& designated = paths_of_designation();
  const bool of_cage = path.starts_with("bearing.cage.");
  std::vector<Condition> by;
  if (path == kPowerPath) return {where_given({kTorquePath}), where_given({kTorqueCurvePath})};
  if (path == "bearing.type" || (of_cage && path != catalogue_keys::kDensity) ||
      std::find(designated.begin(), designated.end(), path) != designated.end())
    by.push_back(where_given({catalogue_keys::kDesignation}));
  if (path == catalogue_keys::kRollers || of_cage) by.push_back(where(catalogue_keys::kComplement, {"full"}));
  if (path == "bearing.bore") by.push_back(where(catalogue_keys::kRings, {"outer", "none"}));
  if (path == "bearing.outside_diameter") by.push_back(where(catalogue_keys::kRings, {"none"}));
  if (path == catalogue_keys::kClearance) by.push_back(where_given({catalogue_keys::kClass}));
  if (path == catalogue_keys::kDensity) by.push_back(where_given({catalogue_keys::kMaterial}));
  if (path == catalogue_keys::kInnerFit) by.push_back(where_given({catalogue_keys::kPinClass}));
  if (path == catalogue_keys::kOuterFit) by.push_back(where_given({catalogue_keys::kPlanetClass}));
  return by;
}

const std::vector<std::string>& paths_of_designation() {
  static const std::vector<std::string> paths{catalogue_keys::kRollers,   "bearing.roller_diameter",
                                              "bearing.roller_length",    "bearing.balls",
                                              "bearing.ball_diameter",    "bearing.contact_angle",
                                              "bearing.pitch_diameter",   "bearing.bore",
                                              "bearing.outside_diameter", "bearing.width"};
  return paths;
}

namespace table {

void add_catalogue_fields(std::vector<Field>& fields) {
  constexpr unsigned bought = with_rollers | with_balls;
  std::vector<std::string> designated = paths_of_designation();
  designated.emplace_back(catalogue_keys::kDynamic);
  const Use by_designation = use_of_any(fields, designated);
  std::vector<Field> rows{
      {.path = catalogue_keys::kDesignation,
       .kind = Kind::text,
       .meaning = "designation of the bearing in a catalogue, such as NU 205, 6205, 7205 B or K 20x24x10: "
                  "boundary dimensions and ratings as printed, rollers or balls inferred from them",
       .use = by_designation,
       .models = bought},
      {.path = catalogue_keys::kCatalogue,
       .kind = Kind::text,
       .meaning = "file of bearings (CSV), searched for the designation before the project's own catalogue; "
                  "several lines: the table itself",
       .use = by_designation.when(where_given({catalogue_keys::kDesignation})),
       .models = bought},
      choice(catalogue_keys::kClass,
             "clearance class of the unmounted bearing, ISO 5753; the middle of its range is used",
             use_of_any(fields, {catalogue_keys::kClearance}), with_rollers | single_ball_bearing,
             names_of_classes()),
      choice(catalogue_keys::kPinClass,
             "tolerance class (ISO 286) of the pin under the inner ring, instead of its interference: mean "
             "interference with a bearing of normal accuracy",
             use_of_row(fields, catalogue_keys::kInnerFit), planetary_drivetrain, catalogue::shaft_classes()),
      choice(catalogue_keys::kPlanetClass,
             "tolerance class (ISO 286) of the planet's bore around the outer ring, instead of its "
             "interference: mean interference with a bearing of normal accuracy",
             use_of_row(fields, catalogue_keys::kOuterFit), planetary_drivetrain, catalogue::hole_classes()),
      choice(catalogue_keys::kMaterial, "material of the cage, instead of its density",
             use_of_any(fields, {catalogue_keys::kDensity}), with_rollers | described::balls_in_time,
             {"polyamide", "steel", "brass", "aluminium"}),
      choice(catalogue_keys::kComplement, "rollers separated by a cage, or in contact with one another",
             use_of_complement(fields), with_rollers, {"caged", "full"})};
  for (Field& field : fields)
    if (field.path == catalogue_keys::kRings) field.use = use_of_rings(fields);
  rows.back().default_text = "caged";
  rows.back().default_reason = "as most catalogue bearings";
  for (const std::string& path : paths_of_designation())
    add_condition(fields, path, where_absent(catalogue_keys::kDesignation));
  add_condition(fields, catalogue_keys::kClearance, where_absent(catalogue_keys::kClass));
  add_condition(fields, catalogue_keys::kDensity, where_absent(catalogue_keys::kMaterial));
  add_condition(fields, catalogue_keys::kInnerFit, where_absent(catalogue_keys::kPinClass));
  add_condition(fields, catalogue_keys::kOuterFit, where_absent(catalogue_keys::kPlanetClass));
  for (Field& field : fields)
    if (field.path.starts_with("bearing.cage."))
      field.use = field.use.when(where(catalogue_keys::kComplement, {"caged"}));
  add_condition(fields, "bearing.bore", where(catalogue_keys::kRings, {"both"}));
  add_condition(fields, "bearing.outside_diameter", where(catalogue_keys::kRings, {"both", "outer"}));
  add_condition(fields, catalogue_keys::kInnerFit, where(catalogue_keys::kRings, {"both"}));
  add_condition(fields, "bearing.temperature.inner_ring", where(catalogue_keys::kRings, {"both"}));
  add_condition(fields, catalogue_keys::kOuterFit, where(catalogue_keys::kRings, {"both", "outer"}));
  add_condition(fields, "bearing.temperature.outer_ring", where(catalogue_keys::kRings, {"both", "outer"}));
  for (Field& row : rows) {
    if (row.path == catalogue_keys::kMaterial)
      row.use = row.use.when(where(catalogue_keys::kComplement, {"caged"}));
    if (row.path == catalogue_keys::kPinClass)
      row.use = row.use.when(where(catalogue_keys::kRings, {"both"}));
    if (row.path == catalogue_keys::kPlanetClass)
      row.use = row.use.when(where(catalogue_keys::kRings, {"both", "outer"}));
    fields.push_back(std::move(row));
  }
}

}  // namespace table

}  // namespace orbearing::app
