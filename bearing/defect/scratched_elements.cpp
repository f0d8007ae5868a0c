#include "bearing/defect/scratched_elements.hpp"

#include <algorithm>
#include <stdexcept>

#include "bearing/motion/vectorised/engine.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::defect {

namespace {

balls::ScratchNumbers scratch_numbers(const Scratch& scratch, Race race, const BearingGeometry& geometry) {
  require_sound(scratch);
  const std::vector<double> angles = angles_of(scratch);
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
  require_sound(scratch);
  mechanics::require(scratch.element >= 1 && scratch.element <= balls, "scratched ball", scratch.element,
                     "one of the bearing's, counted from 1");
  const std::vector<double> angles = angles_of(scratch);
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

namespace {

void check(const Scratch& scratch, const motion::BearingModel& model) {
  require_sound(scratch);
  mechanics::require(scratch.width <= model.geometry.element_radius, "width of the scratch [m]",
                     scratch.width, "at most the radius of a roller");
  if (scratch.race == Scratched::ball)
    throw std::invalid_argument(
        "scratch: found a ball; required: a race or a roller of a bearing of rollers");
  if (scratch.form == ScratchForm::literature_variant)
    throw std::invalid_argument(
        "form of the scratch: found as-printed; required: one that does not jump at its edges, since the "
        "motion is "
        "integrated through them");
  if (scratch.race == Scratched::roller)
    mechanics::require(scratch.element >= 1 && scratch.element <= model.layout.rollers, "scratched roller",
                       scratch.element, "one of the bearing's, counted from 1");
}

// Which of the followed rollers it is; from now on followed if it was not.
int followed_as(int roller, motion::BearingModel& model) {
  for (const RollerScratch& other : model.roller_scratches)
    if (other.roller == roller) return other.followed;
  constexpr int most = vectorised::PaddedLayout::kMostFollowed;
  if (model.layout.followed >= most)
    mechanics::refuse("scratched rollers", most + 1, "at most 2 in a bearing");
  return static_cast<int>(model.layout.followed++);
}

}  // namespace

void put_scratches(const std::vector<Scratch>& scratches, motion::BearingModel& model) {
  const BearingGeometry& geometry = model.geometry;
  for (const Scratch& scratch : scratches) {
    if (scratch.race == Scratched::none) continue;
    check(scratch, model);
    const ScratchLaw on_inner = scratch_law(scratch, Race::inner, geometry);
    const ScratchLaw on_outer = scratch_law(scratch, Race::outer, geometry);
    for (const double angle : angles_of(scratch)) {
      if (scratch.race == Scratched::inner)
        model.inner.scratches.push_back({geometry.inner_radius, angle, on_inner});
      if (scratch.race == Scratched::outer)
        model.outer.scratches.push_back({geometry.outer_radius, angle, on_outer});
      if (scratch.race != Scratched::roller) continue;
      const int roller = scratch.element - 1;
      model.roller_scratches.push_back(
          {roller, followed_as(roller, model), geometry.element_radius, angle, on_inner, on_outer});
    }
  }
}

}  // namespace orbearing::bearing::defect
