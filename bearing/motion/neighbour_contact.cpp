#include "bearing/motion/neighbour_contact.hpp"

namespace orbearing::bearing::motion {

NeighbourTouch neighbour_touch(const NeighbourModel& model, const BodyMotion& roller, double radius,
                               const BodyMotion& neighbour, double neighbour_radius) {
  NeighbourTouch touch;
  const Vector2 between = neighbour.position - roller.position;
  const double distance = between.norm();
  const double approach = radius + neighbour_radius - distance;
  if (approach <= 0.0) return touch;
  const Vector2 normal = between / distance, tangent = across(normal);
  const Vector2 velocity = neighbour.velocity - roller.velocity;
  const double arm = radius - 0.5 * approach, neighbour_arm = neighbour_radius - 0.5 * approach;
  const auto pressed = damped_load(model.elastic.load(approach), model.damping, -velocity.dot(normal));
  touch.load = pressed.load;
  touch.sliding = velocity.dot(tangent) - roller.speed * arm - neighbour.speed * neighbour_arm;
  const double friction = model.friction.force(touch.load, touch.sliding);
  touch.on_roller = {-touch.load * normal + friction * tangent, friction * arm};
  touch.energy = model.elastic.energy(approach);
  touch.damping_power = pressed.power;
  touch.friction_power = friction * touch.sliding;
  return touch;
}

}  // namespace orbearing::bearing::motion
