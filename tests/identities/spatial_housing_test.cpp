// A housing that deflects under the bearings of the carrier: forces of its energy, series of springs, limits,
// and matrices that are no stiffness.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "gearset/spatial/housing_stiffness.hpp"
#include "gearset/spatial/spatial_balance.hpp"
#include "gearset/spatial/spatial_modes.hpp"

namespace orbearing::gearset::spatial::spatial_housing_test {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr int kSlices = 40;
constexpr double kSeries = 1e-10;  // of the largest: both are found to 1e-12 of the largest force

SpatialSet stage(double clearance) {
  SpatialSet set{.centre_distance = 0.308, .face_width = 0.22, .planet_base_radius = 0.184};
  for (int n = 0; n < 3; ++n) set.angles.push_back(2.0 * pi * n / 3.0);
  set.sun = {1.6e10, 0.40, 0.12};
  set.ring = {2.0e10, 0.33, 0.12};
  set.planet_bearings = {{-0.06, 3e9, 0.0}, {0.06, 3e9, 0.0}};
  set.planet_axial_stiffness = set.sun_axial_stiffness = 1e9;
  set.carrier_bearings = {{-0.25, 3e9, 3e9, clearance}, {0.25, 2e9, 0.0, clearance}};
  set.planet_mass = 105.0;
  set.sun_mass = 180.0;
  set.carrier_mass = 900.0;
  return set;
}

SpatialLoad loaded() {
  return {.torque = 325e3,
          .speed = 2.3,
          .gravity = 9.81,
          .axis_tilt = 0.1,
          .rotor = {{1e4, -3e4, 2e4}, {5e4, 2e4, 0.0}}};
}

// Matrix of two seats, coupled, different across and upward.
MatrixXd housing() {
  std::mt19937 random(48);
  std::normal_distribution<double> any;
  MatrixXd root(6, 6);
  for (double& x : root.reshaped()) x = any(random);
  MatrixXd stiffness = 2e8 * root * root.transpose() + 1e9 * MatrixXd::Identity(6, 6);
  return 0.5 * (stiffness + stiffness.transpose());
}

MatrixXd diagonal(double stiffness) {
  return stiffness * MatrixXd::Identity(6, 6);
}

// Coordinates of carrier, sun and planets come first: those of the seats are behind them.
constexpr int kBodies = 30;

TEST(SpatialHousing, ForcesHaveAnEnergyAndTheStiffnessIsTheirSlope) {
  SpatialSet set = stage(2e-4);
  set.housing_stiffness = housing();
  std::mt19937 random(3);
  std::normal_distribution<double> anywhere(0.0, 1e-4);
  constexpr double step = 1e-8, tolerance = 1e-6;
  for (int trial = 0; trial < 5; ++trial) {
    VectorXd position(kBodies + 12);
    for (double& x : position) x = anywhere(random);
    const auto here = imbalance(set, loaded(), 0.7, kSlices, position);
    for (int i = 0; i < position.size(); ++i) {
      SCOPED_TRACE(i);
      VectorXd ahead = position, behind = position;
      ahead[i] += step;
      behind[i] -= step;
      const VectorXd column = (imbalance(set, loaded(), 0.7, kSlices, ahead).force -
                               imbalance(set, loaded(), 0.7, kSlices, behind).force) /
                              (-2 * step);
      EXPECT_LT((here.stiffness.col(i) - column).norm(), tolerance * here.stiffness.norm());
    }
    EXPECT_LT((here.stiffness - here.stiffness.transpose()).norm(), 1e-14 * here.stiffness.norm());
  }
}

void expect_alike(const SpatialBalance& one, const SpatialBalance& other, double tolerance) {
  const double most = other.bearing_load.maxCoeff();
  EXPECT_LT((one.bearing_load - other.bearing_load).cwiseAbs().maxCoeff(), tolerance * most);
  EXPECT_LT((one.sun_mesh.force - other.sun_mesh.force).abs().maxCoeff(), tolerance * most);
  EXPECT_LT((one.carrier_bearing - other.carrier_bearing).cwiseAbs().maxCoeff(), tolerance * most);
  EXPECT_LT((one.carrier_shift - other.carrier_shift).norm(), tolerance * other.carrier_shift.norm());
}

// A seat that is equally stiff in all directions is a spring in series with its bearing: k k_h/(k + k_h),
// behind the same clearance.
TEST(SpatialHousing, DiagonalMatrixIsASeriesOfSprings) {
  for (const double clearance : {0.0, 1.5e-4}) {
    constexpr double seat = 4e9;
    SpatialSet elastic = stage(clearance), series = stage(clearance);
    elastic.housing_stiffness = diagonal(seat);
    for (CarrierBearing& bearing : series.carrier_bearings) {
      bearing.radial_stiffness *= seat / (bearing.radial_stiffness + seat);
      bearing.axial_stiffness *= seat / (bearing.axial_stiffness + seat);
    }
    for (const double angle : {0.0, 0.4, 2.9})
      expect_alike(balance(elastic, loaded(), angle, kSlices), balance(series, loaded(), angle, kSlices),
                   kSeries);
    EXPECT_LT((closed_stiffness(elastic, kSlices, true) - closed_stiffness(series, kSlices, true)).norm(),
              kSeries * closed_stiffness(series, kSlices, true).norm());
  }
}

TEST(SpatialHousing, StiffHousingIsTheRigidOne) {
  SpatialSet stiff = stage(1e-4);
  stiff.housing_stiffness = diagonal(1e16);
  const SpatialBalance rigid = balance(stage(1e-4), loaded(), 0.4, kSlices);
  expect_alike(balance(stiff, loaded(), 0.4, kSlices), rigid, 1e-6);  // 3e9/1e16
  // A soft one moves loads.
  stiff.housing_stiffness = housing();
  EXPECT_GT((balance(stiff, loaded(), 0.4, kSlices).bearing_load - rigid.bearing_load).cwiseAbs().maxCoeff(),
            1e-4 * rigid.bearing_load.maxCoeff());
}

// A matrix that is fixed to the housing rotates in the frame of the carrier: half a turn later all seats
// deflect alike in the housing under a load that is fixed to it.
TEST(SpatialHousing, MatrixStandsWithTheHousing) {
  SpatialSet set = stage(0.0);
  set.planet_mass = set.sun_mass = 0.0;
  MatrixXd across = diagonal(3e9);
  across(0, 0) = across(3, 3) = 5e8;  // soft across, stiff upward
  set.housing_stiffness = across;
  SpatialLoad load{.torque = 325e3};
  const auto sag = [&](const Vector3d& force) {
    load.rotor.force = force;
    const SpatialBalance at = balance(set, load, 0.9, kSlices);
    return Vector3d(Eigen::AngleAxisd(0.9, Vector3d::UnitZ()) * at.carrier_shift);
  };
  const Vector3d still = sag(Vector3d::Zero());
  const Vector3d to_side = sag({1e4, 0.0, 0.0}) - still, down = sag({0.0, -1e4, 0.0}) - still;
  EXPECT_GT(to_side.x() / -down.y(), 1.5);
  EXPECT_GT(to_side.x(), 0.0);
  EXPECT_LT(down.y(), 0.0);
  // Reciprocity: what a force across moves upward, a force upward moves across.
  MatrixXd coupled = diagonal(2e9);
  coupled(0, 1) = coupled(1, 0) = 8e8;
  set.housing_stiffness = coupled;
  const Vector3d none = sag(Vector3d::Zero());
  EXPECT_NEAR((sag({1e4, 0.0, 0.0}) - none).y() / (sag({0.0, 1e4, 0.0}) - none).x(), 1.0, 1e-6);
}

// The carrier alone on two springs: a housing of mass 0 lowers its frequency as the series of springs does.
TEST(SpatialHousing, LowersNaturalFrequencies) {
  MovingSet moving{.set = stage(0.0),
                   .carrier = {900.0, 60.0, 40.0},
                   .sun = {180.0, 2.0, 1.5},
                   .planet = {105.0, 2.0, 1.5}};
  moving.sun_support.held_in_rotation = true;
  const double rigid = modes_at_rest(moving).back().frequency;
  moving.set.housing_stiffness = diagonal(1e16);
  EXPECT_NEAR(modes_at_rest(moving).back().frequency / rigid, 1.0, 1e-6);
  std::vector<double> stiff, soft;
  for (const SpatialMode& mode : modes_at_rest(moving)) stiff.push_back(mode.frequency);
  moving.set.housing_stiffness = housing();
  for (const SpatialMode& mode : modes_at_rest(moving)) soft.insert(soft.end(), mode.frequency);
  EXPECT_LT(soft.back(), stiff.back() * (1.0 + 1e-9));
  double lowest_stiff = 0.0, lowest_soft = 0.0;
  for (const double f : stiff)
    if (f > 1.0 && lowest_stiff == 0.0) lowest_stiff = f;
  for (const double f : soft)
    if (f > 1.0 && lowest_soft == 0.0) lowest_soft = f;
  EXPECT_LT(lowest_soft, lowest_stiff);
}

TEST(SpatialHousing, RefusesWhatIsNoStiffness) {
  const std::vector<double> positions{-0.25, 0.25};
  EXPECT_FALSE(housing_fault(housing(), positions));
  MatrixXd wrong = housing();
  wrong(4, 1) *= 1.01;
  ASSERT_TRUE(housing_fault(wrong));
  EXPECT_EQ(housing_fault(wrong)->row, 4);
  EXPECT_EQ(housing_fault(wrong)->column, 1);
  wrong = housing();
  wrong(2, 2) = -1e6;
  ASSERT_TRUE(housing_fault(wrong));
  EXPECT_EQ(housing_fault(wrong)->row, 2);
  wrong = diagonal(1e9);
  wrong(0, 3) = wrong(3, 0) = 1.2e9;
  ASSERT_TRUE(housing_fault(wrong));
  EXPECT_NE(housing_fault(wrong)->found.find("negative eigenvalue, -2e+08 N/m"), std::string::npos);
  EXPECT_TRUE(housing_fault(MatrixXd::Zero(6, 6)));
  // Without a foundation: both seats against each other.
  wrong << diagonal(1e9).topLeftCorner(3, 3), -diagonal(1e9).topLeftCorner(3, 3),
      -diagonal(1e9).topLeftCorner(3, 3), diagonal(1e9).topLeftCorner(3, 3);
  EXPECT_FALSE(housing_fault(wrong));
  ASSERT_TRUE(housing_fault(wrong, positions));
  EXPECT_NE(housing_fault(wrong, positions)->found.find("moves freely"), std::string::npos);
  // The second bearing locates nothing along the axis: its seat need not be held so, that of the first must.
  wrong = diagonal(1e9);
  wrong(5, 5) = 0.0;
  EXPECT_FALSE(housing_fault(wrong, positions));
  wrong(2, 2) = 0.0;
  EXPECT_TRUE(housing_fault(wrong, positions));
}

}  // namespace
}  // namespace orbearing::gearset::spatial::spatial_housing_test
