#include "app/case/input_keys.hpp"

#include "bearing/defect/scratch.hpp"
#include "bearing/design_problems.hpp"
#include "coupling/analysis/planet_scratch.hpp"
#include "coupling/analysis/single_bearing.hpp"
#include "coupling/analysis/stated_drivetrain.hpp"
#include "mechanics/member_keys.hpp"

namespace orbearing::app {

namespace {

/// Calls `put` with an empty structure and the keys of its members.
template <class Struct, class Put>
void with_keys_of(const Put& put) {
  const Struct of{};
  put(of, mechanics::MemberKeys<Struct>(of));
}

}  // namespace

InputKeys::InputKeys() {
  with_keys_of<analysis::StatedSet>([this](const auto& of, const auto& key) {
    bearing_type = key(of.bearing_type);
    complement = key(of.complement);
    designation = key(of.catalogue.designation);
    clearance_class = key(of.catalogue.clearance_class);
    profile_kind = key(of.profile.kind);
    per_planet = key(of.planets.bearings_per_planet);
    clearance_state = key(of.planets.mounting.state);
    inner_interference = key(of.planets.mounting.inner_interference);
    outer_interference = key(of.planets.mounting.outer_interference);
    inner_ring_temperature = key(of.planets.mounting.inner_ring_temperature);
    outer_ring_temperature = key(of.planets.mounting.outer_ring_temperature);
    axial_positions = key(of.planets.seats.axial_positions);
    tilt = key(of.planets.seats.tilt);
    wind_up = key(of.planets.misalignment.carrier_wind_up);
    rows_contact_angle = key(of.planets.rows.contact_angle);
    rows_arrangement = key(of.planets.rows.arrangement);
    dynamic_capacity = key(of.rating.capacities.dynamic_capacity);
    static_capacity = key(of.rating.capacities.static_capacity);
    fatigue_load_limit = key(of.rating.capacities.fatigue_load_limit);
    life_method = key(of.rating.life.method);
    reliability = key(of.rating.life.reliability);
    viscosity_ratio = key(of.rating.life.viscosity_ratio);
    contamination_factor = key(of.rating.life.contamination_factor);
    cleanliness = key(of.rating.life.cleanliness);
    lubrication = key(of.rating.life.lubrication);
    reduction_factor = key(of.rating.rollers.reduction_factor);
    oil_grade = key(of.rating.oil.stated.grade);
    oil_viscosity_40 = key(of.rating.oil.stated.viscosity_40);
    oil_viscosity_100 = key(of.rating.oil.stated.viscosity_100);
    oil_temperature = key(of.rating.oil.stated.temperature);
    oil_viscosity_index = key(of.rating.oil.stated.viscosity_index);
    kinematic_viscosity = key(of.rating.oil.kinematic_viscosity);
    fixed_member = key(of.teeth.fixed_member);
    planets = key(of.teeth.planets);
    pressure_angle = key(of.teeth.rack.pressure_angle);
    sun_teeth = key(of.teeth.sun_teeth);
    stepped_teeth = key(of.teeth.stepped.teeth);
    second_planet_teeth = key(of.second_planet.teeth);
    rim = key(of.planets.rim);
    mesh_variation = key(of.planets.mesh_variation);
    carrier_bearings = key(of.carrier.positions);
    housing_stiffness = key(of.carrier.housing);
    planet_bore_ratio = key(of.planet_bore_ratio);
    tangential_pin_errors = key(of.gears.choice.pin_error_tangential);
    acceleration = key(of.planets.run_up.acceleration);
    gravity = key(of.planets.dynamics.gravity.across);
    own_orbit = key(of.planets.dynamics.inertia.own_orbit);
    support_stiffness = key(of.planets.dynamics.support.stiffness);
    length_error = key(of.planets.steady_state.allowed_length_error);
    observed_revolutions = key(of.planets.steady_state.observed_windows);
    most_revolutions = key(of.planets.steady_state.most_windows);
    load_drift = key(of.planets.steady_state.load_drift);
    load_error_share = key(of.planets.steady_state.load_error_share);
    oil_density = key(of.planets.dynamics.drag.oil_density);
    drag = key(of.planets.dynamics.drag.on);
    sliding_scale = key(of.planets.dynamics.race.sliding_scale);
    sliding_share = key(of.planets.dynamics.race.sliding_share);
  });
  with_keys_of<bearing::BearingDesign>([this](const auto& of, const auto& key) {
    rings = key(of.rings);
    rollers = key(of.rollers.count);
    roller_diameter = key(of.rollers.diameter);
    roller_length = key(of.rollers.length);
    laminae = key(of.rollers.laminae);
    balls = key(of.balls);
    ball_diameter = key(of.ball_diameter);
    contact_angle = key(of.contact_angle);
    pitch_diameter = key(of.pitch_diameter);
    radial_clearance = key(of.radial_clearance);
    bore = key(of.bore);
    outside_diameter = key(of.outside_diameter);
    width = key(of.width);
    cage_inner_diameter = key(of.cage.inner_diameter);
    cage_outer_diameter = key(of.cage.outer_diameter);
    cage_width = key(of.cage.width);
    cage_density = key(of.cage.density);
    guide_land = key(of.guide_land);
  });
  with_keys_of<bearing::Lubricant>([this](const auto& of, const auto& key) {
    viscosity = key(of.viscosity);
    pressure_viscosity = key(of.pressure_viscosity);
  });
  with_keys_of<gearset::Drive>([this](const auto& of, const auto& key) {
    driven_member = key(of.member);
    power = key(of.power);
    speed = key(of.speed);
    speed_of = key(of.speed_of);
    application_factor = key(of.application_factor);
  });
  with_keys_of<analysis::RingRotation>([this](const auto& of, const auto& key) {
    shaft_speed = key(of.shaft_speed);
    outer_speed = key(of.outer_speed);
  });
  with_keys_of<bearing::defect::Scratch>([this](const auto& of, const auto& key) {
    scratched = key(of.race);
    scratch_form = key(of.form);
    scratch_width = key(of.width);
    scratch_depth = key(of.depth);
    scratched_element = key(of.element);
  });
  with_keys_of<analysis::ScratchedPosition>([this](const auto& of, const auto& key) {
    scratched_planet = key(of.planet);
    scratched_bearing = key(of.bearing);
  });
  with_keys_of<mechanics::Elasticity>(
      [this](const auto& of, const auto& key) { modulus = key(of.youngs_modulus); });
}

const InputKeys& keys() {
  static const InputKeys found;
  return found;
}

}  // namespace orbearing::app
