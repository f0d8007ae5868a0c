// Fields of the bearing beyond those of its members: profile, misalignment, races that are not round.
#include "app/case/bearing_fields.hpp"
#include "app/case/described_fields.hpp"
#include "app/case/drivetrain_analyses.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/resolved_case.hpp"
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
        return in.has(of_set + keys().laminae) || is_chosen(in, of_set + kProfileKind, "straight");
      },
      "where bearing.laminae is given");
}

constexpr const char *kDrop = "bearing.profile.drop", *kDesignLoad = "bearing.profile.design_load";

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
void add_profile_fields(std::vector<Field>& fields, unsigned models, const ProfileUses& uses) {
  Rows rows(fields, models & with_rollers);
  const Use &profile = uses.shape, &depth = uses.depth,
            table = uses.table.when(where(kProfileKind, {"table"}));
  const auto of_kind = [&](const char* kind) { return profile.when(where(kProfileKind, {kind})); };
  // Its depth may be scaled: the shape is determined by the end and the load.
  const std::vector<Condition> shape_beside_end_drop{where(kProfileKind, {"fujiwara-kawase"}),
                                                     where_given({"bearing.profile.end_drop"})};
  // Its load follows from the drop, where none is stated.
  std::vector<Condition> drop_beside_end_drop = shape_beside_end_drop;
  drop_beside_end_drop.push_back(where_absent(kDesignLoad));
  constexpr Range end_length{0.0, 1e4}, relief{0.0, 1000.0};

  rows.choice(kProfileKind, "profile of the rollers along their length; straight: with sharp ends", uses.kind,
              {"straight", "chamfer", "circular", "straight-circular", "lundberg", "johns-gohar", "iso16281",
               "fujiwara-kawase", "table"});
  rows.quantity(
      kDrop,
      "relief of one roller at the outermost of 40 laminae; left out: what the other entries of the "
      "profile give, else the relief of the profile of ISO/TS 16281 there",
      depth.used_too(uses.crown, drop_beside_end_drop), dimension::small_length, relief);
  rows.quantity(kDesignLoad,
                "design load of one roller for lundberg, johns-gohar and fujiwara-kawase; left out: the load "
                "that corresponds to the drop",
                profile.when(where(kProfileKind, {"lundberg", "johns-gohar", "fujiwara-kawase"}))
                    .when(where_absent(kDrop))
                    .used_too(uses.all, shape_beside_end_drop),
                dimension::force, positive(1e8));
  rows.quantity("bearing.profile.chamfer_length",
                "chamfer: its length at each end; left out: a tenth of the roller", of_kind("chamfer"),
                dimension::length, end_length);
  rows.quantity("bearing.profile.straight_length",
                "straight-circular: its straight middle; left out: six tenths of the roller",
                of_kind("straight-circular"), dimension::length, end_length);
  rows.number("bearing.profile.k1", "fujiwara-kawase: K1, factor of the design load; left out: 1",
              depth.when(where(kProfileKind, {"fujiwara-kawase"}))
                  .when(where_given({kDesignLoad}))
                  .when(where_absent(kDrop))
                  .used_too(uses.all, shape_beside_end_drop),
              positive(1000.0));
  rows.number("bearing.profile.k2", "fujiwara-kawase: K2, crowned share of each half; left out: 1",
              of_kind("fujiwara-kawase"), positive(1.0));
  rows.quantity("bearing.profile.end_drop",
                "fujiwara-kawase: z_m, relief at the end; left out: as Johns and Gohar",
                of_kind("fujiwara-kawase"), dimension::small_length, relief);
  rows.quantity("bearing.profile.x", "table: ascending positions from the middle of the roller", table,
                dimension::length, {-1e4, 1e4})
      .listed();
  rows.quantity("bearing.profile.drops", "table: relief at those positions", table, dimension::small_length,
                relief)
      .listed();
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
  add_profile_fields(fields, planetary_drivetrain, profile_of_planets());
  add_forms(fields);
}

}  // namespace orbearing::app::table
