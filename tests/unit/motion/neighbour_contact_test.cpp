// Issue 16, Build 8: rollers of a full complement that touch one another.
#include "bearing/motion/neighbour_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace orbearing::bearing::motion::neighbour_contact_test {
namespace {

constexpr double kRadius = 3e-3, kMass = 4.9e-3, kInertia = 0.5 * kMass * kRadius * kRadius;

NeighbourModel steel(double damping, double friction) {
  return {.elastic = roller_race_contact(ContactLaw::palmgren, 22e-3),
          .damping = damping,
          .friction = {friction, 0.1}};
}

// Two equal rollers on a line, and how they fly on after they have met.
struct Flight {
  BodyMotion left, right;
  double lost = 0.0;  // [J]
};

Flight meet(const NeighbourModel& model, double left_speed, double right_speed, double spin = 0.0) {
  Flight f{{{0.0, 0.0}, {left_speed, 0.0}, spin}, {{2.0 * kRadius + 1e-9, 0.0}, {right_speed, 0.0}, spin}};
  constexpr double kStep = 1e-9;  // [s]  a ten-thousandth of an impact, by the leapfrog scheme
  for (bool met = false, apart = false; !apart;) {
    f.left.position += 0.5 * kStep * f.left.velocity;
    f.right.position += 0.5 * kStep * f.right.velocity;
    const NeighbourTouch on_left = neighbour_touch(model, f.left, kRadius, f.right, kRadius);
    const NeighbourTouch on_right = neighbour_touch(model, f.right, kRadius, f.left, kRadius);
    f.left.velocity += kStep / kMass * on_left.on_roller.force;
    f.right.velocity += kStep / kMass * on_right.on_roller.force;
    f.left.speed += kStep / kInertia * on_left.on_roller.moment;
    f.right.speed += kStep / kInertia * on_right.on_roller.moment;
    f.lost += kStep * (on_left.damping_power + on_left.friction_power);
    f.left.position += 0.5 * kStep * f.left.velocity;
    f.right.position += 0.5 * kStep * f.right.velocity;
    met = met || on_left.load > 0.0;
    apart = met && on_left.load == 0.0;
  }
  return f;
}

// Equal masses without damping exchange their speeds.
TEST(NeighbourContact, HeadOnRollersExchangeTheirSpeeds) {
  constexpr double kError = 1e-5;  // [m/s]  of the leapfrog scheme: the square of step over duration
  const Flight after = meet(steel(0.0, 0.0), 0.3, -0.1);
  EXPECT_NEAR(after.left.velocity.x(), -0.1, kError);
  EXPECT_NEAR(after.right.velocity.x(), 0.3, kError);
  EXPECT_EQ(after.left.velocity.y(), 0.0);
}

// m v dv/(1 + c v) = -K delta^n d(delta): G(v) = v/c - ln(1 + c v)/c^2 is the same on the way in and out,
// whatever the law of the load.
TEST(NeighbourContact, DampedImpactKeepsMomentumAndReturnsAsHuntAndCrossleySay) {
  constexpr double kDamping = 1.0, kIn = 0.4;  // [s/m], [m/s]
  const auto work = [&](double v) { return v / kDamping - std::log1p(kDamping * v) / (kDamping * kDamping); };
  const Flight after = meet(steel(kDamping, 0.0), 0.3, -0.1);
  EXPECT_NEAR(after.left.velocity.x() + after.right.velocity.x(), 0.2, 1e-12);
  const double out = after.right.velocity.x() - after.left.velocity.x();
  EXPECT_LT(out, 0.9 * kIn);
  EXPECT_NEAR(work(-out), work(kIn), 1e-4 * work(kIn));
  const double kinetic = 0.25 * kMass * (kIn * kIn - out * out);
  EXPECT_NEAR(after.lost, kinetic, 1e-3 * kinetic);
}

// Both spin alike: what friction takes from their spins it gives to their sideways motion, and angular
// momentum is kept.
TEST(NeighbourContact, FrictionBrakesBothSpinsAndKeepsAngularMomentum) {
  constexpr double kSpin = 2000.0;  // [rad/s]
  const Flight after = meet(steel(0.1, 0.12), 0.2, -0.2, kSpin);
  EXPECT_LT(after.left.speed, kSpin);
  EXPECT_DOUBLE_EQ(after.left.speed, after.right.speed);
  EXPECT_NEAR(after.left.velocity.y(), -after.right.velocity.y(), 1e-15);
  EXPECT_LT(after.left.velocity.y(), 0.0) << "its neighbour's surface comes down on it";
  const auto angular = [](const BodyMotion& body) {
    return kMass * cross(body.position, body.velocity) + kInertia * body.speed;
  };
  const double before = 2.0 * kInertia * kSpin;
  EXPECT_NEAR(angular(after.left) + angular(after.right), before, 1e-9 * before);
}

TEST(NeighbourContact, SlidesAtTheSumOfTheSurfaceSpeedsAndIsOppositeAndEqual) {
  const NeighbourModel model = steel(0.1, 0.12);
  const BodyMotion one{{1e-3, 2e-3}, {0.1, -0.2}, 900.0};
  const double other_radius = 3.2e-3, approach = 1e-6;
  const Vector2 along = direction(0.7);
  const BodyMotion other{one.position + (kRadius + other_radius - approach) * along, {-0.3, 0.1}, 800.0};
  const NeighbourTouch on_one = neighbour_touch(model, one, kRadius, other, other_radius);
  const NeighbourTouch on_other = neighbour_touch(model, other, other_radius, one, kRadius);
  const double sideways = (other.velocity - one.velocity).dot(across(along));
  EXPECT_NEAR(on_one.sliding, sideways - 900.0 * kRadius - 800.0 * other_radius, 2e-3);
  EXPECT_NEAR((on_one.on_roller.force + on_other.on_roller.force).norm(), 0.0, 1e-9);
  EXPECT_NEAR(on_one.friction_power, on_other.friction_power, 1e-9);
  EXPECT_GT(on_one.friction_power, 0.0);
  const double moments = on_one.on_roller.moment + on_other.on_roller.moment +
                         cross(other.position - one.position, on_other.on_roller.force);
  EXPECT_NEAR(moments, 0.0, 1e-12);
  const double k = model.elastic.load(approach);
  const double closing = (one.velocity - other.velocity).dot(along);
  EXPECT_NEAR(on_one.load, k * (1.0 + 0.1 * closing), 1e-6 * k);
  const BodyMotion off{other.position + 2e-6 * along, other.velocity, other.speed};
  EXPECT_EQ(neighbour_touch(model, one, kRadius, off, other_radius).load, 0.0);
}

}  // namespace
}  // namespace orbearing::bearing::motion::neighbour_contact_test
