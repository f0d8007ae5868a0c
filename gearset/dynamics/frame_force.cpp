#include "gearset/dynamics/frame_force.hpp"

#include <cmath>

namespace orbearing::gearset::dynamics {

namespace {

// Nominal speed of a planet in space.
double planet_speed(const Speeds& speeds) {
  return speeds.carrier + speeds.planet_relative;
}

}  // namespace

void add_weights(const SetModel& model, double time, Eigen::Ref<Eigen::VectorXd> force) {
  const double turned = carrier_angle(model.operation, time);
  for (Eigen::Index n = 0; n < model.layout.planets; ++n) {
    const double angle = turned + model.planet_angles[static_cast<std::size_t>(n)];
    const double weight = model.parameters.gravity * model.parameters.planet.mass;
    force.segment<2>(SetLayout::planet(n)) -= weight * Eigen::Vector2d(std::sin(angle), std::cos(angle));
  }
}

void add_run_up_forces(const SetModel& model, const SpeedState& speed, Eigen::Ref<Eigen::VectorXd> force) {
  const SetParameters& set = model.parameters;
  if (!set.frame.euler) return;
  const Speeds& nominal = model.operation.speeds;
  const auto resist = [&](Eigen::Index index, double inertia, double radius, double rotating) {
    force[index + 2] -= inertia * radius * rotating * speed.rate;
  };
  resist(SetLayout::sun(), set.sun.inertia, set.sun.radius, nominal.sun);
  resist(SetLayout::ring(), set.ring.inertia, set.ring.radius, nominal.ring);
  resist(SetLayout::carrier(), set.carrier.inertia, set.carrier.radius, nominal.carrier);
  for (Eigen::Index n = 0; n < model.layout.planets; ++n)
    resist(SetLayout::planet(n), set.planet.inertia, set.planet.radius, planet_speed(nominal));
}

double run_up_power(const SetModel& model, const SpeedState& speed) {
  const SetParameters& set = model.parameters;
  if (!set.frame.euler) return 0.0;
  const Speeds& nominal = model.operation.speeds;
  const auto square = [](double value) { return value * value; };
  const double twice_energy =
      set.sun.inertia * square(set.sun.radius * nominal.sun) +
      set.ring.inertia * square(set.ring.radius * nominal.ring) +
      (set.carrier.inertia + set.planets * set.planet.mass) * square(set.carrier.radius * nominal.carrier) +
      set.planets * set.planet.inertia * square(set.planet.radius * planet_speed(nominal));
  return twice_energy * speed.factor * speed.rate;
}

}  // namespace orbearing::gearset::dynamics
