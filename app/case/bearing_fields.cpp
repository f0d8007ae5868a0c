// Fields of the bearing and its cage.
#include <utility>

#include "app/case/field_table.hpp"

namespace orbearing::app::table {

namespace {

// What loads, lives and stiffness of the bearing follow from.
constexpr unsigned by_load_and_spring = use::lives | use::bearings_as_springs | use::fmu_bearing;
constexpr unsigned without_motion = use::rollers_at_rest | use::bearings_as_springs | use::mesh;

const Use& of_rollers() {
  static const Use use(by_load_and_spring | use::static_load, use::mesh);
  return use;
}

// Masses that ride on the bearing.
const Use& of_mass() {
  static const Use use(by_load_and_spring, use::mesh | use::static_load);
  return use;
}

const Use& of_cage_motion() {
  static const Use use(use::rollers_in_motion, without_motion | use::static_load);
  return use;
}

Use of_profile(const char* kind) {
  return Use(use::lives | use::fmu_bearing | use::static_load, use::bearings_as_springs | use::mesh)
      .when(where("bearing.profile.kind", {kind}));
}

Field length(std::string path, std::string meaning, const Use& use, unsigned required_by) {
  return {.path = std::move(path),
          .kind = Kind::quantity,
          .meaning = std::move(meaning),
          .use = use,
          .required_by = required_by,
          .dimension = dimension::length,
          .range = {.least = 0.0, .most = 1e4, .least_allowed = false}};
}

void add_rollers(std::vector<Field>& fields) {
  fields.push_back({.path = "bearing.rollers",
                    .kind = Kind::integer,
                    .meaning = "number of rollers",
                    .use = of_rollers(),
                    .required_by = with_rollers,
                    .range = {3, 500}});
  fields.push_back(length("bearing.roller_diameter", "diameter of a roller", of_rollers(), with_rollers));
  fields.push_back(
      length("bearing.roller_length", "effective contact length of a roller", of_rollers(), with_rollers));
  fields.push_back(length("bearing.pitch_diameter", "diameter of the circle of centres of rollers or balls",
                          of_rollers(), with_rollers | ball_bearing));
  fields.back().models = with_rollers | ball_bearing;
  fields.push_back({.path = "bearing.radial_clearance",
                    .kind = Kind::quantity,
                    .meaning = "internal clearance in diametral measure (ISO 5753); negative is interference",
                    .use = of_rollers(),
                    .models = with_rollers | ball_bearing,
                    .required_by = with_rollers | ball_bearing,
                    .dimension = dimension::small_length,
                    .range = {-100.0, 2000.0}});
}

void add_cage(std::vector<Field>& fields) {
  constexpr unsigned drivetrain = planetary_drivetrain;
  fields.push_back(
      length("bearing.cage.inner_diameter", "inner diameter of the cage", of_mass(), drivetrain));
  fields.push_back(
      length("bearing.cage.outer_diameter", "outer diameter of the cage", of_mass(), drivetrain));
  fields.push_back(length("bearing.cage.width", "axial width of the cage", of_mass(), drivetrain));
  fields.push_back({.path = "bearing.cage.density",
                    .kind = Kind::quantity,
                    .meaning = "density of the cage",
                    .use = of_mass(),
                    .required_by = drivetrain,
                    .dimension = dimension::density,
                    .range = {.least = 0.0, .most = 25000.0, .least_allowed = false}});
  fields.push_back(length("bearing.cage.guide_land_diameter", "diameter of the land that guides the cage",
                          of_cage_motion(), no_model));
  fields.push_back({.path = "bearing.cage.guidance",
                    .kind = Kind::choice,
                    .meaning = "ring that guides the cage",
                    .use = of_mass(),
                    .models = drivetrain,
                    .choices = {"outer", "inner"},
                    .default_text = "outer",
                    .default_reason = "inertia of the carrier frame throws the cage outward"});
  fields.push_back({.path = "bearing.cage.pocket_clearance",
                    .kind = Kind::quantity,
                    .meaning = "play of a roller in its pocket, in diametral measure",
                    .use = of_cage_motion(),
                    .models = drivetrain,
                    .dimension = dimension::length,
                    .range = {.least = 0.0, .most = 10.0, .least_allowed = false}});
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

void add_profile_shape(std::vector<Field>& fields) {
  fields.push_back(
      {.path = "bearing.profile.design_load",
       .kind = Kind::quantity,
       .meaning = "load of one roller for which lundberg, johns-gohar and fujiwara-kawase are laid "
                  "out; left out: the load that goes with the drop",
       .use = Use(use::lives | use::fmu_bearing | use::static_load, use::bearings_as_springs | use::mesh)
                  .when(where("bearing.profile.kind", {"lundberg", "johns-gohar", "fujiwara-kawase"}))
                  .when(where_absent("bearing.profile.drop")),
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
                    .use = Use((use::lives & ~unsigned{use::crown}) | use::fmu_bearing | use::static_load,
                               use::crown | use::bearings_as_springs | use::mesh)  // crown varies the depth
                               .when(where("bearing.profile.kind", {"fujiwara-kawase"}))
                               .when(where_given({"bearing.profile.design_load"})),
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
                    .meaning = "table: places from the middle of the roller, rising",
                    .use = Use((use::lives & ~unsigned{use::crown}) | use::fmu_bearing | use::static_load,
                               use::bearings_as_springs | use::mesh)
                               .when(where("bearing.profile.kind", {"table"})),
                    .dimension = dimension::length,
                    .range = {-1e4, 1e4},
                    .element = Kind::quantity});
  fields.push_back({.path = "bearing.profile.drops",
                    .kind = Kind::list,
                    .meaning = "table: relief at those places",
                    .use = Use((use::lives & ~unsigned{use::crown}) | use::fmu_bearing | use::static_load,
                               use::bearings_as_springs | use::mesh)
                               .when(where("bearing.profile.kind", {"table"})),
                    .dimension = dimension::small_length,
                    .range = {0.0, 1000.0},
                    .element = Kind::quantity});
}

// None has a default: a case without them is computed with whole contacts, as before there were laminae.
void add_profile(std::vector<Field>& fields) {
  fields.push_back(
      {.path = "bearing.laminae",
       .kind = Kind::integer,
       .meaning = "laminae into which each contact is cut, for profile and misalignment",
       .use = Use(use::lives | use::fmu_bearing | use::static_load, use::bearings_as_springs | use::mesh),
       .range = {1, 200}});
  fields.push_back(
      {.path = "bearing.profile.kind",
       .kind = Kind::choice,
       .meaning = "profile of the rollers along their length; left out: straight",
       .use = Use(use::lives | use::fmu_bearing | use::static_load, use::bearings_as_springs | use::mesh),
       .choices = {"straight", "chamfer", "circular", "straight-circular", "lundberg", "johns-gohar",
                   "iso16281", "fujiwara-kawase", "table"}});
  fields.push_back(
      profile_length("bearing.profile.drop",
                     "relief of one roller at the outermost of 40 laminae; left out: what the "
                     "other entries of the profile give, else the relief of the profile of "
                     "ISO/TS 16281 there",
                     Use((use::lives & ~unsigned{use::crown}) | use::fmu_bearing | use::static_load,
                         use::crown | use::bearings_as_springs | use::mesh),  // crown varies it
                     dimension::small_length, 1000.0));
  add_profile_shape(fields);
  for (const auto& [key, meaning] :
       {std::pair{"planet_tilt",
                  "tilt of the planet on its pin, in the plane of the load on its bearing; "
                  "positive: the bore leans towards the load at its positive end"},
        std::pair{"carrier_wind_up",
                  "tilt of the bore against the pin in the tangential plane, by the twist of "
                  "the carrier; positive: the bore leads at its positive end"}})
    fields.push_back({.path = std::string("bearing.misalignment.") + key,
                      .kind = Kind::quantity,
                      .meaning = meaning,
                      .use = Use(use::quasi_static | use::in_time | use::fmu_bearing |
                                     (key[0] == 'c' ? unsigned{use::crown} : 0u),
                                 (key[0] == 'p' ? unsigned{use::crown} : 0u) |  // crown varies it
                                     use::bearings_as_springs | use::mesh),
                      .models = planetary_drivetrain,
                      .dimension = dimension::angle,
                      .range = {-2.0, 2.0}});
}

}  // namespace

void add_bearing_fields(std::vector<Field>& fields) {
  fields.push_back({.path = "bearing.type",
                    .kind = Kind::choice,
                    .meaning = "kind of bearing",
                    .use = of_rollers(),
                    .required_by = with_rollers,
                    .choices = {"cylindrical-roller"}});
  fields.push_back({.path = "bearing.per_planet",
                    .kind = Kind::integer,
                    .meaning = "bearings side by side in a planet",
                    .use = of_mass(),
                    .models = planetary_drivetrain,
                    .required_by = planetary_drivetrain,
                    .range = {1, 8}});
  add_rollers(fields);
  // Masses of the pin ring move with the rollers; the springs feel the pin that fills it.
  fields.push_back(length("bearing.bore",
                          "bore of the inner ring, and diameter of the pin, whose stiffness follows from it "
                          "where support.stiffness is left out",
                          Use(use::rollers_in_motion | use::bearings_as_springs,
                              use::rollers_at_rest | use::mesh | use::static_load)
                              .felt_too(use::quasi_static, where_pins_are_displaced()),
                          planetary_drivetrain));
  fields.push_back(length("bearing.outside_diameter", "outside diameter of the outer ring",
                          Use(use::of_a_drivetrain, use::static_load), planetary_drivetrain));
  fields.push_back(length("bearing.width", "width of the rings", of_mass(), planetary_drivetrain));
  add_cage(fields);
  add_profile(fields);
}

}  // namespace orbearing::app::table
