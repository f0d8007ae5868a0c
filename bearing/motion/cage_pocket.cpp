#include "bearing/motion/cage_pocket.hpp"

#include "bearing/contact/rigid_line_film.hpp"

namespace orbearing::bearing::motion {

namespace {

// Adds the film at one bar (`bar` = +1 ahead of the roller, -1 behind it) of the pocket along `outward`. The
// gap is held at the roughness, so that the film goes over into the touch of roller and bar without a jump.
// Surface speeds are along e, relative to the contact, which moves with the roller's centre and turns with
// the cage.
void add_pocket_film(const PocketModel& model, const BodyMotion& roller, const BodyMotion& cage,
                     const Vector2& outward, double larger, double bar, PocketForces& forces) {
  const Vector2 ahead = across(outward);
  const Vector2 from_cage = roller.position - cage.position;
  const Vector2 relative_velocity = roller.velocity - cage.velocity;
  const double offset = from_cage.dot(ahead);
  const double radius = model.roller_radius + larger;
  const double gap = std::max(model.half_clearance - larger - bar * offset, model.roughness);
  const double closing = bar * (relative_velocity.dot(ahead) - cage.speed * from_cage.dot(outward));
  const double roller_surface = -bar * radius * (roller.speed - cage.speed);
  const double bar_surface = -relative_velocity.dot(outward) - cage.speed * offset;
  const double rolling = 0.5 * (roller_surface + bar_surface);
  const auto rigid = RigidLineFilm<double>::of(model.viscosity, model.length, radius);
  auto film = rigid.at(rigid.slenderness(gap), std::abs(rolling), closing);
  film.load = std::max(film.load, 0.0);  // round-off

  // The surface is dragged by 2 rolling shear; the tilt of the pressure pushes the roller ahead by twice
  // that.
  const double drag = film.shear * (bar_surface - roller_surface - 2.0 * rolling);
  const Vector2 force = -bar * film.load * ahead + (drag + 4.0 * film.shear * rolling) * outward;
  const Wrench on_roller{force, -bar * radius * drag};
  forces.on_roller += on_roller;
  forces.on_cage += {-force, -cross(from_cage, force) - on_roller.moment};
  forces.load += bar * film.load;
  forces.film_power += line_film_power(film, rolling, closing, bar_surface - roller_surface);
}

}  // namespace

PocketForces pocket_forces(const PocketModel& model, const BodyMotion& roller, const BodyMotion& cage,
                           const Vector2& outward, double larger) {
  PocketForces forces = touch_forces(model, roller, cage, outward, larger);
  if (!model.with_film) return forces;
  for (const double bar : {-1.0, 1.0}) add_pocket_film(model, roller, cage, outward, larger, bar, forces);
  return forces;
}

}  // namespace orbearing::bearing::motion
