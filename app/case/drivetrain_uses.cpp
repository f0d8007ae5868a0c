// Uses of the fields whose rows are beside their members: use_of() of field_use.hpp. Members are named here,
// and their keys follow from their rows. Unlike the other pairs of this folder it has no header of its own,
// since its conditions on a case are declared above the fields.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "app/case/case_shape.hpp"
#include "app/case/drivetrain_analyses.hpp"
#include "app/case/field_use.hpp"
#include "app/case/spectrum_case.hpp"
#include "app/case/text_parts.hpp"
#include "app/case/use_conditions.hpp"
#include "bearing/contact/traction_law.hpp"
#include "coupling/analysis/drivetrain_physics.hpp"
#include "mechanics/member_keys.hpp"

namespace orbearing::app {

namespace {

using analysis::Physics;

// Members of Use that hold the possible uses of a field by an analysis.
constexpr AnalysisSet Use::*statuses[]{&Use::by, &Use::not_modelled_by, &Use::refused_by};

void put(Use& use, AnalysisId analysis, AnalysisSet Use::*status) {
  for (AnalysisSet Use::*other : statuses) use.*other = (use.*other).without(analysis);
  use.*status |= analysis;
}

// `analysis` does with a field what `leader` does, its ways apart.
void follow(Use& use, AnalysisId analysis, AnalysisId leader) {
  for (AnalysisSet Use::*status : statuses) {
    use.*status = (use.*status).without(analysis);
    if ((use.*status).has(leader)) use.*status |= analysis;
  }
}

Use also_used(Use use, AnalysisSet analyses) {
  use.by |= analyses;
  use.not_modelled_by = use.not_modelled_by.without(analyses);
  return use;
}

/// Rules of the uses, by the members that they are about.
class UseRules {
  using enum AnalysisId;

 public:
  UseRules();

  // Words of conditions, and members that they are about (field_use.hpp).
  Condition unlike_loads() const {
    return where_given(
        {key_(gears_.pin_error_radial), key_(gears_.pin_error_tangential), key_(teeth_.planet_angles)});
  }
  bool link_rows(std::string_view path) const { return is_among(pin_links_, path); }
  Condition pin_links(std::string_view path) const {
    const std::string& ends = key_(planets_.seats.ends);
    return path == pin_diameter_ ? where(ends, {"flexpin"}) : where(ends, {"one", "flexpin"});
  }
  Condition tilts_are_computed() const { return where(tilt_, {"computed"}); }
  std::vector<Condition> body_has_pin(std::string_view path) const {
    if (path == pin_diameter_) return {pin_links(path), tilts_are_computed()};
    return {where_true(pin_links_rows, "where " + key_(planets_.seats.ends) + " is one or flexpin, or " +
                                           key_(planets_.bearings_per_planet) + " is above 2"),
            tilts_are_computed()};
  }
  Condition bearings_are_springs() const {
    return where_true(bearings_make_springs,
                      "where " + spring_ + " is not given, or together with an elastic rim");
  }

  Use with_planet_defect(const Use& use, std::string_view path) const;
  Use with_carrier_body(Use use, std::string_view path) const;
  Use with_carrier_beside(const Use& use, std::string_view path) const;

  bool know(const std::string& path) const { return physics_.contains(path); }
  bool make_meshes(std::string_view path) const { return is_among(meshes_, path); }
  Use use_of(const std::string& path, const described::Where& row) const {
    Use use = with_meshes(with_pins(by_physics(path), path), path);
    use = with_oil(with_stiffness(use, path), path);
    use = with_carrier(with_springs(with_held_members(use, path), path), path);
    use = with_other_ways(with_own_condition(use, path, row), path);
    return with_moving_pin(with_resonances(beside_rollers(use, path), path), path);
  }

 private:
  /// Keys of members, with all that is within them.
  using Keys = std::vector<std::string>;
  template <class... Members>
  Keys of(const Members&... members) const {
    return key_.of(members...);
  }
  static bool is_among(const Keys& keys, std::string_view path) {
    return std::ranges::find(keys, path) != keys.end();
  }

  /// Differences of single members from their physics.
  struct Exception {
    Keys keys;
    AnalysisSet refused_by{};       // analyses that ought to take them and cannot
    AnalysisSet not_modelled_by{};  // analyses that vary them themselves, or do not need them
    AnalysisSet unused_by{};        // analyses that ought to include them and leave them out
  };

  /// None: the input is one of the rating, or of other machines alone.
  std::optional<Physics> physics_of(const std::string& path) const {
    const auto found = physics_.find(path);
    return found == physics_.end() ? std::nullopt : std::optional(found->second);
  }

  Use by_physics(const std::string& path) const;
  Use with_pins(const Use& use, std::string_view path) const;
  Use with_meshes(Use use, std::string_view path) const;
  Use with_stiffness(const Use& use, std::string_view path) const;
  Use with_oil(const Use& use, std::string_view path) const;
  Use with_springs(const Use& use, const std::string& path) const;
  Use with_rotating_carrier(const Use& use) const;
  Use with_carrier(const Use& use, std::string_view path) const;
  Use with_held_members(const Use& use, std::string_view path) const;
  Use with_own_condition(const Use& use, const std::string& path, const described::Where& row) const;
  Use with_friction_and_heat(const Use& use, std::string_view path) const;
  Use with_other_ways(Use use, std::string_view path) const;
  Use beside_rollers(const Use& use, std::string_view path) const;
  Use with_resonances(const Use& use, std::string_view path) const;
  Use with_moving_pin(const Use& use, std::string_view path) const;

  /// Without the laws of friction that rollers lack.
  Condition of_rollers(Condition condition) const {
    if (condition.paths == Keys{key_(race_.traction)})
      std::erase_if(condition.values, [](const std::string& value) {
        const auto law = value_named<bearing::TractionLaw>(value);
        return law && !nature_of(*law).of_rollers;
      });
    return condition;
  }
  Condition filmed() const { return where(film_, {"true"}); }
  Condition rim_bends() const { return where(rim_, {"elastic"}); }

  const analysis::DrivetrainRows rows_;
  const mechanics::MemberKeys<analysis::DrivetrainRows> key_{rows_};
  const analysis::StatedSet& set_ = rows_.set;
  const analysis::PlanetaryDrivetrain& planets_ = set_.planets;
  const gearset::PlanetarySet& teeth_ = set_.teeth;
  const analysis::GearDynamicsChoice& gears_ = set_.gears.choice;
  const bearing::Bearing& bearing_ = planets_.bearing;
  const bearing::motion::RaceContactParameters& race_ = planets_.dynamics.race;
  const bearing::motion::CageParameters& cage_ = planets_.dynamics.cage;
  const bearing::InertiaSwitches& inertia_ = planets_.dynamics.inertia;
  const analysis::LifeInputs& life_ = set_.rating.life;
  const analysis::BearingOil& oil_ = set_.rating.oil;

  const AnalysisSet all_ = all_of_drivetrains(), springs_ = analyses_with(Physics::springs),
                    vibration_ = analyses_with(Physics::vibration),
                    moving_gears_ = analyses_with(Physics::gear_motion),
                    moving_rollers_ = analyses_with(Physics::motion),
                    at_equilibrium_ = analyses_with(Physics::equilibrium),
                    in_time_ = analyses_with(Physics::run), coupled_ = analyses_with(Physics::coupled),
                    one_set_in_time_ = analyses_of_one_set_in_time();

  const std::map<std::string, Physics, std::less<>>& physics_ = analysis::physics_of_inputs();
  std::vector<Exception> exceptions_;

  // Members that several rules are about.
  const std::string film_ = key_(race_.film_in_approach), rim_ = key_(planets_.rim),
                    tilt_ = key_(planets_.seats.tilt), support_ = key_(planets_.dynamics.support.stiffness),
                    bore_ = key_(bearing_.inner.seat_diameter), width_ = key_(bearing_.width),
                    pin_diameter_ = key_(planets_.seats.diameter), power_ = key_(rows_.drive.power),
                    grade_ = key_(oil_.stated.grade),
                    density_of_oil_ = key_(planets_.dynamics.drag.oil_density),
                    viscosity_ = key_(planets_.dynamics.lubricant.viscosity),
                    spring_ = key_(gears_.bearing_stiffness),
                    acceleration_ = key_(planets_.run_up.acceleration),
                    modulus_ = key_(set_.gears.material.youngs_modulus),
                    ratio_ = key_(set_.gears.material.poisson_ratio);
  const Keys speed_and_stages_ = of(rows_.drive.speed, rows_.drive.speed_of, rows_.drive.parallel.front),
             load_ = of(rows_.drive.power, rows_.drive.application_factor);
  /// The stiffness of the meshes, beside what makes the planets themselves.
  const Keys meshes_ = of(teeth_.sun_heights, teeth_.ring_heights, teeth_.web, teeth_.flanks,
                          gears_.sun_mesh_stiffness, gears_.ring_mesh_stiffness);
  /// Compliance under the planets and its inputs, beside the meshes.
  const Keys compliance_ =
      of(bearing_.inner.seat_diameter, planets_.cage_positions, planets_.dynamics.support.stiffness,
         gears_.sun.mass, gears_.sun.support_stiffness, gears_.ring.mass, gears_.ring.support_stiffness,
         gears_.carrier.mass, gears_.carrier.support_stiffness, gears_.carrier_plate_ratio,
         gears_.planet.mass, gears_.backlash, gears_.separation, gears_.sun_error, gears_.ring_error);
  const Keys oil_inputs_ = of(planets_.dynamics.drag.oil_density, planets_.dynamics.lubricant.viscosity,
                              planets_.dynamics.lubricant.pressure_viscosity);
  const Keys relief_ = of(teeth_.flanks.relief_length, teeth_.flanks.relief_form);
  /// The race of the planet, and with it its mass: the clearance of a bearing on its seats, too.
  const Keys race_of_planet_ =
      of(bearing_.radial_clearance, planets_.mounting.state, planets_.bearings_per_planet,
         bearing_.rollers().diameter, bearing_.pitch_diameter, bearing_.width,
         planets_.mounting.inner_interference, planets_.mounting.outer_interference,
         planets_.mounting.pin_bore, planets_.mounting.expansion, planets_.mounting.pin_temperature,
         planets_.mounting.inner_ring_temperature, planets_.mounting.roller_temperature,
         planets_.mounting.outer_ring_temperature, planets_.mounting.planet_temperature);
  /// Between the root of a planet's teeth and its bearings.
  const Keys rim_sizes_ =
      of(teeth_.rack.addendum, teeth_.rack.clearance, teeth_.planet_heights, bearing_.outer.seat_diameter);
  const Keys of_planet_ = of(teeth_.face_width, teeth_.rack.root_fillet_radius, bearing_.width);
  const Keys of_rollers_ = of(planets_.reduction_factor, bearing_.contact_law, race_.film_heating,
                              race_.viscosity_slope, planets_.dynamics.drag.oil_density);
  const Keys misalignment_ = of(planets_.misalignment), cage_sizes_ = of(bearing_.cage),
             motion_of_cage_ = of(planets_.dynamics.cage),
             frame_ = of(inertia_.coriolis, inertia_.carrier_centrifugal), web_ = of(teeth_.web);

  // Of a scratched planet bearing: inputs of the scratch; and those of lives, and of bearings without a cage,
  // which it does not model.
  const Keys scratch_ = of(rows_.scratch, rows_.position, rows_.sampling, rows_.band);
  const Keys beside_scratch_ =
      of(race_.film_heating, oil_.kinematic_viscosity, planets_.steady_state.observed_windows,
         planets_.steady_state.most_windows, planets_.steady_state.load_drift,
         planets_.steady_state.load_error_share, planets_.steady_state.cage_drift, set_.rating.capacities,
         planets_.dynamics.neighbours);
  /// Planets with a computed quasi-static tilt, which the bearings keep in motion.
  const Keys computed_tilt_ = of(planets_.seats);

  // Of the carrier as a body.
  const Keys pin_links_ =
      of(planets_.seats.tilt, planets_.seats.ends, planets_.seats.span, planets_.seats.diameter);
  const Keys carrier_ = of(set_.carrier);
  /// Springs that are linked, a ring that turns, other rows than cylindrical ones, two gears on a planet,
  /// pairs.
  const Keys refused_by_carrier_ =
      of(planets_.rim, teeth_.fixed_member, planets_.rows, teeth_.stepped, set_.second_planet);
  /// Rotation and supports of members in their planes, and tilts that it computes itself.
  const Keys left_out_of_carrier_ =
      of(gears_.sun.inertia, gears_.ring.inertia, gears_.carrier.inertia, gears_.planet.inertia,
         gears_.sun.torsional_stiffness, gears_.ring.torsional_stiffness, gears_.carrier.torsional_stiffness,
         gears_.ring.mass, gears_.ring.support_stiffness, gears_.carrier.support_stiffness, gears_.separation,
         gears_.sun_error, gears_.ring_error, planets_.seats, planets_.misalignment, life_.method);
  /// Inputs that a set in its plane does not have; loads, clearance and weight do not change its springs.
  const Keys beside_plane_ =
      of(set_.carrier.positions, set_.carrier.radial_stiffness, set_.carrier.housing,
         set_.carrier.centre_of_mass, planets_.seats.axial_positions, bearing_.rollers().length,
         gears_.ring.inertia, set_.carrier.sun_tilt_stiffness, set_.carrier.sun_axial_stiffness,
         set_.carrier.planet_axial_stiffness);
};

UseRules::UseRules() {
  const analysis::PinSeats& seats = planets_.seats;
  const bearing::PlanetRows& rows = planets_.rows;
  exceptions_ = {
      {of(planets_.run_up.acceleration), quasi_static | coupled_, {}, gears | fmu_gearset},
      {of(planets_.rim), gears | fmu_gearset | fmu_bearing},
      // Coupled gears start on it; --fidelity dynamic fits a law of its own.
      {of(gears_.bearing_stiffness), {}, {}, dynamic},
      {of(gears_.bearing_damping_ratio), {}, fmu_gearset, one_set_in_time_},
      {of(planets_.steady_state.integration.method), coupled_ | fmu_bearing},
      {of(bearing_.rollers().diameter_deviation), at_equilibrium_},  // their mean assumes identical ones
      {of(planets_.misalignment.planet_tilt), {}, crown},
      // A computed tilt is that of bearings at rest; a single bearing in motion may use it. It has no effect
      // on gears.
      {of(seats.tilt, seats.axial_positions, seats.clearance_differences, seats.ends, seats.span,
          seats.diameter, seats.carrier_twist, seats.radial_inclination, seats.tangential_inclination),
       moving_rollers_.without(dynamic | dynamic_of_sets) | planet_stiffness, springs_},
      // Stops hold planets and sun under a load; their stiffness affects only small vibration.
      {of(set_.carrier.sun_axial_stiffness, set_.carrier.planet_axial_stiffness), {}, carrier},
      // At rest and in gears alone planets are without weight; an FMU has no angle of its carrier.
      {of(planets_.dynamics.gravity), fmu_bearing | fmu_gearset, {}, quasi_static | crown | gears},
      {of(race_.starvation), fmu_bearing},  // whose speeds change
      {of(race_.film_heating), fmu_bearing},
      // Rows of other bearings than cylindrical ones are modelled only quasi-static.
      {of(rows.contact_angle, rows.arrangement, rows.distance, rows.preload, rows.approach, rows.balls,
          rows.ball_diameter),
       all_.without(quasi_static | mesh)},
      {of(planets_.steady_state.load_error_share), {}, {}, fmu_bearing},  // whose loads are not known before
      // Two gears on a planet, and planets in pairs, are modelled only quasi-static.
      {of(teeth_.stepped, set_.second_planet), all_.without(quasi_static)},
      {of(planets_.cage_positions), {}, dynamic_of_sets}};  // but for what is found at rest before
}

// Use by the physics of the member, with the exceptions of single ones.
Use UseRules::by_physics(const std::string& path) const {
  Exception but{};
  for (const Exception& exception : exceptions_)
    if (is_among(exception.keys, path)) but = exception;
  const std::optional<Physics> physics = physics_of(path);
  const AnalysisSet holding = physics ? analyses_with(*physics) : AnalysisSet(),
                    without = (physics ? analyses_leaving_out(*physics) : AnalysisSet()) | but.unused_by,
                    by = holding.without(but.refused_by | but.not_modelled_by | but.unused_by);
  return {by, all_.without(by | but.refused_by | without) | but.not_modelled_by, but.refused_by};
}

// Uses beyond the physics, and those that depend on other inputs, for each part of a drivetrain in turn.

// A pin that is held at one end makes the support's stiffness where none is stated.
Use UseRules::with_pins(const Use& use, std::string_view path) const {
  if (!link_rows(path)) return use;
  return use.used_too(springs_, {where_absent(support_), pin_links(path), tilts_are_computed()});
}

Use UseRules::with_meshes(Use use, std::string_view path) const {
  // It affects quasi-static results too where planets carry unequal loads, since it then determines the load
  // sharing.
  if (is_among(meshes_, path) || is_among(compliance_, path))
    use = use.used_too(quasi_static | dynamic_of_sets, unlike_loads());
  // Length and form of a relief have an effect where there is one.
  const gearset::FlankModifications& flanks = teeth_.flanks;
  if (is_among(relief_, path))
    return use.when(
        where_given({key_(flanks.sun_relief), key_(flanks.planet_relief), key_(flanks.ring_relief)}));
  // Power and speed determine the load of the meshes, under which teeth deflect and helical teeth exert axial
  // forces; a rim bends under them.
  if (is_among(load_, path) || is_among(speed_and_stages_, path) || path == rim_) return also_used(use, mesh);
  return use;
}

// Laminae and the tilt of the bore affect lives, and the stiffness too; the model of line contacts has no
// modulus, their films do.
Use UseRules::with_stiffness(const Use& use, std::string_view path) const {
  if (is_among(misalignment_, path)) return also_used(use, planet_stiffness);
  if (path == pin_diameter_) return use.when(where(key_(planets_.seats.ends), {"flexpin"}));
  if (path == key_(bearing_.rollers().laminae)) return also_used(use, planet_stiffness);
  if (path != modulus_ && path != ratio_) return use;
  return use.used_only(planet_stiffness, {filmed()}).used_too(planet_stiffness, rim_bends());
}

// Lives include films; elsewhere the oil has an effect where a film takes part in the approach, or where the
// life by its cleanliness depends on its viscosity.
Use UseRules::with_oil(const Use& use, std::string_view path) const {
  if (!is_among(oil_inputs_, path)) return use;
  std::vector<Condition> viscosity_makes_kappa{
      where_given({key_(life_.cleanliness), key_(life_.contamination_factor)}),
      where_absent(key_(life_.viscosity_ratio)), where_absent(key_(oil_.kinematic_viscosity))};
  const Condition no_grade = where_absent(grade_);
  const AnalysisSet with_film_alone = springs_ | planet_stiffness | crown;
  // It makes the viscosity of a grade, under films, or kinematic that which is stated.
  if (path == density_of_oil_) {
    const Condition grade = where_given({grade_});
    viscosity_makes_kappa.push_back(no_grade);
    return use.used_too(quasi_static, grade)
        .used_too(with_film_alone, {grade, filmed()})
        .used_too(quasi_static | crown, viscosity_makes_kappa);
  }
  Use oil = use.used_only(with_film_alone, {filmed()});
  if (path == viscosity_) oil = oil.used_too(crown, viscosity_makes_kappa);
  return oil.when(no_grade);
}

// Gears are affected by a bearing through its springs, which the case may state; what makes the mass of a
// planet as well affects them beside these too, and what makes the rim that bends: bearings hold the race in
// it.
Use UseRules::with_springs(const Use& use, const std::string& path) const {
  if (is_among(race_of_planet_, path)) return use.used_too(mesh, rim_bends());
  if (is_among(web_, path))
    return use.limited(moving_gears_ | vibration_ | quasi_static,
                       {where_true(teeth_make_meshes, "where the stiffness of a mesh is not given")});
  if (path == modulus_)
    return use.limited(springs_, {where_true(modulus_makes_springs, "where a stiffness is not given")});
  if (path == ratio_)
    return use.limited(springs_, {where_true(material_makes_springs, "where a stiffness is not given")});
  const bool of_speed = is_among(speed_and_stages_, path);
  if (of_speed || is_among(load_, path))
    return use.limited(of_speed ? AnalysisSet(modes) : vibration_,
                       {where_true(loads_make_springs, "where a stiffness depends on the load")});
  if (is_among(frame_, path)) return use.limited(modes, {bearings_are_springs()});
  const std::optional<Physics> physics = physics_of(path);
  const bool of_bearing = physics == Physics::balance || physics == Physics::carrier ||
                          physics == Physics::pin || physics == Physics::at_rest;
  if (!of_bearing || path == key_(bearing_.material.density) || path == rim_) return use;
  return use.limited(springs_, {bearings_are_springs()});
}

// Forces in the frame of the carrier; an FMU of a bearing has its speed as an input.
Use UseRules::with_rotating_carrier(const Use& use) const {
  return use.limited(all_.without(fmu_bearing), {where_true(carrier_rotates, "where the carrier rotates")});
}

// A carrier that is held pulls on nothing.
Use UseRules::with_carrier(const Use& use, std::string_view path) const {
  if (is_among(frame_, path)) return with_rotating_carrier(use);
  const bool of_cage = is_among(cage_sizes_, path) || is_among(motion_of_cage_, path),
             of_rim = is_among(rim_sizes_, path);
  if (!of_cage && !of_rim && !is_among(of_planet_, path)) return use;
  const std::string rotating =
      "where the carrier rotates and " + key_(inertia_.carrier_centrifugal) + " is true";
  if (of_cage) return use.limited(at_equilibrium_ | springs_, {where_true(carrier_pulls, rotating)});
  const Use as_mass =
      use.limited(at_equilibrium_,
                  {where_true(planet_counts_at_rest,
                              rotating + ", or the planet bends, tilts or is pressed on a seat")})
          .used_too(quasi_static, unlike_loads());
  return of_rim ? as_mass.used_too(quasi_static, std::vector<Condition>{}) : as_mass;
}

// A member that is held does not move, unless a spring holds it.
Use UseRules::with_held_members(const Use& use, std::string_view path) const {
  using gearset::Member;
  const std::array<std::pair<Member, const analysis::GearMemberChoice*>, 3> central{
      {{Member::sun, &gears_.sun}, {Member::ring, &gears_.ring}, {Member::carrier, &gears_.carrier}}};
  for (const auto& [member, choice] : central) {
    if (path != key_(choice->inertia)) continue;
    std::vector<std::string> others;
    for (const auto& [other, name] : names_of(member))
      if (other != member) others.emplace_back(name);
    return use.limited(vibration_,
                       {where(key_(teeth_.fixed_member), others), where_absent(key_(teeth_.sun_teeth)),
                        where_given({key_(choice->torsional_stiffness)})});
  }
  return use;
}

// Conditions of single members. A set without teeth has no loads to share. With several sets none has a
// driven member of its own, but all share the power.
Use UseRules::with_own_condition(const Use& use, const std::string& path, const described::Where& row) const {
  if (physics_of(path) == Physics::load_sharing) return use.when(where_given({power_}));
  return row.path.empty() ? use : use.when(of_rollers(condition_of(row)));
}

Use UseRules::with_friction_and_heat(const Use& use, std::string_view path) const {
  // Besides the friction of the races, others build up over the same sliding speed.
  const AnalysisSet moving = moving_rollers_ | planet_defect;
  if (path == key_(race_.sliding_scale))
    return use.used_too(moving, where_given({key_(cage_.pocket_friction)}))
        .used_too(moving, where_given({key_(cage_.guide_diameter)}))
        .used_too(moving, where(key_(race_.lubrication), {"mixed"}))
        .used_too(moving, {where(key_(set_.complement), {"full"}),
                           where_given({key_(planets_.dynamics.neighbours.friction)})});
  if (path == key_(race_.largest_barus_exponent))
    return use.when(of_rollers(condition_of({key_(race_.traction), bearing::kLawsOfOil.text})));
  if (path == key_(race_.film_heating)) return also_used(use, quasi_static);
  if (path == key_(race_.viscosity_slope))
    return use.used_too(quasi_static, where(key_(race_.film_heating), {"gupta"}));
  return use;
}

// Members that apply only to rollers in planets: balls have neither a model of line contacts nor a film, so
// they have no effect with them.
Use UseRules::beside_rollers(const Use& use, std::string_view path) const {
  if (!is_among(of_rollers_, path)) return use;
  return use.when(where_true(planets_have_rollers, "where the planet bearings have rollers"));
}

// Rows in motion name the nearest resonance of the gears, of which bearings are springs.
Use UseRules::with_resonances(const Use& use, std::string_view path) const {
  if (path != spring_) return use;
  return use
      .used_too(dynamic,
                where_true(resonances_are_named, "where " + key_(planets_.mesh_variation) + " is true"))
      .used_too(dynamic, where_true(is_one_system, "where " + key_(set_.complement) + " is full"));
}

// A pin that is the inner race moves with it, down to its hole.
Use UseRules::with_moving_pin(const Use& use, std::string_view path) const {
  if (path != key_(planets_.mounting.pin_bore)) return use;
  return use.used_too(moving_rollers_, where_true(pin_is_race, "where " + key_(planets_.mounting.rings) +
                                                                   " is outer or none"));
}

// Members of different physics, each of which depends on other choices.
Use UseRules::with_other_ways(Use use, std::string_view path) const {
  const auto at_steady_speed = [&](const Use& any) {
    return any.limited(dynamic | dynamic_of_sets,
                       {where_true(speed_is_steady, "where " + acceleration_ + " is 0")});
  };
  // The diameter of the pin makes its stiffness where none is stated.
  if (path == bore_)
    for (Way& way : use.ways) way.conditions.push_back(where_absent(support_));
  // The outer ring is a part of the planet's mass, and of its rim.
  if (path == width_)
    use = use.limited(at_equilibrium_ | springs_,
                      {where(key_(planets_.mounting.rings), {"both", "outer"}), rim_bends()});
  use = with_friction_and_heat(use, path);
  if (path == key_(race_.starvation)) return at_steady_speed(use);
  if (path == key_(planets_.cage_positions)) return use.used_too(dynamic_of_sets, tilts_are_computed());
  if (path == key_(race_.roughness))
    return use.used_too(quasi_static | in_time_, where(key_(set_.rating.viscosity_ratio_by), {"film"}));
  if (path == key_(planets_.mounting.expansion))
    return use.when(where_true(fits_are_warm, "together with a bearing.temperature"));
  if (path == key_(rows_.scratch.profile))
    return use.when(where(key_(rows_.scratch.race), {"outer", "inner", "ball", "roller"}));
  // The carrier's speed grows in a run-up, and as the master of an FMU has it.
  if (path == key_(inertia_.euler))
    return with_rotating_carrier(
        use.used_only(dynamic | dynamic_of_sets, {where_given({acceleration_})})
            .used_only(gears | fmu_gearset,
                       {where_true(gears_run_up, "together with " + key_(gears_.run_up.duration) +
                                                     " and a run_up.from other than 1")}));
  // A run-up is observed from its begin to its end.
  if (path == key_(planets_.steady_state.observed_windows)) return at_steady_speed(use);
  // For a driven sun or ring the power determines the tooth force, whichever member is held.
  if (path == key_(teeth_.fixed_member))
    return use.used_only(mesh, {where(key_(rows_.drive.member), {"carrier"})});
  return use;
}

Use UseRules::with_planet_defect(const Use& use, std::string_view path) const {
  Use more = use;
  if (is_among(scratch_, path) || path == kScratchedSet) return more;
  if (is_among(beside_scratch_, path) || begins_with_one_of(path, {"life.", "requirements.", "spectrum"})) {
    put(more, planet_defect, &Use::not_modelled_by);
    return more;
  }
  follow(more, planet_defect, is_among(computed_tilt_, path) ? dynamic : monolithic);
  const auto is_to_a_life = [](const Condition& condition) {
    return std::ranges::any_of(condition.paths,
                               [](const std::string& other) { return other.starts_with("life."); });
  };
  for (Way& way : more.ways)
    if (way.by.has(monolithic) && std::ranges::none_of(way.conditions, is_to_a_life)) way.by |= planet_defect;
  return more;
}

Use UseRules::with_carrier_body(Use use, std::string_view path) const {
  constexpr AnalysisSet leaders = modes | quasi_static;
  if (is_among(carrier_, path)) return use;
  if (is_among(refused_by_carrier_, path)) {
    put(use, carrier, &Use::refused_by);
    return use;
  }
  if (is_among(left_out_of_carrier_, path) || path == kMinimumLoadPath ||
      begins_with_one_of(path, {"requirements.", "spectrum"})) {
    put(use, carrier, &Use::not_modelled_by);
    if (path == key_(planets_.seats.axial_positions)) return use.used_too(carrier, std::vector<Condition>{});
    return link_rows(path) ? use.used_too(carrier, body_has_pin(path)) : use;
  }
  if (use.refused_by.has(quasi_static))
    put(use, carrier, &Use::refused_by);
  else if (use.by.has_some_of(leaders))
    put(use, carrier, &Use::by);
  else
    follow(use, carrier, modes);
  for (Way& way : use.ways)
    if (way.by.has_some_of(leaders)) way.by |= carrier;
  // It moves back flanks whatever the pins do.
  if (path == key_(gears_.backlash)) put(use, carrier, &Use::by);
  return use;
}

Use UseRules::with_carrier_beside(const Use& use, std::string_view path) const {
  const Condition body = where_true(
      carrier_is_body, "where " + key_(set_.carrier.positions) + " and bearing_stiffness are given, " +
                           key_(teeth_.fixed_member) + " is ring and " + rim_ + " is rigid");
  const auto with_body = [&](std::vector<Condition> conditions) {
    conditions.push_back(body);
    return conditions;
  };
  Use more = use;
  if (use.by.has(carrier) && !use.by.has(quasi_static))
    more = more.used_too(quasi_static, with_body(use.conditions));
  for (const Way& way : use.ways)
    if (way.by.has(carrier) && !way.by.has(quasi_static))
      more = more.used_too(quasi_static, with_body(way.conditions));
  if (is_among(beside_plane_, path)) more = more.used_too(modes, body);
  if (link_rows(path)) more = more.used_too(modes, with_body(body_has_pin(path)));
  return more;
}

}  // namespace

Condition condition_of(const described::Where& where) {
  return {.paths = parts_of(where.path, '|'),
          .values = where.value.empty() ? std::vector<std::string>{} : parts_of(where.value, '|')};
}

namespace {

const UseRules& use_rules() {
  static const UseRules rules;
  return rules;
}

}  // namespace

bool makes_meshes(std::string_view path) {
  return use_rules().make_meshes(path);
}

Use use_of(const described::Facts& facts, unsigned models) {
  if ((models & planetary_drivetrain) != 0 && !use_rules().know(facts.path))
    throw std::logic_error("no physics is listed for '" + facts.path + "'");
  return use_rules().use_of(facts.path, facts.details.where);
}

Condition where_planets_carry_unlike_loads() {
  return use_rules().unlike_loads();
}
Condition where_bearings_make_springs() {
  return use_rules().bearings_are_springs();
}

Use with_planet_defect(const Use& use, std::string_view path) {
  return use_rules().with_planet_defect(use, path);
}
Use with_carrier_body(Use use, std::string_view path) {
  return use_rules().with_carrier_body(std::move(use), path);
}
Use with_carrier_beside(const Use& use, std::string_view path) {
  return use_rules().with_carrier_beside(use, path);
}

}  // namespace orbearing::app
