// The driven bearing as a machine: windows, state, errors, outputs.
#include "coupling/system/driven_bearing.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <stdexcept>

#include "tests/messages.hpp"
#include "tests/unit/cosim/driven_reducer.hpp"

namespace orbearing::system::driven_bearing_test {
namespace {

using bearing::motion::BoreMotion;
using std::numbers::pi;

constexpr double kWindow = 20e-6;  // [s]

Window window(long k) {
  return {static_cast<double>(k) * kWindow, static_cast<double>(k + 1) * kWindow};
}

void advance(DrivenBearing& bearing, const BoreMotion& about, long from, long to) {
  for (long k = from; k < to; ++k)
    bearing.advance(window(k), test::swinging_polynomial(about, 2e-6, 2e4, window(k).begin));
}

BoreMotion swinging(const BoreMotion& about, double time) {
  return test::swinging_polynomial(about, 2e-6, 2e4, time).at(0.0);
}

TEST(DrivenBearing, StandsStillWhereNothingMoves) {
  DrivenBearing bearing(test::driven_reducer());
  const BoreMotion none;
  bearing.initialize(none);
  bearing.advance({0.0, 1e-3}, test::constant_polynomial(none));
  const DrivenBearingOutput output = bearing.output(none);
  EXPECT_NEAR(output.reaction.force.norm(), 0.0, 0.1);  // [N]  the start rests on films of no thickness
  EXPECT_EQ(output.cage_slip, 0.0);
  EXPECT_EQ(output.revolutions, 0.0);
  EXPECT_EQ(output.life_used, 0.0);
}

TEST(DrivenBearing, PushesBackWhereItIsPressed) {
  DrivenBearing bearing(test::driven_reducer());
  const BoreMotion motion = test::pressed_motion();
  bearing.initialize(motion);
  const double at_start = bearing.output(motion).reaction.force.y();
  EXPECT_LT(at_start, -3000.0);  // [N]
  bearing.advance({0.0, 1e-3}, test::constant_polynomial(motion));
  const DrivenBearingOutput output = bearing.output(motion);
  EXPECT_NEAR(output.reaction.force.y(), at_start, 0.3 * std::abs(at_start));
  EXPECT_NEAR(output.reaction.moment, 0.0, 5.0);
  EXPECT_GT(output.reaction.moment, 0.0) << "friction holds back a bore that turns clockwise";
  EXPECT_NEAR(output.revolutions, std::abs(motion.speed) * 1e-3 / (2.0 * pi), 1e-12);
  EXPECT_GT(output.life_used, 0.0);
  EXPECT_GT(output.friction_loss, 0.0);
  EXPECT_LT(std::abs(output.cage_slip), 0.05);
  EXPECT_EQ(output.inner_load.size(), 15u);
}

TEST(DrivenBearing, ReactionIsThatOfTheOutput) {
  DrivenBearing bearing(test::driven_reducer());
  const BoreMotion motion = test::pressed_motion();
  bearing.initialize(motion);
  const auto quick = bearing.reaction(motion), full = bearing.output(motion).reaction;
  EXPECT_EQ(quick.force, full.force);
  EXPECT_EQ(quick.moment, full.moment);
}

class DrivenBearingState : public testing::TestWithParam<bool> {
 protected:
  DrivenBearingState() {
    if (GetParam()) setup.dynamics.cage.pocket_film = bearing::motion::PocketFilm::hydrodynamic;
    setup.bearing.outer.form = {{.order = 5, .amplitude = 0.5e-6, .phase = 1.0, .rotating = true}};
  }
  DrivenBearingSetup setup = test::driven_reducer();
  BoreMotion about = test::pressed_motion();
};

TEST_P(DrivenBearingState, ComesBackToTheSameBits) {
  DrivenBearing bearing(setup);
  bearing.initialize(about);
  advance(bearing, about, 0, 5);
  SavedState before, after, again, elsewhere;
  bearing.save(before);
  advance(bearing, about, 5, 10);
  bearing.save(after);
  bearing.restore(before);
  advance(bearing, about, 5, 10);
  bearing.save(again);
  DrivenBearing other(setup);
  other.restore(before);
  advance(other, about, 5, 10);
  other.save(elsewhere);
  EXPECT_NE(before, after);
  EXPECT_EQ(after, again);
  EXPECT_EQ(after, elsewhere);
}

TEST_P(DrivenBearingState, StaysAtTheBeginningOnAnError) {
  setup.most_steps = 1000;
  DrivenBearing bearing(setup);
  bearing.initialize(about);
  advance(bearing, about, 0, 2);
  SavedState before, after;
  bearing.save(before);
  BoreInputs inputs = test::constant_polynomial(about);
  inputs.v_y.coefficient[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_REFUSED(std::runtime_error, "driven input", bearing.advance(window(2), inputs));
  inputs = test::constant_polynomial(about);
  inputs.x.coefficient[1] = 1e4;  // [m/s]  through all rollers
  EXPECT_THROW(bearing.advance({0.0, 1e-4}, inputs), std::runtime_error);
  EXPECT_REFUSED(std::runtime_error, "driven window",
                 bearing.advance({1e-3, 0.0}, test::constant_polynomial(about)));
  bearing::motion::BoreMotion nowhere = about;
  nowhere.velocity.x() = std::numeric_limits<double>::infinity();
  EXPECT_REFUSED(std::runtime_error, "driven motion", DrivenBearing(setup).initialize(nowhere));
  bearing.save(after);
  EXPECT_EQ(before, after);
}

INSTANTIATE_TEST_SUITE_P(Paths, DrivenBearingState, testing::Bool(),
                         [](const auto& path) { return path.param ? "oiled_pockets" : "dry_pockets"; });

TEST(DrivenBearing, GivesUpWhereItsStepsAreUsedUp) {
  DrivenBearingSetup setup = test::driven_reducer();
  setup.most_steps = 3;
  DrivenBearing bearing(setup);
  bearing.initialize(test::pressed_motion());
  EXPECT_THROW(bearing.advance({0.0, 1e-3}, test::constant_polynomial(test::pressed_motion())),
               std::runtime_error);
}

TEST(DrivenBearing, RefusesAForeignState) {
  DrivenBearing bearing(test::driven_reducer());
  DrivenBearingSetup other = test::driven_reducer();
  other.bins = 36;
  SavedState state;
  DrivenBearing(other).save(state);
  EXPECT_REFUSED(std::invalid_argument, "driven_bearing 5", bearing.restore(state));
  bearing.save(state);
  state.pop_back();
  EXPECT_REFUSED(std::invalid_argument, "driven_bearing 6", bearing.restore(state));
  EXPECT_REFUSED(std::invalid_argument, "driven_bearing 7", bearing.restore({}));
  bearing.save(state);
  state[0] += 1.0;
  EXPECT_REFUSED(std::invalid_argument, "driven_bearing 8", bearing.restore(state));
}

TEST(DrivenBearing, RefusesWhatAsksForSpeedsBeforehand) {
  DrivenBearingSetup setup = test::driven_reducer();
  setup.dynamics.driving.ramp = 1.0;
  EXPECT_REFUSED(std::invalid_argument, "driven_bearing 9", DrivenBearing{setup});
  setup = test::driven_reducer();
  setup.orbit_radius = -1.0;
  EXPECT_REFUSED(std::invalid_argument, "driven_bearing 10", DrivenBearing{setup});
}

// The step size outlives a window, so that how time is cut matters little.
TEST(DrivenBearing, DependsLittleOnTheWindows) {
  const BoreMotion motion = test::pressed_motion();
  const auto force_after = [&](long windows) {
    DrivenBearingSetup setup = test::driven_reducer();
    setup.allowed_length_error = 1e-13;
    DrivenBearing bearing(setup);
    bearing.initialize(motion);
    const double end = 50e-6;
    for (long k = 0; k < windows; ++k)
      bearing.advance({end * static_cast<double>(k) / static_cast<double>(windows),
                       end * static_cast<double>(k + 1) / static_cast<double>(windows)},
                      test::constant_polynomial(motion));
    return bearing.reaction(motion).force;
  };
  const Eigen::Vector2d whole = force_after(1), cut = force_after(37);
  EXPECT_LT((whole - cut).norm(), 1e-3 * whole.norm());
}

TEST(DrivenBearing, SlopesAreThoseOfTheForce) {
  for (const bool oiled_pockets : {false, true}) {
    DrivenBearingSetup setup = test::driven_reducer();
    if (oiled_pockets) setup.dynamics.cage.pocket_film = bearing::motion::PocketFilm::hydrodynamic;
    DrivenBearing bearing(setup);
    const BoreMotion about = test::pressed_motion();
    bearing.initialize(about);
    advance(bearing, about, 0, 5);
    const BoreMotion motion = swinging(about, window(5).begin);
    const ForceSlopes slopes = bearing.slopes(motion);
    const auto difference = [&](double step, auto move) -> Eigen::Vector2d {
      const auto at = [&](double by) {
        BoreMotion moved = motion;
        move(moved) += by;
        return bearing.reaction(moved).force;
      };
      return (8.0 * (at(step) - at(-step)) - (at(2.0 * step) - at(-2.0 * step))) / (12.0 * step);
    };
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d position =
          difference(2e-9, [k](BoreMotion& m) -> double& { return m.position[k]; });
      const Eigen::Vector2d velocity =
          difference(1e-5, [k](BoreMotion& m) -> double& { return m.velocity[k]; });
      EXPECT_LT((slopes.by_displacement.col(k) - position).norm(), 1e-6 * position.norm());
      EXPECT_LT((slopes.by_velocity.col(k) - velocity).norm(), 1e-6 * velocity.norm());
    }
    const Eigen::Vector2d speed = difference(1e-2, [](BoreMotion& m) -> double& { return m.speed; });
    EXPECT_LT((slopes.by_speed - speed).norm(), 1e-5 * speed.norm());
    EXPECT_LT(slopes.by_displacement(1, 1), -1e7) << "a stiff spring [N/m]";
  }
}

}  // namespace
}  // namespace orbearing::system::driven_bearing_test
