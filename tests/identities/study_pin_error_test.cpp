// Planets on pins with position errors: their load sharing, and that every fidelity gives the same.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numeric>

#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/equilibrium/race_equilibrium.hpp"
#include "coupling/analysis/load_sharing.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "mechanics/constants.hpp"
#include "tests/coupled_reducer.hpp"
#include "tests/messages.hpp"

namespace orbearing::analysis::study_pin_error_test {
namespace {

constexpr double kBalance = 1e-6;  // of a load: the search ends at 1e-9 of the largest, gears take part of it
constexpr double kRoundOff = 1e-9;

// The first pin ahead of its position by `error` [m]; no case here separates the teeth unless stated.
PlanetaryDrivetrain displaced(int planets, double error, bool floating_sun) {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.set.planets = planets;
  drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  gearset::dynamics::SetParameters gears = example::reducer_gears(drivetrain);
  if (floating_sun) gears.sun.support = {};
  gears.frame.centrifugal = false;  // of displaced bodies it would add what no closed form here has
  gears.pin_error = Eigen::Matrix2Xd::Zero(2, planets);
  gears.pin_error(1, 0) = error;
  drivetrain.gear_set = [gears] { return gears; };
  drivetrain.uneven_planets = true;
  return drivetrain;
}

std::vector<double> shares_of(const PlanetaryDrivetrain& drivetrain) {
  return planet_balance(drivetrain, derive(drivetrain)).shares;
}

double sum(const std::vector<double>& shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0);
}

TEST(LoadSharing, IsEvenWherePinsStandInTheirPositions) {
  for (const double share : shares_of(displaced(4, 0.0, false))) EXPECT_NEAR(share, 1.0, kBalance);
}

// Three planets about a sun that floats are statically determinate: no error of a pin changes their loads.
TEST(LoadSharing, OfThreePlanetsAboutAFloatingSunIsEven) {
  for (const double share : shares_of(displaced(3, 5e-6, true))) EXPECT_NEAR(share, 1.0, kBalance);
}

// Four about a floating sun: its equilibrium gives equal loads in pairs of opposite planets, and the torque
// the sum.
TEST(LoadSharing, OfFourPlanetsAboutAFloatingSunGoesByPairs) {
  const std::vector<double> shares = shares_of(displaced(4, 5e-6, true));
  EXPECT_NEAR(shares[0], shares[2], kBalance);
  EXPECT_NEAR(shares[1], shares[3], kBalance);
  EXPECT_NEAR(sum(shares), 4.0, kBalance);
  // The pin that is ahead is where the teeth push its planet to: they press it less.
  EXPECT_LT(shares[0], shares[1] - 0.1);
}

// Searches of the last round start near their equilibria and still end there. Bearings solved anew without a
// start deflect under each planet's force as far as the equilibrium reports.
TEST(LoadSharing, EndsWhereBearingsBalancedFromNothingStand) {
  for (const int laminae : {0, 20}) {
    PlanetaryDrivetrain drivetrain = displaced(4, 5e-6, false);
    drivetrain.bearing.rollers().laminae = laminae;
    const DrivetrainGeometry geometry = derive(drivetrain);
    const BearingDuty even = bearing_duty(drivetrain, geometry);
    const bearing::QuasiStaticOptions options = quasi_static_options(drivetrain);
    const PlanetBalance balance = planet_balance(drivetrain, geometry);
    for (Eigen::Index i = 0; i < balance.forces.cols(); ++i) {
      const Eigen::Vector2d force = balance.forces.col(i);
      const bearing::OperatingPoint point = point_under(drivetrain, even, force);
      Eigen::Vector2d moved = point.bore_load / drivetrain.dynamics.support.stiffness;
      for (int k = 0; k < options.cage_positions; ++k) {
        const double first =
            k * constants::two_pi / (options.cage_positions * drivetrain.bearing.rollers().count);
        moved +=
            quasi_static_state(bearing::laminae::LaminaBearing(drivetrain.bearing), point, options, first)
                .displacement /
            options.cage_positions;
      }
      const Eigen::Vector2d expected = moved + force / balance.stiffness;
      EXPECT_LT((balance.offset.col(i) - expected).norm(), 1e-8 * force.norm() / balance.stiffness)
          << laminae << " laminae, planet " << i;
    }
  }
}

// A search that starts near ends where one without a start does, and sooner.
TEST(LoadSharing, SearchesThatStartNearEndAlike) {
  const PlanetaryDrivetrain drivetrain = displaced(4, 0.0, false);
  const DrivetrainGeometry geometry = derive(drivetrain);
  bearing::OperatingPoint point = bearing_duty(drivetrain, geometry).point;
  const bearing::QuasiStaticOptions options = quasi_static_options(drivetrain);
  const auto problem = [&] {
    return quasi_static_problem(drivetrain.bearing, geometry.bearing, point, options, 0.1);
  };
  bearing::QuasiStaticState near = solve(problem());
  const Eigen::Vector2d more = 1e-3 * point.bore_load.norm() * Eigen::Vector2d(0.6, 0.8);
  point.bore_load += more;
  const bearing::QuasiStaticState anew = solve(problem());
  const Eigen::Vector2d along = near.stiffness.inverse() * more;
  EXPECT_LT((anew.displacement - near.displacement - along).norm(), 1e-2 * along.norm());
  near.displacement += along;
  const bearing::QuasiStaticState again = solve(problem(), &near);
  EXPECT_LT((again.displacement - anew.displacement).norm(), kRoundOff * anew.displacement.norm());
  EXPECT_LT(again.report.iterations, anew.report.iterations);
}

// The planet that carries most after one error carries least after the opposite one; small errors act
// equally.
TEST(LoadSharing, GoesWithTheError) {
  const double ahead = shares_of(displaced(4, 1e-6, false))[0] - 1.0;
  const double behind = shares_of(displaced(4, -1e-6, false))[0] - 1.0;
  EXPECT_LT(ahead * behind, 0.0);
  constexpr double kCurvature =
      0.05;  // of the change: the bearings' stiffness is proportional to the ninth root of load
  EXPECT_NEAR(-behind / ahead, 1.0, kCurvature);
}

// Errors that part the teeth of a planet leave nothing to it, however large they are, and all to the others.
TEST(LoadSharing, OfALargeErrorPartsTheTeeth) {
  const std::vector<double> shares = shares_of(displaced(4, 60e-6, false));
  EXPECT_EQ(shares[0], 0.0);
  EXPECT_NEAR(sum(shares), 4.0, kBalance);
  const std::vector<double> further = shares_of(displaced(4, 90e-6, false));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(shares[i], further[i], kBalance);
  const std::vector<double> behind = shares_of(displaced(4, -60e-6, false));
  EXPECT_NEAR(std::min(behind[1], behind[3]), 0.0, kBalance);
  EXPECT_NEAR(sum(behind), 4.0, kBalance);
}

TEST(PinErrors, EveryPlanetLivesUnderItsOwnLoad) {
  const PlanetaryDrivetrain drivetrain = displaced(4, 10e-6, false);
  const PointResult point = evaluate(drivetrain, derive(drivetrain));
  ASSERT_EQ(point.planets.size(), 4U);
  const std::vector<double> shares = shares_of(drivetrain);
  double damage = 0.0, mean = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(point.planets[i].load_share, shares[i], kBalance);
    damage += 2.0 * std::pow(point.planets[i].life_hours, -9.0 / 8.0);
    mean += 0.25 * point.planets[i].load;
  }
  EXPECT_NEAR(point.system_life_hours, std::pow(damage, -8.0 / 9.0), kRoundOff * point.system_life_hours);
  // Pooled, the mean of fourth powers: between the shortest and the longest.
  const auto [shortest, longest] = std::minmax_element(
      point.planets.begin(), point.planets.end(),
      [](const PlanetResult& a, const PlanetResult& b) { return a.life_hours < b.life_hours; });
  EXPECT_GT(point.life_hours, shortest->life_hours);
  EXPECT_LT(point.life_hours, longest->life_hours);
  EXPECT_NEAR(mean, point.planet_load, kBalance * mean);
  PlanetaryDrivetrain even = drivetrain;
  even.uneven_planets = false;
  EXPECT_TRUE(evaluate(even, derive(even)).planets.empty());
}

// Each life of all bearings of unequal planets is computed from the same lives of the bearings.
TEST(PinErrors, HaveASystemsLivesOfTheSameLives) {
  PlanetaryDrivetrain drivetrain = displaced(4, 10e-6, false);
  drivetrain.rated.oil = bearing::rating::StatedOil{.viscosity_ratio = 0.7, .contamination_factor = 0.5};
  const PointResult point = evaluate(drivetrain, derive(drivetrain));
  for (const auto life : bearing::rating::kRatedHours) {
    double damage = 0.0;
    for (const PlanetResult& planet : point.planets)
      damage += 2.0 * std::pow(planet.rated_hours.*life, -9.0 / 8.0);
    EXPECT_NEAR(point.rating.system_hours.*life * std::pow(damage, 8.0 / 9.0), 1.0, kRoundOff);
  }
  EXPECT_GT(std::abs(point.rating.system_hours.modified / point.rating.system_hours.basic - 1.0), 0.01);
}

// The sun's thrust follows from its torque, however its planets share it; axial force and overturning moment
// of one planet are means over the planets.
TEST(PinErrors, LeaveTheThrustOfTheSunAsItIs) {
  PlanetaryDrivetrain drivetrain = displaced(4, 10e-6, false);
  drivetrain.set.helix_angle = 0.2;
  gearset::dynamics::SetParameters gears = example::reducer_gears(drivetrain);
  gears.frame.centrifugal = false;
  gears.pin_error = drivetrain.gear_set().pin_error;
  drivetrain.gear_set = [gears] { return gears; };
  const DrivetrainGeometry geometry = derive(drivetrain);
  const PointResult point = evaluate(drivetrain, geometry);
  ASSERT_EQ(point.planets.size(), 4U);
  const double torque = drivetrain.drive.power / drivetrain.drive.speed;
  const double thrust = torque / geometry.gears.sun.pitch_radius * std::tan(0.2);
  EXPECT_NEAR(std::abs(point.sun_thrust) / thrust, 1.0, kBalance);
  EXPECT_NEAR(4.0 * point.axial_mesh_force / -point.sun_thrust, 1.0, kBalance);
  const gearset::MeanLoads even = bearing_duty(drivetrain, geometry).gears;
  EXPECT_NEAR(point.overturning_moment / even.overturning_moment, 1.0, kBalance);
}

// Gears at mean mesh stiffness, so that motion adds little to the quasi-static loads: loads of every planet
// as quasi-static, one way and as one system.
TEST(PinErrors, LoadPlanetsAlikeInEveryFidelity) {
  constexpr double kMotion = 0.03;  // of a load: what rollers in motion do to the stiffness of the bearings
  PlanetaryDrivetrain drivetrain = displaced(4, 10e-6, false);
  gearset::dynamics::SetParameters gears = drivetrain.gear_set();
  gears.frame.centrifugal = true;  // centrifugal loads of planets, as in the quasi-static model
  drivetrain.gear_set = [gears] { return gears; };
  drivetrain.mesh_variation = false;
  drivetrain.drive.speed = 9000.0 * example::rpm;
  drivetrain.steady_state.observed_windows = 1;
  drivetrain.steady_state.most_windows = 2;
  const DrivetrainGeometry geometry = derive(drivetrain);
  const PointResult still = evaluate(drivetrain, geometry);
  for (const Fidelity fidelity : {Fidelity::dynamic, Fidelity::monolithic}) {
    const PointResult moving = evaluate(drivetrain, geometry, fidelity);
    ASSERT_EQ(moving.planets.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(moving.planets[i].load_share, still.planets[i].load_share, kMotion) << i;
      EXPECT_NEAR(moving.planets[i].load, still.planets[i].load, kMotion * still.planets[i].load) << i;
    }
    EXPECT_NEAR(moving.life_hours / still.life_hours, 1.0, 4.0 * kMotion);
    EXPECT_NEAR(moving.system_life_hours / still.system_life_hours, 1.0, 4.0 * kMotion);
  }
}

// Shares are means over time, in which every roller passes every place.
TEST(LoadSharing, KnowsLikeRollersAndStandingForms) {
  PlanetaryDrivetrain drivetrain = displaced(4, 10e-6, false);
  const std::vector<double> like = shares_of(drivetrain);
  drivetrain.bearing.rollers().diameter_deviation = {1e-6};
  drivetrain.bearing.outer.form = {{.order = 2, .amplitude = 1e-6, .rotating = true}};
  EXPECT_EQ(shares_of(drivetrain), like);
  drivetrain.bearing.outer.form = {{.order = 2, .amplitude = 1e-6, .rotating = false}};
  EXPECT_NE(shares_of(drivetrain), like);
}

TEST(PinErrors, AskForNoStateToStartFrom) {
  const PlanetaryDrivetrain drivetrain = displaced(4, 10e-6, false);
  EXPECT_REFUSED(std::invalid_argument, "study_pin_error 1",
                 evaluate_from(drivetrain, derive(drivetrain), Eigen::VectorXd::Zero(86)));
}

}  // namespace
}  // namespace orbearing::analysis::study_pin_error_test
