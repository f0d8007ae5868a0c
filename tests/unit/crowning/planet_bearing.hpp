// The planet bearing of cases/reducer_150kW as the crowning tests use it.
#pragma once

#include "coupling/analysis/crowning/crown_problem.hpp"

namespace orbearing::analysis::crowning {

inline constexpr double kRpm = 0.10471975511965977;  // [rad/s]

inline PlanetaryDrivetrain reducer() {
  PlanetaryDrivetrain drivetrain;
  drivetrain.set = {.sun_teeth = 37,
                    .planet_teeth = 22,
                    .ring_teeth = 79,
                    .planets = 4,
                    .module = 3e-3,
                    .sun_shift = 0.2618,
                    .ring_shift = 0.4146,
                    .face_width = 28e-3,
                    .planet_bore = 47e-3,
                    .density = 7850.0};
  drivetrain.drive = {.power = 150e3, .speed = 6000.0 * kRpm};
  drivetrain.bearing = {
      .inner = {.seat_diameter = 25e-3},
      .outer = {.seat_diameter = 47e-3},
      .cage = {33.44e-3, 38.54e-3, 9e-3, 1310.0},
      .elements = bearing::CylindricalRollers{.count = 15, .diameter = 5.24e-3, .length = 5.7e-3},
      .pitch_diameter = 35.64e-3,
      .width = 11.9e-3};
  drivetrain.bearings_per_planet = 2;
  drivetrain.cage_positions = 4;
  return drivetrain;
}

inline CrownProblem problem_at(const std::vector<SpectrumPoint>& spectrum, LifeMethod measure) {
  const PlanetaryDrivetrain drivetrain = reducer();
  return crown_problem(drivetrain, derive(drivetrain), spectrum, measure);
}

inline CrownProblem problem_at(double rpm, LifeMethod measure) {
  return problem_at({{rpm * kRpm, 1.0}}, measure);
}

}  // namespace orbearing::analysis::crowning
