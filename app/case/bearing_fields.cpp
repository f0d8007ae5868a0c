// Fields of the bearing beyond those of its members: profile, misalignment, races that are not round.
#include "app/case/bearing_fields.hpp"
#include "app/case/described_fields.hpp"
#include "app/case/field_table.hpp"

namespace orbearing::app::table {

namespace {

Use of_profile(const char* kind) {
  return Use(use::lives | use::fmu_bearing | use::single_bearing_equilibrium | use::planet_stiffness,
             use::bearings_as_springs | use::mesh)
      .when(where("bearing.profile.kind", {kind}));
}

Field profile_length(std::string path, std::string meaning, const Use& use, const Dimension& dimension,
                     double most) {
  return {.path = std::move(path),
          .kind = Kind::quantity,
          .meaning = std::move(meaning),
          .use = use,
          .dimension = dimension,
          .range = {0.0, most}};
}

// Its depth may be scaled: what the end and the load make of each other is the shape.
std::vector<Condition> shape_beside_end_drop() {
  return {where("bearing.profile.kind", {"fujiwara-kawase"}), where_given({"bearing.profile.end_drop"})};
}

// Its load follows from the drop, where none is stated.
std::vector<Condition> drop_beside_end_drop() {
  std::vector<Condition> all = shape_beside_end_drop();
  all.push_back(where_absent("bearing.profile.design_load"));
  return all;
}

void add_profile_shape(std::vector<Field>& fields) {
  fields.push_back(
      {.path = "bearing.profile.design_load",
       .kind = Kind::quantity,
       .meaning = "design load of one roller for lundberg, johns-gohar and fujiwara-kawase; left out: the "
                  "load that corresponds to the drop",
       .use = Use(use::lives | use::fmu_bearing | use::single_bearing_equilibrium | use::planet_stiffness,
                  use::bearings_as_springs | use::mesh)
                  .when(where("bearing.profile.kind", {"lundberg", "johns-gohar", "fujiwara-kawase"}))
                  .when(where_absent("bearing.profile.drop"))
                  .used_too(
                      use::lives | use::fmu_bearing | use::single_bearing_equilibrium | use::planet_stiffness,
                      shape_beside_end_drop()),
       .dimension = dimension::force,
       .range = {.least = 0.0, .most = 1e8, .least_allowed = false}});
  fields.push_back(profile_length("bearing.profile.chamfer_length",
                                  "chamfer: its length at each end; left out: a tenth of the roller",
                                  of_profile("chamfer"), dimension::length, 1e4));
  fields.push_back(
      profile_length("bearing.profile.straight_length",
                     "straight-circular: its straight middle; left out: six tenths of the roller",
                     of_profile("straight-circular"), dimension::length, 1e4));
  fields.push_back({.path = "bearing.profile.k1",
                    .kind = Kind::number,
                    .meaning = "fujiwara-kawase: K1, factor of the design load; left out: 1",
                    .use = Use((use::lives & ~unsigned{use::crown}) | use::fmu_bearing |
                                   use::single_bearing_equilibrium | use::planet_stiffness,
                               use::crown | use::bearings_as_springs | use::mesh)  // crown varies the depth
                               .when(where("bearing.profile.kind", {"fujiwara-kawase"}))
                               .when(where_given({"bearing.profile.design_load"}))
                               .when(where_absent("bearing.profile.drop"))
                               .used_too(use::lives | use::fmu_bearing | use::single_bearing_equilibrium |
                                             use::planet_stiffness,
                                         shape_beside_end_drop()),
                    .range = {.least = 0.0, .most = 1000.0, .least_allowed = false}});
  fields.push_back({.path = "bearing.profile.k2",
                    .kind = Kind::number,
                    .meaning = "fujiwara-kawase: K2, crowned share of each half; left out: 1",
                    .use = of_profile("fujiwara-kawase"),
                    .range = {.least = 0.0, .most = 1.0, .least_allowed = false}});
  fields.push_back(profile_length("bearing.profile.end_drop",
                                  "fujiwara-kawase: z_m, relief at the end; left out: as Johns and Gohar",
                                  of_profile("fujiwara-kawase"), dimension::small_length, 1000.0));
  fields.push_back({.path = "bearing.profile.x",
                    .kind = Kind::list,
                    .meaning = "table: ascending positions from the middle of the roller",
                    .use = Use((use::lives & ~unsigned{use::crown}) | use::fmu_bearing |
                                   use::single_bearing_equilibrium | use::planet_stiffness,
                               use::bearings_as_springs | use::mesh)
                               .when(where("bearing.profile.kind", {"table"})),
                    .dimension = dimension::length,
                    .range = {-1e4, 1e4},
                    .element = Kind::quantity});
  fields.push_back({.path = "bearing.profile.drops",
                    .kind = Kind::list,
                    .meaning = "table: relief at those positions",
                    .use = Use((use::lives & ~unsigned{use::crown}) | use::fmu_bearing |
                                   use::single_bearing_equilibrium | use::planet_stiffness,
                               use::bearings_as_springs | use::mesh)
                               .when(where("bearing.profile.kind", {"table"})),
                    .dimension = dimension::small_length,
                    .range = {0.0, 1000.0},
                    .element = Kind::quantity});
}

// None has a default: a case without them is computed with whole contacts, as before there were laminae.
void add_profile(std::vector<Field>& fields) {
  fields.push_back(
      {.path = "bearing.profile.kind",
       .kind = Kind::choice,
       .meaning = "profile of the rollers along their length; left out: straight",
       .use = Use(use::lives | use::fmu_bearing | use::single_bearing_equilibrium | use::planet_stiffness,
                  use::bearings_as_springs | use::mesh),
       .choices = {"straight", "chamfer", "circular", "straight-circular", "lundberg", "johns-gohar",
                   "iso16281", "fujiwara-kawase", "table"}});
  fields.push_back(profile_length("bearing.profile.drop",
                                  "relief of one roller at the outermost of 40 laminae; left out: what the "
                                  "other entries of the profile give, else the relief of the profile of "
                                  "ISO/TS 16281 there",
                                  Use((use::lives & ~unsigned{use::crown}) | use::fmu_bearing |
                                          use::single_bearing_equilibrium | use::planet_stiffness,
                                      use::crown | use::bearings_as_springs | use::mesh)  // crown varies it
                                      .used_too(use::crown, drop_beside_end_drop()),
                                  dimension::small_length, 1000.0));
  add_profile_shape(fields);
}

// The mean over one roller pitch knows like rollers and races that stand.
const Use& of_waviness() {
  static const Use use(use::rollers_in_motion, use::bearings_as_springs | use::mesh, use::rollers_at_rest);
  return use;
}

const Use& of_out_of_roundness() {
  static const Use use =
      Use(use::lives | use::bearings_as_springs | use::fmu_bearing | use::planet_stiffness, use::mesh)
          .limited(use::bearings_as_springs, {where_bearings_make_springs()});
  return use;
}

Field list(std::string path, std::string meaning, const Use& use, Kind element, const Dimension& dimension,
           Range range) {
  return {.path = std::move(path),
          .kind = Kind::list,
          .meaning = std::move(meaning),
          .use = use,
          .models = planetary_drivetrain,
          .dimension = dimension,
          .range = range,
          .element = element};
}

// Waves of one race: lists of equal length, phases may be left out.
void add_form(std::vector<Field>& fields, const std::string& block, const std::string& which,
              const Use& use) {
  const Use of_waves = use.when(where_given({block + ".amplitude"}));
  fields.push_back(list(block + ".order", "waves around " + which, of_waves, Kind::integer, {}, {1, 1000}));
  fields.push_back(list(block + ".amplitude", "amplitude of each wave of " + which + ", outward", use,
                        Kind::quantity, dimension::small_length, {-1000.0, 1000.0}));
  fields.push_back(list(block + ".phase", "phase of each wave of " + which, of_waves, Kind::quantity,
                        dimension::angle, {-360.0, 360.0}));
}

void add_forms(std::vector<Field>& fields) {
  add_form(fields, "bearing.inner_race.out_of_roundness", "the pin's race, stationary in the carrier",
           of_out_of_roundness());
  add_form(fields, "bearing.inner_race.waviness", "the pin's race, rotating with it", of_waviness());
  add_form(fields, "bearing.outer_race.out_of_roundness", "the bore's race, stationary in the carrier",
           of_out_of_roundness());
  add_form(fields, "bearing.outer_race.waviness", "the bore's race, rotating with it", of_waviness());
}

std::vector<std::string> types_of_bearings() {
  std::vector<std::string> names;
  for (const auto& name : names_of(bearing::PlanetBearingType{})) names.emplace_back(name.text);
  return names;
}

}  // namespace

void add_bearing_fields(std::vector<Field>& fields) {
  fields.push_back({.path = "bearing.type",
                    .kind = Kind::choice,
                    .meaning = "kind of bearing; others than cylindrical-roller in planets at rest alone",
                    .use = Use(use::lives | use::bearings_as_springs | use::fmu_bearing |
                                   use::single_bearing_equilibrium | use::planet_stiffness,
                               use::mesh),
                    .required_by = with_rollers,
                    .choices = types_of_bearings()});
  add_described(fields, default_drivetrain());
  add_profile(fields);
  add_forms(fields);
}

}  // namespace orbearing::app::table
