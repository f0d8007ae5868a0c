// The planet bearing of the reducer, driven: for tests of the co-simulation.
#pragma once

#include <cmath>

#include "coupling/system/driven_bearing.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::test {

inline cosim::DrivenBearingSetup driven_reducer() {
  cosim::DrivenBearingSetup setup;
  setup.bearing = reducer_bearing();
  setup.dynamics = reducer_parameters();
  setup.dynamics.race.film_in_approach = true;
  setup.orbit_radius = reducer_point(6000.0).carrier.orbit_radius;
  setup.first_roller = 0.3;
  return setup;
}

/// The bore pressed against its rollers at 6000 rpm of the sun.
inline bearing::dynamics::BoreMotion pressed_motion() {
  const bearing::OperatingPoint point = reducer_point(6000.0);
  bearing::dynamics::BoreMotion motion;
  motion.position = {2e-6, 25e-6};
  motion.speed = point.outer_speed;
  motion.carrier_speed = point.carrier.speed;
  return motion;
}

/// Inputs that keep `motion` as it is.
inline cosim::BoreCourse constant_course(const bearing::dynamics::BoreMotion& motion) {
  using cosim::Course;
  return {Course::constant(motion.position.x()),
          Course::constant(motion.position.y()),
          Course::constant(0.0),
          Course::constant(0.0),
          Course::constant(motion.speed),
          Course::constant(motion.carrier_speed),
          Course::constant(motion.carrier_acceleration)};
}

/// A window of a bore that swings about `motion` with amplitude `reach` [m] at `frequency` [rad/s], by its
/// Taylor series at the beginning.
inline cosim::BoreCourse swinging_course(const bearing::dynamics::BoreMotion& motion, double reach,
                                         double frequency, double begin) {
  cosim::BoreCourse inputs = constant_course(motion);
  const double w = frequency, s = reach * std::sin(w * begin), c = reach * std::cos(w * begin);
  inputs.x = {{motion.position.x() + s, w * c, -w * w * s / 2.0, -w * w * w * c / 6.0}};
  inputs.v_x = {{w * c, -w * w * s, -w * w * w * c / 2.0, 0.0}};
  inputs.y = {{motion.position.y() + c, -w * s, -w * w * c / 2.0, w * w * w * s / 6.0}};
  inputs.v_y = {{-w * s, -w * w * c, w * w * w * s / 2.0, 0.0}};
  return inputs;
}

}  // namespace orbearing::test
