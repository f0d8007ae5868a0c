#include "bearing/equilibrium/race_equilibrium.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "mechanics/constants.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::race_equilibrium_test {
namespace {

constexpr double kRoundOff = 1e-12;        // relative
constexpr double kDifferenceError = 1e-6;  // central difference with a step of 1e-4 of the approach, relative

constexpr double kPitch = constants::two_pi / 15.0;  // [rad]

RaceEquilibrium planet_equilibrium(const std::optional<Lubricant>& lubricant) {
  const Bearing bearing = example_bearings::planet_bearing();
  RaceEquilibrium problem{rolling_contacts(bearing, geometry_of(bearing), 0.0, -720.0, lubricant)};
  problem.clearance = 10e-6;
  problem.load = {500.0, 1000.0};
  problem.angle = Eigen::ArrayXd::LinSpaced(15, 0.1, 0.1 + 14.0 * kPitch);
  problem.inertial_load = 5.0 + 10.0 * problem.angle.cos();
  return problem;
}

constexpr Lubricant kOil{.viscosity = 0.01, .pressure_viscosity = 1.5e-8};

// Entrainment u = |(omega - omega_c) R -+ (phi' - omega_c) D/2| / 2, relative to the contact that moves with
// the cage.
TEST(RollingContacts, FilmIsThatOfTheEntrainmentRelativeToTheMovingContact) {
  const Bearing bearing = example_bearings::planet_bearing();
  const BearingGeometry geometry = geometry_of(bearing);
  const double inner_speed = 100.0, outer_speed = -720.0, load = 300.0;
  const RollerContacts contacts = rolling_contacts(bearing, geometry, inner_speed, outer_speed, kOil);
  const double cage = kinematic_cage_speed(geometry, inner_speed, outer_speed);
  const double roller =
      (kinematic_roller_spin(geometry, inner_speed, outer_speed) - cage) * geometry.element_radius;
  const double inner = 0.5 * std::abs((inner_speed - cage) * geometry.inner_radius - roller);
  const double outer = 0.5 * std::abs((outer_speed - cage) * geometry.outer_radius + roller);
  const double inner_film = Film(film_contact(bearing, geometry, Race::inner, kOil), inner).central(load);
  const double outer_film = Film(film_contact(bearing, geometry, Race::outer, kOil), outer).central(load);
  EXPECT_GT(inner_film, 0.0);
  EXPECT_NEAR(contacts.inner.film().central(load), inner_film, inner_film * kRoundOff);
  EXPECT_NEAR(contacts.outer.film().central(load), outer_film, outer_film * kRoundOff);
}

TEST(RollingContacts, AreDryWithoutLubricant) {
  const Bearing bearing = example_bearings::planet_bearing();
  const RollerContacts contacts = rolling_contacts(bearing, geometry_of(bearing), 0.0, -720.0, std::nullopt);
  EXPECT_EQ(contacts.inner.film().central(300.0), 0.0);
  EXPECT_EQ(contacts.outer.onset(), 0.0);
}

TEST(RaceEquilibrium, ApproachIsMinusTheDisplacementOutwardLessHalfTheClearance) {
  RaceEquilibrium problem = planet_equilibrium(std::nullopt);
  problem.angle = Eigen::ArrayXd::Zero(1);
  EXPECT_NEAR(problem.approach(0, {-20e-6, 3e-6}), 20e-6 - 5e-6, 20e-6 * kRoundOff);
}

mechanics::Imbalance<2> imbalance_at(const RaceEquilibrium& problem, const Eigen::Vector2d& displacement) {
  std::vector<laminae::RollerState> rollers(15);
  return ring_on_rollers<2>(problem, rollers)(displacement);
}

TEST(RaceEquilibrium, StiffnessIsTheSlopeOfTheForce) {
  for (const std::optional<Lubricant>& lubricant :
       {std::optional<Lubricant>(), std::optional<Lubricant>(kOil)}) {
    const RaceEquilibrium problem = planet_equilibrium(lubricant);
    const Eigen::Vector2d at(-12e-6, -18e-6);
    const double step = 1e-9;
    const Eigen::Matrix2d stiffness = imbalance_at(problem, at).stiffness;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d h = step * Eigen::Vector2d::Unit(axis);
      const Eigen::Vector2d slope =
          (imbalance_at(problem, at + h).force - imbalance_at(problem, at - h).force) / (2.0 * step);
      EXPECT_LT((stiffness.col(axis) + slope).norm(), stiffness.norm() * kDifferenceError);
    }
  }
}

TEST(RaceEquilibrium, SolutionLeavesNoForce) {
  for (const std::optional<Lubricant>& lubricant :
       {std::optional<Lubricant>(), std::optional<Lubricant>(kOil)}) {
    const RaceEquilibrium problem = planet_equilibrium(lubricant);
    const QuasiStaticState state = solve(problem);
    ASSERT_TRUE(state.report.converged) << state.report.message;
    EXPECT_LT(imbalance_at(problem, state.displacement).force.norm(), 1e-9 * problem.load.norm());
    EXPECT_EQ(state.report.residual, imbalance_at(problem, state.displacement).force.norm());
    EXPECT_GT(state.report.iterations, 0);
    EXPECT_TRUE(state.report.message.empty());
  }
}

}  // namespace
}  // namespace orbearing::bearing::race_equilibrium_test
