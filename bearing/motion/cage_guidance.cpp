#include "bearing/motion/cage_guidance.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace orbearing::bearing::motion {

using boost::math::double_constants::two_pi;

LandLaw land_law(const GuidanceModel& model) {
  const double width_cube = std::pow(model.land_width, 3);
  const double printed = model.lands * model.viscosity * width_cube / (model.clearance * model.clearance);
  const double shear = two_pi * model.viscosity * std::pow(model.cage_radius, 3) * model.lands *
                       model.land_width / model.clearance;
  return {.side = model.side,
          .clearance = model.clearance,
          .cage_radius = model.cage_radius,
          .largest_eccentricity = model.largest_eccentricity,
          .literature_variant = model.film == GuidanceFilm::literature_variant,
          .film_scale = printed * model.cage_radius / model.clearance,
          .printed_scale = printed,
          .shear_scale = shear,
          .stiffness = model.stiffness,
          .damping = model.damping,
          .friction = {model.friction, model.sliding_scale}};
}

GuidanceForces guidance_forces(const GuidanceModel& model, const BodyMotion& cage, const BodyMotion& land) {
  GuidanceForces forces;
  if (!model.present) return forces;
  const Vector2 offset = cage.position - land.position, velocity = cage.velocity - land.velocity;
  const LandForces<double> now = land_law(model).forces(
      LandMotion<double>{offset.x(), offset.y(), velocity.x(), velocity.y(), cage.speed}, land.speed);
  const Vector2 film(now.film_x, now.film_y), squeeze(now.squeeze_x, now.squeeze_y);
  const Vector2 touch(now.touch_x, now.touch_y);
  // The couple of the film's two forces, which act through both centres, is shared evenly by both surfaces.
  const double couple = 0.5 * cross(offset, film);
  const double cage_arm = model.side * model.cage_radius;
  forces.eccentricity = now.eccentricity;
  forces.on_cage = {film + touch, now.shear - couple + cage_arm * now.touch_friction};
  forces.on_land = {-film - touch, -now.shear - couple - (cage_arm + offset.norm()) * now.touch_friction};
  forces.film_power = -film.dot(squeeze) + now.shear * (land.speed - cage.speed);
  forces.touch_down_power = now.touch_damping_power + now.touch_friction * now.touch_sliding;
  return forces;
}

double guidance_energy(const GuidanceModel& model, const Vector2& cage, const Vector2& land) {
  if (!model.present) return 0.0;
  const double depth = std::max(0.0, (cage - land).norm() - model.largest_eccentricity * model.clearance);
  return 0.5 * model.stiffness * depth * depth;
}

}  // namespace orbearing::bearing::motion
