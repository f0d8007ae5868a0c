// Symmetries, limits and reciprocity of the planet bearing on laminae.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/quasi_static.hpp"

namespace orbearing::bearing::laminae::lamina_bearing_test {
namespace {

constexpr double kRoundOff = 1e-10;        // of the largest load: the search ends at 1e-12
constexpr double kDifferenceError = 1e-5;  // relative; a step small enough to keep all laminae on their side
constexpr double kCrown = 6e-6;            // [m]

Bearing planet_bearing(int laminae, double crown) {
  Bearing bearing{
      .inner = {.seat_diameter = 25e-3},
      .outer = {.seat_diameter = 47e-3},
      .elements = CylindricalRollers{.count = 15, .diameter = 5.24e-3, .length = 5.7e-3, .laminae = laminae},
      .pitch_diameter = 35.64e-3,
      .width = 11.9e-3};
  bearing.cage = {.inner_diameter = 33.44e-3, .outer_diameter = 38.54e-3, .width = 9e-3, .density = 1310.0};
  bearing.rollers().profile = profile::CircularCrown{bearing.rollers().length, crown};
  return bearing;
}

// Near the reducer's point at 6000 rpm of the sun.
OperatingPoint planet_point(const Eigen::Vector2d& tilt) {
  OperatingPoint point;
  point.carrier = {.speed = 200.0, .orbit_radius = 87.9e-3};
  point.outer_speed = -720.0;
  point.bore_load = {900.0, 1600.0};
  point.bore_tilt = tilt;
  return point;
}

QuasiStaticState solved(const Bearing& bearing, const OperatingPoint& point, double first = 0.1) {
  QuasiStaticState state = quasi_static_state(LaminaBearing(bearing), point, {}, first);
  EXPECT_TRUE(state.report.converged) << state.report.message;
  return state;
}

TEST(LaminaBearing, StraightWithoutTiltIsTheUncutBearingAtAllCageAngles) {
  const OperatingPoint point = planet_point(Eigen::Vector2d::Zero());
  const QuasiStaticResult uncut = quasi_static_bearing(planet_bearing(0, 0.0), point, {});
  for (const int n : {1, 40, 200}) {
    Bearing bearing = planet_bearing(n, 0.0);
    bearing.rollers().profile = profile::Straight{};
    const QuasiStaticResult cut = quasi_static_bearing(LaminaBearing(bearing), point, {});
    const double scale = uncut.outer_load.maxCoeff();
    EXPECT_LE((cut.inner_load - uncut.inner_load).abs().maxCoeff(), kRoundOff * scale);
    EXPECT_LE((cut.outer_load - uncut.outer_load).abs().maxCoeff(), kRoundOff * scale);
    EXPECT_LE((cut.displacement - uncut.displacement).norm(), kRoundOff * uncut.displacement.norm());
    EXPECT_LE((cut.inner_lamina_load.colwise().sum().transpose() - cut.inner_load).abs().maxCoeff(),
              kRoundOff * scale);
  }
}

TEST(LaminaBearing, TiltTheOtherWayIsTheMirrorImage) {
  const Eigen::Vector2d tilt(0.4e-3, -1.1e-3);
  const Bearing bearing = planet_bearing(40, kCrown);
  const QuasiStaticResult one = quasi_static_bearing(LaminaBearing(bearing), planet_point(tilt), {});
  const QuasiStaticResult other = quasi_static_bearing(LaminaBearing(bearing), planet_point(-tilt), {});
  const double scale = one.outer_load.maxCoeff();
  EXPECT_LE((one.outer_load - other.outer_load).abs().maxCoeff(), kRoundOff * scale);
  EXPECT_LE((one.outer_lamina_load - other.outer_lamina_load.colwise().reverse()).abs().maxCoeff(),
            kRoundOff * scale);
  EXPECT_LE((one.moment + other.moment).norm(), kRoundOff * one.moment.norm());
  EXPECT_GT((one.outer_lamina_load - other.outer_lamina_load).abs().maxCoeff(), 0.01 * scale / 40.0);
}

TEST(LaminaBearing, MomentIsAgainstTheTilt) {
  for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
    const Eigen::Vector2d tilt = 1e-3 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    EXPECT_LT(solved(planet_bearing(40, kCrown), planet_point(tilt)).moment.dot(tilt), 0.0);
  }
  const OperatingPoint level = planet_point(Eigen::Vector2d::Zero());
  EXPECT_LE(solved(planet_bearing(40, kCrown), level).moment.norm(), 1e-9);
}

// With E(u, t) the energy of all rollers, least over them, and P = E - F u least over u: dP/dF = -u, dP/dt =
// -M, M the moment of the rollers on the bore. So du/dt = dM/dF: holds only if forces and moments have an
// energy.
TEST(LaminaBearing, DisplacementByTiltIsMomentByLoad) {
  const Bearing bearing = planet_bearing(40, kCrown);
  const Eigen::Vector2d tilt(0.3e-3, 0.5e-3);
  const double tilt_step = 1e-8, load_step = 1e-2;
  Eigen::Matrix2d by_tilt, by_load;
  for (int i = 0; i < 2; ++i) {
    OperatingPoint up = planet_point(tilt), down = planet_point(tilt);
    up.bore_tilt[i] += tilt_step, down.bore_tilt[i] -= tilt_step;
    by_tilt.col(i) =
        (solved(bearing, up).displacement - solved(bearing, down).displacement) / (2 * tilt_step);
    up = down = planet_point(tilt);
    up.bore_load[i] += load_step, down.bore_load[i] -= load_step;
    by_load.col(i) = (solved(bearing, up).moment - solved(bearing, down).moment) / (2 * load_step);
  }
  EXPECT_GT(by_tilt.norm(), 1e-5);
  EXPECT_LE((by_tilt - by_load.transpose()).norm(), kDifferenceError * by_tilt.norm());
}

TEST(LaminaBearing, RollersTiltBetweenTheRacesAndOutwardWithTheBore) {
  const QuasiStaticResult result =
      quasi_static_bearing(LaminaBearing(planet_bearing(40, kCrown)), planet_point({1e-3, 0.0}), {});
  for (Eigen::Index j = 0; j < result.angle.size(); ++j) {
    // A roller that rests on one race alone lies along that.
    if (std::min(result.inner_load[j], result.outer_load[j]) < 1.0) continue;
    const double bore = 1e-3 * std::cos(result.angle[j]), share = result.roller_tilt[j] / bore;
    if (std::abs(bore) < 1e-4) continue;
    EXPECT_GT(share, 0.0) << "at " << result.angle[j];
    EXPECT_LT(share, 1.0) << "at " << result.angle[j];
  }
}

// The lamina sums are the midpoint rule for the integral along the roller: second order in the width of a
// lamina, less where the end of the contact lies inside the roller.
TEST(LaminaBearing, MoreLaminaeConverge) {
  const OperatingPoint point = planet_point({0.2e-3, 0.3e-3});
  const auto displacement = [&](int n) { return solved(planet_bearing(n, 3e-6), point).displacement; };
  const Eigen::Vector2d limit = displacement(960);
  const double coarse = (displacement(15) - limit).norm(), fine = (displacement(60) - limit).norm();
  EXPECT_LT(fine, coarse / 8.0);
  EXPECT_LT(fine, 1e-3 * limit.norm());
}

TEST(LaminaBearing, MoreCrownIsSofter) {
  const OperatingPoint point = planet_point(Eigen::Vector2d::Zero());
  double before = 0.0;
  for (const double crown : {0.0, 2e-6, 5e-6, 10e-6, 20e-6}) {
    const double now = solved(planet_bearing(40, crown), point).displacement.norm();
    EXPECT_GT(now, before);
    before = now;
  }
}

TEST(LaminaBearing, RefusesAnUnsoundProfileAndAPointThatIsNotFinite) {
  EXPECT_THROW(LaminaBearing(planet_bearing(40, -1e-6)), std::invalid_argument);
  OperatingPoint point = planet_point({std::nan(""), 0.0});
  EXPECT_THROW(quasi_static_state(LaminaBearing(planet_bearing(40, 0.0)), point, {}, 0.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace orbearing::bearing::laminae::lamina_bearing_test
