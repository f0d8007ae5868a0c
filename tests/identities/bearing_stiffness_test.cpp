// The 5 x 5 stiffness against differences of the equilibrium itself, entry by entry: positions of the ring
// under slightly larger and smaller loads. Its product with these slopes is the unit matrix.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "bearing/equilibrium/lamina_stiffness.hpp"
#include "bearing/equilibrium/ring_axes.hpp"
#include "bearing/equilibrium/row_group.hpp"
#include "bearing/profile/profile.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::equilibrium::bearing_stiffness_test {
namespace {

using constants::degree;
using Vector5 = Eigen::Vector<double, 5>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

constexpr double kAgreement = 1e-6;  // required of every entry, over what its row and column scale with

struct Loaded {
  std::string name;
  Bearing bearing;
  RowMotion motion;
  Vector5 load;  // [N], [N m]  along x, y, z, moments in the planes of x and z, of y and z
  bool axial = true;
};

Bearing angular_contact() {
  return {.inner = {.osculation = 0.52},
          .outer = {.osculation = 0.52},
          .elements = Balls{.count = 16, .diameter = 12.7e-3, .contact_angle = 40.0 * degree},
          .pitch_diameter = 70e-3};
}

Bearing rollers() {
  Bearing bearing{
      .elements = CylindricalRollers{.count = 14, .diameter = 10e-3, .length = 9.6e-3, .laminae = 41},
      .pitch_diameter = 65e-3,
      .radial_clearance = 10e-6};
  bearing.rollers().profile = profile::Iso16281{9.6e-3, 10e-3, 1.0};
  return bearing;
}

std::vector<Loaded> loaded_bearings() {
  const RowMotion rotating{.speeds = {.inner = 1000.0}};
  RowMotion filmed = rotating;
  filmed.film = Lubricant{.viscosity = 0.02, .pressure_viscosity = 2e-8};
  const Vector5 combined(1500.0, 0.0, 6000.0, 12.0, -7.0);
  return {{"balls at rest", angular_contact(), {}, combined},
          {"balls that turn", angular_contact(), rotating, combined},
          {"balls that turn on a film", angular_contact(), filmed, combined},
          {"rollers", rollers(), {}, Vector5(4000.0, 0.0, 0.0, 9.0, 5.0), false}};
}

// Position of the ring under `load`: x, y, z and both tilts as tangents. The equilibrium requires the radial
// load along x, so the bearing is rotated accordingly.
Vector5 stands(const Loaded& at, const Vector5& load) {
  const double turn = std::atan2(load[1], load[0]);
  const Eigen::Rotation2D<double> back(turn);
  const Eigen::Vector2d moment = back.inverse() * Eigen::Vector2d(load[3], load[4]);
  Bearing bearing = at.bearing;
  bearing.first_element -= turn;
  const RingState state = balance_bearing(bearing, at.motion,
                                          {.radial = std::hypot(load[0], load[1]),
                                           .axial = load[2],
                                           .moment = moment[0],
                                           .moment_across = moment[1]});
  EXPECT_TRUE(state.report.converged) << at.name;
  const Eigen::Vector2d across = back * Eigen::Vector2d(state.radial, state.lateral);
  const Eigen::Vector2d tilt = back * Eigen::Vector2d(std::tan(state.tilt), std::tan(state.lateral_tilt));
  return {across[0], across[1], state.axial, tilt[0], tilt[1]};
}

RingState balanced(const Loaded& at) {
  return balance_bearing(
      at.bearing, at.motion,
      {.radial = at.load[0], .axial = at.load[2], .moment = at.load[3], .moment_across = at.load[4]});
}

// Differences of fourth order: steps far above the equilibrium's round-off.
Vector5 slope_by_load(const Loaded& at, int freedom, double step) {
  const auto moved = [&](double steps) {
    return stands(at, (at.load + steps * step * Vector5::Unit(freedom)).eval());
  };
  return (8.0 * (moved(1.0) - moved(-1.0)) - (moved(2.0) - moved(-2.0))) / (12.0 * step);
}

TEST(BearingStiffness, EveryEntryIsTheSlopeOfTheEquilibrium) {
  for (const Loaded& at : loaded_bearings()) {
    SCOPED_TRACE(at.name);
    const Matrix5 stiffness = balanced(at).stiffness;
    // Laminae that come into touch bend the curve sharply (exponent 10/9): short steps.
    Matrix5 slopes = Matrix5::Zero();
    for (int i = 0; i < 5; ++i)
      if (at.axial || i != 2)
        slopes.col(i) = slope_by_load(at, i, (at.axial ? 1.0 : 0.01) * (i < 3 ? 3.0 : 0.05));
    Matrix5 expected = Matrix5::Identity();
    if (!at.axial) expected(2, 2) = 0.0;
    const Matrix5 product = stiffness * slopes;
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) {
        // With an arm of 1 cm, forces and moments are comparable.
        const double arm = std::pow(100.0, (i >= 3) - (j >= 3));
        EXPECT_NEAR(arm * product(i, j), arm * expected(i, j), kAgreement) << i << " " << j;
      }
  }
}

TEST(BearingStiffness, SymmetricAtRest) {
  constexpr double round_off = 1e-10;
  for (const Loaded& at : loaded_bearings()) {
    if (!at.motion.speeds.at_rest()) continue;
    const Matrix5 stiffness = balanced(at).stiffness;
    EXPECT_LT((stiffness - stiffness.transpose()).norm(), round_off * stiffness.norm()) << at.name;
  }
}

// Reciprocity (Maxwell, Betti): what a force along one freedom moves along another, the other's moves along
// the one. At rest alone: forces that follow the motion have no energy.
TEST(BearingStiffness, ReciprocityAtRest) {
  for (const Loaded& at : loaded_bearings()) {
    if (!at.motion.speeds.at_rest() || !at.axial) continue;
    const Vector5 axial = slope_by_load(at, 2, 3.0), moment = slope_by_load(at, 3, 0.05),
                  across = slope_by_load(at, 1, 3.0);
    EXPECT_NEAR(axial[3] / moment[2], 1.0, kAgreement);
    EXPECT_NEAR(axial[1] / across[2], 1.0, kAgreement);
    EXPECT_NEAR(moment[1] / across[3], 1.0, kAgreement);
  }
}

// Under thrust alone no direction across the axis is distinguished; a row whose angle does not change follows
// K_z = 3/2 F/w, and so grows with the cube root of the load; slow rotation tends to the stationary bearing.
TEST(BearingStiffness, Limits) {
  Bearing bearing = angular_contact();
  const auto under = [&](double axial, double speed) {
    return balance_bearing(bearing, {.speeds = {.inner = speed}}, {.axial = axial});
  };
  const RingState state = under(6000.0, 800.0);
  EXPECT_NEAR(state.stiffness(0, 0) / state.stiffness(1, 1), 1.0, 1e-9);
  EXPECT_NEAR(state.stiffness(3, 3) / state.stiffness(4, 4), 1.0, 1e-9);
  EXPECT_NEAR(state.stiffness(0, 2) / state.stiffness(2, 2), 0.0, 1e-9);
  const Matrix5 rest = under(6000.0, 0.0).stiffness, slow = under(6000.0, 0.01).stiffness;
  EXPECT_LT((slow - rest).norm(), 1e-8 * rest.norm());
  bearing.balls().contact_angle = 89.999 * degree;
  const RingState weak = under(1.0, 0.0), strong = under(8.0, 0.0);
  EXPECT_NEAR(strong.stiffness(2, 2) / weak.stiffness(2, 2), 2.0, 1e-3);
  EXPECT_NEAR(strong.stiffness(2, 2) * strong.axial / 8.0, 1.5, 1e-3);
}

// By axes: tilts about x and y are the right hand's, and their moments go with them.
TEST(BearingStiffness, AxesAreTheRightHands) {
  const Loaded at = loaded_bearings().front();
  const RingState state = balanced(at);
  const RingStiffness by_axes = stiffness_by_axes(state);
  const RingDisplacement moved = displacement_by_axes(state);
  EXPECT_EQ(moved[3], state.lateral_tilt);
  EXPECT_EQ(moved[4], -state.tilt);
  EXPECT_EQ(by_axes(3, 3), state.stiffness(4, 4));
  EXPECT_EQ(by_axes(0, 4), -state.stiffness(0, 3));
  EXPECT_EQ(by_axes(3, 4), -state.stiffness(4, 3));
}

struct Planet {
  Bearing bearing;
  OperatingPoint point;
  QuasiStaticOptions options;
};

Planet planet(bool film, bool crowned) {
  Planet p;
  p.bearing = {
      .inner = {.seat_diameter = 25e-3},
      .outer = {.seat_diameter = 47e-3},
      .elements = CylindricalRollers{.count = 15, .diameter = 5.24e-3, .length = 5.7e-3, .laminae = 40},
      .pitch_diameter = 35.64e-3,
      .width = 11.9e-3};
  if (crowned) p.bearing.rollers().profile = profile::Iso16281{5.7e-3, 5.24e-3, 1.0};
  if (crowned) p.bearing.outer.profile = profile::CircularCrown{5.7e-3, 2e-6};
  p.point.carrier = {.speed = 200.0, .orbit_radius = 87.9e-3};
  p.point.outer_speed = -720.0;
  p.point.bore_load = {900.0, 1600.0};
  if (crowned) p.point.bore_tilt = {0.5e-3, 0.9e-3};
  p.options.cage_positions = 3;
  p.options.first_roller = 0.137;
  if (film) p.options.film = Lubricant{0.01, 1.5e-8};
  return p;
}

// Load, tilt -> displacement, moment that holds the tilt, as means over the cage angles.
Eigen::Vector4d means(Planet p, const Eigen::Vector4d& change) {
  p.point.bore_load += change.head<2>();
  p.point.bore_tilt += change.tail<2>();
  const QuasiStaticResult result =
      quasi_static_bearing(laminae::LaminaBearing(p.bearing), p.point, p.options);
  EXPECT_TRUE(result.report.converged);
  return (Eigen::Vector4d() << result.displacement, -result.moment).finished();
}

TEST(PlanetStiffness, EveryEntryIsTheSlopeOfTheMeans) {
  for (const bool film : {false, true})
    for (const bool crowned : {false, true}) {
      SCOPED_TRACE(std::string(film ? "film" : "dry") +
                   (crowned ? ", crowned and tilted" : ", straight and level"));
      const Planet p = planet(film, crowned);
      const laminae::LaminaBearing bearing(p.bearing);
      const Eigen::Matrix4d stiffness =
          laminae::mean_stiffness(bearing, quasi_static_bearing(bearing, p.point, p.options));
      Eigen::Matrix4d slopes;
      for (int i = 0; i < 4; ++i) {
        const double step = i < 2 ? 0.02 : 1e-8;  // [N], [rad]: no lamina comes into touch or leaves it
        const auto moved = [&](double steps) {
          return means(p, (steps * step * Eigen::Vector4d::Unit(i)).eval());
        };
        slopes.col(i) = (8.0 * (moved(1.0) - moved(-1.0)) - (moved(2.0) - moved(-2.0))) / (12.0 * step);
      }
      // Displacement and moment by load and tilt, from the stiffness.
      const Eigen::Matrix2d compliance = stiffness.topLeftCorner<2, 2>().inverse();
      Eigen::Matrix4d ours;
      ours << compliance, -compliance * stiffness.topRightCorner<2, 2>(),
          stiffness.bottomLeftCorner<2, 2>() * compliance,
          stiffness.bottomRightCorner<2, 2>() -
              stiffness.bottomLeftCorner<2, 2>() * compliance * stiffness.topRightCorner<2, 2>();
      for (const auto& [row, column] : {std::pair(0, 0), std::pair(0, 2), std::pair(2, 0), std::pair(2, 2)}) {
        const Eigen::Matrix2d found = slopes.block<2, 2>(row, column);
        // Blocks that vanish in straight and level bearings are measured by what both freedoms alone would
        // do.
        const double size =
            std::sqrt(ours.block<2, 2>(row, row).norm() * ours.block<2, 2>(column, column).norm());
        const double scale = row == column ? found.norm() : std::max(found.norm(), 1e-3 * size);
        EXPECT_LT((ours.block<2, 2>(row, column) - found).norm(), kAgreement * scale) << row << " " << column;
      }
      EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-10 * stiffness.norm());
    }
}

// At one cage angle, without inertia: stiffness of the same rollers, unloaded ones among them, in series.
TEST(PlanetStiffness, IsThatOfTheRollersAlongTheLoad) {
  const Planet p = planet(false, false);
  const laminae::LaminaBearing bearing(p.bearing);
  const QuasiStaticState state = quasi_static_state(bearing, p.point, p.options, 0.2, nullptr);
  const Eigen::Matrix4d stiffness = laminae::stiffness_at(bearing, state);
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (std::size_t j = 0; j < state.rollers.size(); ++j) {
    const double angle = state.angle[static_cast<Eigen::Index>(j)];
    const Eigen::Vector2d outward(std::cos(angle), std::sin(angle));
    sum += state.rollers[j].stiffness * outward * outward.transpose();
  }
  EXPECT_LT((stiffness.topLeftCorner<2, 2>() - sum).norm(), 1e-12 * sum.norm());
  EXPECT_GT(stiffness(2, 2), 0.0);
}

// With rollers or balls on the line of the load two are at right angles to it, where the approach is
// round-off of none: rigid rings, no clearance, load approach^n on rollers (10/9) and balls (3/2), by a sum
// over the loaded half. Round-off through the ninth root would stiffen rollers across the load by a percent.
TEST(BearingStiffness, AcrossOverAlongIsThatOfTheSum) {
  for (const int count : {8, 12, 16})
    for (const double turn : {0.0, 0.5})
      for (const bool rolls : {true, false}) {
        Bearing bearing{.pitch_diameter = 65e-3, .first_element = turn * 360.0 / count * degree};
        if (rolls)
          bearing.elements =
              CylindricalRollers{.count = count, .diameter = 10e-3, .length = 10e-3, .laminae = 40};
        else
          bearing.elements = Balls{.count = count, .diameter = 10e-3};
        const RingState state = balance_bearing(bearing, {.radial = 4000.0, .tilt = 0.0});
        ASSERT_TRUE(state.report.converged);
        double along = 0.0, across = 0.0;
        for (int j = 0; j < count; ++j) {
          const double angle = (j + turn) * 360.0 / count * degree;
          if (std::cos(angle) < 1e-9) continue;
          const double stiffness = std::pow(std::cos(angle), rolls ? 1.0 / 9.0 : 0.5);
          along += stiffness * std::pow(std::cos(angle), 2);
          across += stiffness * std::pow(std::sin(angle), 2);
        }
        EXPECT_NEAR(state.stiffness(1, 1) / state.stiffness(0, 0), across / along, kAgreement)
            << count << (rolls ? " rollers" : " balls") << ", turned by " << turn;
      }
}

}  // namespace
}  // namespace orbearing::bearing::equilibrium::bearing_stiffness_test
