// Computed tilt of a planet on two bearings.
#include "bearing/equilibrium/planet_on_pin.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include "bearing/equilibrium/lamina_stiffness.hpp"
#include "bearing/pin_beam.hpp"
#include "mechanics/linear_algebra.hpp"
#include "tests/messages.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::laminae::planet_on_pin_test {
namespace {

using Eigen::Vector2d;

constexpr double kPosition = 0.007;  // [m]  of the bearings on either side of the middle
const Vector2d kNone = Vector2d::Zero();

Bearing cut_bearing(double clearance = 0.0) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.rollers().laminae = 20;
  bearing.radial_clearance = clearance;
  return bearing;
}

OperatingPoint loaded(const Vector2d& load) {
  OperatingPoint point;
  point.carrier = {.speed = 200.0, .orbit_radius = 0.0879};
  point.outer_speed = -720.0;
  point.bore_load = load;
  return point;
}

PlanetOnPin two_bearings(const PinBeam& pin, double more_clearance = 0.0) {
  PlanetOnPin planet{.position = {-kPosition, kPosition}};
  planet.bearings.emplace_back(cut_bearing());
  planet.bearings.emplace_back(cut_bearing(more_clearance));
  planet.pin_compliance = pin_compliance(pin, planet.position);
  return planet;
}

PinBeam stiff_pin() {
  PinBeam pin{.diameter = 0.025, .span = 0.035};
  pin.material.youngs_modulus = 206e16;
  return pin;
}

Vector2d force_of(const QuasiStaticState& bearing) {
  Vector2d sum = kNone;
  for (Eigen::Index j = 0; j < bearing.angle.size(); ++j)
    sum += bearing.rollers[static_cast<std::size_t>(j)].outer.load *
           Vector2d(std::cos(bearing.angle[j]), std::sin(bearing.angle[j]));
  return sum;
}

// Equal bearings on a stiff pin give the results of one bearing alone.
TEST(PlanetOnPin, OfEqualBearingsOnAStiffPinIsOneBearing) {
  const Vector2d load(640.0 * 2.0, 1060.0 * 2.0);
  const QuasiStaticOptions options{.cage_positions = 4};
  const PlanetOnPinResult planet =
      planet_on_pin_over_a_pitch(two_bearings(stiff_pin()), loaded(load), kNone, options);
  ASSERT_TRUE(planet.report.converged) << planet.report.message;
  const QuasiStaticResult alone =
      quasi_static_bearing(LaminaBearing(cut_bearing()), loaded(0.5 * load), options);
  for (const QuasiStaticResult& one : planet.bearings) {
    EXPECT_LT((one.outer_lamina_load - alone.outer_lamina_load).abs().maxCoeff(),
              1e-6 * alone.outer_lamina_load.maxCoeff());
    EXPECT_LT((one.inner_load - alone.inner_load).abs().maxCoeff(), 1e-6 * alone.inner_load.maxCoeff());
  }
  EXPECT_LT(planet.tilt.norm(), 1e-9);
}

// Forces and moments of planet and pin close, whatever the errors.
TEST(PlanetOnPin, IsInBalance) {
  PlanetOnPin planet = two_bearings({.diameter = 0.02, .span = 0.035, .ends = PinEnds::one}, 10e-6);
  planet.tilt_stiffness << 4e3, 1e3, 1e3, 4e4;
  planet.pin_inclination.assign(2, Vector2d(2e-4, -5e-4));
  planet.pin_error = {Vector2d(-1e-6, 3e-6), Vector2d(2e-6, -4e-6)};
  const OperatingPoint point = loaded({900.0, 2100.0});
  const Vector2d moment(1.0, -2.0);
  const PlanetOnPinState state = planet_on_pin(planet, point, moment, {}, 0.1);
  ASSERT_TRUE(state.report.converged) << state.report.message;
  Vector2d force = point.bore_load, moments = moment - planet.tilt_stiffness * state.tilt;
  for (std::size_t k = 0; k < 2; ++k) {
    const Vector2d one =
        force_of(state.bearings[k]) +
        load_through_cage(planet.bearings[k].bearing(), planet.bearings[k].geometry(), point.carrier, {});
    force += one;
    moments += planet.position[k] * one + state.bearings[k].moment;
  }
  EXPECT_LT(force.norm(), 1e-8 * point.bore_load.norm());
  EXPECT_LT(moments.norm(), 1e-8 * point.bore_load.norm() * kPosition);
  // The pin bends by its compliance under the opposite forces and moments.
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const Vector2d a = force_of(state.bearings[0]), b = force_of(state.bearings[1]);
    const Eigen::Vector4d on_pin(-a[axis], -b[axis], -state.bearings[0].moment[axis],
                                 -state.bearings[1].moment[axis]);
    const Eigen::Vector4d bent = planet.pin_compliance * on_pin;
    for (std::size_t k = 0; k < 2; ++k) {
      const double relative = state.displacement[axis] + planet.position[k] * state.tilt[axis] -
                              bent[static_cast<Eigen::Index>(k)] - planet.pin_error[k][axis];
      EXPECT_NEAR(state.bearings[k].displacement[axis], relative, 1e-12);
    }
  }
}

// Hand calculation: each bearing a spring that is linear about equal loads; rigid pin. Loads within 2 %.
TEST(PlanetOnPin, BearingWithMoreClearanceCarriesLess) {
  const Vector2d load(0.0, 12000.0);
  const double more = 10e-6;
  const PlanetOnPinState state = planet_on_pin(two_bearings(stiff_pin(), more), loaded(load), kNone, {}, 0.0);
  ASSERT_TRUE(state.report.converged) << state.report.message;
  // In equilibrium both forces are equal whatever the clearance: two forces on a planet without other
  // moments. The difference is in its tilt: half the clearance over the distance, less the effect of the
  // stiffness of tilted rollers.
  const LaminaBearing one(cut_bearing()), other(cut_bearing(more));
  const double f = force_of(state.bearings[0]).norm() / force_of(state.bearings[1]).norm();
  const Vector2d first = quasi_static_state(one, loaded(0.5 * load), {}, 0.0).displacement;
  const Vector2d second = quasi_static_state(other, loaded(0.5 * load), {}, 0.0).displacement;
  const double free_tilt = (second - first).y() / (2.0 * kPosition);
  const double k = stiffness_at(one, quasi_static_state(one, loaded(0.5 * load), {}, 0.0))(1, 1);
  const double c = 0.5 * (stiffness_at(one, quasi_static_state(one, loaded(0.5 * load), {}, 0.0))(3, 3) +
                          stiffness_at(other, quasi_static_state(other, loaded(0.5 * load), {}, 0.0))(3, 3));
  // Both bearings resist the tilt t with c; their forces make up for it: k kPlace^2 (t0 - t) 2 = 2 c t.
  const double tilt = free_tilt * k * kPosition * kPosition / (k * kPosition * kPosition + c);
  const double difference = c * tilt / kPosition;  // [N]  by which each force leaves the half
  const double by_hand = (0.5 * load.y() + difference) / (0.5 * load.y() - difference);
  EXPECT_NEAR(state.tilt.y() / tilt, 1.0, 0.05);
  EXPECT_NEAR(f / by_hand, 1.0, 0.02);
  EXPECT_GT(f, 1.0);
}

// A pin clamped at one end deflects more at the other: the planet tilts with it, and where the meshes hold
// its tilt, the bearing at the wall carries more. Springs in series by hand.
TEST(PlanetOnPin, ClampedPinLoadsTheBearingAtTheWall) {
  const Vector2d load(0.0, 2400.0);
  PlanetOnPin planet = two_bearings({.diameter = 0.02, .span = 0.03, .ends = PinEnds::one});
  planet.tilt_stiffness = 1e9 * Eigen::Matrix2d::Identity();  // no tilt
  const PlanetOnPinState state = planet_on_pin(planet, loaded(load), kNone, {}, 0.0);
  ASSERT_TRUE(state.report.converged) << state.report.message;
  const LaminaBearing one(cut_bearing());
  // Both bearings have the displacement u - p_k; forces F_k = F_0 + k (u - p_k - d_0), tilts -p'_k against c.
  const QuasiStaticState even = quasi_static_state(one, loaded(0.5 * load), {}, 0.0);
  const Eigen::Matrix4d slope = stiffness_at(one, even);
  const double k = slope(1, 1), c = slope(3, 3), d0 = even.displacement.y(), f0 = 0.5 * load.y();
  // Unknowns: u, p (2), p' (2).  F_k on the pin; M_k = -c p'_k... p = C (F, M), sum F = load.
  Eigen::Matrix<double, 5, 5> a = Eigen::Matrix<double, 5, 5>::Zero();
  Eigen::Matrix<double, 5, 1> b = Eigen::Matrix<double, 5, 1>::Zero();
  const Eigen::Matrix4d flexible = planet.pin_compliance;
  a(0, 0) = 2.0 * k;
  a(0, 1) = a(0, 2) = -k;
  b[0] = load.y() - 2.0 * (f0 - k * d0);
  for (int i = 0; i < 4; ++i) {
    a(1 + i, 1 + i) += 1.0;
    for (int j = 0; j < 2; ++j) {  // F_j = f0 - k d0 + k u - k p_j,  M_j = -c p'_j
      a(1 + i, 0) -= flexible(i, j) * k;
      a(1 + i, 1 + j) += flexible(i, j) * k;
      a(1 + i, 3 + j) += flexible(i, 2 + j) * c;
      b[1 + i] += flexible(i, j) * (f0 - k * d0);
    }
  }
  const Eigen::Matrix<double, 5, 1> x = mechanics::solution(a, b);
  const double at_wall = f0 + k * (x[0] - x[1] - d0), far = f0 + k * (x[0] - x[2] - d0);
  EXPECT_GT(at_wall, 1.05 * far);
  EXPECT_NEAR(force_of(state.bearings[0]).norm() / at_wall, 1.0, 0.02);
  EXPECT_NEAR(force_of(state.bearings[1]).norm() / far, 1.0, 0.02);
}

// Bearings on the rigid sleeve of a flexpin move together, however many they are: each carries its part as
// one bearing alone does, and the sleeve follows by L^3/(12 E I) and shear without inclining.
TEST(PlanetOnPin, FlexpinCarriesAnyNumberOfBearingsAlike) {
  const PinBeam pin{.diameter = 0.015, .span = 0.035, .ends = PinEnds::flexpin};
  const double compliance = pin_compliance(pin, {0.0})(0, 0);  // pin_beam_test has its closed form
  for (const std::vector<double>& position :
       {std::vector<double>{0.0}, {-kPosition, kPosition}, {-0.02, 0.0, 0.02}}) {
    const Vector2d load = static_cast<double>(position.size()) * Vector2d(640.0, 1060.0);
    PlanetOnPin planet{.position = position, .pin_compliance = pin_compliance(pin, position)};
    for (std::size_t k = 0; k < position.size(); ++k) planet.bearings.emplace_back(cut_bearing());
    const PlanetOnPinState state = planet_on_pin(planet, loaded(load), kNone, {}, 0.1);
    ASSERT_TRUE(state.report.converged) << state.report.message;
    const QuasiStaticState alone =
        quasi_static_state(planet.bearings[0], loaded(load / static_cast<double>(position.size())), {}, 0.1);
    for (const QuasiStaticState& one : state.bearings)
      EXPECT_LT((one.displacement - alone.displacement).norm(), 1e-6 * alone.displacement.norm());
    EXPECT_LT(state.tilt.norm(), 1e-9);
    // Rollers and cages press on the pin besides the load.
    Vector2d on_pin = kNone;
    for (const QuasiStaticState& one : state.bearings) on_pin += force_of(one);
    EXPECT_LT((state.displacement - alone.displacement + compliance * on_pin).norm(),
              1e-6 * compliance * load.norm());
    EXPECT_TRUE(state.compliance.allFinite());
  }
}

// A moment inclines the sleeve by M L/(E I), and all bearings with it.
TEST(PlanetOnPin, FlexpinInclinesUnderAMoment) {
  const PinBeam pin{.diameter = 0.015, .span = 0.035, .ends = PinEnds::flexpin};
  PlanetOnPin planet = two_bearings(pin);
  const Vector2d moment(0.5, -1.5);
  const PlanetOnPinState state = planet_on_pin(planet, loaded({900.0, 2100.0}), moment, {}, 0.1);
  ASSERT_TRUE(state.report.converged) << state.report.message;
  const double angular = pin_compliance(pin, {0.0})(1, 1);  // L/(E I)
  Vector2d from_cages = kNone;
  for (std::size_t k = 0; k < 2; ++k)
    from_cages +=
        planet.position[k] * load_through_cage(planet.bearings[k].bearing(), planet.bearings[k].geometry(),
                                               loaded(kNone).carrier, {});
  for (const Vector2d& bearing : state.bearing_tilt)
    EXPECT_LT((state.tilt - bearing - angular * (moment + from_cages)).norm(),
              1e-6 * angular * moment.norm());
}

// A pin that is no number ends as a planet without equilibrium, reported without NaN.
TEST(PlanetOnPin, LeavesNoNaN) {
  PlanetOnPin planet = two_bearings(stiff_pin());
  planet.pin_compliance.setConstant(std::numeric_limits<double>::quiet_NaN());
  const PlanetOnPinState state = planet_on_pin(planet, loaded({900.0, 2100.0}), kNone, {}, 0.1);
  EXPECT_FALSE(state.report.converged);
  EXPECT_FALSE(std::isnan(state.report.residual));
  EXPECT_SAID("planet on a pin that is no number", state.report.message);
}

// An inclined pin takes a free planet with it: nothing changes but the planet's tilt. Held by its meshes it
// does not follow.
TEST(PlanetOnPin, InclinedPinIsFeltWhereTheMeshesHoldThePlanet) {
  const Vector2d load(0.0, 2400.0), inclined(0.0, 20e-6 / 0.035);  // 20 um over the span
  PlanetOnPin planet = two_bearings(stiff_pin());
  const PlanetOnPinState straight = planet_on_pin(planet, loaded(load), kNone, {}, 0.0);
  planet.pin_inclination.assign(2, inclined);
  planet.pin_error = {-kPosition * inclined, kPosition * inclined};
  const PlanetOnPinState follows = planet_on_pin(planet, loaded(load), kNone, {}, 0.0);
  EXPECT_LT((follows.tilt - inclined).norm(), 1e-6 * inclined.norm());
  EXPECT_NEAR(force_of(follows.bearings[0]).norm(), force_of(straight.bearings[0]).norm(), 1e-3);
  // Held: the moment k t of the meshes against that of two springs at +-kPlace and of the rollers' own.
  planet.tilt_stiffness = 5e2 * Eigen::Matrix2d::Identity();
  const PlanetOnPinState held = planet_on_pin(planet, loaded(load), kNone, {}, 0.0);
  const LaminaBearing one(cut_bearing());
  const Eigen::Matrix4d slope = stiffness_at(one, quasi_static_state(one, loaded(0.5 * load), {}, 0.0));
  const double bearings = 2.0 * (slope(1, 1) * kPosition * kPosition + slope(3, 3));
  const double tilt = inclined.y() * bearings / (bearings + 5e2);
  const double difference = slope(1, 1) * kPosition * (tilt - inclined.y());
  EXPECT_NEAR(held.tilt.y() / tilt, 1.0, 0.02);
  EXPECT_NEAR(force_of(held.bearings[0]).norm(), 0.5 * load.y() - difference, 0.02 * 0.5 * load.y());
  EXPECT_NEAR(force_of(held.bearings[1]).norm(), 0.5 * load.y() + difference, 0.02 * 0.5 * load.y());
}

}  // namespace
}  // namespace orbearing::bearing::laminae::planet_on_pin_test
