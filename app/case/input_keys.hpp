// Keys of the inputs that the program itself asks for, each by the member that holds it.
#pragma once

#include <string>

namespace orbearing::app {

struct InputKeys {
  InputKeys();

  // Of a bearing, its cage and its seats.
  std::string bearing_type, complement, designation, clearance_class, per_planet, rings, rollers,
      roller_diameter, roller_length, laminae, profile_kind, balls, ball_diameter, contact_angle,
      pitch_diameter, radial_clearance, bore, outside_diameter, width, cage_inner_diameter,
      cage_outer_diameter, cage_width, cage_density, guide_land, clearance_state, inner_interference,
      outer_interference, inner_ring_temperature, outer_ring_temperature, axial_positions, tilt, wind_up,
      rows_contact_angle, rows_arrangement, dynamic_capacity, static_capacity, fatigue_load_limit;
  // Of its life and oil.
  std::string life_method, reliability, viscosity_ratio, contamination_factor, cleanliness, lubrication,
      reduction_factor, oil_grade, oil_viscosity_40, oil_viscosity_100, oil_temperature, oil_viscosity_index,
      kinematic_viscosity, viscosity, pressure_viscosity, oil_density, drag;
  // Of the gears.
  std::string fixed_member, planets, pressure_angle, sun_teeth, stepped_teeth, second_planet_teeth, rim,
      mesh_variation, carrier_bearings, housing_stiffness, planet_bore_ratio, tangential_pin_errors;
  // Of power, speed and motion.
  std::string driven_member, power, speed, speed_of, application_factor, acceleration, gravity, own_orbit,
      support_stiffness, length_error, observed_revolutions, most_revolutions, load_drift, load_error_share,
      shaft_speed, outer_speed, sliding_scale, sliding_share;
  // Of a scratch, and of the material.
  std::string scratched, scratch_form, scratch_width, scratch_depth, scratched_element, scratched_planet,
      scratched_bearing, modulus;
};

/// The keys, which are found once.
const InputKeys& keys();

}  // namespace orbearing::app
