// Single bearings under a load of their own, from structures of inputs without a case.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bearing/equilibrium/ring_axes.hpp"
#include "coupling/analysis/bearing_stiffness.hpp"
#include "coupling/analysis/bearing_under_load.hpp"

namespace orbearing::analysis::single_bearing_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double round_off = 1e-9;

RollersUnderLoad rollers() {
  RollersUnderLoad in;
  bearing::Bearing& bearing = in.loaded.bearing;
  bearing.rollers().count = 12;
  bearing.rollers().diameter = 10e-3;
  bearing.rollers().length = 12e-3;
  bearing.pitch_diameter = 60e-3;
  in.loaded.load.radial = 5000.0;
  return in;
}

BallsUnderLoad balls(double contact_angle) {
  BallsUnderLoad in;
  bearing::Bearing& bearing = in.loaded.bearing;
  bearing.balls() = {.count = 9, .diameter = 10e-3, .contact_angle = contact_angle};
  bearing.pitch_diameter = 50e-3;
  in.loaded.load.radial = 1000.0;
  return in;
}

// A mineral oil as a case with lubricant.grade states it.
void fill_with_oil(double temperature, LoadedBearing& in) {
  const bearing::GradedOil stated{.grade = bearing::ViscosityGrade::vg100, .temperature = temperature};
  const bearing::OilGrade grade = oil_of(stated).value();
  in.oil = {.stated = stated,
            .kinematic_viscosity = bearing::kinematic_viscosity(grade, temperature),
            .lubricant = bearing::lubricant_at(grade, temperature)};
}

TEST(RollersUnderLoad, CarryTheLoad) {
  const BearingUnderLoad result = rollers_under_load(rollers());
  const Eigen::ArrayXd& load = result.state.contact_load;
  ASSERT_EQ(load.size(), 12);
  EXPECT_NEAR((load * bearing::equilibrium::element_angles(result.bearing).cos()).sum() / 5000.0, 1.0,
              round_off);
  EXPECT_EQ(result.bearing.rollers().laminae, default_laminae);
  EXPECT_EQ(result.speed, 0.0);
  EXPECT_FALSE(result.passing || result.rolling_friction || result.films);
}

TEST(RollersUnderLoad, HaveTheStatedProfile) {
  RollersUnderLoad in = rollers();
  in.loaded.profile = {.kind = bearing::profile::Kind::circular, .drop = 20e-6};
  EXPECT_EQ(kind(rollers_under_load(in).bearing.rollers().profile), "circular");
  const auto softness = [&] {
    const RollerSupport support{
        .load = in.loaded.load, .bearing = in.loaded.bearing, .profile = in.loaded.profile};
    return 1.0 / (*stiffness_of_rollers(support).points.front().stiffness)(0, 0);
  };
  const double crowned = softness();
  in.loaded.profile = {};
  EXPECT_GT(crowned, 1.01 * softness());
}

// L10 of ISO 281 for p = 10/3.
TEST(RollersUnderLoad, HaveTheBasicLifeOfTheStatedCapacity) {
  RollersUnderLoad in = rollers();
  in.loaded.capacities.dynamic_capacity = 50000.0;
  EXPECT_NEAR(rollers_under_load(in).lives.basic / (1e6 * std::pow(10.0, 10.0 / 3.0)), 1.0, round_off);
}

TEST(RollersUnderLoad, GovernByTheOilThatIsStated) {
  using bearing::rating::Life;
  RollersUnderLoad in = rollers();
  in.loaded.life.method = bearing::rating::LifeMethod::iso16281;
  in.loaded.rotation.shaft_speed = 100.0;
  EXPECT_FALSE(stated_oil(in.loaded));
  EXPECT_EQ(rollers_under_load(in).governing, Life::reference);
  fill_with_oil(70.0, in.loaded);
  EXPECT_EQ(stated_oil(in.loaded)->kinematic_viscosity, *in.loaded.oil.kinematic_viscosity);
  EXPECT_EQ(rollers_under_load(in).governing, Life::modified_reference);
}

// The oil leaves with all heat: T = T_in + W/(c flow).
TEST(RollersUnderLoad, HeatTheirOil) {
  constexpr double kelvin = 0.01;  // of the search
  RollersUnderLoad in = rollers();
  in.loaded.rotation.shaft_speed = 300.0;
  fill_with_oil(70.0, in.loaded);
  in.oil = {.flow = 1e-5, .heated = true, .model = system::HeatModel::oil, .inlet = 50.0};
  const BearingUnderLoad result = rollers_under_load(in);
  ASSERT_TRUE(result.rolling_friction && result.rolling_friction->oil_temperature);
  const double outlet =
      system::outlet_temperature({.inlet = 50.0}, in.oil.flow, result.rolling_friction->loss.total());
  EXPECT_GT(outlet, 50.0);
  EXPECT_NEAR(*result.rolling_friction->oil_temperature, outlet, kelvin);
  EXPECT_THAT(result.warnings, Contains(HasSubstr("the friction heats the oil to")));
}

// 20 kN times the tangent of 40 degrees, for the bearing of cases/jones_218.
TEST(BallsUnderLoad, RequireAThrust) {
  BallsUnderLoad in = balls(40.0 * constants::degree);
  bearing::Bearing& bearing = in.loaded.bearing;
  bearing.balls().count = 16;
  bearing.balls().diameter = 22.23e-3;
  bearing.pitch_diameter = 125.26e-3;
  bearing.inner.osculation = bearing.outer.osculation = 0.5232;
  in.loaded.load.radial = 20e3;
  in.loaded.load.axial = 100.0;
  in.loaded.rotation.shaft_speed = 1000.0;
  try {
    balls_under_load(in);
    ADD_FAILURE() << "an equilibrium";
  } catch (const NoResult& error) {
    EXPECT_THAT(error.what(), HasSubstr("The axial load of 100 N is too small"));
    EXPECT_THAT(error.what(), HasSubstr("a radial load of 2e+04 N requires at least 1.678e+04 N"));
  }
}

TEST(StiffnessOfBalls, IsThatOfTheirRun) {
  BallsUnderLoad in = balls(0.0);
  in.loaded.rotation.shaft_speed = 500.0;
  BallSupport support{.load = in.loaded.load, .rotation = in.loaded.rotation, .bearing = in.loaded.bearing};
  const StiffnessStudy study = stiffness_of_balls(support);
  ASSERT_EQ(study.points.size(), 1u);
  ASSERT_TRUE(study.points.front().stiffness);
  EXPECT_EQ(*study.points.front().stiffness,
            bearing::equilibrium::stiffness_by_axes(balls_under_load(in).state));
}

TEST(StiffnessOfBalls, HasASeriesForEachLoad) {
  const BallsUnderLoad in = balls(0.0);
  const StiffnessStudy study = stiffness_of_balls({.load = in.loaded.load,
                                                   .bearing = in.loaded.bearing,
                                                   .speeds = {0.0, 100.0},
                                                   .load_factors = {1.0, 2.0}});
  EXPECT_EQ(study.series, 2u);
  EXPECT_THAT(described::each(study.points, &StiffnessPoint::speed), ElementsAre(0.0, 100.0, 0.0, 100.0));
  EXPECT_THAT(described::each(study.points, &StiffnessPoint::series), ElementsAre(0, 0, 1, 1));
  EXPECT_EQ(study.points[2].load.front().second, 2000.0);
}

TEST(BearingQuantities, HoldTheLifeByTheLoad) {
  BallsUnderLoad in = balls(0.0);
  in.loaded.capacities.dynamic_capacity = 10000.0;
  in.loaded.rotation.shaft_speed = 100.0;
  const BearingQuantities found = quantities_of(BallBearing{.run = in});
  ASSERT_TRUE(found.lives);
  EXPECT_NEAR(found.lives->basic / 1e9, 1.0, round_off);  // (C/P)^3
  EXPECT_TRUE(found.groove_distance);
  in.loaded.load.radial = 0.0;
  EXPECT_FALSE(quantities_of(BallBearing{.run = in}).lives);
}

}  // namespace
}  // namespace orbearing::analysis::single_bearing_test
