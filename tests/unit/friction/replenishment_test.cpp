// Inlets of rollers limited by the balance of their oil; starvation by SKF's factor; oil heated by its
// friction.
#include "bearing/friction/replenishment.hpp"

#include <gtest/gtest.h>

#include <Eigen/Sparse>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/bessel_prime.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "bearing/friction/oil_supply.hpp"
#include "bearing/friction/published_torque.hpp"
#include "bearing/friction/rolling_friction.hpp"
#include "bearing/motion/balls/mixture.hpp"
#include "coupling/system/heated_balls.hpp"
#include "tests/messages.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::friction::replenishment_test {
namespace {

constexpr double kPrinted = 5e-5;  // of 0.0932

// The mean of two sums of an alternating series, twice.
TEST(EndFlow, IsTheSeries) {
  double sum = 0.0, before = 0.0, mean = 0.0, both = 0.0;
  for (int n = 1; n <= 400; ++n) {
    const double k = boost::math::cyl_bessel_j_zero(2.5, n), j = boost::math::cyl_bessel_j(3.5, k);
    before = sum;
    sum += 2.0 * (std::sqrt(2.0 / M_PI) * std::sqrt(k) / 3.0 + j / k) / (k * k * j);
    both = 0.5 * (mean + 0.5 * (sum + before));
    mean = 0.5 * (sum + before);
  }
  EXPECT_NEAR(both, kEndFlow, kPrinted);
}

// (x^6 p_x)_x + x^6 p_yy = -x between the contact and x = 1, p = 0 at x = 1 and y = 0, nothing through y = 4:
// finite volumes of p x^3, cells that widen from the end.
TEST(EndFlow, IsThatOfReynoldsEquation) {
  constexpr int nx = 60, ny = 50;
  const double dx = 1.0 / nx;
  const auto end = [](int j) { return 4.0 * std::sinh(6.0 * j / ny) / std::sinh(6.0); };
  const auto middle = [&](int j) { return 0.5 * (end(j) + end(j + 1)); };
  const auto x = [&](int i) { return (i + 0.5) * dx; };
  std::vector<Eigen::Triplet<double>> terms;
  Eigen::VectorXd right(nx * ny);
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j) {
      const int here = i * ny + j;
      const double width = end(j + 1) - end(j);
      const auto to = [&](int other, double conductance, double scale) {
        terms.emplace_back(here, here, conductance / std::pow(x(i), 3.0));
        if (other >= 0) terms.emplace_back(here, other, -conductance / std::pow(scale, 3.0));
      };
      if (i > 0) to(here - ny, std::pow(i * dx, 6.0) * width / dx, x(i - 1));
      if (i < nx - 1)
        to(here + ny, std::pow((i + 1) * dx, 6.0) * width / dx, x(i + 1));
      else
        to(-1, 2.0 * width / dx, 1.0);
      const double across = std::pow(x(i), 6.0) * dx;
      to(j > 0 ? here - 1 : -1, across / (j > 0 ? middle(j) - middle(j - 1) : middle(0)), x(i));
      if (j < ny - 1) to(here + 1, across / (middle(j + 1) - middle(j)), x(i));
      right[here] = x(i) * dx * width;
    }
  Eigen::SparseMatrix<double> system(nx * ny, nx * ny);
  system.setFromTriplets(terms.begin(), terms.end());
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(system);
  const Eigen::VectorXd scaled = factors.solve(right);
  double flow = 0.0;
  for (int i = 0; i < nx; ++i) flow += std::pow(x(i), 3.0) * scaled[i * ny] / middle(0) * dx;
  EXPECT_NEAR(flow, kEndFlow, 2e-3 * kEndFlow);  // of second order in 1/60
}

TEST(InletLength, LetsAsMuchLeaveAsReturns) {
  const double radius = 3e-3, length = 8e-3, returned = 2e-6, speed = 15.0;
  const double begin = inlet_length(radius, length, returned);
  EXPECT_NEAR(2.0 * kEndFlow * speed * std::pow(begin, 3.0) / radius, returned * speed * length, 1e-18);
}

struct Turning {
  Bearing bearing = example_bearings::planet_bearing();
  BearingGeometry geometry = geometry_of(bearing);
  equilibrium::RingSpeeds speeds{900.0, 0.0};
  double cage = kinematic_cage_speed(geometry, 900.0, 0.0);
  double share = 0.05, density = 0.05 * 850.0;
  balls::DragNumbers drag{
      .churning = 0.5 * 0.05 * density * std::pow(geometry.element_radius, 4.0) * bearing.rollers().length,
      .mixture = {.carried = true,
                  .inner_radius = geometry.inner_radius,
                  .outer_radius = geometry.outer_radius,
                  .width = 10e-3,
                  .density = density,
                  .viscosity = 1e-5,
                  .share = 0.7}};

  double returned(Race race) const { return returned_oil(bearing, geometry, race, speeds, drag, share); }
};

// share c R/4 with the coefficient c of the churning, at any speed.
TEST(ReturnedOil, OfRollersIsByTheirChurning) {
  Turning turning;
  turning.drag.mixture.viscosity = 0.0;  // walls that drag nothing
  const double expected = 0.05 * 0.05 * turning.geometry.element_radius / 4.0;
  EXPECT_NEAR(turning.returned(Race::inner), expected, 1e-12 * expected);
  EXPECT_NEAR(turning.returned(Race::outer), expected, 1e-12 * expected);
  turning.speeds = {90.0, 0.0};
  EXPECT_NEAR(turning.returned(Race::outer), expected, 1e-12 * expected);
}

// The oil that returns to a race in the time of one turn past the rollers has the momentum that its wall
// takes.
TEST(ReturnedOil, OfRacesHasTheMomentumOfTheirDrag) {
  Turning turning;
  turning.drag.churning = 0.0;
  for (const Race race : {Race::inner, Race::outer}) {
    const bool inner = race == Race::inner;
    const double radius = inner ? turning.geometry.inner_radius : turning.geometry.outer_radius;
    const double ring = inner ? 900.0 : 0.0, difference = ring - 0.7 * turning.cage;
    const double torque = std::abs(balls::wall_torque(turning.drag.mixture, radius, difference));
    const double per_time = turning.returned(race) * 15 * std::abs(ring - turning.cage) / (2.0 * M_PI) * 2.0 *
                            M_PI * radius * 10e-3 * 850.0;  // [kg/s]
    EXPECT_NEAR(per_time * radius * std::abs(radius * difference), torque, 1e-9 * torque);
  }
}

TEST(ReturnedOil, IsNoneWhereNothingPasses) {
  Turning turning;
  turning.speeds = {900.0, 900.0};
  EXPECT_EQ(turning.returned(Race::inner), 0.0);
}

struct Lossy {
  Bearing bearing = example_bearings::planet_bearing();
  Eigen::ArrayXd loads = Eigen::ArrayXd::Constant(15, 300.0);
  Lubricant oil{.viscosity = 0.01, .pressure_viscosity = 1.5e-8};

  RollingFriction with(const Inlets& inlets, const RollerMixture& mixture = {}) const {
    return roller_friction(bearing, loads, {900.0, 0.0}, oil, inlets, mixture);
  }
};

TEST(ReplenishedRollers, ResistMoreTheMoreOilReturns) {
  const Lossy rollers;
  double before = 0.0;
  for (const double share : {1e-12, 1e-4, 0.01, 0.05, 0.3}) {
    const RollingFriction loss = rollers.with({.end = InletEnd::replenished}, {.oil_share = share});
    EXPECT_GT(loss.rolling, before);
    EXPECT_LT(loss.rolling, loss.flooded_rolling);
    before = loss.rolling;
  }
  EXPECT_LT(rollers.with({.end = InletEnd::replenished}, {.oil_share = 1e-12}).rolling, 0.01 * before);
}

// All races and rollers equal: ln of the remaining share is as 1/X, so as the third root of the share of oil.
TEST(ReplenishedRollers, LoseByTheThirdRootOfTheOil) {
  const Lossy rollers;
  const auto far = [&](double share) {
    const RollingFriction loss = rollers.with({.end = InletEnd::replenished}, {.oil_share = share});
    return 1.0 - loss.rolling / loss.flooded_rolling;
  };
  EXPECT_NEAR(far(0.2) / far(0.4), std::cbrt(2.0), 0.03);  // of exp(-x) over 1 - x
}

TEST(StarvedRollers, LoseTheFactorOfTheRollingPartAlone) {
  const Lossy rollers;
  const RollingFriction full = rollers.with({.end = InletEnd::layer});
  const RollingFriction starved = rollers.with({.end = InletEnd::layer, .starvation = 0.8});
  EXPECT_DOUBLE_EQ(starved.rolling, 0.8 * full.rolling);
  EXPECT_EQ(starved.flooded_rolling, full.flooded_rolling);
  EXPECT_EQ(starved.drag, full.drag);
}

TEST(RollerMixture, IsHeldBackByOilThatFlowsThrough) {
  const Lossy rollers;
  EXPECT_GT(rollers.with({}, {.flow = 2e-5}).drag, rollers.with({}).drag);
}

TEST(OilSupply, OfRollersInMotionIsSkfsFactor) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.inner.seat_diameter = 25e-3;
  bearing.outer.seat_diameter = 50e-3;
  motion::DynamicsParameters given;
  EXPECT_EQ(supplied(bearing, given, 900.0).race.rolling_share, 1.0);
  given.race.starvation = motion::Starvation::skf;
  const TorqueCondition at{.speed = 900.0, .viscosity = given.lubricant.viscosity / given.drag.oil_density};
  const double caged = bearing.has_cage() ? 5.1 : 6.2;
  EXPECT_DOUBLE_EQ(supplied(bearing, given, 900.0).race.rolling_share,
                   starvation_factor(25e-3, 50e-3, caged, at));
  bearing.cage.width = 0.0;
  EXPECT_DOUBLE_EQ(supplied(bearing, given, 900.0).race.rolling_share,
                   starvation_factor(25e-3, 50e-3, 6.2, at));
  given.race.starvation = motion::Starvation::replenished;
  EXPECT_REFUSED(std::invalid_argument, "oil_supply starvation", supplied(bearing, given, 900.0));
}

// Power that falls in proportion: W = W_0 (1 - a (T - T_in)).
TEST(BalancedOutlet, IsWhereTheOilTakesTheHeat) {
  system::HeatParameters heat;
  heat.inlet = 50.0;
  const double flow = 1e-5, at_inlet = 500.0, slope = 0.01, warming = at_inlet / (1.7e6 * flow);
  const double outlet =
      balanced_outlet(heat, flow, [&](double t) { return at_inlet * (1.0 - slope * (t - 50.0)); });
  EXPECT_NEAR(outlet, 50.0 + warming / (1.0 + slope * warming), 1e-9);
  EXPECT_EQ(balanced_outlet(heat, flow, [](double) { return 0.0; }), 50.0);
  EXPECT_REFUSED(std::domain_error, "balanced_outlet hot",
                 balanced_outlet(heat, flow, [](double) { return 2000.0; }));
  EXPECT_REFUSED(std::invalid_argument, "balanced_outlet flow",
                 balanced_outlet(heat, 0.0, [](double) { return 500.0; }));
}

}  // namespace
}  // namespace orbearing::bearing::friction::replenishment_test
