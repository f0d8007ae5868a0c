#include "coupling/integration/integrate_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/messages.hpp"

namespace orbearing::integration::integrate_pieces_test {
namespace {

using Eigen::VectorXd;

// x' = r x with r = 1 and 3 in turn, each for half a second: ln x grows by 2 in a second.
const RightHandSide kAlternating = [](double time, const Eigen::Ref<const VectorXd>& x,
                                      Eigen::Ref<VectorXd> dx) {
  dx = (std::fmod(time, 1.0) < 0.5 ? 1.0 : 3.0) * x;
};
double exact(double time) {
  const double part = std::fmod(time, 1.0);
  return std::exp(2.0 * std::floor(time) + (part < 0.5 ? part : 0.5 + 3.0 * (part - 0.5)));
}

IntegrationOptions options(double error) {
  IntegrationOptions out;
  out.allowed_error = VectorXd::Constant(1, error);
  out.step = 1e-2;
  return out;
}

const Jumps kHalfSeconds{.time = [](long i) { return 0.5 * static_cast<double>(i); }, .margin = 1e-9};

TEST(IntegratePieces, StepsEndAtTheJumps) {
  VectorXd x = VectorXd::Ones(1);
  double worst = 0.0;
  const auto observe = [&](double time, const Eigen::Ref<const VectorXd>& at) {
    worst = std::max(worst, std::abs(at[0] - exact(time)) / exact(time));
  };
  const IntegrationReport report =
      integrate_pieces(kAlternating, x, {0.0, 0.07, 50}, kHalfSeconds, options(1e-11), observe);
  EXPECT_TRUE(report.completed);
  EXPECT_LT(worst, 1e-8);  // some hundred steps of the allowed error, and dense output between them
  EXPECT_NEAR(x[0], exact(3.5), 1e-8 * exact(3.5));
}

TEST(IntegratePieces, CostsLessThanSteppingAcrossTheJumps) {
  VectorXd x = VectorXd::Ones(1), across = x;
  const OutputTimes output{0.0, 3.0, 1};
  const IntegrationReport pieces = integrate_pieces(kAlternating, x, output, kHalfSeconds, options(1e-9), {});
  const IntegrationReport blind = integrate(kAlternating, across, output, options(1e-9), {});
  EXPECT_LT(2 * pieces.rhs_calls, blind.rhs_calls);
}

TEST(IntegratePieces, GivesUpOnAStateThatIsNotFinite) {
  VectorXd x = VectorXd::Ones(1);
  const RightHandSide explodes = [](double, const Eigen::Ref<const VectorXd>& at, Eigen::Ref<VectorXd> dx) {
    dx = at.array().square().matrix() * 1e3;
  };
  const IntegrationReport report = integrate_pieces(explodes, x, {0.0, 1.0, 1}, {}, options(1e-9), {});
  EXPECT_FALSE(report.completed);
  EXPECT_SAID("pieces explode", report.message);
  x.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_SAID("pieces not finite",
              integrate_pieces(explodes, x, {0.0, 1.0, 1}, {}, options(1e-9), {}).message);
}

}  // namespace
}  // namespace orbearing::integration::integrate_pieces_test
