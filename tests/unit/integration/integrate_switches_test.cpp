#include "coupling/integration/integrate_switches.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace orbearing::integration::integrate_switches_test {
namespace {

using Eigen::VectorXd;
using ConstState = Eigen::Ref<const VectorXd>;

constexpr double kPi = 3.14159265358979324;

// A mass that swings over to a stiffer spring: w = 1 where x > 0 and 3 where x < 0. From x = 1 at rest,
//
//     x = cos t  up to pi/2, then  -sin(3 (t - pi/2))/3  for pi/3, then back up along sin: a period of pi +
//     pi/3.
double exact(double time) {
  const double t = std::fmod(time, 4.0 * kPi / 3.0);
  if (t < 0.5 * kPi) return std::cos(t);
  if (t < 0.5 * kPi + kPi / 3.0) return -std::sin(3.0 * (t - 0.5 * kPi)) / 3.0;
  return std::sin(t - 0.5 * kPi - kPi / 3.0);
}

struct Swinging {
  bool above = true;
  int switched = 0;

  void operator()(const ConstState& x, Eigen::Ref<VectorXd> dx) const {
    dx << x[1], -(above ? 1.0 : 9.0) * x[0];
  }
  Switches switches(double largest_step) {
    return {
        .count = 1,
        .values = [](double, const ConstState& x, Eigen::Ref<Eigen::ArrayXd> values) { values[0] = x[0]; },
        .set =
            [this](Eigen::Index, bool positive) {
              above = positive;
              ++switched;
            },
        .largest_step = largest_step};
  }
};

IntegrationOptions options(double error, double step) {
  IntegrationOptions out;
  out.allowed_error = VectorXd::Constant(2, error);
  out.step = step;
  return out;
}

double largest_error(double allowed, double largest_step) {
  Swinging swinging;
  VectorXd x(2);
  x << 1.0, 0.0;
  double worst = 0.0;
  const auto rates = [&](double, const ConstState& at, Eigen::Ref<VectorXd> dx) { swinging(at, dx); };
  const auto observe = [&](double time, const ConstState& at) {
    worst = std::max(worst, std::abs(at[0] - exact(time)));
  };
  const IntegrationReport report = integrate_switches(
      rates, x, {0.0, 0.05, 400}, swinging.switches(largest_step), options(allowed, largest_step), observe);
  EXPECT_TRUE(report.completed) << report.message;
  EXPECT_EQ(swinging.switched, 1 + 10);  // at the start, and twice a period
  return worst;
}

TEST(IntegrateSwitches, FollowsTheClosedForm) {
  EXPECT_LT(largest_error(1e-12, 0.1), 1e-10);  // some hundred steps of the allowed error
}

// The formula's own order, across the switches as well: half the step, an error of 2^5 less.
TEST(IntegrateSwitches, KeepsTheOrderOfTheFormula) {
  constexpr double any = 1.0;  // the step alone decides
  const double order = std::log2(largest_error(any, 0.1) / largest_error(any, 0.05));
  EXPECT_NEAR(order, 5.0, 0.6);
}

// Blind to the switch the same formula falls to an order of about two.
TEST(IntegrateSwitches, BlindStepsLoseIt) {
  const auto error = [](double step) {
    const auto rates = [](double, const ConstState& x, Eigen::Ref<VectorXd> dx) {
      dx << x[1], -(x[0] > 0.0 ? 1.0 : 9.0) * x[0];
    };
    VectorXd x(2);
    x << 1.0, 0.0;
    IntegrationOptions fixed = options(1.0, step);
    fixed.method = Method::fixed_dopri5;
    double worst = 0.0;
    integrate(rates, x, {0.0, 0.1, 200}, fixed, [&](double time, const ConstState& at) {
      worst = std::max(worst, std::abs(at[0] - exact(time)));
    });
    return worst;
  };
  EXPECT_LT(std::log2(error(0.1) / error(0.0125)) / 3.0, 3.5);
}

// Two switches at one instant, and one that comes back at once, end neither in a loop nor unseen.
TEST(IntegrateSwitches, SwitchesAtOneInstant) {
  VectorXd x = VectorXd::Zero(1);
  int calls = 0;
  const Switches switches{.count = 3,
                          .values =
                              [](double time, const ConstState&, Eigen::Ref<Eigen::ArrayXd> values) {
                                values << time - 0.5, 0.5 - time, (time - 0.5) * (time - 0.5) - 1e-20;
                              },
                          .set = [&](Eigen::Index, bool) { ++calls; },
                          .largest_step = 0.1};
  const auto rates = [](double, const ConstState&, Eigen::Ref<VectorXd> dx) { dx[0] = 1.0; };
  IntegrationOptions one = options(1e-9, 0.1);
  one.allowed_error = VectorXd::Constant(1, 1e-9);
  const IntegrationReport report = integrate_switches(rates, x, {0.0, 1.0, 1}, switches, one, {});
  EXPECT_TRUE(report.completed);
  EXPECT_NEAR(x[0], 1.0, 1e-12);
  EXPECT_GE(calls, 3 + 2);
  EXPECT_LE(calls, 3 + 4);
}

}  // namespace
}  // namespace orbearing::integration::integrate_switches_test
