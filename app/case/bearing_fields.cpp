// Fields of the bearing beyond those of its members: races that are not round; and the uses of its profile.
#include "app/case/bearing_fields.hpp"
#include "app/case/described_fields.hpp"
#include "app/case/drivetrain_analyses.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/resolved_case.hpp"
#include "bearing/profile/stated_profile.hpp"
#include "mechanics/member_keys.hpp"
#include "mechanics/part_rows.hpp"

namespace orbearing::app::table {

namespace {

using analysis::Physics;

AnalysisSet without_rollers() {
  return analyses_with(Physics::springs) | AnalysisId::mesh;
}

Condition where_profile_acts_on_loads() {
  return where_true(
      [](const ResolvedCase& in, std::string_view set) {
        const std::string of_set(set);
        return in.has(of_set + keys().laminae) || is_chosen(in, of_set + keys().profile_kind, "straight");
      },
      "where bearing.laminae is given");
}

// Without laminae loads of planets are those of whole contacts, and the profile affects lives only by the
// standards.
ProfileUses profile_of_planets() {
  const AnalysisSet of_laminae =
                        analyses_with_lives() | AnalysisId::fmu_bearing | AnalysisId::planet_stiffness,
                    but_crown = of_laminae.without(AnalysisId::crown), others = without_rollers();
  const auto with_laminae = [](const Use& use) {
    return use.limited(AnalysisId::fmu_bearing | AnalysisId::planet_stiffness,
                       {where_given({keys().laminae})});
  };
  const Use of_any(of_laminae, others);
  return {.kind = of_any.limited(AnalysisId::fmu_bearing | AnalysisId::planet_stiffness,
                                 {where_profile_acts_on_loads()}),
          .shape = with_laminae(of_any),
          .depth = with_laminae(Use(but_crown, AnalysisId::crown | others)),  // crown varies it
          .table = with_laminae(Use(but_crown, others)),
          .all = of_laminae,
          .crown = AnalysisId::crown};
}

}  // namespace

// The kind has a default by the type of bearing (derived_defaults.cpp).
void put_profile_uses(std::vector<Field>& fields, const ProfileUses& uses) {
  const bearing::profile::StatedProfile stated;
  const mechanics::MemberKeys key(stated);
  const auto put = [&](const auto& member, const Use& use) { row_of(fields, key(member)).use = use; };
  const Use &profile = uses.shape, &depth = uses.depth,
            table = uses.table.when(where(key(stated.kind), {"table"}));
  const auto of_kind = [&](const char* kind) { return profile.when(where(key(stated.kind), {kind})); };
  // Its depth may be scaled: the shape is determined by the end and the load.
  const std::vector<Condition> shape_beside_end_drop{where(key(stated.kind), {"fujiwara-kawase"}),
                                                     where_given({key(stated.end_drop)})};
  // Its load follows from the drop, where none is stated.
  std::vector<Condition> drop_beside_end_drop = shape_beside_end_drop;
  drop_beside_end_drop.push_back(where_absent(key(stated.design_load)));

  put(stated.kind, uses.kind);
  put(stated.drop, depth.used_too(uses.crown, drop_beside_end_drop));
  put(stated.design_load,
      profile.when(where(key(stated.kind), {"lundberg", "johns-gohar", "fujiwara-kawase"}))
          .when(where_absent(key(stated.drop)))
          .used_too(uses.all, shape_beside_end_drop));
  put(stated.chamfer_length, of_kind("chamfer"));
  put(stated.straight_length, of_kind("straight-circular"));
  put(stated.k1, depth.when(where(key(stated.kind), {"fujiwara-kawase"}))
                     .when(where_given({key(stated.design_load)}))
                     .when(where_absent(key(stated.drop)))
                     .used_too(uses.all, shape_beside_end_drop));
  put(stated.k2, of_kind("fujiwara-kawase"));
  put(stated.end_drop, of_kind("fujiwara-kawase"));
  put(stated.x, table);
  put(stated.drops, table);
}

namespace {

// Waves of one race: lists of equal length, phases may be left out.
void add_form(std::vector<Field>& fields, const std::string& block, const std::string& which,
              const Use& use) {
  Rows rows(fields, planetary_drivetrain);
  const Use of_waves = use.when(where_given({block + ".amplitude"}));
  rows.integer(block + ".order", "waves around " + which, of_waves, {1, 1000}).listed();
  rows.quantity(block + ".amplitude", "amplitude of each wave of " + which + ", outward", use,
                dimension::small_length, {-1000.0, 1000.0})
      .listed();
  rows.quantity(block + ".phase", "phase of each wave of " + which, of_waves, dimension::angle,
                {-360.0, 360.0})
      .listed();
}

void add_forms(std::vector<Field>& fields) {
  // The mean over one roller pitch assumes identical rollers and races that do not rotate.
  const Use waviness(analyses_with(Physics::motion), without_rollers(), analyses_with(Physics::equilibrium));
  const Use out_of_roundness = Use(analyses_with(Physics::balance), AnalysisId::mesh)
                                   .limited(analyses_with(Physics::springs), {where_bearings_make_springs()});
  for (const auto& [race, whose] : {std::pair{"inner", "pin"}, {"outer", "bore"}}) {
    const std::string block = fmt::format("bearing.{}_race.", race),
                      which = fmt::format("the {}'s race", whose);
    add_form(fields, block + "out_of_roundness", which + ", stationary in the carrier", out_of_roundness);
    add_form(fields, block + "waviness", which + ", rotating with it", waviness);
  }
}

}  // namespace

void add_bearing_type(std::vector<Field>& fields, unsigned models, const Use& use) {
  if ((models & with_rollers) == 0) return;
  Rows(fields, models & with_rollers)
      .choice(keys().bearing_type, "kind of bearing; others than cylindrical-roller in planets at rest alone",
              use, choices_of<bearing::PlanetBearingType>())
      .required();
}

void add_bearing_fields(std::vector<Field>& fields) {
  add_bearing_type(fields, planetary_drivetrain, Use(analyses_with(Physics::balance), AnalysisId::mesh));
  analysis::PlanetaryDrivetrain drivetrain = default_drivetrain();
  add_described(fields, drivetrain.bearing, no_model);
  // All of these but the angle of the first roller: the rollers of a planet pass all positions.
  DescribedFields visit(fields, planetary_drivetrain);
  mechanics::describe_without(visit, drivetrain, drivetrain.bearing.first_element);
  add_described(fields, bearing::profile::StatedProfile{});
  put_profile_uses(fields, profile_of_planets());
  add_forms(fields);
}

}  // namespace orbearing::app::table
