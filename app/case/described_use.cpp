// Who uses the fields whose rows stand beside their members: use_of() of field_use.hpp. Beside the other
// pairs of this folder it has no header of its own, since what it asks of a case stands above the fields.
#include <algorithm>
#include <initializer_list>
#include <iterator>

#include "app/case/field_use.hpp"
#include "app/case/use_conditions.hpp"

namespace orbearing::app {

namespace {

// Analyses that hold the physics. What belongs to it alone has no effect on others.
unsigned holding(described::Physics physics) {
  using enum described::Physics;
  switch (physics) {
    case everywhere:
      return use::all;
    case planet:
      return use::of_a_drivetrain;
    case pair:
    case thrust:
      return use::mesh;
    case gear_bodies:
      return use::gears_in_motion | use::natural;
    case central_teeth:
      return use::gears_in_motion | use::natural | use::mesh;
    case output:
      return 0;
    case gear_motion:
      return use::gears_in_motion;
    case balance:
      return use::lives | use::bearings_as_springs | use::fmu_bearing | use::single_bearing_equilibrium |
             use::balls_in_motion | use::defect | use::duplex | use::planet_stiffness;
    case carrier:
      return use::lives | use::bearings_as_springs | use::fmu_bearing | use::balls_in_motion |
             use::planet_stiffness;
    case carrier_body:
      return use::carrier;
    case walls:
      return use::gears_in_motion | use::natural | use::rollers_in_motion;
    case pin:
      return use::rollers_in_motion | use::bearings_as_springs | use::balls_in_motion;
    case load_sharing:
      return use::gears_in_motion | use::quasi_static | use::dynamic_of_sets;
    case positions:
      return use::gears_in_motion | use::quasi_static | use::dynamic_of_sets | use::natural | use::mesh;
    case at_rest:
      return use::rollers_at_rest | use::in_time | use::bearings_as_springs;
    case motion:
      return use::rollers_in_motion | use::balls_in_motion;
    case euler:
      return use::dynamic | use::dynamic_of_sets | use::gears | use::fmu_gearset | use::fmu_bearing;
    case life:
      return use::lives | use::fmu_bearing | use::static_load;
    case run:
      return use::in_time;
    case run_up:
      return use::dynamic | use::dynamic_of_sets;
    case single_bearing:
      return use::single_bearing_equilibrium | use::balls_in_motion | use::defect | use::duplex;
    case rotating_balls:
      return use::single_bearing_equilibrium | use::duplex;
    case single_bearing_run:
      return use::ball_run;
    case defect:
      return use::defect | use::moving_defect | use::planet_defect;
    case exchange:
      return use::co_simulated;
    case one_contact:
      return use::spin_film;
  }
  return 0;
}

// Analyses that ought to hold the physics and leave it out: they warn. Of several sets the meshes give mean
// forces, and crown varies a planet of the mean load.
unsigned leaving_out(described::Physics physics) {
  using enum described::Physics;
  if (physics == gear_bodies || physics == gear_motion || physics == central_teeth)
    return use::dynamic_of_sets;
  // All that moves bearings knows none with scratches but what is run for them.
  if (physics == described::Physics::defect)
    return use::lives | use::gears | use::fmu_bearing | use::fmu_gearset | use::planet_stiffness;
  return physics == load_sharing || physics == positions ? use::crown | use::planet_stiffness : 0u;
}

// How single parameters differ from what their physics says.
struct Exception {
  std::string_view path;
  unsigned refused_by = 0;       // analyses that ought to take it and cannot
  unsigned not_modelled_by = 0;  // analyses that vary it themselves, or do not need it
  unsigned unused_by = 0;        // analyses that ought to include it and leave it out
};

constexpr unsigned other_rungs = use::co_simulated | use::monolithic;
constexpr unsigned no_tilt =
    (use::rollers_in_motion & ~(use::dynamic | use::dynamic_of_sets)) | use::planet_stiffness;
constexpr unsigned no_second_gear = use::of_a_drivetrain & ~unsigned{use::quasi_static};
constexpr unsigned but_at_rest = use::of_a_drivetrain & ~unsigned{use::quasi_static | use::mesh};
constexpr Exception exceptions[] = {
    {"input.acceleration", use::quasi_static | other_rungs, 0, use::gears | use::fmu_gearset},
    {"gearset.planet_rim", use::gears | use::fmu_gearset | use::fmu_bearing},
    // Coupled gears start on it; --fidelity dynamic fits a law of its own.
    {"gearset.dynamics.planet.bearing_stiffness", 0, 0, use::dynamic},
    {"gearset.dynamics.damping_ratio.bearing", 0, use::fmu_gearset, use::one_set_in_time},
    {"film.approach", other_rungs | use::fmu_bearing},
    {"bearing.roller_diameter_deviation", use::rollers_at_rest},  // their mean knows like rollers
    {"bearing.cage.reference_speed", other_rungs | use::fmu_bearing},
    {"bearing.misalignment.planet_tilt", 0, use::crown},
    // A computed tilt is that of bearings at rest, with which one bearing may go on; it has no effect on
    // gears.
    {"bearing.tilt_state", no_tilt, use::bearings_as_springs},
    {"bearing.axial_places", no_tilt, use::bearings_as_springs},
    {"bearing.clearance_differences", no_tilt, use::bearings_as_springs},
    {"support.pin_ends", no_tilt, use::bearings_as_springs},
    {"support.pin_span", no_tilt, use::bearings_as_springs},
    {"support.carrier_twist_stiffness", no_tilt, use::bearings_as_springs},
    {"support.pin_inclination.radial", no_tilt, use::bearings_as_springs},
    {"support.pin_inclination.tangential", no_tilt, use::bearings_as_springs},
    {"load.tilt", use::ball_run},
    {"traction.starvation", use::fmu_bearing},  // whose speeds change
    {"film.inlet_heating", use::fmu_bearing},
    // Rows of other bearings than cylindrical ones are known at rest alone.
    {"bearing.rows.contact_angle", but_at_rest},
    {"bearing.rows.arrangement", but_at_rest},
    {"bearing.rows.distance", but_at_rest},
    {"bearing.rows.preload", but_at_rest},
    {"bearing.rows.approach", but_at_rest},
    {"bearing.balls", but_at_rest},
    {"bearing.ball_diameter", but_at_rest},
    // Contacts and oil of the whole motion have damping and steps of their own.
    {"contact.damping_ratio", 0, use::moving_defect},
    {"contact.damping_model", 0, use::moving_defect},
    {"signal.length_error", 0, use::moving_defect},
    {"simulation.integrator", other_rungs | use::fmu_bearing},
    {"simulation.load_error_share", 0, 0, use::fmu_bearing},  // whose loads are not known before
    // Two gears on a planet are known at rest.
    {"gearset.stepped_planet.teeth", no_second_gear},
    {"gearset.stepped_planet.module", no_second_gear},
    {"gearset.stepped_planet.profile_shift", no_second_gear},
    {"gearset.stepped_planet.face_width", no_second_gear},
    {"gearset.stepped_planet.offset", no_second_gear},
    // So are planets in pairs.
    {"gearset.second_planet.teeth", no_second_gear},
    {"gearset.second_planet.first_profile_shift", no_second_gear},
    {"gearset.second_planet.profile_shift", no_second_gear},
    {"gearset.second_planet.side", no_second_gear},
    {"numerics.cage_positions", 0, use::dynamic_of_sets}};  // but for what is found at rest before

// What gives way under the planets besides, with its ends: it counts at rest too where planets carry unlike
// loads, since then it decides who carries how much.
constexpr std::string_view giving_way[] = {"bearing.bore",
                                           "numerics.cage_positions",
                                           "support.stiffness",
                                           "gearset.dynamics.sun.mass",
                                           "gearset.dynamics.sun.support_stiffness",
                                           "gearset.dynamics.ring.mass",
                                           "gearset.dynamics.ring.support_stiffness",
                                           "gearset.dynamics.carrier.mass",
                                           "gearset.dynamics.carrier.support_stiffness",
                                           "gearset.dynamics.carrier.plate_ratio",
                                           "gearset.dynamics.planet.mass",
                                           "gearset.dynamics.backlash",
                                           "gearset.dynamics.separation",
                                           "gearset.dynamics.transmission_error.sun",
                                           "gearset.dynamics.transmission_error.ring"};

Use with_load_sharing(const Use& use, std::string_view path) {
  const bool gives_way = makes_meshes(path) || std::find(std::begin(giving_way), std::end(giving_way),
                                                         path) != std::end(giving_way);
  return gives_way
             ? use.used_too(use::quasi_static | use::dynamic_of_sets, where_planets_carry_unlike_loads())
             : use;
}

// "one|other"
std::vector<std::string> either_of(std::string_view values) {
  std::vector<std::string> found;
  for (std::size_t bar = 0; bar != std::string_view::npos; values.remove_prefix(bar + 1)) {
    bar = values.find('|');
    found.emplace_back(values.substr(0, bar));
    if (bar == std::string_view::npos) break;
  }
  return found;
}

Exception exception_of(std::string_view path) {
  for (const Exception& exception : exceptions)
    if (exception.path == path) return exception;
  return {path};
}

Use also_used(Use use, unsigned analyses) {
  use.by |= analyses;
  use.not_modelled_by &= ~analyses;
  return use;
}

// Power and speed make the load of the meshes, under which teeth give way and helical ones push along the
// axis.
Use with_mesh_loads(const Use& use, std::string_view path) {
  const bool makes_them = path == "input.power" || path == "input.application_factor" ||
                          path == "input.speed" || path == "input.speed_of" || path == "parallel_stage.front";
  return makes_them ? also_used(use, use::mesh) : use;
}

// Length and form of a relief count where there is one.
Use with_relief(const Use& use, std::string_view path) {
  if (path != "gearset.tip_relief.length" && path != "gearset.tip_relief.form") return use;
  return use.when(
      where_given({"gearset.tip_relief.sun", "gearset.tip_relief.planet", "gearset.tip_relief.ring"}));
}

// Laminae and what tilts the bore belong to lives, and change the stiffness too; the law of line
// contacts knows no modulus, their films do.
Use with_stiffness(Use use, std::string_view path) {
  if (path.starts_with("bearing.misalignment.")) return also_used(use, use::planet_stiffness);
  if (path == "gearset.planet_rim") return also_used(use, use::mesh);
  if (path == "bearing.laminae") return also_used(use, use::stiffness | use::planet_stiffness);
  if (path != "material.youngs_modulus" && path != "material.poisson_ratio") return use;
  return use.used_only(use::planet_stiffness, {where("film.enabled", {"true"})})
      .used_too(use::planet_stiffness, where("gearset.planet_rim", {"elastic"}));
}

// The mass of balls counts, and the film under them, where a ring turns.
Use with_rotating_rings(const Use& use, const described::Facts& facts) {
  Condition rotating = where_given({"operation.shaft_speed", "operation.outer_speed", "operation.speeds"});
  if (facts.physics == described::Physics::rotating_balls) return use.when(rotating);
  if (facts.path == "material.density")
    return use.used_too(
        use::single_bearing_equilibrium | use::duplex,
        {rotating, where_given({"bearing.balls"}), where("equilibrium.ball_inertia", {"true"})});
  if (facts.path == "film.enabled") {
    rotating.paths.emplace_back("input.speed");  // planets turn always
    return also_used(use, use::single_bearing_equilibrium).when(rotating);
  }
  return use;
}

const Condition& where_filmed() {
  static const Condition filmed = where("film.enabled", {"true"});
  return filmed;
}

std::vector<Condition> where_viscosity_makes_kappa() {
  return {where_given({"life.cleanliness", "life.contamination_factor"}),
          where_absent("life.viscosity_ratio"), where_absent("lubricant.kinematic_viscosity")};
}

// It makes the viscosity of a grade, under films, or kinematic that which is stated.
Use with_density(const Use& use) {
  const Condition grade = where_given({"lubricant.grade"});
  std::vector<Condition> stated = where_viscosity_makes_kappa();
  stated.push_back(where_absent("lubricant.grade"));
  return use.used_too(use::quasi_static, grade)
      .used_too(use::crown | use::planet_stiffness | use::bearings_as_springs, {grade, where_filmed()})
      .used_too(use::quasi_static | use::crown, stated);
}

bool share_is_stated(const ResolvedCase& in, std::string_view) {
  return !in.has("lubricant.fill") || in.choice("lubricant.fill") == "stated";
}

// Films stand in results of lives; elsewhere the oil counts where a film takes part in the approach, or
// where the life by its cleanliness is made of its viscosity.
Use with_oil(const Use& use, std::string_view path) {
  if (path == "lubricant.density") return with_density(use);
  if (path == "lubricant.flow")
    return use.when(where("drag.mixture", {"carried"}))
        .when(where("drag.enabled", {"true"}))
        .used_too(use::ball_run, {where("lubricant.fill", {"parker"}), where("drag.enabled", {"true"})})
        .used_too(use::ball_run, where("heat.enabled", {"true"}));
  if (path == "lubricant.share")
    return use.when(where_true(share_is_stated, "where lubricant.fill is stated"));
  if (path != "lubricant.viscosity" && path != "lubricant.pressure_viscosity") return use;
  constexpr unsigned with_film_alone = use::bearings_as_springs | use::planet_stiffness | use::crown;
  Use oil = also_used(use, use::spin_film)
                .used_only(with_film_alone, {where_filmed()})
                .used_too(use::single_bearing_equilibrium, where_filmed());
  if (path == "lubricant.viscosity") oil = oil.used_too(use::crown, where_viscosity_makes_kappa());
  return oil.when(where_absent("lubricant.grade"));
}

// Besides the friction of the races, others build up over the same sliding speed.
Use with_other_frictions(const Use& use) {
  constexpr unsigned moving = use::rollers_in_motion | use::balls_in_motion | use::planet_defect;
  return use.used_too(moving, where_given({"bearing.cage.pocket_friction"}))
      .used_too(moving, where_given({"bearing.cage.guide_land_diameter"}))
      .used_too(moving, where("contact.lubrication", {"mixed"}))
      .used_too(moving, {where("bearing.complement", {"full"}), where_given({"bearing.neighbour_friction"})});
}

Condition where_gears_run_up() {
  return where_true(gears_run_up,
                    "together with gearset.dynamics.run_up.duration and a run_up.from other than 1");
}

// The carrier's speed grows in a run-up, and as the master of an FMU has it.
Use with_run_up(const Use& use) {
  return use.used_only(use::dynamic | use::dynamic_of_sets, {where_given({"input.acceleration"})})
      .used_only(use::gears | use::fmu_gearset, {where_gears_run_up()});
}

// Forces in the frame of the carrier; an FMU of a bearing has its speed as an input.
Use with_rotating_carrier(const Use& use) {
  return use.limited(use::of_a_drivetrain & ~unsigned{use::fmu_bearing},
                     {where_true(carrier_rotates, "where the carrier rotates")});
}

// The diameter of the pin makes its stiffness where none is stated.
Use with_pins(const Use& use) {
  const Condition derived = where_absent("support.stiffness");
  Use pins = use;
  for (Way& way : pins.ways) way.conditions.push_back(derived);
  return pins;
}

bool is_one_of(std::string_view path, std::initializer_list<std::string_view> paths) {
  return std::find(paths.begin(), paths.end(), path) != paths.end();
}

// What makes the clearance of a bearing on its seats.
bool makes_clearance(std::string_view path) {
  return is_one_of(path, {"bearing.radial_clearance", "bearing.clearance_state"}) ||
         path.starts_with("bearing.fit.") || path.starts_with("bearing.temperature.");
}

// What makes the race of the planet, and with it its mass.
bool makes_race(std::string_view path) {
  return makes_clearance(path) || is_one_of(path, {"bearing.per_planet", "bearing.roller_diameter",
                                                   "bearing.pitch_diameter", "bearing.width"});
}

// What makes the rim that bends: bearings hold the race in it.
Use with_rim(const Use& use, std::string_view path) {
  return makes_race(path) ? use.used_too(use::mesh, where("gearset.planet_rim", {"elastic"})) : use;
}

// Gears are affected by a bearing through its springs, which the case may state; what makes the mass of a
// planet as well affects them beside these too.
Use with_springs(const Use& use, const described::Facts& facts) {
  using enum described::Physics;
  const std::string_view path = facts.path;
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
  if (!of_bearing || makes_race(path) || path == "material.density" || path == "gearset.planet_rim")
    return use;
  return use.limited(use::bearings_as_springs, {where_bearings_make_springs()});
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
  return use
      .limited(use::rollers_at_rest,
               {where_true(planet_counts_at_rest,
                           rotating + ", or the planet bends, tilts or is pressed on a seat")})
      .used_too(use::quasi_static, where_planets_carry_unlike_loads());
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

// The outer ring is a part of the planet's mass, and of its rim.
Use with_ring_width(const Use& use) {
  return use.limited(use::rollers_at_rest | use::bearings_as_springs,
                     {where("bearing.rings", {"both", "outer"}), where("gearset.planet_rim", {"elastic"})});
}

// Friction of a single bearing by the formulas of others goes by its boundary dimensions.
Use with_friction_of_others(const Use& use) {
  return use.used_too(use::static_load, {where_given({"lubricant.grade", "lubricant.kinematic_viscosity"}),
                                         where_given({"operation.shaft_speed", "operation.outer_speed"})});
}

// Oil and heat of a roller bearing at rest count for its friction.
Use with_roller_friction(const Use& use, std::string_view path) {
  const bool of_heat = is_one_of(path, {"heat.model", "heat.inlet"});
  if (!of_heat &&
      !is_one_of(path, {"heat.enabled", "lubricant.flow", "lubricant.share", "traction.starvation"}))
    return use;
  std::vector<Condition> rotating{where_given({"lubricant.grade", "lubricant.kinematic_viscosity"}),
                                  where_given({"operation.shaft_speed", "operation.outer_speed"})};
  if (of_heat) rotating.push_back(where("heat.enabled", {"true"}));
  return use.used_too(use::static_load, std::move(rotating));
}

// Fields of unlike physics, of which each hangs on other choices.
Use with_other_ways(const Use& without, std::string_view path) {
  const Use use = with_roller_friction(without, path);
  if (path == "traction.sliding_scale") return with_other_frictions(use);
  if (path == "traction.largest_barus_exponent")
    return use.when(where("traction.law", {"limiting-shear", "ree-eyring"}));
  if (is_one_of(path, {"heat.surroundings", "heat.contact_conductance", "heat.oil_conductance",
                       "heat.fit_conductance", "heat.housing_conductance", "heat.shaft_conductance",
                       "heat.expansion", "heat.sizes_temperature"}))
    return use.when(where("heat.model", {"network"}));
  if (path == "traction.starvation")
    return use.limited(use::dynamic | use::dynamic_of_sets,
                       {where_true(speed_is_steady, "where input.acceleration is 0")});
  if (path == "film.inlet_heating") return also_used(use, use::quasi_static);
  if (path == "heat.viscosity_slope")
    return use.used_too(use::quasi_static, where("film.inlet_heating", {"gupta"}));
  if (path == "numerics.cage_positions")
    return use.used_too(use::dynamic_of_sets, where("bearing.tilt_state", {"computed"}));
  if (path == "traction.limiting_friction")
    return use.used_too(use::balls_in_motion, where("traction.law", {"ree-eyring"}));
  // Masses of rings warm up; that of the ring at rest counts for nothing besides.
  if (path == "bearing.outside_diameter")
    return with_friction_of_others(use)
        .used_too(use::ball_run, where("heat.enabled", {"true"}))
        .used_too(use::ball_run, where_given({"bearing.designation", "bearing.bore"}));
  if (path == "contact.roughness")
    return use.used_too(use::quasi_static | use::in_time, where("life.viscosity_ratio_by", {"film"}));
  if (path == "bearing.fit.expansion")
    return use.when(where_true(fits_are_warm, "together with a bearing.temperature"));
  if (path == "defect.profile") return use.when(where("defect.race", {"outer", "inner", "ball", "roller"}));
  if (path == "material.density") return with_friction_of_others(use);  // of rollers that turn
  if (path == "bearing.width") return with_friction_of_others(with_ring_width(use));
  if (path == "inertia.euler") return with_rotating_carrier(with_run_up(use));
  // A run-up is observed from its begin to its end.
  if (path == "simulation.observed_revolutions")
    return use.limited(use::dynamic | use::dynamic_of_sets,
                       {where_true(speed_is_steady, "where input.acceleration is 0")});
  if (path == "bearing.bore") return with_friction_of_others(with_pins(use));
  // Of a driven sun or ring the power makes the force of the teeth, whichever member is held.
  if (path == "gearset.fixed") return use.used_only(use::mesh, {where("input.member", {"carrier"})});
  return use;
}

// A set without teeth has no loads to share. Of several sets none has a driven member of its own, but all
// share the power.
described::Where only_where(const described::Facts& facts) {
  if (facts.physics == described::Physics::load_sharing) return {.path = "input.power"};
  return facts.details.where;
}

}  // namespace

Use use_of(const described::Facts& facts) {
  const Exception but = exception_of(facts.path);
  const unsigned without = leaving_out(facts.physics) | but.unused_by;
  const unsigned by = holding(facts.physics) & ~(but.refused_by | but.not_modelled_by | but.unused_by);
  const unsigned not_modelled = (use::all & ~(by | but.refused_by | without)) | but.not_modelled_by;
  const Use at_rest =
      with_mesh_loads(with_load_sharing(Use(by, not_modelled, but.refused_by), facts.path), facts.path);
  const Use with_films = with_oil(
      with_relief(with_rotating_rings(with_stiffness(at_rest, facts.path), facts), facts.path), facts.path);
  const Use use = with_carrier(
      with_springs(with_held_members(with_rim(with_films, facts.path), facts.path), facts), facts.path);
  const described::Where only = only_where(facts);
  if (only.path.empty()) return with_other_ways(use, facts.path);
  const std::vector<std::string> paths = either_of(only.path);
  return with_other_ways(
      use.when(only.value.empty() ? where_given(paths)
                                  : Condition{.paths = paths, .values = either_of(only.value)}),
      facts.path);
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
  // What a set in its plane does not know; loads, clearance and weight leave its springs as they are.
  if (is_one_of(path,
                {"gearset.carrier.bearing_positions", "gearset.carrier.bearing_stiffness",
                 "gearset.carrier.housing_stiffness", "gearset.carrier.centre_of_mass",
                 "bearing.axial_places", "bearing.roller_length", "gearset.dynamics.ring.equivalent_mass"}))
    more = more.used_too(use::modes, body);
  return more;
}

Condition where_bearings_make_springs() {
  return where_true(
      bearings_make_springs,
      "where gearset.dynamics.planet.bearing_stiffness is not given, or together with an elastic rim");
}

}  // namespace orbearing::app
