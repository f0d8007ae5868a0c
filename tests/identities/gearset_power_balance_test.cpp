// Power, torque and motion of every set, whichever member is fixed and whichever drives.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "gearset/mean_loads.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::gearset_power_balance_test {
namespace {

constexpr double round_off = 1e-12;       // relative to the largest term
constexpr double root_round_off = 1e-10;  // relative; the centre distance comes from a root finder
constexpr double power = 150e3;           // [W]
constexpr double speed = 628.0;           // [rad/s]

using Layout = std::tuple<Member, Member>;  // fixed, driven

class EveryLayout : public testing::TestWithParam<Layout> {
 protected:
  template <typename Check>
  void for_all_sets(const Check& check) const {
    const auto [fixed, driven] = GetParam();
    if (fixed == driven) return;
    for (PlanetarySet set : all_sets()) {
      set.fixed_member = fixed;
      const WorkingGeometry geometry = working_geometry(set);
      check(set, geometry, mean_loads(set, geometry, {driven, power, speed}));
    }
  }
};

TEST_P(EveryLayout, PowersSumToZero) {
  for_all_sets([](const PlanetarySet&, const WorkingGeometry&, const MeanLoads& loads) {
    const double sum = loads.sun_torque * loads.sun_speed + loads.ring_torque * loads.ring_speed +
                       loads.carrier_torque * loads.carrier_speed;
    EXPECT_NEAR(sum, 0.0, round_off * power);
  });
}

TEST_P(EveryLayout, PowerEntersAtTheDrivenMember) {
  const auto [fixed, driven] = GetParam();
  const Member entry = driven;
  for_all_sets([entry](const PlanetarySet&, const WorkingGeometry&, const MeanLoads& loads) {
    const double entering = entry == Member::sun    ? loads.sun_torque * loads.sun_speed
                            : entry == Member::ring ? loads.ring_torque * loads.ring_speed
                                                    : loads.carrier_torque * loads.carrier_speed;
    EXPECT_NEAR(entering, power, round_off * power);
  });
}

TEST_P(EveryLayout, TorquesSumToZero) {
  for_all_sets([](const PlanetarySet&, const WorkingGeometry&, const MeanLoads& loads) {
    EXPECT_NEAR(loads.sun_torque + loads.ring_torque + loads.carrier_torque, 0.0,
                round_off * std::abs(loads.carrier_torque));
  });
}

TEST_P(EveryLayout, RollingSpeedsMatchAtBothMeshes) {
  for_all_sets([](const PlanetarySet& set, const WorkingGeometry&, const MeanLoads& loads) {
    const double planet = loads.planet_speed_relative * set.planet_teeth;
    EXPECT_NEAR((loads.sun_speed - loads.carrier_speed) * set.sun_teeth, -planet,
                round_off * std::abs(planet));
    EXPECT_NEAR((loads.ring_speed - loads.carrier_speed) * set.ring_teeth, planet,
                round_off * std::abs(planet));
  });
}

TEST_P(EveryLayout, CarrierNeverTurnsBackwards) {
  for_all_sets([](const PlanetarySet&, const WorkingGeometry&, const MeanLoads& loads) {
    EXPECT_GE(loads.carrier_speed, 0.0);
  });
}

TEST_P(EveryLayout, TangentialForcesCarryTheCarrierTorque) {
  for_all_sets([](const PlanetarySet& set, const WorkingGeometry& geometry, const MeanLoads& loads) {
    EXPECT_NEAR(loads.tangential_force * set.planets * geometry.centre_distance, -loads.carrier_torque,
                root_round_off * std::abs(loads.carrier_torque));
  });
}

TEST_P(EveryLayout, BothMeshesLoadThePlanetWithTheSameNormalForce) {
  for_all_sets([](const PlanetarySet& set, const WorkingGeometry& geometry, const MeanLoads& loads) {
    const double at_ring = std::abs(loads.ring_torque) / (set.planets * geometry.ring.base_radius);
    EXPECT_NEAR(at_ring, loads.normal_force, round_off * loads.normal_force);
  });
}

INSTANTIATE_TEST_SUITE_P(FixedAndDriven, EveryLayout,
                         testing::Combine(testing::Values(Member::sun, Member::ring, Member::carrier),
                                          testing::Values(Member::sun, Member::ring, Member::carrier)));

}  // namespace
}  // namespace orbearing::gearset::gearset_power_balance_test
