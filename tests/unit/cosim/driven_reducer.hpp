// The planet bearing of the reducer, driven: for tests of the co-simulation.
#pragma once

#include <cmath>

#include "coupling/system/driven_bearing.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::test {

inline system::DrivenBearingSetup driven_reducer() {
  system::DrivenBearingSetup setup;
  setup.bearing = reducer_bearing();
  setup.dynamics = reducer_parameters();
  setup.dynamics.race.film_in_approach = true;
  setup.orbit_radius = reducer_point(6000.0).carrier.orbit_radius;
  setup.first_roller = 0.3;
  return setup;
}

/// The bore pressed against its rollers at 6000 rpm of the sun.
inline bearing::motion::BoreMotion pressed_motion() {
  const bearing::OperatingPoint point = reducer_point(6000.0);
  bearing::motion::BoreMotion motion;
  motion.position = {2e-6, 25e-6};
  motion.speed = point.outer_speed;
  motion.carrier_speed = point.carrier.speed;
  return motion;
}

/// Inputs that keep `motion` as it is.
inline system::BoreInputs constant_polynomial(const bearing::motion::BoreMotion& motion) {
  using system::InputPolynomial;
  return {InputPolynomial::constant(motion.position.x()),
          InputPolynomial::constant(motion.position.y()),
          InputPolynomial::constant(0.0),
          InputPolynomial::constant(0.0),
          InputPolynomial::constant(motion.speed),
          InputPolynomial::constant(motion.carrier_speed),
          InputPolynomial::constant(motion.carrier_acceleration)};
}

/// A window of a bore that swings about `motion` with amplitude `reach` [m] at `frequency` [rad/s], by its
/// Taylor series at the beginning.
inline system::BoreInputs swinging_polynomial(const bearing::motion::BoreMotion& motion, double reach,
                                              double frequency, double begin) {
  system::BoreInputs inputs = constant_polynomial(motion);
  const double w = frequency, s = reach * std::sin(w * begin), c = reach * std::cos(w * begin);
  inputs.x = {{motion.position.x() + s, w * c, -w * w * s / 2.0, -w * w * w * c / 6.0}};
  inputs.v_x = {{w * c, -w * w * s, -w * w * w * c / 2.0, 0.0}};
  inputs.y = {{motion.position.y() + c, -w * s, -w * w * c / 2.0, w * w * w * s / 6.0}};
  inputs.v_y = {{-w * s, -w * w * c, w * w * w * s / 2.0, 0.0}};
  return inputs;
}

}  // namespace orbearing::test
