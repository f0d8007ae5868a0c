#include "bearing/motion/cage_pocket.hpp"

namespace orbearing::bearing::motion {

PocketForces pocket_forces(const PocketModel& model, const BodyMotion& roller, const BodyMotion& cage,
                           const Vector2& outward, double larger) {
  PocketForces forces = touch_forces(model, roller, cage, outward, larger);
  if (!model.with_film()) return forces;
  const PocketLaw law = pocket_law(model);
  const PocketMotion motion = pocket_motion(roller, cage, outward);
  const auto oil = law.oil(model.roller_radius + larger, larger, motion);
  const Vector2 force = oil.ahead * across(outward) + oil.along * outward;
  forces.on_roller += {force, oil.roller_moment};
  forces.on_cage += {-force, oil.cage_moment};
  forces.load -= oil.ahead;
  forces.film_power += oil.power;
  return forces;
}

}  // namespace orbearing::bearing::motion
