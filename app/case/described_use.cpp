// Uses of the fields whose rows are beside their members: use_of() of field_use.hpp. Unlike the other pairs
// of this folder it has no header of its own, since its conditions on a case are declared above the fields.
#include <algorithm>
#include <initializer_list>
#include <utility>

#include "app/case/field_use.hpp"
#include "app/case/printable.hpp"
#include "app/case/use_conditions.hpp"

namespace orbearing::app {

namespace {

// Analyses that hold the physics. What belongs to it alone has no effect on others.
unsigned holding(described::Physics physics) {
  using enum described::Physics;
  static constexpr std::pair<described::Physics, unsigned> holders[] = {
      {everywhere, use::all},
      {planet, use::of_a_drivetrain},
      {thrust, use::mesh},
      {gear_bodies, use::gears_in_motion | use::natural},
      {central_teeth, use::gears_in_motion | use::natural | use::mesh},
      {output, 0},
      {gear_motion, use::gears_in_motion},
      {balance, use::lives | use::bearings_as_springs | use::fmu_bearing | use::planet_stiffness},
      {carrier, use::lives | use::bearings_as_springs | use::fmu_bearing | use::planet_stiffness},
      {carrier_body, use::carrier},
      {walls, use::gears_in_motion | use::natural | use::rollers_in_motion},
      {pin, use::rollers_in_motion | use::bearings_as_springs},
      {load_sharing, use::gears_in_motion | use::quasi_static | use::dynamic_of_sets},
      {positions, use::gears_in_motion | use::quasi_static | use::dynamic_of_sets | use::natural | use::mesh},
      {at_rest, use::rollers_at_rest | use::in_time | use::bearings_as_springs},
      {motion, use::rollers_in_motion},
      {euler, use::dynamic | use::dynamic_of_sets | use::gears | use::fmu_gearset | use::fmu_bearing},
      {life, use::lives | use::fmu_bearing},
      {run, use::in_time},
      {run_up, use::dynamic | use::dynamic_of_sets},
      {single_bearing, 0},  // of machines whose cases are types
      {defect, use::planet_defect},
      {exchange, use::co_simulated}};
  return std::ranges::find(holders, physics, &std::pair<described::Physics, unsigned>::first)->second;
}

// Analyses that ought to hold the physics and leave it out: they warn. Of several sets the meshes give mean
// forces, and crown varies a planet of the mean load.
unsigned leaving_out(described::Physics physics) {
  using enum described::Physics;
  if (physics == gear_bodies || physics == gear_motion || physics == central_teeth)
    return use::dynamic_of_sets;
  // Only the runs for scratched bearings model scratches; the other analyses that move bearings leave them
  // out.
  if (physics == described::Physics::defect)
    return use::lives | use::gears | use::fmu_bearing | use::fmu_gearset | use::planet_stiffness;
  return physics == load_sharing || physics == positions ? use::crown | use::planet_stiffness : 0u;
}

// Differences of single parameters from their physics.
struct Exception {
  std::initializer_list<std::string_view> paths;
  unsigned refused_by = 0;       // analyses that ought to take them and cannot
  unsigned not_modelled_by = 0;  // analyses that vary them themselves, or do not need them
  unsigned unused_by = 0;        // analyses that ought to include them and leave them out
};

constexpr unsigned other_rungs = use::co_simulated | use::monolithic;
constexpr unsigned no_tilt =
    (use::rollers_in_motion & ~(use::dynamic | use::dynamic_of_sets)) | use::planet_stiffness;
constexpr unsigned no_second_gear = use::of_a_drivetrain & ~unsigned{use::quasi_static};
constexpr unsigned but_at_rest = use::of_a_drivetrain & ~unsigned{use::quasi_static | use::mesh};
const Exception exceptions[] = {
    {{"input.acceleration"}, use::quasi_static | other_rungs, 0, use::gears | use::fmu_gearset},
    {{"gearset.planet_rim"}, use::gears | use::fmu_gearset | use::fmu_bearing},
    // Coupled gears start on it; --fidelity dynamic fits a law of its own.
    {{"gearset.dynamics.planet.bearing_stiffness"}, 0, 0, use::dynamic},
    {{"gearset.dynamics.damping_ratio.bearing"}, 0, use::fmu_gearset, use::one_set_in_time},
    {{"simulation.integrator"}, other_rungs | use::fmu_bearing},
    {{"bearing.roller_diameter_deviation"}, use::rollers_at_rest},  // their mean assumes identical rollers
    {{"bearing.misalignment.planet_tilt"}, 0, use::crown},
    // A computed tilt is that of bearings at rest; a single bearing in motion may use it. It has no effect on
    // gears.
    {{"bearing.tilt_state", "bearing.axial_places", "bearing.clearance_differences", "support.pin_ends",
      "support.pin_span", "support.pin_diameter", "support.carrier_twist_stiffness",
      "support.pin_inclination.radial", "support.pin_inclination.tangential"},
     no_tilt,
     use::bearings_as_springs},
    // Stops hold planets and sun under a load; their stiffness affects only small vibration.
    {{"gearset.dynamics.sun.axial_stiffness", "gearset.dynamics.planet.axial_stiffness"}, 0, use::carrier},
    // At rest and in gears alone planets are without weight; an FMU has no angle of its carrier.
    {{"inertia.gravity"},
     use::fmu_bearing | use::fmu_gearset,
     0,
     use::quasi_static | use::crown | use::gears},
    {{"traction.starvation"}, use::fmu_bearing},  // whose speeds change
    {{"film.inlet_heating"}, use::fmu_bearing},
    // Rows of other bearings than cylindrical ones are modelled only quasi-static.
    {{"bearing.rows.contact_angle", "bearing.rows.arrangement", "bearing.rows.distance",
      "bearing.rows.preload", "bearing.rows.approach", "bearing.balls", "bearing.ball_diameter"},
     but_at_rest},
    {{"simulation.load_error_share"}, 0, 0, use::fmu_bearing},  // whose loads are not known before
    // Two gears on a planet, and planets in pairs, are modelled only quasi-static.
    {{"gearset.stepped_planet.teeth", "gearset.stepped_planet.module", "gearset.stepped_planet.profile_shift",
      "gearset.stepped_planet.face_width", "gearset.stepped_planet.offset", "gearset.second_planet.teeth",
      "gearset.second_planet.first_profile_shift", "gearset.second_planet.profile_shift",
      "gearset.second_planet.side"},
     no_second_gear},
    {{"numerics.cage_positions"}, 0, use::dynamic_of_sets}};  // but for what is found at rest before

// Use by the physics of the field, with the exceptions of single parameters.
Use use_by_physics(const described::Facts& facts) {
  Exception but{};
  for (const Exception& exception : exceptions)
    if (is_one_of(facts.path, exception.paths)) but = exception;
  const unsigned without = leaving_out(facts.physics) | but.unused_by;
  const unsigned by = holding(facts.physics) & ~(but.refused_by | but.not_modelled_by | but.unused_by);
  return {by, (use::all & ~(by | but.refused_by | without)) | but.not_modelled_by, but.refused_by};
}

Use also_used(Use use, unsigned analyses) {
  use.by |= analyses;
  use.not_modelled_by &= ~analyses;
  return use;
}

const Condition& where_filmed() {
  static const Condition filmed = where("film.enabled", {"true"});
  return filmed;
}

// Uses beyond the physics, and those that depend on other inputs, for each part of a drivetrain in turn.

// A pin that is held at one end makes the support's stiffness where none is stated.
Use with_pins(const Use& use, std::string_view path) {
  if (!links_rows(path)) return use;
  return use.used_too(use::bearings_as_springs,
                      {where_absent("support.stiffness"), where_pin_links(path), where_tilts_are_computed()});
}

Use with_meshes(Use use, std::string_view path) {
  // Compliance under the planets and its inputs: it affects quasi-static results too where planets carry
  // unequal loads, since it then determines the load sharing.
  if (makes_meshes(path) ||
      is_one_of(path,
                {"bearing.bore", "numerics.cage_positions", "support.stiffness", "gearset.dynamics.sun.mass",
                 "gearset.dynamics.sun.support_stiffness", "gearset.dynamics.ring.mass",
                 "gearset.dynamics.ring.support_stiffness", "gearset.dynamics.carrier.mass",
                 "gearset.dynamics.carrier.support_stiffness", "gearset.dynamics.carrier.plate_ratio",
                 "gearset.dynamics.planet.mass", "gearset.dynamics.backlash", "gearset.dynamics.separation",
                 "gearset.dynamics.transmission_error.sun", "gearset.dynamics.transmission_error.ring"}))
    use = use.used_too(use::quasi_static | use::dynamic_of_sets, where_planets_carry_unlike_loads());
  // Length and form of a relief have an effect where there is one.
  if (is_one_of(path, {"gearset.tip_relief.length", "gearset.tip_relief.form"}))
    return use.when(
        where_given({"gearset.tip_relief.sun", "gearset.tip_relief.planet", "gearset.tip_relief.ring"}));
  // Power and speed determine the load of the meshes, under which teeth deflect and helical teeth exert axial
  // forces; a rim bends under them.
  if (is_one_of(path, {"input.power", "input.application_factor", "input.speed", "input.speed_of",
                       "parallel_stage.front", "gearset.planet_rim"}))
    return also_used(use, use::mesh);
  return use;
}

// Laminae and the tilt of the bore affect lives, and the stiffness too; the model of line contacts has no
// modulus, their films do.
Use with_stiffness(const Use& use, std::string_view path) {
  if (path.starts_with("bearing.misalignment.")) return also_used(use, use::planet_stiffness);
  if (path == "support.pin_diameter") return use.when(where("support.pin_ends", {"flexpin"}));
  if (path == "bearing.laminae") return also_used(use, use::planet_stiffness);
  if (path != "material.youngs_modulus" && path != "material.poisson_ratio") return use;
  return use.used_only(use::planet_stiffness, {where_filmed()})
      .used_too(use::planet_stiffness, where("gearset.planet_rim", {"elastic"}));
}

// Lives include films; elsewhere the oil has an effect where a film takes part in the approach, or where the
// life by its cleanliness depends on its viscosity.
Use with_oil(const Use& use, std::string_view path) {
  std::vector<Condition> viscosity_makes_kappa{where_given({"life.cleanliness", "life.contamination_factor"}),
                                               where_absent("life.viscosity_ratio"),
                                               where_absent("lubricant.kinematic_viscosity")};
  const Condition no_grade = where_absent("lubricant.grade");
  constexpr unsigned with_film_alone = use::bearings_as_springs | use::planet_stiffness | use::crown;
  // It makes the viscosity of a grade, under films, or kinematic that which is stated.
  if (path == "lubricant.density") {
    const Condition grade = where_given({"lubricant.grade"});
    viscosity_makes_kappa.push_back(no_grade);
    return use.used_too(use::quasi_static, grade)
        .used_too(with_film_alone, {grade, where_filmed()})
        .used_too(use::quasi_static | use::crown, viscosity_makes_kappa);
  }
  if (path != "lubricant.viscosity" && path != "lubricant.pressure_viscosity") return use;
  Use oil = use.used_only(with_film_alone, {where_filmed()});
  if (path == "lubricant.viscosity") oil = oil.used_too(use::crown, viscosity_makes_kappa);
  return oil.when(no_grade);
}

// Whether the field affects the race of the planet, and with it its mass: the clearance of a bearing on its
// seats, too.
bool makes_race(std::string_view path) {
  return is_one_of(path, {"bearing.radial_clearance", "bearing.clearance_state", "bearing.per_planet",
                          "bearing.roller_diameter", "bearing.pitch_diameter", "bearing.width"}) ||
         path.starts_with("bearing.fit.") || path.starts_with("bearing.temperature.");
}

// Gears are affected by a bearing through its springs, which the case may state; what makes the mass of a
// planet as well affects them beside these too, and what makes the rim that bends: bearings hold the race in
// it.
Use with_springs(const Use& use, const described::Facts& facts) {
  using enum described::Physics;
  const std::string_view path = facts.path;
  if (makes_race(path)) return use.used_too(use::mesh, where("gearset.planet_rim", {"elastic"}));
  if (is_one_of(path, {"gearset.web.thickness", "gearset.web.rim"}))
    return use.limited(use::gears_in_motion | use::natural | use::quasi_static,
                       {where_true(teeth_make_meshes, "where the stiffness of a mesh is not given")});
  if (path == "material.youngs_modulus")
    return use.limited(use::bearings_as_springs,
                       {where_true(modulus_makes_springs, "where a stiffness is not given")});
  if (path == "material.poisson_ratio")
    return use.limited(use::bearings_as_springs,
                       {where_true(material_makes_springs, "where a stiffness is not given")});
  const bool of_speed = is_one_of(path, {"input.speed", "input.speed_of", "parallel_stage.front"});
  if (of_speed || is_one_of(path, {"input.power", "input.application_factor"}))
    return use.limited(of_speed ? use::modes : use::natural,
                       {where_true(loads_make_springs, "where a stiffness depends on the load")});
  if (is_one_of(path, {"inertia.coriolis", "inertia.carrier_centrifugal"}))
    return use.limited(use::modes, {where_bearings_make_springs()});
  const bool of_bearing = facts.physics == balance || facts.physics == carrier || facts.physics == pin ||
                          facts.physics == at_rest;
  if (!of_bearing || path == "material.density" || path == "gearset.planet_rim") return use;
  return use.limited(use::bearings_as_springs, {where_bearings_make_springs()});
}

// Forces in the frame of the carrier; an FMU of a bearing has its speed as an input.
Use with_rotating_carrier(const Use& use) {
  return use.limited(use::of_a_drivetrain & ~unsigned{use::fmu_bearing},
                     {where_true(carrier_rotates, "where the carrier rotates")});
}

// A carrier that is held pulls on nothing.
Use with_carrier(const Use& use, std::string_view path) {
  if (is_one_of(path, {"inertia.coriolis", "inertia.carrier_centrifugal"})) return with_rotating_carrier(use);
  const std::string rotating = "where the carrier rotates and inertia.carrier_centrifugal is true";
  if (path.starts_with("bearing.cage."))
    return use.limited(use::rollers_at_rest | use::bearings_as_springs,
                       {where_true(carrier_pulls, rotating)});
  const bool of_planet =
      is_one_of(path, {"gearset.face_width", "gearset.addendum", "gearset.clearance",
                       "gearset.root_fillet_radius", "gearset.addendum_of.planet",
                       "gearset.clearance_of.planet", "bearing.outside_diameter", "bearing.width"});
  if (!of_planet) return use;
  // Between the root of its teeth and its bearings.
  const bool of_rim = is_one_of(path, {"gearset.addendum", "gearset.clearance", "gearset.addendum_of.planet",
                                       "gearset.clearance_of.planet", "bearing.outside_diameter"});
  const Use as_mass =
      use.limited(use::rollers_at_rest,
                  {where_true(planet_counts_at_rest,
                              rotating + ", or the planet bends, tilts or is pressed on a seat")})
          .used_too(use::quasi_static, where_planets_carry_unlike_loads());
  return of_rim ? as_mass.used_too(use::quasi_static, std::vector<Condition>{}) : as_mass;
}

// A member that is held does not move, unless a spring holds it.
Use with_held_members(const Use& use, std::string_view path) {
  constexpr std::string_view block = "gearset.dynamics.", mass = ".equivalent_mass";
  if (!path.starts_with(block) || !path.ends_with(mass)) return use;
  const std::string member(path.substr(block.size(), path.size() - block.size() - mass.size()));
  if (member == "planet") return use;
  std::vector<std::string> others{"sun", "ring", "carrier"};
  std::erase(others, member);
  return use.limited(use::natural, {where("gearset.fixed", others), where_absent("gearset.teeth.sun"),
                                    where_given({std::string(block) + member + ".torsional_stiffness"})});
}

// Conditions of single parameters. A set without teeth has no loads to share. With several sets none has a
// driven member of its own, but all share the power.
Use with_own_condition(const Use& use, const described::Facts& facts) {
  described::Where only = facts.details.where;
  if (facts.physics == described::Physics::load_sharing) only = {.path = "input.power"};
  if (only.path.empty()) return use;
  return use.when(condition_of(only));
}

Use with_friction_and_heat(const Use& use, std::string_view path) {
  // Besides the friction of the races, others build up over the same sliding speed.
  constexpr unsigned moving = use::rollers_in_motion | use::planet_defect;
  if (path == "traction.sliding_scale")
    return use.used_too(moving, where_given({"bearing.cage.pocket_friction"}))
        .used_too(moving, where_given({"bearing.cage.guide_land_diameter"}))
        .used_too(moving, where("contact.lubrication", {"mixed"}))
        .used_too(moving,
                  {where("bearing.complement", {"full"}), where_given({"bearing.neighbour_friction"})});
  if (path == "traction.largest_barus_exponent")
    return use.when(where("traction.law", {"limiting-shear", "ree-eyring"}));
  if (path == "film.inlet_heating") return also_used(use, use::quasi_static);
  if (path == "heat.viscosity_slope")
    return use.used_too(use::quasi_static, where("film.inlet_heating", {"gupta"}));
  return use;
}

// Fields that apply only to rollers in planets: balls have neither a model of line contacts nor a film, so
// the field has no effect with them.
Use used_beside_rollers(const Use& use, std::string_view path) {
  if (!is_one_of(path, {"life.reduction_factor", "contact.law", "film.inlet_heating", "heat.viscosity_slope",
                        "lubricant.density"}))
    return use;
  return use.when(where_true(planets_have_rollers, "where the planet bearings have rollers"));
}

// Rows in motion name the nearest resonance of the gears, of which bearings are springs.
Use with_resonances(const Use& use, std::string_view path) {
  if (path != "gearset.dynamics.planet.bearing_stiffness") return use;
  return use.used_too(use::dynamic, where_true(resonances_are_named, "where gearset.mesh_variation is true"))
      .used_too(use::dynamic, where_true(is_one_system, "where bearing.complement is full"));
}

// A pin that is the inner race moves with it, down to its hole.
Use with_moving_pin(const Use& use, std::string_view path) {
  if (path != "bearing.fit.pin_bore") return use;
  return use.used_too(use::rollers_in_motion,
                      where_true(pin_is_race, "where bearing.rings is outer or none"));
}

// Fields of different physics, each of which depends on other choices.
Use with_other_ways(Use use, std::string_view path) {
  const auto at_steady_speed = [&](const Use& any) {
    return any.limited(use::dynamic | use::dynamic_of_sets,
                       {where_true(speed_is_steady, "where input.acceleration is 0")});
  };
  // The diameter of the pin makes its stiffness where none is stated.
  if (path == "bearing.bore")
    for (Way& way : use.ways) way.conditions.push_back(where_absent("support.stiffness"));
  // The outer ring is a part of the planet's mass, and of its rim.
  if (path == "bearing.width")
    use = use.limited(use::rollers_at_rest | use::bearings_as_springs,
                      {where("bearing.rings", {"both", "outer"}), where("gearset.planet_rim", {"elastic"})});
  use = with_friction_and_heat(use, path);
  if (path == "traction.starvation") return at_steady_speed(use);
  if (path == "numerics.cage_positions")
    return use.used_too(use::dynamic_of_sets, where("bearing.tilt_state", {"computed"}));
  if (path == "contact.roughness")
    return use.used_too(use::quasi_static | use::in_time, where("life.viscosity_ratio_by", {"film"}));
  if (path == "bearing.fit.expansion")
    return use.when(where_true(fits_are_warm, "together with a bearing.temperature"));
  if (path == "defect.profile") return use.when(where("defect.race", {"outer", "inner", "ball", "roller"}));
  // The carrier's speed grows in a run-up, and as the master of an FMU has it.
  if (path == "inertia.euler")
    return with_rotating_carrier(
        use.used_only(use::dynamic | use::dynamic_of_sets, {where_given({"input.acceleration"})})
            .used_only(use::gears | use::fmu_gearset,
                       {where_true(gears_run_up,
                                   "together with gearset.dynamics.run_up.duration and a "
                                   "run_up.from other than 1")}));
  // A run-up is observed from its begin to its end.
  if (path == "simulation.observed_revolutions") return at_steady_speed(use);
  // For a driven sun or ring the power determines the tooth force, whichever member is held.
  if (path == "gearset.fixed") return use.used_only(use::mesh, {where("input.member", {"carrier"})});
  return use;
}

}  // namespace

Condition condition_of(const described::Where& where) {
  return {.paths = parts_of(where.path, '|'),
          .values = where.value.empty() ? std::vector<std::string>{} : parts_of(where.value, '|')};
}

Use use_of(const described::Facts& facts) {
  const std::string_view path = facts.path;
  Use use = with_meshes(with_pins(use_by_physics(facts), path), path);
  use = with_oil(with_stiffness(use, path), path);
  use = with_carrier(with_springs(with_held_members(use, path), facts), path);
  use = with_other_ways(with_own_condition(use, facts), path);
  return with_moving_pin(with_resonances(used_beside_rollers(use, path), path), path);
}

Use with_carrier_beside(const Use& use, std::string_view path) {
  const Condition body =
      where_true(carrier_is_body,
                 "where gearset.carrier.bearing_positions and bearing_stiffness are given, "
                 "gearset.fixed is ring and gearset.planet_rim is rigid");
  const auto with_body = [&](std::vector<Condition> conditions) {
    conditions.push_back(body);
    return conditions;
  };
  Use more = use;
  if ((use.by & use::carrier) != 0 && (use.by & use::quasi_static) == 0)
    more = more.used_too(use::quasi_static, with_body(use.conditions));
  for (const Way& way : use.ways)
    if ((way.by & use::carrier) != 0 && (way.by & use::quasi_static) == 0)
      more = more.used_too(use::quasi_static, with_body(way.conditions));
  // Inputs that a set in its plane does not have; loads, clearance and weight do not change its springs.
  if (is_one_of(path, {"gearset.carrier.bearing_positions", "gearset.carrier.bearing_stiffness",
                       "gearset.carrier.housing_stiffness", "gearset.carrier.centre_of_mass",
                       "bearing.axial_places", "bearing.roller_length",
                       "gearset.dynamics.ring.equivalent_mass", "gearset.dynamics.sun.tilt_stiffness",
                       "gearset.dynamics.sun.axial_stiffness", "gearset.dynamics.planet.axial_stiffness"}))
    more = more.used_too(use::modes, body);
  if (links_rows(path)) more = more.used_too(use::modes, with_body(where_body_has_pin(path)));
  return more;
}

std::vector<Condition> where_body_has_pin(std::string_view path) {
  if (path == "support.pin_diameter") return {where_pin_links(path), where_tilts_are_computed()};
  return {where_true(pin_links_rows,
                     "where support.pin_ends is one or flexpin, or bearing.per_planet is above 2"),
          where_tilts_are_computed()};
}

Condition where_bearings_make_springs() {
  return where_true(
      bearings_make_springs,
      "where gearset.dynamics.planet.bearing_stiffness is not given, or together with an elastic rim");
}

}  // namespace orbearing::app
