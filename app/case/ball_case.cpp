#include "app/case/ball_case.hpp"

#include <cmath>

#include "app/case/described_case.hpp"
#include "app/case/static_case.hpp"

namespace orbearing::app {

bearing::balls::MotionParameters ball_motion_of(const ResolvedCase& in) {
  return from_case<bearing::balls::MotionParameters>(in);
}

bearing::balls::BallDuty ball_duty_of(const ResolvedCase& in) {
  using bearing::balls::RingDrive;
  const double speed = in.quantity("operation.shaft_speed");
  const double acceleration = in.quantity("operation.shaft_acceleration");
  const bearing::equilibrium::RingLoad load = ring_load_of(in);
  bearing::balls::BallDuty duty;
  duty.inner = acceleration > 0.0 ? RingDrive{0.0, std::copysign(acceleration, speed), speed}
                                  : RingDrive::steady(speed);
  duty.outer = RingDrive::steady(in.quantity("operation.outer_speed"));
  // A tilt moves the ring forward where x or y is positive: its axis leans the other way.
  duty.on_inner = {{load.radial, 0.0, load.axial, -load.moment, -load.moment_across}};
  return duty;
}

system::BallRunOptions ball_run_options_of(const ResolvedCase& in) {
  system::BallRunOptions options = from_case<system::BallRunOptions>(in);
  options.first_ball = in.quantity("bearing.first_element_angle");
  return options;
}

system::HeatParameters heat_of(const ResolvedCase& in) {
  return from_case<system::HeatParameters>(in);
}

}  // namespace orbearing::app
