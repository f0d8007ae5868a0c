#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "bearing/motion/vectorised/constants_of.hpp"

namespace orbearing::bearing::fast {

namespace {

using boost::math::double_constants::two_pi;

RaceConstants race_constants(const dynamics::RaceModel& race, double speed) {
  RaceConstants c;
  c.side = race.side.side;
  c.radius = race.side.radius;
  c.speed = speed;
  c.stiffness = race.load.elastic().constant();
  c.log_stiffness = std::log(c.stiffness);
  c.damping = race.damping;
  c.entrainment_scale = race.entrainment_scale;
  c.film = race.load.with_film();
  c.film_law = race.load.film();
  set_film_powers(c);
  c.friction = race.friction;
  return c;
}

LandConstants land_constants(const dynamics::BearingModel& model) {
  const dynamics::GuidanceModel& guidance = model.guidance;
  LandConstants c;
  c.present = guidance.present;
  if (!c.present) return c;
  const double width_cube = std::pow(guidance.land_width, 3);
  const double square = guidance.clearance * guidance.clearance;
  c.on_bore = model.guiding_race == Race::outer;
  c.as_printed = guidance.film == dynamics::GuidanceFilm::as_printed;
  c.speed = c.on_bore ? model.point.outer_speed : model.point.inner_speed;
  c.side = guidance.side;
  c.clearance = guidance.clearance;
  c.cage_radius = guidance.cage_radius;
  c.largest_eccentricity = guidance.largest_eccentricity;
  c.printed_scale = guidance.lands * guidance.viscosity * width_cube / square;
  c.film_scale = c.printed_scale * guidance.cage_radius / guidance.clearance;
  c.shear_scale = two_pi * guidance.viscosity * std::pow(guidance.cage_radius, 3) * guidance.lands *
                  guidance.land_width / guidance.clearance;
  c.stiffness = guidance.stiffness;
  c.damping = guidance.damping;
  c.friction = guidance.friction;
  c.sliding_scale = guidance.sliding_scale;
  return c;
}

}  // namespace

Constants constants_of(const dynamics::BearingModel& model) {
  Constants c;
  c.rollers = static_cast<int>(model.layout.rollers);
  c.roller_radius = model.geometry.roller_radius;
  c.roller_mass = model.roller.mass;
  c.roller_inertia = model.roller.inertia;
  c.orbit_drag = model.orbit_drag.coefficient;
  c.spin_drag = model.spin_drag.coefficient;
  c.cage_drag = model.cage_drag.coefficient;
  c.coriolis_speed = model.frame.coriolis_speed;
  c.centrifugal = model.frame.centrifugal;
  c.euler = model.frame.euler;
  c.own_orbit = model.frame.own_orbit;
  c.orbit_radius = model.frame.orbit_radius;
  c.inner = race_constants(model.inner, model.point.inner_speed);
  c.outer = race_constants(model.outer, model.point.outer_speed);
  c.half_clearance = model.pocket.half_clearance;
  c.pocket_stiffness = model.pocket.stiffness;
  c.pocket_damping = model.pocket.damping;
  c.pocket_friction = model.pocket.friction;
  c.pocket_sliding_scale = model.pocket.sliding_scale;
  c.cage_mass = model.cage.mass;
  c.cage_inertia = model.cage.inertia;
  c.bore_mass = model.bore_mass;
  c.pin_mass = model.pin_mass;
  c.support_stiffness = model.support.stiffness;
  c.support_damping = model.support.damping;
  c.land = land_constants(model);
  return c;
}

}  // namespace orbearing::bearing::fast
