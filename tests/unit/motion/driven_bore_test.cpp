// The bearing whose bore is driven, against the one whose bore is free, and its balance of power.
#include "bearing/motion/driven_start.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <Eigen/LU>

#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/motion/snapshot.hpp"
#include "bearing/motion/vector_bearing.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::driven_bore_test {
namespace {

constexpr int kStates = 30;

struct Variant {
  const char* name;
  bool film;
  bool inner_guidance;
  bool rough;
  bool rim = false;  // bends
};

class DrivenBore : public testing::TestWithParam<Variant> {
 protected:
  DrivenBore() {
    parameters.race.film_in_approach = GetParam().film;
    point.carrier.acceleration = 300.0;
    if (GetParam().inner_guidance) {
      bearing.cage.guidance = Race::inner;
      parameters.cage.guide_diameter = 33.1e-3;
    }
    if (GetParam().rim) point.outer_race = test::bending_race();
    if (!GetParam().rough) return;
    parameters.race.lubrication = Lubrication::mixed;
    parameters.cage.pocket_film = PocketFilm::hydrodynamic;
    bearing.inner.form = {{.order = 2, .amplitude = 1e-6, .phase = 0.4, .rotating = false}};
    bearing.outer.form = {{.order = 3, .amplitude = 2e-6, .phase = 1.0, .rotating = true},
                          {.order = 11, .amplitude = 0.3e-6, .phase = 2.0, .rotating = false}};
    bearing.rollers().diameter_deviation = {0.0, 1e-6, -1e-6, 2e-6};
  }

  BoreMotion motion_of(const BearingModel& model, const Eigen::VectorXd& x, double time) const {
    const ConstStateViews state = state_views(model.layout, x.data());
    BoreMotion motion;
    motion.position = state.bore_position;
    motion.velocity = state.bore_velocity;
    motion.speed = point.outer_speed;
    motion.angle = point.outer_speed * time;
    motion.carrier_speed = point.carrier.speed;
    motion.carrier_acceleration = point.carrier.acceleration;
    return motion;
  }
  Eigen::VectorXd shaken(const BearingModel& model, int i) {
    return test::shaken_state(model, bearing, parameters, i % 3 == 0 ? 2e-6 : 2e-5, 0.05, random);
  }

  Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  OperatingPoint point = test::reducer_point(6000.0);
  test::Random random;
};

// F = m (a - frame) - load.
TEST_P(DrivenBore, ReactionIsWhatTheFreeBoreFeels) {
  const BearingModel model = bearing_model(bearing, point, parameters);
  // The instruction set of snapshots: others round loads otherwise.
  vectorised::VectorBearing equations(model, mechanics::InstructionSet::baseline);
  constexpr double kTime = 1e-3;
  for (int i = 0; i < kStates; ++i) {
    const Eigen::VectorXd x = shaken(model, i);
    Eigen::VectorXd free_rate(x.size()), rate(x.size());
    equations.derivative(kTime, x, free_rate);
    BoreMotion motion = motion_of(model, x, kTime);
    motion.acceleration = free_rate.segment<2>(model.layout.bore() + 2);
    CarrierFrame centred = model.frame;
    centred.orbit_radius = 0.0;
    const Vector2 expected =
        model.bore_mass *
            (motion.acceleration - inertial_acceleration(centred, motion.position, motion.velocity)) -
        point.bore_load;
    const BoreReaction found = equations.derivative(motion, x, rate);
    EXPECT_LT((found.force - expected).norm(), 1e-12 * (expected.norm() + point.bore_load.norm()));
    EXPECT_EQ((rate - free_rate).cwiseAbs().maxCoeff(), 0.0) << "all bodies feel the same";
    const BoreReaction alone = driven_snapshot(model, motion, x).on_bore;
    EXPECT_LT((found.force - alone.force).norm(), 1e-12 * found.force.norm());
    EXPECT_NEAR(found.moment, alone.moment, 1e-12 * found.force.norm() * model.geometry.outer_radius);
    EXPECT_NEAR(found.moment, snapshot(model, x, kTime).on_bore.moment,
                1e-12 * found.force.norm() * model.geometry.outer_radius);
  }
}

// The work at bore and pin, with all other inputs, is stored or lost: the slope of the energy along the
// motion.
TEST_P(DrivenBore, PowerAtTheBoreIsStoredOrLost) {
  BearingModel model = bearing_model(bearing, point, parameters);
  model.bore_mass = 0.0;  // its inertia belongs to the driving system
  vectorised::VectorBearing equations(model);
  int kinked = 0;
  for (int i = 0; i < kStates; ++i) {
    const Eigen::VectorXd x = shaken(model, i);
    const BoreMotion motion = motion_of(model, x, 0.0);
    Eigen::VectorXd rate(x.size());
    const BoreReaction on_bore = equations.derivative(motion, x, rate);
    const PowerInput input = driven_power_input(model, motion, x, rate);
    const double loss = driven_snapshot(model, motion, x).loss.total();
    const double at_port = -on_bore.force.dot(motion.velocity) - on_bore.moment * motion.speed;
    const double others = input.euler + input.changing_film + input.out_of_roundness;
    const auto slope = [&](double step) {
      const auto energy = [&](double time) {
        BoreMotion then = motion;
        then.position += time * motion.velocity;
        then.velocity += time * motion.acceleration;
        then.angle += time * motion.speed;
        return driven_energy(model, then, x + time * rate).total();
      };
      return (energy(step) - energy(-step)) / (2.0 * step);
    };
    const double narrow = slope(1e-9), wide = slope(2e-9);
    const double size = std::abs(at_port) + std::abs(loss) + std::abs(others) + std::abs(narrow);
    if (std::abs(narrow - wide) > 1e-4 * size) {
      ++kinked;
      continue;
    }
    EXPECT_NEAR(at_port + others - loss, narrow, 2e-5 * size) << "state " << i;
  }
  EXPECT_LT(kinked, kStates / 3);
}

// Springs and rollers hold the pin ring; the bore is where it was put.
TEST_P(DrivenBore, StartsWithThePinInBalance) {
  const BearingModel model = bearing_model(bearing, point, parameters);
  for (const double y : {0.0, 10e-6, 40e-6}) {
    BoreMotion motion;
    motion.position = {3e-6, y};
    motion.speed = point.outer_speed;
    motion.carrier_speed = point.carrier.speed;
    const PinBalance balance = balance_pin(bearing, model, parameters, motion, 0.3);
    ASSERT_TRUE(balance.rollers.report.converged);
    EXPECT_GT(balance.pin.norm(), 0.0);
    EXPECT_LT((balance.rollers.displacement - (motion.position - balance.pin)).norm(), 1e-18);
    Vector2 force = model.pin_mass * inertial_acceleration(vectorised::surroundings_of(model, motion).frame,
                                                           Vector2(0.0, 0.0), Vector2(0.0, 0.0)) -
                    model.support.stiffness * balance.pin;
    for (Eigen::Index j = 0; j < model.layout.rollers; ++j)
      force -= balance.rollers.inner_load[j] *
               Vector2(std::cos(balance.rollers.angle[j]), std::sin(balance.rollers.angle[j]));
    EXPECT_LT(force.norm(), 1e-8 * (1.0 + balance.rollers.inner_load.sum()));
    Eigen::VectorXd on_waves(model.layout.waves);
    for (Eigen::Index i = 0; i < model.layout.waves; ++i) {
      const vectorised::RimWave& wave = model.rim[static_cast<std::size_t>(i)];
      on_waves[i] = -wave.stiffness * (balance.rollers.waves[i] - wave.at_rest);
    }
    for (Eigen::Index j = 0; j < model.layout.rollers && GetParam().rim; ++j)
      on_waves += balance.rollers.outer_load[j] * wave_shapes(model.point.outer_race, balance.rollers.angle[j]);
    EXPECT_LT(on_waves.norm(), 1e-8 * (1.0 + balance.rollers.inner_load.sum()));
    const Eigen::VectorXd x = driven_start(bearing, model, parameters, motion, 0.3);
    const BoreReaction on_bore = driven_snapshot(model, motion, x).on_bore;
    // The rollers' own places are those of straight rays and round races: some per cent.
    Vector2 expected = Vector2::Zero();
    for (Eigen::Index j = 0; j < model.layout.rollers; ++j)
      expected += balance.rollers.outer_load[j] *
                  Vector2(std::cos(balance.rollers.angle[j]), std::sin(balance.rollers.angle[j]));
    EXPECT_LT((on_bore.force - expected).norm(), 0.05 * balance.rollers.outer_load.sum() + 1.0);
  }
}

// Equilibrium of the bore too: with the bore in the position found, the pin alone finds the same equilibrium,
// and the rollers balance the load.
TEST_P(DrivenBore, FindsThePositionUnderALoad) {
  const BearingModel model = bearing_model(bearing, point, parameters);
  for (const Vector2& load : {Vector2(100.0, 1000.0), Vector2(-3000.0, 20.0), Vector2(0.0, -20000.0)}) {
    BoreMotion motion;
    motion.speed = point.outer_speed;
    motion.carrier_speed = point.carrier.speed;
    const PinBalance found = balance_pin_and_bore(bearing, model, parameters, motion, 0.3, load);
    ASSERT_TRUE(found.rollers.report.converged) << load.transpose();
    motion.position = found.bore;
    const PinBalance held = balance_pin(bearing, model, parameters, motion, 0.3);
    EXPECT_LT((held.pin - found.pin).norm(), 1e-6 * found.bore.norm());
    Vector2 force = load;
    for (Eigen::Index j = 0; j < model.layout.rollers; ++j)
      force += held.rollers.outer_load[j] *
               Vector2(std::cos(held.rollers.angle[j]), std::sin(held.rollers.angle[j]));
    EXPECT_LT(force.norm(), 1e-6 * load.norm()) << load.transpose();
  }
}

TEST_P(DrivenBore, StartsWhereAllIsZero) {
  const BearingModel model = bearing_model(bearing, point, parameters);
  const Eigen::VectorXd x = driven_start(bearing, model, parameters, {}, 0.0);
  Eigen::VectorXd rate(x.size());
  EXPECT_TRUE(x.allFinite());
  vectorised::VectorBearing(model).derivative(BoreMotion{}, x, rate);
  EXPECT_TRUE(rate.allFinite());
}

INSTANTIATE_TEST_SUITE_P(Variants, DrivenBore,
                         testing::Values(Variant{"dry", false, false, false},
                                         Variant{"film", true, false, false},
                                         Variant{"inner_guidance", true, true, false},
                                         Variant{"rough", true, false, true},
                                         // An elastic rim.
                                         Variant{"rim", true, false, false, true}),
                         [](const testing::TestParamInfo<Variant>& variant) { return variant.param.name; });

}  // namespace
}  // namespace orbearing::bearing::motion::driven_bore_test
