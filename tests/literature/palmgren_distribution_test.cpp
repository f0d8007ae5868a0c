// Largest roller load of a radially loaded roller bearing without clearance: 4.08 F/Z for many rollers,
// chapter on load distribution of [Harris2006].
#include <gtest/gtest.h>

#include <cmath>

#include "bearing/equilibrium/quasi_static.hpp"
#include "mechanics/constants.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::palmgren_distribution_test {
namespace {

constexpr double kPublished = 0.005;  // half a unit of the last digit of 4.08

// 1/J with J = (1/2 pi) integral of cos^(10/9 + 1) over the loaded half = Gamma(p) / (2 sqrt(pi) Gamma(p +
// 1/2)), p = (10/9 + 2) / 2.
double integral_of_many_rollers() {
  const double p = 0.5 * (10.0 / 9.0 + 2.0);
  return 2.0 * std::sqrt(constants::pi) * std::tgamma(p + 0.5) / std::tgamma(p);
}

double largest_share(int rollers) {
  Bearing bearing = example_bearings::bearing_209();
  bearing.rollers().count = rollers;
  const QuasiStaticState state = quasi_static_state(bearing, example_bearings::static_load(-4450.0), {}, 0.0);
  EXPECT_TRUE(state.report.converged) << state.report.message;
  return state.outer_load.maxCoeff() * rollers / 4450.0;
}

TEST(PalmgrenDistribution, ManyRollersShareAsPublished) {
  EXPECT_NEAR(integral_of_many_rollers(), 4.08, kPublished);
  EXPECT_NEAR(largest_share(1000), 4.08, kPublished);
}

// The sum over Z rollers is the trapezoidal rule of the integral; cos^(19/9) has a kink of that order at the
// edge of the load zone, so that the error falls with at least the pitch squared.
TEST(PalmgrenDistribution, ConvergesToTheIntegral) {
  for (const int rollers : {20, 40, 80, 160, 1000}) {
    const double pitch = 2.0 * constants::pi / rollers;
    EXPECT_NEAR(largest_share(rollers) / integral_of_many_rollers(), 1.0, pitch * pitch)
        << rollers << " rollers";
  }
}

}  // namespace
}  // namespace orbearing::bearing::palmgren_distribution_test
