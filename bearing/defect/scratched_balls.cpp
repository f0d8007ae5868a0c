#include "bearing/defect/scratched_balls.hpp"

#include <algorithm>
#include <stdexcept>

#include "mechanics/checks.hpp"

namespace orbearing::bearing::defect {

namespace {

balls::ScratchNumbers scratch_numbers(const Scratch& scratch, Race race, const BearingGeometry& geometry) {
  mechanics::require_positive(scratch.width, "width of the scratch [m]");
  mechanics::require_positive(scratch.depth, "depth of the scratch [m]");
  std::vector<double> angles = scratch.more_angles;
  angles.insert(angles.begin(), scratch.angle);
  if (angles.size() > balls::ScratchNumbers::kMost)
    mechanics::refuse("scratches", static_cast<double>(angles.size()), "at most 32 in this motion");
  balls::ScratchNumbers numbers{
      .count = static_cast<int>(angles.size()),
      .track_radius = race == Race::inner ? geometry.inner_radius : geometry.outer_radius,
      .law = scratch_law(scratch, race, geometry)};
  std::copy(angles.begin(), angles.end(), numbers.angle);
  return numbers;
}

balls::SpotNumbers spot_numbers(const Scratch& scratch, int balls, const BearingGeometry& geometry) {
  mechanics::require_positive(scratch.width, "width of the scratch [m]");
  mechanics::require_positive(scratch.depth, "depth of the scratch [m]");
  mechanics::require(scratch.element >= 1 && scratch.element <= balls, "scratched ball", scratch.element,
                     "one of the bearing's, counted from 1");
  std::vector<double> angles = scratch.more_angles;
  angles.insert(angles.begin(), scratch.angle);
  if (angles.size() > balls::SpotNumbers::kMost)
    mechanics::refuse("scratches of a ball", static_cast<double>(angles.size()), "at most 4 in this motion");
  balls::SpotNumbers numbers{.count = static_cast<int>(angles.size()),
                             .on_inner = scratch_law(scratch, Race::inner, geometry),
                             .on_outer = scratch_law(scratch, Race::outer, geometry)};
  std::copy(angles.begin(), angles.end(), numbers.angle);
  std::fill_n(numbers.ball, numbers.count, scratch.element - 1);
  return numbers;
}

}  // namespace

balls::BallNumbers scratched_numbers(const ScratchedBearing& scratched, balls::MotionParameters motion) {
  mechanics::require_positive(scratched.ring.mass, "mass of the outer ring [kg]");
  const BearingGeometry geometry = geometry_of(scratched.bearing);
  const double radius = geometry.outer_radius;
  motion.inner = {.held = true};
  motion.outer = {.mass = scratched.ring.mass, .across = 0.5 * scratched.ring.mass * radius * radius};
  balls::BallNumbers numbers = ball_numbers(scratched.bearing, motion);
  switch (scratched.scratch.race) {
    case Scratched::outer:
      numbers.outer.scratch = scratch_numbers(scratched.scratch, Race::outer, geometry);
      break;
    case Scratched::inner:
      numbers.inner.scratch = scratch_numbers(scratched.scratch, Race::inner, geometry);
      break;
    case Scratched::ball:
      numbers.spots = spot_numbers(scratched.scratch, numbers.balls, geometry);
      break;
    case Scratched::roller:
      throw std::invalid_argument("a scratched roller was found; a ball or a race is required among balls");
    case Scratched::none:
      break;
  }
  return numbers;
}

balls::BallDuty scratched_duty(const ScratchedBearing& scratched) {
  mechanics::require_positive(scratched.load, "radial load [N]");
  balls::BallDuty duty;
  const RunUp& run_up = scratched.run_up;
  const double speed = scratched.shaft_speed, from = run_up.from * speed;
  duty.inner = run_up.time > 0.0 ? balls::RingDrive{from, (speed - from) / run_up.time, speed}
                                 : balls::RingDrive::steady(speed);
  duty.on_outer = {{-(scratched.load + weight_of(scratched.ring)), 0.0, 0.0, 0.0, 0.0}};
  return duty;
}

}  // namespace orbearing::bearing::defect
