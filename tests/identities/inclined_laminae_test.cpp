// Tapered rollers cut into laminae: against laminae in space of a second program, whole contacts, slopes of
// the energy, finer laminae.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bearing/equilibrium/inclined_rows.hpp"
#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/profile/profile.hpp"
#include "mechanics/constants.hpp"
#include "tests/inclined_planets.hpp"
#include "tests/reference/inclined_laminae.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::inclined_laminae_test {
namespace {

using constants::degree;

constexpr double kTwoSearches = 1e-7;  // of the largest load: both end at 1e-9 of the force
const std::vector<double> kPositions{-9e-3, 7e-3};

Bearing rollers(int laminae, double crown = 0.0) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.radial_clearance = 0.0;
  bearing.rollers().laminae = laminae;
  if (crown > 0.0) bearing.rollers().profile = profile::CircularCrown{bearing.rollers().length, crown};
  return bearing;
}

PlanetRows pair(RowArrangement arrangement = RowArrangement::back_to_back) {
  return {
      .type = PlanetBearingType::tapered_roller, .contact_angle = 15.0 * degree, .arrangement = arrangement};
}

OperatingPoint at_speed(double sun_speed) {
  return example_bearings::planet_motion(example_bearings::rpm(sun_speed));
}

InclinedPlanet planet_on(const Bearing& bearing, const PlanetRows& rows, double speed) {
  return {inclined_rows(bearing, rows, kPositions), at_speed(speed), {}};
}

const PlanetLoad kLoad{.force = {900.0, 2600.0}, .axial = 120.0, .moment = {14.0, -5.0}};

// The geometry once more: rows are at the middles of their rollers, lines of contact are inclined by the
// angle.
std::vector<reference::LaminaRoller> drawn(const InclinedPlanet& planet, const Bearing& bearing,
                                           const PlanetRows& rows, double first) {
  std::vector<reference::LaminaRoller> all;
  const CylindricalRollers& one = bearing.rollers();
  const double pitch = 0.5 * bearing.pitch_diameter, angle = rows.contact_angle;
  const double nu = std::atan2(one.diameter / bearing.pitch_diameter * std::sin(angle),
                               1.0 + one.diameter / bearing.pitch_diameter * std::cos(angle));
  for (std::size_t row = 0; row < kPositions.size(); ++row)
    for (int j = 0; j < one.count; ++j) {
      const double at = first + constants::two_pi * j / one.count;
      const double side =
          (row == 0 ? 1.0 : -1.0) * (rows.arrangement == RowArrangement::back_to_back ? 1.0 : -1.0);
      reference::LaminaRoller roller{
          .at = {pitch * std::cos(at), pitch * std::sin(at), kPositions[row]},
          .along = {-side * std::sin(angle) * std::cos(at), -side * std::sin(angle) * std::sin(at),
                    std::cos(angle)},
          .outer_normal = {std::cos(angle) * std::cos(at), std::cos(angle) * std::sin(at),
                           side * std::sin(angle)},
          .between = std::cos(2.0 * nu),
          .mounted = 0.5 * rows.approach.value_or(0.0) * std::sin(angle),
          .stiffness = 8.06e4 * std::pow(1e3 * one.length, 8.0 / 9.0) * std::pow(1e3, 10.0 / 9.0),
          .inertia = planet.inertial_load(planet.rows().front(), at) * std::cos(angle - 2.0 * nu)};
      for (int k = 0; k < one.laminae; ++k) {
        const double x = 0.5 * one.length * ((2.0 * k + 1.0) / one.laminae - 1.0);
        roller.places.push_back(x);
        roller.drops.push_back(profile::drop(one.profile, x));
      }
      all.push_back(roller);
    }
  return all;
}

TEST(InclinedLaminae, CarryAsLaminaeInSpace) {
  for (const RowArrangement arrangement : {RowArrangement::back_to_back, RowArrangement::face_to_face})
    for (const double approach : {6e-6, -4e-6}) {
      const Bearing bearing = rollers(4, 3e-6);
      PlanetRows rows = pair(arrangement);
      rows.approach = approach;
      const InclinedPlanet planet = planet_on(bearing, rows, 9000.0);
      const InclinedState found = planet.balance(kLoad, 0.07);
      ASSERT_TRUE(found.report.converged) << found.report.message;
      // The tilt (x, y) is the rotation (-y, x).
      const reference::LaminaLoads other = reference::laminae_in_balance(drawn(planet, bearing, rows, 0.07),
                                                                         {900.0, 2600.0, 120.0}, {5.0, 14.0});
      double most = 0.0;
      for (const std::vector<double>& roller : other.outer)
        most = std::max(most, *std::max_element(roller.begin(), roller.end()));
      ASSERT_LT(other.residual, kTwoSearches * most);
      std::size_t next = 0;
      for (std::size_t k = 0; k < 2; ++k)
        for (int j = 0; j < bearing.rollers().count; ++j, ++next) {
          const laminae::RollerState& roller = found.rollers[next];
          const Eigen::ArrayXd inner = planet.rows()[k].cut->inner.loads(roller.inner_approach(),
                                                                         roller.inner_end_displacement),
                               outer = planet.rows()[k].cut->outer.loads(roller.outer_approach,
                                                                         roller.outer_end_displacement);
          for (int lamina = 0; lamina < 4; ++lamina) {
            const auto at = static_cast<std::size_t>(lamina);
            EXPECT_NEAR(outer[lamina], other.outer[next][at], kTwoSearches * most) << k << ' ' << j;
            EXPECT_NEAR(inner[lamina], other.inner[next][at], kTwoSearches * most) << k << ' ' << j;
          }
        }
    }
}

// One lamina without profile is the whole contact.
TEST(InclinedLaminae, OneLaminaIsTheWholeRoller) {
  for (const double speed : {100.0, 9000.0}) {
    PlanetRows rows = pair();
    rows.preload = 900.0;
    const InclinedState whole = planet_on(rollers(0), rows, speed).balance(kLoad, 0.02);
    const InclinedState one = planet_on(rollers(1), rows, speed).balance(kLoad, 0.02);
    ASSERT_TRUE(whole.report.converged && one.report.converged);
    const double most = whole.outer_load[0].maxCoeff();
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LE((one.outer_load[k] - whole.outer_load[k]).abs().maxCoeff(), 1e-9 * most);
      EXPECT_LE((one.inner_load[k] - whole.inner_load[k]).abs().maxCoeff(), 1e-9 * most);
    }
    EXPECT_LE((one.stiffness - whole.stiffness).norm(), 1e-7 * whole.stiffness.norm());
  }
}

TEST(InclinedLaminae, ForcesHaveAnEnergy) {
  PlanetRows rows = pair();
  rows.preload = 800.0;
  const InclinedPlanet planet = planet_on(rollers(12, 2e-6), rows, 6000.0);
  const InclinedPlanet::Position at{4e-6, -3e-6, 2e-6, 2.5e-6, -1.5e-6};
  test::expect_slopes_of_energy(planet, at);
}

// Loads of rollers converge with laminae a quarter as wide; a tilt loads one end.
TEST(InclinedLaminae, FinerLaminaeConvergeAndATiltLoadsOneEnd) {
  PlanetRows rows = pair();
  rows.preload = 800.0;
  const auto loads = [&](int laminae) {
    return planet_on(rollers(laminae, 2e-6), rows, 6000.0).balance(kLoad, 0.0).outer_load[0];
  };
  const Eigen::ArrayXd fine = loads(512);
  const auto error = [&](int laminae) { return (loads(laminae) - fine).abs().maxCoeff() / fine.maxCoeff(); };
  EXPECT_LT(error(32), 0.5 * error(8));
  EXPECT_LT(error(128), 0.5 * error(32));
  EXPECT_LT(error(32), 2e-3);

  const InclinedPlanet planet = planet_on(rollers(30), rows, 6000.0);
  const InclinedResult result = inclined_planet_over_a_pitch(planet, kLoad, 2);
  ASSERT_TRUE(result.report.converged) << result.report.message;
  const Eigen::ArrayXXd& along = result.rows[0].outer_lamina_load;
  Eigen::Index roller = 0;
  result.rows[0].outer_load.maxCoeff(&roller);
  EXPECT_NEAR(along.col(roller).sum() / result.rows[0].outer_load[roller], 1.0, 1e-9);
  // A planet whose axis is inclined outward at +z relieves that end of the rollers.
  const Eigen::Vector2d to(std::cos(result.angle[roller]), std::sin(result.angle[roller]));
  const double lean = result.tilt.dot(to), slope = along(29, roller) - along(0, roller);
  EXPECT_LT(lean * slope, 0.0);
}

// All in equilibrium: rows' forces and moments balance the load.
TEST(InclinedLaminae, HoldTheLoadAndItsMoment) {
  PlanetRows rows = pair();
  rows.preload = 800.0;
  const InclinedPlanet planet = planet_on(rollers(10, 2e-6), rows, 6000.0);
  const InclinedResult result = inclined_planet_over_a_pitch(planet, kLoad, 3);
  Eigen::Vector2d force = kLoad.force, moment = kLoad.moment;
  for (std::size_t k = 0; k < 2; ++k) {
    force += result.rows[k].radial;
    moment += planet.rows()[k].pressure_centre * result.rows[k].radial + result.rows[k].moment;
  }
  EXPECT_LT(force.norm(), 1e-8 * kLoad.force.norm());
  EXPECT_LT(moment.norm(), 1e-7 * kLoad.moment.norm());
}

// Preload presses each roller with F/(Z sin(alpha)), whatever its profile.
TEST(InclinedLaminae, PreloadIsThatOfTheForce) {
  PlanetRows rows = pair();
  rows.preload = 1500.0;
  const Bearing bearing = rollers(20, 4e-6);
  const InclinedState state =
      InclinedPlanet(inclined_rows(bearing, rows, {-9e-3, 9e-3}), {}, {}).balance({}, 0.0);
  ASSERT_TRUE(state.report.converged) << state.report.message;
  const double each = 1500.0 / (bearing.rollers().count * std::sin(rows.contact_angle));
  for (std::size_t k = 0; k < 2; ++k) EXPECT_LE((state.outer_load[k] / each - 1.0).abs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace orbearing::bearing::inclined_laminae_test
