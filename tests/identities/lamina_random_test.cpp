// Properties of every bearing on laminae: profiles, tilts, loads and motions drawn at random.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "tests/random_laminae.hpp"

namespace orbearing::bearing::laminae::lamina_random_test {
namespace {

constexpr double kBalance = 1e-8;  // of the largest force: the search ends below 1e-9, sums round again

int number_of_draws() {
  const char* text = std::getenv("RANDOM_BEARINGS");
  return text == nullptr ? 1000 : 10 * std::atoi(text);
}

double largest_load(const Draw& draw, const QuasiStaticState& state) {
  double most = draw.point.bore_load.norm();
  for (const RollerState& roller : state.rollers)
    most = std::max({most, roller.inner.load, roller.outer.load});
  return most;
}

void expect_balance(const Draw& draw, const LaminaBearing& bearing, const QuasiStaticState& state) {
  const RaceEquilibrium problem = quasi_static_problem(draw.bearing, geometry_of(draw.bearing), draw.point,
                                                       draw.options, draw.options.first_roller);
  const double scale = largest_load(draw, state) + problem.load.norm();
  Eigen::Vector2d force = problem.load, moment = Eigen::Vector2d::Zero();
  for (Eigen::Index j = 0; j < state.angle.size(); ++j) {
    const RollerState& roller = state.rollers[static_cast<std::size_t>(j)];
    const Eigen::Vector2d outward(std::cos(state.angle[j]), std::sin(state.angle[j]));
    const Eigen::ArrayXd inner =
        bearing.contact(Race::inner).loads(roller.inner_approach(), roller.inner_end_displacement);
    const Eigen::ArrayXd outer =
        bearing.contact(Race::outer).loads(roller.outer_approach, roller.outer_end_displacement);
    ASSERT_TRUE(inner.allFinite() && outer.allFinite()) << draw;
    EXPECT_GE(std::min(inner.minCoeff(), outer.minCoeff()), 0.0);
    const Eigen::ArrayXd positions = bearing.contact(Race::outer).positions();
    EXPECT_NEAR(outer.sum() - inner.sum(), problem.inertial_load[j], kBalance * scale) << draw;
    EXPECT_NEAR((positions * outer).sum(), (positions * inner).sum(), kBalance * scale) << draw;
    force += outer.sum() * outward;
    moment += bearing.half_length() * (positions * outer).sum() * outward;
  }
  EXPECT_LE(force.norm(), kBalance * scale) << draw;
  EXPECT_LE((moment - state.moment).norm(), kBalance * scale * bearing.half_length()) << draw;
}

TEST(RandomLaminae, BalanceUnderAnyProfileTiltLoadAndMotion) {
  RandomLaminae bearings;
  for (int i = 0; i < number_of_draws(); ++i) {
    const Draw draw = bearings.next();
    SCOPED_TRACE("draw " + std::to_string(i) + " of seed " + std::to_string(kSeed) + ", " +
                 std::to_string(draw.bearing.rollers().laminae) + " laminae, " +
                 profile::kind(draw.bearing.rollers().profile) + " rollers");
    const LaminaBearing bearing(draw.bearing);
    const QuasiStaticState state =
        quasi_static_state(bearing, draw.point, draw.options, draw.options.first_roller);
    ASSERT_TRUE(state.report.converged) << draw << ": " << state.report.message;
    expect_balance(draw, bearing, state);
  }
}

TEST(RandomLaminae, StraightWithoutTiltAreTheUncutBearing) {
  constexpr double kAgreement = 1e-8;  // of the largest force: both searches end below 1e-9 of it
  RandomLaminae bearings;
  for (int i = 0; i < number_of_draws() / 5; ++i) {
    Draw draw = bearings.next();
    SCOPED_TRACE("draw " + std::to_string(i));
    draw.bearing.rollers().profile = draw.bearing.inner.profile = draw.bearing.outer.profile =
        profile::Straight{};
    draw.point.bore_tilt.setZero();
    const QuasiStaticState state =
        quasi_static_state(LaminaBearing(draw.bearing), draw.point, draw.options, draw.options.first_roller);
    const QuasiStaticState uncut =
        quasi_static_state(draw.bearing, draw.point, draw.options, draw.options.first_roller);
    const double scale = largest_load(draw, state);
    for (Eigen::Index j = 0; j < state.angle.size(); ++j) {
      const RollerState& roller = state.rollers[static_cast<std::size_t>(j)];
      EXPECT_NEAR(roller.inner.load, uncut.inner_load[j], kAgreement * scale) << draw;
      EXPECT_NEAR(roller.outer.load, uncut.outer_load[j], kAgreement * scale) << draw;
    }
  }
}

}  // namespace
}  // namespace orbearing::bearing::laminae::lamina_random_test
