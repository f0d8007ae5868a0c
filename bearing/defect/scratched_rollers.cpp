#include "bearing/defect/scratched_rollers.hpp"

#include <stdexcept>

#include "bearing/motion/vectorised/engine.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::defect {

namespace {

void check(const Scratch& scratch, const motion::BearingModel& model) {
  mechanics::require_positive(scratch.width, "width of the scratch [m]");
  mechanics::require_positive(scratch.depth, "depth of the scratch [m]");
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

std::vector<double> angles_of(const Scratch& scratch) {
  std::vector<double> angles{scratch.angle};
  angles.insert(angles.end(), scratch.more_angles.begin(), scratch.more_angles.end());
  return angles;
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
