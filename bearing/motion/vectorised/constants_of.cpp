#include <cmath>

#include "bearing/motion/vectorised/constants_of.hpp"

namespace orbearing::bearing::vectorised {

namespace {

RaceConstants race_constants(const motion::RaceModel& race, double speed) {
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
  c.squeezed = race.squeeze.has_value();
  if (race.squeeze) {
    c.film_law = race.squeeze->film;
    c.squeeze = race.squeeze->law;
  }
  set_film_powers(c);
  c.friction = race.friction;
  return c;
}

LandConstants land_constants(const motion::BearingModel& model) {
  if (!model.guidance.present) return {};
  const bool on_bore = model.guiding_race == Race::outer;
  return {.present = true,
          .on_bore = on_bore,
          .speed = on_bore ? model.point.outer_speed : model.point.inner_speed,
          .law = motion::land_law(model.guidance)};
}

}  // namespace

Constants constants_of(const motion::BearingModel& model) {
  Constants c;
  c.rollers = static_cast<int>(model.layout.rollers);
  c.followed = static_cast<int>(model.layout.followed);
  c.roller_radius = model.geometry.element_radius;
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
  c.caged = model.layout.caged;
  c.pocket = motion::pocket_law(model.pocket);
  c.neighbours = {model.neighbours.elastic.constant(), model.neighbours.damping, model.neighbours.friction};
  c.cage_mass = model.cage.mass;
  c.cage_inertia = model.cage.inertia;
  c.bore_mass = model.bore_mass;
  c.pin_mass = model.pin_mass;
  c.support_stiffness = model.support.stiffness;
  c.support_damping = model.support.damping;
  c.land = land_constants(model);
  return c;
}

}  // namespace orbearing::bearing::vectorised
