#include "bearing/motion/cage_pocket.hpp"

namespace orbearing::bearing::motion {

PocketForces pocket_forces(const PocketModel& model, const BodyMotion& roller, const BodyMotion& cage,
                           const Vector2& outward, double larger) {
  PocketForces forces = touch_forces(model, roller, cage, outward, larger);
  if (!model.with_film()) return forces;
  const PocketLaw law = pocket_law(model);
  const PocketMotion motion = pocket_motion(roller, cage, outward);
  for (const double bar : {-1.0, 1.0}) {
    const auto film = law.film(bar, model.roller_radius + larger, larger, motion);
    const Vector2 force = film.ahead * across(outward) + film.along * outward;
    forces.on_roller += {force, film.roller_moment};
    forces.on_cage += {-force, film.cage_moment};
    forces.load -= film.ahead;
    forces.film_power += film.power;
  }
  return forces;
}

}  // namespace orbearing::bearing::motion
