// Planets on tapered, spherical and ball bearings: against springs in space, closed forms and limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/inclined_rows.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "mechanics/constants.hpp"
#include "tests/inclined_planets.hpp"
#include "tests/messages.hpp"
#include "tests/reference/inclined_springs.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::inclined_rows_test {
namespace {

using constants::degree;

constexpr double kSearch = 1e-9;  // of the largest load: both searches end at 1e-12 and 1e-9 of the force

Bearing roller_row(double clearance = 0.0) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.radial_clearance = clearance;
  return bearing;
}

PlanetRows tapered(RowArrangement arrangement, double angle = 15.0 * degree) {
  return {.type = PlanetBearingType::tapered_roller, .contact_angle = angle, .arrangement = arrangement};
}

PlanetRows spherical(double angle = 10.0 * degree) {
  return {.type = PlanetBearingType::spherical_roller, .contact_angle = angle};
}

OperatingPoint at_speed(double sun_speed) {
  return example_bearings::planet_motion(example_bearings::rpm(sun_speed));
}

InclinedPlanet planet_on(const Bearing& bearing, const PlanetRows& rows, const std::vector<double>& positions,
                         const OperatingPoint& point) {
  return {inclined_rows(bearing, rows, positions), point, {}};
}

// The geometry once more, from drawings: nothing but angles, radii and the law of one contact.
std::vector<reference::InclinedSpring> springs_of(const InclinedPlanet& planet, const Bearing& bearing,
                                                  double arrangement, const std::vector<double>& positions,
                                                  double angle, double taper, double mounted, double first) {
  std::vector<reference::InclinedSpring> all;
  const double pitch = 0.5 * bearing.pitch_diameter;
  for (std::size_t k = 0; k < positions.size(); ++k)
    for (int j = 0; j < bearing.rollers().count; ++j) {
      const double at = first + constants::two_pi * j / bearing.rollers().count;
      const double side = (k == 0 ? 1.0 : -1.0) * arrangement;
      const auto normal = [&](double inclined) {
        return reference::Space{std::cos(inclined) * std::cos(at), std::cos(inclined) * std::sin(at),
                                side * std::sin(inclined)};
      };
      all.push_back({.at = {pitch * std::cos(at), pitch * std::sin(at), positions[k]},
                     .outer_normal = normal(angle),
                     .inner_normal = normal(angle - taper),
                     .mounted = mounted,
                     .stiffness = 8.06e4 * std::pow(1e3 * bearing.rollers().length, 8.0 / 9.0) *
                                  std::pow(1e3, 10.0 / 9.0),
                     .outward_inertia = planet.inertial_load(planet.rows().front(), at)});
    }
  return all;
}

void expect_like_springs(const InclinedState& found, const reference::SpringLoads& springs) {
  ASSERT_TRUE(found.report.converged) << found.report.message;
  const double most = *std::max_element(springs.outer.begin(), springs.outer.end());
  ASSERT_LT(springs.residual, 1e-7 * most);
  std::size_t next = 0;
  for (std::size_t k = 0; k < found.outer_load.size(); ++k)
    for (Eigen::Index j = 0; j < found.outer_load[k].size(); ++j, ++next) {
      EXPECT_NEAR(found.outer_load[k][j], springs.outer[next], kSearch * 100.0 * most) << k << ' ' << j;
      EXPECT_NEAR(found.inner_load[k][j], springs.inner[next], kSearch * 100.0 * most) << k << ' ' << j;
    }
}

TEST(InclinedRows, TaperedPairsLoadTheirRollersAsSpringsInSpace) {
  const std::vector<double> positions{-9e-3, 7e-3};
  for (const RowArrangement arrangement : {RowArrangement::back_to_back, RowArrangement::face_to_face})
    for (const double approach : {0.0, 8e-6, -6e-6})
      for (const double speed : {100.0, 9000.0}) {
        const Bearing bearing = roller_row();
        PlanetRows rows = tapered(arrangement);
        rows.approach = approach;
        const InclinedPlanet planet = planet_on(bearing, rows, positions, at_speed(speed));
        const double taper = taper_of(bearing.element_diameter(), bearing.pitch_diameter, rows.contact_angle);
        const PlanetLoad load{.force = {900.0, 2600.0}, .axial = 120.0, .moment = {14.0, -5.0}};
        const double first = 0.07;
        SCOPED_TRACE(testing::Message() << approach << " m, " << speed << " rpm");
        // The tilt (x, y) is the rotation (-y, x).
        expect_like_springs(
            planet.balance(load, first),
            reference::springs_in_balance(
                springs_of(planet, bearing, arrangement == RowArrangement::back_to_back ? 1.0 : -1.0,
                           positions, rows.contact_angle, taper,
                           0.5 * approach * std::sin(rows.contact_angle), first),
                {900.0, 2600.0, 120.0}, {5.0, 14.0}, true));
      }
}

TEST(InclinedRows, SphericalBearingsLoadTheirRollersAsSpringsInSpace) {
  for (const double clearance : {0.0, 20e-6, -5e-6}) {
    const Bearing bearing = roller_row(clearance);
    const PlanetRows rows = spherical();
    const InclinedPlanet planet = planet_on(bearing, rows, {0.0}, at_speed(9000.0));
    EXPECT_FALSE(planet.holds_tilt());
    // Normals meet in the middle: rows are where they do so.
    const double middle = 0.5 * bearing.pitch_diameter * std::tan(rows.contact_angle);
    const PlanetLoad load{.force = {900.0, 2600.0}, .axial = 200.0};
    expect_like_springs(
        planet.balance(load, 0.05),
        reference::springs_in_balance(springs_of(planet, bearing, -1.0, {-middle, middle}, rows.contact_angle,
                                                 0.0, -0.5 * clearance * std::cos(rows.contact_angle), 0.05),
                                      {900.0, 2600.0, 200.0}, {0.0, 0.0}, false));
  }
}

TEST(InclinedRows, ForcesHaveAnEnergy) {
  for (const bool balls : {false, true}) {
    Bearing bearing = roller_row();
    PlanetRows rows = tapered(RowArrangement::back_to_back);
    if (balls) {
      bearing.elements = Balls{.count = 9, .diameter = 6e-3};
      rows = {.type = PlanetBearingType::deep_groove_ball};
    } else {
      rows.preload = 800.0;
    }
    const InclinedPlanet planet = planet_on(bearing, rows, {-9e-3, 9e-3}, at_speed(6000.0));
    const InclinedPlanet::Position at{4e-6, -3e-6, 2e-6, 2.5e-6, -1.5e-6};
    SCOPED_TRACE(balls);
    test::expect_slopes_of_energy(planet, at);
  }
}

// Each roller bears F / (Z sin(alpha)), on the cone less by the cosine of the taper.
TEST(InclinedRows, PreloadAloneIsSharedEvenly) {
  const Bearing bearing = roller_row();
  for (const double angle : {10.0 * degree, 28.0 * degree}) {
    PlanetRows rows = tapered(RowArrangement::back_to_back, angle);
    rows.preload = 1500.0;
    const InclinedState state = planet_on(bearing, rows, {-9e-3, 9e-3}, {}).balance({}, 0.0);
    ASSERT_TRUE(state.report.converged) << state.report.message;
    const double each = 1500.0 / (bearing.rollers().count * std::sin(angle));
    const double taper = taper_of(bearing.element_diameter(), bearing.pitch_diameter, angle);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LE((state.outer_load[k] / each - 1.0).abs().maxCoeff(), 1e-12);
      EXPECT_LE((state.inner_load[k] / (each * std::cos(taper)) - 1.0).abs().maxCoeff(), 1e-12);
    }
    // The same by the displacement that the force makes.
    rows.approach = 2.0 * inclined_rows(bearing, rows, {-9e-3, 9e-3}).front().approach / std::sin(angle);
    rows.preload.reset();
    const InclinedState displaced = planet_on(bearing, rows, {-9e-3, 9e-3}, {}).balance({}, 0.0);
    EXPECT_LE((displaced.outer_load[0] / each - 1.0).abs().maxCoeff(), 1e-12);
  }
}

// Races and axis of a tapered roller meet in one point.
TEST(InclinedRows, TaperMeetsTheAxis) {
  for (const double angle : {8.0 * degree, 15.0 * degree, 30.0 * degree}) {
    const double nu = 0.5 * taper_of(6e-3, 40e-3, angle);
    EXPECT_NEAR(std::sin(nu), 6.0 / 40.0 * std::sin(angle - nu), 1e-15);
  }
  EXPECT_EQ(taper_of(6e-3, 40e-3, 0.0), 0.0);
}

// Two rows at the angle 0 are two cylindrical bearings, each under half the load, with inertia and clearance.
TEST(InclinedRows, WithoutContactAngleIsTheCylindricalBearing) {
  for (const double clearance : {0.0, 15e-6}) {
    const Bearing bearing = roller_row(clearance);
    OperatingPoint point = at_speed(9000.0);
    point.bore_load = {450.0, 1300.0};
    Bearing alone = bearing;
    alone.cage.guidance = Race::inner;  // so that the load on the bore is that of the rollers
    const QuasiStaticState cylindrical = quasi_static_state(alone, point, {}, 0.05);
    const InclinedState rows =
        planet_on(bearing, spherical(0.0), {0.0}, point).balance({.force = {900.0, 2600.0}}, 0.05);
    const double most = cylindrical.outer_load.maxCoeff();
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LE((rows.outer_load[k] - cylindrical.outer_load).abs().maxCoeff(), kSearch * most);
      EXPECT_LE((rows.inner_load[k] - cylindrical.inner_load).abs().maxCoeff(), kSearch * most);
    }
  }
}

// [ISO16281]: the row of balls of the static equilibrium, whose load moves the inner ring.
TEST(InclinedRows, BallsAtRestAreThoseOfTheStaticBalance) {
  Bearing bearing = roller_row(8e-6);
  bearing.elements = Balls{.count = 9, .diameter = 6e-3};
  const InclinedState planet = planet_on(bearing, {.type = PlanetBearingType::deep_groove_ball}, {0.0}, {})
                                   .balance({.force = {-1500.0, 0.0}}, 0.0);
  const equilibrium::RingState ring =
      equilibrium::balance_ring(equilibrium::BallRow(bearing), {.radial = 1500.0, .tilt = 0.0});
  ASSERT_TRUE(planet.report.converged && ring.report.converged);
  const double most = ring.contact_load.maxCoeff();
  EXPECT_LE((planet.outer_load[0] - ring.contact_load).abs().maxCoeff(), kSearch * most);
  EXPECT_NEAR(-planet.displacement.x(), ring.radial, kSearch * ring.radial);
}

// [NSKE728]: 4.08 F/(Z cos(alpha)) and an induced axial load of 1.26 F tan(alpha) of line contacts where
// half of the rollers are loaded, to the printed digits.
TEST(InclinedRows, LargestAndAxialLoadWithoutClearanceAreThePublishedFactors) {
  Bearing bearing = roller_row();
  bearing.rollers().count = 90;
  bearing.rollers().diameter = 1e-3;
  constexpr double angle = 15.0 * degree, load = 4000.0;
  const InclinedResult pair = inclined_planet_over_a_pitch(
      planet_on(bearing, tapered(RowArrangement::back_to_back, angle), {-9e-3, 9e-3}, {}),
      {.force = {load, 0.0}}, 16);
  ASSERT_TRUE(pair.report.converged);
  for (const InclinedRowLoads& row : pair.rows) {
    EXPECT_NEAR(row.outer_load.maxCoeff() * 90.0 * std::cos(angle) / (0.5 * load), 4.08, 0.005);
    EXPECT_NEAR(row.axial / (0.5 * load * std::tan(angle)), 1.26, 0.005);
    EXPECT_NEAR(row.radial.x() / (0.5 * load), -1.0, kSearch);
  }
  const InclinedResult barrels = inclined_planet_over_a_pitch(planet_on(bearing, spherical(angle), {0.0}, {}),
                                                              {.force = {load, 0.0}}, 16);
  EXPECT_NEAR(barrels.rows.front().outer_load.maxCoeff() * 180.0 * std::cos(angle) / load, 4.08, 0.005);
}

// An O pair resists a moment by the spread of its pressure centres, an X pair by less; the lever arm decides.
TEST(InclinedRows, SpreadOfPressureCentresHoldsTheTilt) {
  const Bearing bearing = roller_row();
  const auto tilt_stiffness = [&](RowArrangement arrangement) {
    PlanetRows rows = tapered(arrangement);
    rows.preload = 3000.0;
    return planet_on(bearing, rows, {-9e-3, 9e-3}, {}).balance({}, 0.0).stiffness(3, 3);
  };
  const double arm = 0.5 * bearing.pitch_diameter * std::tan(15.0 * degree);
  EXPECT_NEAR(tilt_stiffness(RowArrangement::back_to_back) / tilt_stiffness(RowArrangement::face_to_face),
              std::pow((9e-3 + arm) / (9e-3 - arm), 2), 1e-9);
}

TEST(InclinedRows, RotatedLoadsAndElementsRotateTheBalance) {
  const Bearing bearing = roller_row(5e-6);
  const InclinedPlanet planet = planet_on(bearing, tapered(RowArrangement::back_to_back), {-9e-3, 9e-3}, {});
  const InclinedState one = planet.balance({.force = {2000.0, 0.0}}, 0.0);
  const double pitch = constants::two_pi / bearing.rollers().count;
  const InclinedState other =
      planet.balance({.force = {2000.0 * std::cos(pitch), 2000.0 * std::sin(pitch)}}, 0.0);
  for (Eigen::Index j = 0; j < bearing.rollers().count; ++j)
    EXPECT_NEAR(other.outer_load[0][(j + 1) % bearing.rollers().count], one.outer_load[0][j],
                kSearch * one.outer_load[0].maxCoeff());
}

TEST(InclinedRows, RefusesWhatDoesNotFit) {
  const Bearing bearing = roller_row();
  const PlanetRows pair = tapered(RowArrangement::back_to_back);
  EXPECT_REFUSED(std::invalid_argument, "rows of tapered rollers", inclined_rows(bearing, pair, {0.0}));
  EXPECT_REFUSED(std::invalid_argument, "angle of tapered rollers",
                 inclined_rows(bearing, tapered(RowArrangement::back_to_back, 0.0), {-9e-3, 9e-3}));
  EXPECT_REFUSED(std::invalid_argument, "bearings of a planet", inclined_rows(bearing, spherical(), {}));
  EXPECT_REFUSED(std::invalid_argument, "elements of a planet bearing",
                 inclined_rows(bearing, {.type = PlanetBearingType::deep_groove_ball}, {0.0}));
  EXPECT_REFUSED(std::invalid_argument, "rows of a planet", InclinedPlanet({}, {}, {}));
  EXPECT_REFUSED(std::invalid_argument, "cage angles of a planet",
                 inclined_planet_over_a_pitch(planet_on(bearing, pair, {-9e-3, 9e-3}, {}), {}, 0));
}

// Two rows that are pressed the same way hold no axial load of the other one.
TEST(InclinedRows, SaysWhereThereIsNoBalance) {
  const Bearing bearing = roller_row();
  std::vector<InclinedRow> rows =
      inclined_rows(bearing, tapered(RowArrangement::back_to_back), {-9e-3, 9e-3});
  rows[1].side = rows[0].side;
  const InclinedState state = InclinedPlanet(rows, {}, {}).balance({.axial = 500.0}, 0.0);
  EXPECT_FALSE(state.report.converged);
  EXPECT_SAID("planet without balance", state.report.message);
}

}  // namespace
}  // namespace orbearing::bearing::inclined_rows_test
