#include "bearing/defect/scratch.hpp"

#include <cmath>

namespace orbearing::bearing::defect {

namespace {

// Height of an arc of `radius` over a chord of about the length `width`, as eq. 4 writes it.
double arc_height(double radius, double width) {
  const double half = std::sin(0.25 * width / radius);
  return 2.0 * radius * half * half;  // R (1 - cos(w/(2R)))
}

}  // namespace

double deepest_sinking(double width, Race race, const BearingGeometry& geometry) {
  const double of_race = race == Race::inner ? arc_height(geometry.inner_radius, width)
                                             : -arc_height(geometry.outer_radius, width);
  return arc_height(geometry.element_radius, width) + of_race;
}

ScratchLaw scratch_law(const Scratch& scratch, Race race, const BearingGeometry& geometry) {
  return {scratch.form, scratch.width, scratch.depth, deepest_sinking(scratch.width, race, geometry)};
}

}  // namespace orbearing::bearing::defect
