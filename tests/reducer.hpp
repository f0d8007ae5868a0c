// The reducer of [Gai2025] as parameters, for tests that need a whole drivetrain without a case file.
#pragma once

#include "coupling/analysis/drivetrain.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::example {

inline constexpr double rpm = constants::pi / 30.0;  // [rad/s]

inline analysis::PlanetaryDrivetrain reducer() {
  analysis::PlanetaryDrivetrain drivetrain;
  drivetrain.set = {.sun_teeth = 37,
                    .planet_teeth = 22,
                    .ring_teeth = 79,
                    .planets = 4,
                    .module = 3e-3,
                    .sun_shift = 0.2618,
                    .ring_shift = 0.4146,
                    .face_width = 28e-3,
                    .planet_bore = 47e-3};
  drivetrain.drive = {.member = gearset::Member::sun, .power = 150e3, .speed = 6000.0 * rpm};
  drivetrain.bearing = {
      .inner = {.seat_diameter = 25e-3},
      .outer = {.seat_diameter = 47e-3},
      .cage = {.inner_diameter = 33.44e-3, .outer_diameter = 38.54e-3, .width = 9e-3, .density = 1310.0},
      .elements = bearing::CylindricalRollers{.count = 15, .diameter = 5.24e-3, .length = 5.7e-3},
      .pitch_diameter = 35.64e-3,
      .width = 11.9e-3};
  drivetrain.bearings_per_planet = 2;
  drivetrain.dynamics.lubricant = {.viscosity = 0.01, .pressure_viscosity = 1.5e-8};
  return drivetrain;
}

}  // namespace orbearing::example
