#include "app/case/static_case.hpp"

#include <cmath>

#include "app/case/catalogue_case.hpp"
#include "app/case/described_case.hpp"
#include "app/case/profile_case.hpp"

namespace orbearing::app {

namespace {

std::optional<double> stated(const ResolvedCase& in, const char* path) {
  return in.has(path) ? std::optional<double>(in.quantity(path)) : std::nullopt;
}

}  // namespace

bearing::Bearing bearing_of(const ResolvedCase& in) {
  bearing::Bearing bearing;
  if ((in.model() & with_balls) != 0) bearing.elements = bearing::Balls{};
  bearing = from_case(in, bearing);
  if (is_full_complement(in)) bearing.cage = {};
  // Values that a case does not state by fields alone.
  if (auto* rollers = std::get_if<bearing::CylindricalRollers>(&bearing.elements)) {
    if (rollers->laminae == 0) rollers->laminae = default_laminae;
    rollers->profile = roller_profile_of(in);
  }
  bearing.motions = bearing::rating::rotating(
      in.choice("operation.turning_race") == "outer" ? bearing::Race::outer : bearing::Race::inner);
  return bearing;
}

bearing::equilibrium::RingLoad ring_load_of(const ResolvedCase& in) {
  return from_case<bearing::equilibrium::RingLoad>(in);
}

bearing::equilibrium::RowMotion row_motion_of(const ResolvedCase& in) {
  bearing::equilibrium::RowMotion motion{
      .speeds = {in.quantity("operation.shaft_speed"), in.quantity("operation.outer_speed")}};
  if (in.model() != ball_bearing) return motion;
  motion.inertia = from_case<bearing::equilibrium::BallInertia>(in);
  if (in.flag("film.enabled")) motion.film = from_case<bearing::Lubricant>(in);
  return motion;
}

bearing::rating::StatedRatings stated_ratings_of(const ResolvedCase& in) {
  bearing::rating::StatedRatings ratings{.dynamic_capacity = stated(in, "bearing.dynamic_capacity"),
                                         .static_capacity = stated(in, "bearing.static_capacity"),
                                         .fatigue_load_limit = stated(in, "bearing.fatigue_load_limit")};
  if (in.has("life.reduction_factor")) ratings.reduction_factor = in.number("life.reduction_factor");
  if (in.has("life.stress_riser"))
    ratings.stress_riser = *value_named<bearing::rating::StressRiser>(in.choice("life.stress_riser"));
  return ratings;
}

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
