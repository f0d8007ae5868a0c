// Speed of the longest life at constant power: scaling law, closed forms and published points.
//
//   tangential load A/n, radial mesh load C/n inward, centrifugal load B n^2 outward
//
#include <gtest/gtest.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "coupling/analysis/operating_point.hpp"
#include "tests/reducer.hpp"

namespace orbearing::analysis::study_peak_test {
namespace {

using example::reducer;
using example::rpm;

// The loads balance to 1e-12 of themselves, so a smooth maximum is located to the square root of that.
constexpr double kPeakResolution = 1e-6;
// The bar of the closed forms, which hold for one resultant load: the rollers' own inertial loads are not in
// them.
constexpr double kClosedForm = 0.005;

// Place [rad/s] of the extremum of a function of speed, by Brent's method on the logarithms of both.
double extremum_of(const std::function<double(double)>& of_speed, double sign) {
  constexpr int bits = std::numeric_limits<double>::digits / 2;
  const auto objective = [&](double log_speed) { return sign * std::log(of_speed(std::exp(log_speed))); };
  return std::exp(
      boost::math::tools::brent_find_minima(objective, std::log(3000.0 * rpm), std::log(11000.0 * rpm), bits)
          .first);
}

double speed_of_longest_life(const PlanetaryDrivetrain& drivetrain) {
  const DrivetrainGeometry geometry = derive(drivetrain);
  const auto life = [&](double speed) {
    PlanetaryDrivetrain at_speed = drivetrain;
    at_speed.drive.speed = speed;
    return evaluate(at_speed, geometry).life_hours;
  };
  return extremum_of(life, -1.0);
}

struct Parts {
  double a;  // [N]  tangential at n = 1
  double b;  // [N]  centrifugal at n = 1
  double c;  // [N]  radial mesh, inward, at n = 1
};

// Loads at the drivetrain's own speed, which is n = 1.
Parts parts_of(const PlanetaryDrivetrain& drivetrain) {
  const PointResult point = evaluate(drivetrain, derive(drivetrain));
  return {std::abs(point.tangential_load), point.centrifugal_load, -point.radial_mesh_load};
}

double closed_form_life_peak(const Parts& p) {
  return std::cbrt((p.c + std::sqrt(3.0 * p.a * p.a + 4.0 * p.c * p.c)) / (3.0 * p.b));
}

double closed_form_least_load(const Parts& p) {
  return std::cbrt((p.c + std::sqrt(p.c * p.c + 8.0 * (p.a * p.a + p.c * p.c))) / (4.0 * p.b));
}

// Rollers whose inertial load acts through the cage alone: the resultant on the bore is then the only load.
PlanetaryDrivetrain without_rollers_inertia() {
  PlanetaryDrivetrain drivetrain = reducer();
  drivetrain.bearing.material.density = 1e-6;
  return drivetrain;
}

// Equal working pressure angles of both meshes leave no radial mesh load: sun and ring without shift.
PlanetaryDrivetrain without_radial_mesh_load() {
  PlanetaryDrivetrain drivetrain = without_rollers_inertia();
  drivetrain.set.sun_teeth = 36;
  drivetrain.set.planet_teeth = 22;
  drivetrain.set.ring_teeth = 80;
  drivetrain.set.sun_shift = drivetrain.set.ring_shift = 0.0;
  return drivetrain;
}

TEST(StudyPeak, FollowsTheCubeRootOfPowerAtZeroClearance) {
  PlanetaryDrivetrain drivetrain = reducer();
  const double at_150 = speed_of_longest_life(drivetrain);
  drivetrain.drive.power = 75e3;
  EXPECT_NEAR(speed_of_longest_life(drivetrain) / at_150, std::cbrt(0.5), kPeakResolution);
  drivetrain.drive.power = 300e3;
  EXPECT_NEAR(speed_of_longest_life(drivetrain) / at_150, std::cbrt(2.0), kPeakResolution);
}

TEST(StudyPeak, DoesNotFollowTheCubeRootWithClearance) {
  PlanetaryDrivetrain drivetrain = reducer();
  drivetrain.bearing.radial_clearance = 37e-6;
  const double at_150 = speed_of_longest_life(drivetrain);
  drivetrain.drive.power = 300e3;
  EXPECT_GT(std::abs(speed_of_longest_life(drivetrain) / at_150 - std::cbrt(2.0)), 1e-3);
}

TEST(StudyPeak, MeetsTheClosedFormWithRadialMeshLoad) {
  const PlanetaryDrivetrain drivetrain = without_rollers_inertia();
  const Parts parts = parts_of(drivetrain);
  ASSERT_GT(parts.c, 0.0);
  EXPECT_NEAR(speed_of_longest_life(drivetrain) / drivetrain.drive.speed / closed_form_life_peak(parts), 1.0,
              kClosedForm);
}

TEST(StudyPeak, MeetsTheClosedFormWithoutRadialMeshLoad) {
  const PlanetaryDrivetrain drivetrain = without_radial_mesh_load();
  const Parts parts = parts_of(drivetrain);
  ASSERT_NEAR(parts.c, 0.0, 1e-9 * parts.a);
  const double expected = std::pow(parts.a * parts.a / (3.0 * parts.b * parts.b), 1.0 / 6.0);
  EXPECT_NEAR(speed_of_longest_life(drivetrain) / drivetrain.drive.speed / expected, 1.0, kClosedForm);
}

TEST(StudyPeak, LeastLoadStandsWhereTheClosedFormPutsIt) {
  const PlanetaryDrivetrain drivetrain = reducer();
  const DrivetrainGeometry geometry = derive(drivetrain);
  const auto load = [&](double speed) {
    PlanetaryDrivetrain at_speed = drivetrain;
    at_speed.drive.speed = speed;
    return evaluate(at_speed, geometry).planet_load;
  };
  const double expected = drivetrain.drive.speed * closed_form_least_load(parts_of(drivetrain));
  EXPECT_NEAR(extremum_of(load, 1.0) / expected, 1.0, kPeakResolution);
}

TEST(StudyPeak, LoadsScaleWithPowerToTwoThirdsAlongThePeak) {
  PlanetaryDrivetrain drivetrain = reducer();
  const double load = evaluate(drivetrain, derive(drivetrain)).inner.load_max;
  drivetrain.drive.power *= 8.0;
  drivetrain.drive.speed *= 2.0;
  EXPECT_NEAR(evaluate(drivetrain, derive(drivetrain)).inner.load_max / load, 4.0, 1e-9);
}

}  // namespace
}  // namespace orbearing::analysis::study_peak_test
