#include "bearing/defect/scratch.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace orbearing::bearing::defect {

namespace {

constexpr double kPi = boost::math::double_constants::pi;

// Height of an arc of `radius` over a chord of about the length `width`, as eq. 4 writes it.
double arc_height(double radius, double width) {
  const double half = std::sin(0.25 * width / radius);
  return 2.0 * radius * half * half;  // R (1 - cos(w/(2R)))
}

// Of depth 1 and width 1.
Sinking unit_sinking(ScratchForm form, double s) {
  switch (form) {
    case ScratchForm::raised_cosine:
      return {0.5 * (1.0 + std::cos(2.0 * kPi * s)), -kPi * std::sin(2.0 * kPi * s)};
    case ScratchForm::half_cosine:
      return {std::cos(kPi * s), -kPi * std::sin(kPi * s)};
    case ScratchForm::edges: {
      const double inside = 1.0 - 2.0 * std::abs(s);
      return {inside * inside, std::copysign(4.0 * inside, -s)};
    }
    case ScratchForm::as_printed:
      return {std::cos(2.0 * kPi * s), -2.0 * kPi * std::sin(2.0 * kPi * s)};
  }
  return {};
}

}  // namespace

double deepest_sinking(double width, Race race, const BearingGeometry& geometry) {
  const double of_race = race == Race::inner ? arc_height(geometry.inner_radius, width)
                                             : -arc_height(geometry.outer_radius, width);
  return arc_height(geometry.element_radius, width) + of_race;
}

Sinking sinking(const Scratch& scratch, double deepest, double from_middle) {
  const Sinking unit = unit_sinking(scratch.form, from_middle / scratch.width);
  if (deepest * unit.depth >= scratch.depth) return {scratch.depth, 0.0};  // on the bottom
  return {deepest * unit.depth, deepest * unit.slope / scratch.width};
}

}  // namespace orbearing::bearing::defect
