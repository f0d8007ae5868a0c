#include "bearing/defect/scratch.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/checks.hpp"

namespace orbearing::bearing::defect {

namespace {

// Height of an arc of `radius` over a chord of about the length `width`, as eq. 4 writes it.
double arc_height(double radius, double width) {
  const double half = std::sin(0.25 * width / radius);
  return 2.0 * radius * half * half;  // R (1 - cos(w/(2R)))
}

}  // namespace

std::vector<double> angles_of(const Scratch& scratch) {
  std::vector<double> angles{scratch.angle};
  angles.insert(angles.end(), scratch.more_angles.begin(), scratch.more_angles.end());
  return angles;
}

void require_sound(const Scratch& scratch) {
  mechanics::require_positive(scratch.width, "width of the scratch [m]");
  mechanics::require_positive(scratch.depth, "depth of the scratch [m]");
}

double greatest_depth(double width, Race race, const BearingGeometry& geometry) {
  const double of_race = race == Race::inner ? arc_height(geometry.inner_radius, width)
                                             : -arc_height(geometry.outer_radius, width);
  return arc_height(geometry.element_radius, width) + of_race;
}

DefectDepthTable rolled_over(const std::vector<double>& depths, double width, Race race,
                             const BearingGeometry& geometry) {
  constexpr int kFine = 20,
                kLast = DefectDepthTable::kPoints - 1;  // positions evaluated for each one that is kept
  const double of_race = race == Race::inner ? 1.0 / geometry.inner_radius : -1.0 / geometry.outer_radius;
  const double curvature = 1.0 / geometry.element_radius + of_race;  // [1/m]
  const auto last = static_cast<double>(depths.size() - 1);
  const auto depth_at = [&](double share) {  // straight from one measured point to the next
    const auto i = std::min(static_cast<std::size_t>(share * last), depths.size() - 2);
    const auto at = [&](std::size_t k) { return k == 0 || k + 1 == depths.size() ? 0.0 : depths[k]; };
    return at(i) + (share * last - static_cast<double>(i)) * (at(i + 1) - at(i));
  };
  DefectDepthTable table;
  for (int i = 1; i < kLast; ++i) {
    double least = depth_at(static_cast<double>(i) / kLast);
    for (int k = 0; k <= kFine * kLast; ++k) {
      const double off = width * (static_cast<double>(k) / (kFine * kLast) - static_cast<double>(i) / kLast);
      least =
          std::min(least, depth_at(static_cast<double>(k) / (kFine * kLast)) + 0.5 * curvature * off * off);
    }
    table.depth[i] = least;
  }
  // Level at both edges; within, the slope of a parabola through three neighbours.
  for (int i = 1; i < kLast; ++i)
    table.slope[i] = 0.5 * (table.depth[i + 1] - table.depth[i - 1]) * kLast / width;
  return table;
}

ScratchLaw scratch_law(const Scratch& scratch, Race race, const BearingGeometry& geometry) {
  ScratchLaw law{
      scratch.form, scratch.width, scratch.depth, greatest_depth(scratch.width, race, geometry), {}};
  if (scratch.form != ScratchForm::profile) return law;
  if (scratch.profile.size() < 3)
    mechanics::refuse("depths of a measured scratch", static_cast<double>(scratch.profile.size()),
                      "at least 3");
  std::vector<double> depths = scratch.profile;
  for (double& depth : depths) {
    mechanics::require(depth >= 0.0, "depth of a measured scratch over its largest [-]", depth, "0 or more");
    depth *= scratch.depth;
  }
  law.table = rolled_over(depths, scratch.width, race, geometry);
  return law;
}

}  // namespace orbearing::bearing::defect
