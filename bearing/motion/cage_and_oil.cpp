#include "bearing/motion/cage_and_oil.hpp"

#include <cmath>
#include <string>

#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::motion {

std::optional<GuidingLands> guiding_lands(const Bearing& bearing, const CageParameters& given, int lands,
                                          double viscosity, double sliding_scale) {
  using constants::two_pi;
  using mechanics::require;
  if (given.guide_diameter <= 0.0) return std::nullopt;
  const Cage& cage = bearing.cage;
  const bool outside = cage.guidance == Race::outer, rollers = bearing.has_rollers();
  const double side = outside ? 1.0 : -1.0, diameter = outside ? cage.outer_diameter : cage.inner_diameter;
  const double between = rollers ? bearing.rollers().length : bearing.balls().diameter;
  const double clearance = 0.5 * side * (given.guide_diameter - diameter), radius = 0.5 * diameter;
  const double width = given.land_width > 0.0 ? given.land_width : 0.5 * (cage.width - between);
  require(clearance > 0.0, "radial clearance of cage and land [m]", clearance,
          "more than 0; the guide diameter lies outside an outer-guided cage and inside an inner-guided one");
  require(width > 0.0, "width of the cage's land [m]", width,
          std::string("more than 0; give it, or a cage wider than the ") + (rollers ? "rollers" : "balls"));
  return GuidingLands{
      .width = width,
      .law = {
          .side = side,
          .clearance = clearance,
          .cage_radius = radius,
          .largest_eccentricity = given.largest_eccentricity,
          .film_scale = lands * viscosity * std::pow(width, 3) / (clearance * clearance) * radius / clearance,
          .shear_scale = two_pi * viscosity * std::pow(radius, 3) * lands * width / clearance,
          .stiffness = given.touch_down_stiffness,
          .damping = given.touch_down_damping,
          .friction = {given.touch_down_friction, sliding_scale}}};
}

}  // namespace orbearing::bearing::motion
