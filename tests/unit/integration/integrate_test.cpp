#include "coupling/integration/integrate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/messages.hpp"

namespace orbearing::integration::integrate_test {
namespace {

// x'' = -x from (1, 0): x = cos t.
void oscillator(double, const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> dx) {
  dx[0] = x[1];
  dx[1] = -x[0];
}

double error_at_one(const IntegrationOptions& options) {
  Eigen::VectorXd x = Eigen::Vector2d(1.0, 0.0);
  const IntegrationReport report = integrate(oscillator, x, {0.0, 0.5, 2}, options, {});
  EXPECT_TRUE(report.completed) << report.message;
  return std::hypot(x[0] - std::cos(1.0), x[1] + std::sin(1.0));
}

double observed_order(Method method) {
  IntegrationOptions coarse{.method = method, .allowed_error = {}, .step = 1.0 / 8.0};
  IntegrationOptions fine = coarse;
  fine.step = coarse.step / 2.0;
  return std::log2(error_at_one(coarse) / error_at_one(fine));
}

constexpr double kOrderMargin = 0.25;  // the next term of the error at steps of 1/8 and 1/16 period units

TEST(Integrate, ConvergesAtTheOrderOfTheMethod) {
  EXPECT_NEAR(observed_order(Method::rk4), 4.0, kOrderMargin);
  EXPECT_NEAR(observed_order(Method::fixed_dopri5), 5.0, 2.0 * kOrderMargin);
}

TEST(Integrate, ControlledStepsKeepToTheAllowedError) {
  for (double allowed : {1e-4, 1e-7, 1e-10}) {
    IntegrationOptions options{.allowed_error = Eigen::Vector2d::Constant(allowed), .step = 1e-3};
    Eigen::VectorXd x = Eigen::Vector2d(1.0, 0.0);
    const IntegrationReport report = integrate(oscillator, x, {0.0, 0.1, 10}, options, {});
    // Steps of the oscillator cannot add up to more than their number times what one may have.
    EXPECT_LT(std::abs(x[0] - std::cos(1.0)), static_cast<double>(report.steps) * allowed);
    EXPECT_GT(report.steps, 1);
    EXPECT_GE(report.rhs_calls, 6 * report.steps);
  }
}

TEST(Integrate, SamplesAtUniformTimes) {
  IntegrationOptions options{.allowed_error = Eigen::Vector2d::Constant(1e-10), .step = 1e-3};
  Eigen::VectorXd x = Eigen::Vector2d(1.0, 0.0);
  long count = 0;
  integrate(oscillator, x, {2.0, 0.037, 50}, options, [&](double time, const auto& state) {
    ++count;
    EXPECT_DOUBLE_EQ(time, 2.0 + 0.037 * static_cast<double>(count));
    EXPECT_NEAR(state[0], std::cos(time - 2.0), 1e-7);
  });
  EXPECT_EQ(count, 50);
}

TEST(Integrate, EndsWithAMessageWhereTheRateIsNotFinite) {
  const auto breaks = [](double time, const Eigen::Ref<const Eigen::VectorXd>&,
                         Eigen::Ref<Eigen::VectorXd> dx) {
    dx.setConstant(time > 0.5 ? std::numeric_limits<double>::quiet_NaN() : 1.0);
  };
  for (Method method : {Method::dopri5, Method::fixed_dopri5, Method::rk4}) {
    IntegrationOptions options{
        .method = method, .allowed_error = Eigen::Vector2d::Constant(1e-6), .step = 1e-2};
    Eigen::VectorXd x = Eigen::Vector2d::Zero();
    const IntegrationReport report = integrate(breaks, x, {0.0, 0.1, 10}, options, {});
    EXPECT_FALSE(report.completed);
    EXPECT_SAID("rate not finite", report.message);
    EXPECT_TRUE(x.allFinite()) << "the last good state stays";
  }
}

TEST(Integrate, EndsWhenTheStepsAreUsedUp) {
  IntegrationOptions options{.method = Method::rk4, .allowed_error = {}, .step = 1e-3, .most_steps = 100};
  Eigen::VectorXd x = Eigen::Vector2d(1.0, 0.0);
  const IntegrationReport report = integrate(oscillator, x, {0.0, 1.0, 1}, options, {});
  EXPECT_FALSE(report.completed);
  EXPECT_LE(report.steps, 101);
  EXPECT_SAID("steps used up", report.message);
  options.most_steps = 1000;
  options.smallest_step = 2e-3;
  x = Eigen::Vector2d(1.0, 0.0);
  EXPECT_SAID("step too small", integrate(oscillator, x, {0.0, 1.0, 1}, options, {}).message);
  options.most_seconds = -1.0;
  options.smallest_step = 0.0;
  x = Eigen::Vector2d(1.0, 0.0);
  EXPECT_SAID("time used up", integrate(oscillator, x, {0.0, 1.0, 1}, options, {}).message);
}

TEST(Integrate, RefusesAStateThatIsNotFinite) {
  Eigen::VectorXd x = Eigen::Vector2d(std::nan(""), 0.0);
  IntegrationOptions options{.allowed_error = Eigen::Vector2d::Ones()};
  const IntegrationReport report = integrate(oscillator, x, {0.0, 1.0, 1}, options, {});
  EXPECT_FALSE(report.completed);
  EXPECT_SAID("state not finite", report.message);
  options.method = Method::linearly_implicit;
  x.setOnes();
  EXPECT_REFUSED(std::invalid_argument, "implicit steps",
                 integrate(oscillator, x, {0.0, 1.0, 1}, options, {}));
}

}  // namespace
}  // namespace orbearing::integration::integrate_test
