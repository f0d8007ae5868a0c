#include "bearing/equilibrium/tilted_roller.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bearing/equilibrium/roller_balance.hpp"

namespace orbearing::bearing::laminae::tilted_roller_test {
namespace {

constexpr double kBalance = 1e-12;  // of the loads: where the search ends, and the sums' round-off
constexpr double kSides = 1e-5;     // relative, between differences to both sides over 1e-6 of the approach
constexpr double kNothing = 1e-2;   // [N]  below any load of interest
constexpr double kLength = 5.7e-3;

const LineContact line = roller_race_contact(ContactLaw::palmgren, kLength);

LaminaContact contact_with(double crown, int n = 40) {
  return {line, kLength,
          lamina_drops(profile::CircularCrown{kLength, crown}, profile::Straight{}, kLength, n)};
}

Film film(double speed) {
  return {{.equivalent_radius = 2.2e-3,
           .length = kLength,
           .reduced_modulus = 2.26e11,
           .lubricant = {.viscosity = 0.02, .pressure_viscosity = 1.5e-8}},
          speed};
}

RollerState settled(const TiltedRoller& roller, const RollerSetting& setting) {
  RollerState state;
  converge_roller(roller, setting, state);
  EXPECT_TRUE(state.settled);
  return state;
}

TEST(TiltedRoller, WithoutInertiaItTiltsHalfAsMuchAsTheRaces) {
  const LaminaContact contact = contact_with(0.0);
  const Film dry;
  const RollerState state = settled({contact, contact, dry, dry}, {14e-6, 0.0, 6e-6, 0.0});
  EXPECT_NEAR(state.end_displacement, 3e-6, 1e-17);
  EXPECT_NEAR(state.outer_approach, 7e-6, 1e-17);
}

TEST(TiltedRoller, WithoutInertiaItsLaminaeCarryWhatTheStandardSays) {
  // q_k = c_L/n (delta - x_k tan(psi) - 2 P_k)^(10/9) with both contacts in series.
  const double crown = 4e-6, approach = 20e-6, end_displacement = 12e-6;
  const LineContact one = roller_race_contact(ContactLaw::iso16281, kLength);
  const std::vector<double> drops =
      lamina_drops(profile::CircularCrown{kLength, crown}, profile::Straight{}, kLength, 30);
  const LaminaContact contact(one, kLength, drops);
  const Film dry;
  const RollerState state = settled({contact, contact, dry, dry}, {approach, 0.0, end_displacement, 0.0});
  const Eigen::ArrayXd load = contact.loads(state.outer_approach, state.outer_end_displacement);
  const double series = 35948.0 * std::pow(5.7, 8.0 / 9.0) / 30.0;  // N, mm
  for (int k = 0; k < 30; ++k) {
    const double position = 2.0 * ((k + 0.5) / 30.0 - 0.5);
    const double depth =
        1e3 * (approach - position * end_displacement - 2.0 * drops[static_cast<std::size_t>(k)]);
    const double expected = depth > 0.0 ? series * std::pow(depth, 10.0 / 9.0) : 0.0;
    EXPECT_NEAR(load[k], expected, 1e-10 * load.maxCoeff());
  }
}

TEST(TiltedRoller, StraightWithoutTiltIsTheUncutRoller) {
  for (const double inertial : {0.0, 37.0, -520.0})
    for (const bool oil : {false, true})
      for (const double approach : {-30e-6, -0.3e-6, 0.1e-6, 8e-6, 90e-6}) {
        const LaminaContact contact = contact_with(0.0);
        const Film inner = oil ? film(3.0) : Film(), outer = oil ? film(4.0) : Film();
        const RollerState state = settled({contact, contact, inner, outer}, {approach, 0.0, 0.0, inertial});
        const RollerBalance expected = balance_roller({line, inner}, {line, outer}, inertial, approach);
        const double scale = expected.inner_load + expected.outer_load;
        EXPECT_NEAR(state.inner.load, expected.inner_load, kBalance * scale);
        EXPECT_NEAR(state.outer.load, expected.outer_load, kBalance * scale);
        EXPECT_NEAR(state.stiffness, expected.stiffness,
                    1e-12 * (state.inner.by_approach + state.outer.by_approach));
        EXPECT_NEAR(state.end_displacement, 0.0, 1e-16);
      }
}

struct RandomRoller {
  LaminaContact inner, outer;
  Film inner_film, outer_film;
  RollerSetting setting;
};

RandomRoller random_roller(std::mt19937_64& engine) {
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  const int n = std::uniform_int_distribution<int>(1, 200)(engine);
  const bool oil = between(0.0, 1.0) < 0.5;
  const double sign = between(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
  return {contact_with(between(0.0, 30e-6), n),
          contact_with(between(0.0, 30e-6), n),
          oil ? film(between(0.1, 20.0)) : Film(),
          oil ? film(between(0.1, 20.0)) : Film(),
          {sign * std::pow(10.0, between(-8.0, -3.5)), between(-20e-6, 20e-6), between(-20e-6, 20e-6),
           between(0.0, 1.0) < 0.2 ? 0.0 : between(-300.0, 300.0)}};
}

TEST(TiltedRoller, RandomRollersBalanceForcesMomentsAndApproach) {
  std::mt19937_64 engine(11);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const RandomRoller r = random_roller(engine);
    const RollerState state = settled({r.inner, r.outer, r.inner_film, r.outer_film}, r.setting);
    const double scale = state.inner.load + state.outer.load + std::abs(r.setting.inertial_load) + kNothing;
    EXPECT_NEAR(state.outer.load - state.inner.load, r.setting.inertial_load, kBalance * scale);
    EXPECT_NEAR(state.outer.end_load, state.inner.end_load, kBalance * scale);
    const double films = r.inner_film.central(state.inner.load) + r.outer_film.central(state.outer.load);
    EXPECT_NEAR(state.elastic - films, r.setting.approach, 1e-18);
    const LaminaForce again =
        r.outer.evaluate(state.outer_approach, state.end_displacement - r.setting.outer_end_displacement);
    EXPECT_NEAR(again.load, state.outer.load, kBalance * scale);
  }
}

TEST(TiltedRoller, RandomRollersHaveTheStiffnessOfTheirLoad) {
  std::mt19937_64 engine(12);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    const RandomRoller r = random_roller(engine);
    const TiltedRoller roller{r.inner, r.outer, r.inner_film, r.outer_film};
    RollerSetting up = r.setting, down = r.setting;
    const double step = 1e-6 * std::abs(r.setting.approach);
    up.approach += step, down.approach -= step;
    const RollerState state = settled(roller, r.setting);
    const double above = (settled(roller, up).outer.load - state.outer.load) / step;
    const double below = (state.outer.load - settled(roller, down).outer.load) / step;
    // At the first touch of a lamina, or at the end of a film's cap, the two sides differ.
    if (std::abs(above - below) > kSides * std::abs(above)) continue;
    EXPECT_NEAR(state.stiffness, 0.5 * (above + below),
                kSides * std::abs(above) + kBalance * (state.outer.load + kNothing) / step);
    ++compared;
  }
  EXPECT_GT(compared, 200);
}

TEST(TiltedRoller, StartingNearbyEndsAtTheSamePosition) {
  std::mt19937_64 engine(13);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    const RandomRoller r = random_roller(engine), s = random_roller(engine);
    const TiltedRoller roller{r.inner, r.outer, r.inner_film, r.outer_film};
    const RollerState cold = settled(roller, r.setting);
    RollerState warm = settled(roller, s.setting);
    converge_roller(roller, r.setting, warm);
    EXPECT_TRUE(warm.settled);
    EXPECT_NEAR(warm.outer.load, cold.outer.load,
                1e-11 * (cold.outer.load + std::abs(r.setting.inertial_load) + kNothing));
  }
}

}  // namespace
}  // namespace orbearing::bearing::laminae::tilted_roller_test
