// Rows of designation, class, cage material and complement, and the conditions that they put on the rows
// before them.
#include "app/case/catalogue_fields.hpp"

#include <algorithm>
#include <string_view>

#include "app/case/drivetrain_analyses.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machine_fields.hpp"
#include "app/case/resolved_case.hpp"
#include "bearing/catalogue/catalogue_bearing.hpp"

namespace orbearing::app {

namespace {

namespace catalogue = bearing::catalogue;

Use either_of(const Use& one, const Use& other) {
  const AnalysisSet by = one.by | other.by, refused = (one.refused_by | other.refused_by).without(by);
  Use any{by, (one.not_modelled_by | other.not_modelled_by).without(by | refused), refused};
  any.ways = one.ways;
  any.ways.insert(any.ways.end(), other.ways.begin(), other.ways.end());
  return any;
}

// Used wherever one of `paths` is.
Use use_of_any(std::vector<Field>& fields, const std::vector<std::string>& paths) {
  Use any{{}, {}};
  for (const std::string& path : paths)
    if (const Field* field = table::find_row(fields, path)) any = either_of(any, field->use);
  return any;
}

// Without inner ring the pin differs, without any the planet's bore as well.
Use use_of_rings(std::vector<Field>& fields) {
  const Use planet = table::row_of(fields, keys().outside_diameter)
                         .use.limited(all_of_drivetrains(), {where(keys().rings, {"none"})});
  return either_of(table::row_of(fields, keys().bore).use, planet);
}

// Use as that of the number of rollers, which it determines for a catalogue bearing. The frequencies of a
// scratched bearing are those of its cage.
Use use_of_complement(std::vector<Field>& fields, AnalysisSet by_designation) {
  constexpr AnalysisId moving = AnalysisId::planet_defect;
  const Field* row = table::find_row(fields, keys().rollers);
  if (row == nullptr) return {{}, {}};
  Use rollers = row->use;
  for (AnalysisSet* status : {&rollers.by, &rollers.not_modelled_by, &rollers.refused_by})
    *status = status->without(moving);
  rollers.refused_by |= moving;
  return rollers.used_only(by_designation, {where_given({keys().designation})});
}

}  // namespace

std::vector<Condition> given_by(std::string_view path) {
  const std::vector<std::string>& designated = paths_of_designation();
  const bool of_cage = path.starts_with("bearing.cage.");
  std::vector<Condition> by;
  if (path == keys().power) return {where_given({kTorquePath}), where_given({kTorqueCurvePath})};
  if (path == keys().bearing_type || (of_cage && path != keys().cage_density) ||
      std::find(designated.begin(), designated.end(), path) != designated.end())
    by.push_back(where_given({keys().designation}));
  if (path == keys().rollers || of_cage) by.push_back(where(keys().complement, {"full"}));
  if (path == keys().bore) by.push_back(where(keys().rings, {"outer", "none"}));
  if (path == keys().outside_diameter) by.push_back(where(keys().rings, {"none"}));
  if (path == keys().radial_clearance) by.push_back(where_given({keys().clearance_class}));
  if (path == keys().cage_density) by.push_back(where_given({catalogue_keys::kMaterial}));
  if (path == keys().inner_interference) by.push_back(where_given({catalogue_keys::kPinClass}));
  if (path == keys().outer_interference) by.push_back(where_given({catalogue_keys::kPlanetClass}));
  return by;
}

const std::vector<std::string>& paths_of_designation() {
  static const std::vector<std::string> paths{keys().rollers,          keys().roller_diameter,
                                              keys().roller_length,    keys().balls,
                                              keys().ball_diameter,    keys().contact_angle,
                                              keys().pitch_diameter,   keys().bore,
                                              keys().outside_diameter, keys().width};
  return paths;
}

namespace table {

void add_catalogue_fields(std::vector<Field>& fields, unsigned models, AnalysisSet by_complement) {
  using namespace catalogue_keys;
  const auto use_of = [&](const std::string& path) {
    const Field* field = find_row(fields, path);
    return field == nullptr ? Use({}, {}) : field->use;
  };
  std::vector<std::string> designated = paths_of_designation();
  designated.emplace_back(keys().dynamic_capacity);
  const Use by_designation = use_of_any(fields, designated);
  const Condition caged = where(keys().complement, {"caged"}),
                  with_both_rings = where(keys().rings, {"both"}),
                  with_outer_ring = where(keys().rings, {"both", "outer"});
  std::vector<Field> added;
  Rows bought(added, with_rollers | with_balls), planets(added, planetary_drivetrain);
  using Stated = catalogue::CatalogueBearing;
  added.push_back(field_of_row<Stated>(keys().designation, with_rollers | with_balls, by_designation));
  bought.text(kCatalogue,
              "file of bearings (CSV), searched for the designation before the project's own catalogue; "
              "several lines: the table itself",
              by_designation.when(where_given({keys().designation})));
  added.push_back(field_of_row<Stated>(keys().clearance_class, with_rollers | single_ball_bearing,
                                       use_of_any(fields, {keys().radial_clearance})));
  planets.choice(
      kPinClass,
      "tolerance class (ISO 286) of the pin under the inner ring, instead of its interference: mean "
      "interference with a bearing of normal accuracy",
      use_of(keys().inner_interference).when(with_both_rings), catalogue::shaft_classes());
  planets.choice(kPlanetClass,
                 "tolerance class (ISO 286) of the planet's bore around the outer ring, instead of its "
                 "interference: mean interference with a bearing of normal accuracy",
                 use_of(keys().outer_interference).when(with_outer_ring), catalogue::hole_classes());
  Rows(added, with_rollers | model_sets::balls_in_time)
      .choice(kMaterial, "material of the cage, instead of its density",
              use_of_any(fields, {keys().cage_density}).when(caged),
              {"polyamide", "steel", "brass", "aluminium"});
  Rows(added, with_rollers)
      .choice(keys().complement, "rollers separated by a cage, or in contact with one another",
              use_of_complement(fields, by_complement), {"caged", "full"})
      .by_default("caged", "as most catalogue bearings");

  if (Field* rings = find_row(fields, keys().rings)) rings->use = use_of_rings(fields);
  const auto limit = [&](const std::string& path, const Condition& condition) {
    if (Field* field = find_row(fields, path)) field->under(condition);
  };
  for (const std::string& path : paths_of_designation()) limit(path, where_absent(keys().designation));
  limit(keys().radial_clearance, where_absent(keys().clearance_class));
  limit(keys().cage_density, where_absent(kMaterial));
  limit(keys().inner_interference, where_absent(kPinClass));
  limit(keys().outer_interference, where_absent(kPlanetClass));
  for (Field& field : fields)
    if (field.path.starts_with("bearing.cage.")) field.under(caged);
  limit(keys().bore, with_both_rings);
  limit(keys().outside_diameter, with_outer_ring);
  limit(keys().inner_interference, with_both_rings);
  limit(keys().inner_ring_temperature, with_both_rings);
  limit(keys().outer_interference, with_outer_ring);
  limit(keys().outer_ring_temperature, with_outer_ring);
  for (Field& field : added) {
    Field* own = find_row(fields, field.path);  // of a machine that has the member
    if (own != nullptr)
      own->use = field.use;
    else if ((field.models &= models) != 0)
      fields.push_back(std::move(field));
  }
}

}  // namespace table

}  // namespace orbearing::app
