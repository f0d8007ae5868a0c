// An integrator from elsewhere on the same equations: SUNDIALS CVODE against our Dormand-Prince runs. It
// shares neither formula nor code with ours, so what both agree on is the equations' doing.
#include <gtest/gtest.h>

#ifdef ORBEARING_HAS_CVODE

#include <cmath>

#include "bearing/motion/initial_state.hpp"
#include "bearing/motion/snapshot.hpp"
#include "bearing/motion/vector_bearing.hpp"
#include "benchmarks/cvode.hpp"
#include "coupling/integration/integrate.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bench::cvode_test {
namespace {

// x' = -1000 (x - cos t) - sin t, x(0) = 1: x = cos t whatever the stiffness.
TEST(Cvode, FollowsAStiffCosine) {
  Eigen::VectorXd x = Eigen::VectorXd::Ones(1);
  const auto rate = [](double t, const double* at, double* dx) {
    dx[0] = -1000.0 * (at[0] - std::cos(t)) - std::sin(t);
  };
  long seen = 0;
  const CvodeReport report =
      run_cvode(rate, x, 2.0, 20, Eigen::VectorXd::Constant(1, 1e-9), 5, [&](double t, const double* at) {
        EXPECT_NEAR(at[0], std::cos(t), 1e-6);
        ++seen;
      });
  EXPECT_EQ(seen, 20);
  EXPECT_GE(report.end_time, 2.0);
  EXPECT_LT(report.steps,
            2000);  // an explicit method needs 1000 / 2 a second to be stable, and Jacobians none
  EXPECT_GT(report.jacobians, 0);
}

// Paths of the bearing part company within a millisecond; over 0.3 ms they can be compared.
constexpr double kPath = 0.3e-3;          // [s]
constexpr long kSamples = 30;             // [-]
constexpr double kAllowedLength = 1e-13;  // [m]  of one step
// Tolerance over the largest load: a thousand steps, each off by the allowed length, over approaches of
// micrometres.
constexpr double kLoadAgreement = 1e-4;

class CvodeBearing : public testing::Test {
 protected:
  CvodeBearing()
      : equations(bearing_model(bearing, point, parameters)),
        start(initial_state(bearing, equations.model(), parameters, 0.3).x),
        allowed(system::allowed_errors(equations.model().layout, kAllowedLength,
                                       equations.model().geometry.pitch_radius, 1e5)) {}

  Eigen::ArrayXXd loads_by_dopri5() {
    Eigen::ArrayXXd loads(bearing.rollers().count, kSamples);
    Eigen::VectorXd x = start;
    Eigen::Index column = 0;
    const auto report = integration::integrate(
        [&](double t, const auto& at, auto dx) { equations.derivative(t, at, dx); }, x,
        {0.0, kPath / kSamples, kSamples}, {.allowed_error = allowed},
        [&](double, const auto& at) { loads.col(column++) = snapshot(equations.model(), at).inner.load; });
    EXPECT_TRUE(report.completed) << report.message;
    return loads;
  }

  Eigen::ArrayXXd loads_by_cvode() {
    const Eigen::Index size = start.size();
    using In = Eigen::Map<const Eigen::VectorXd>;
    using Out = Eigen::Map<Eigen::VectorXd>;
    Eigen::ArrayXXd loads(bearing.rollers().count, kSamples);
    Eigen::VectorXd x = start;
    Eigen::Index column = 0;
    run_cvode(
        [&](double t, const double* at, double* dx) { equations.derivative(t, In(at, size), Out(dx, size)); },
        x, kPath, kSamples, allowed, 5,
        [&](double, const double* at) {
          loads.col(column++) = snapshot(equations.model(), In(at, size)).inner.load;
        });
    return loads;
  }

  bearing::Bearing bearing = test::reducer_bearing();
  bearing::OperatingPoint point = test::reducer_point(6000.0);
  bearing::motion::DynamicsParameters parameters = film_on();
  bearing::vectorised::VectorBearing equations;
  Eigen::VectorXd start;
  Eigen::VectorXd allowed;

 private:
  static bearing::motion::DynamicsParameters film_on() {
    bearing::motion::DynamicsParameters parameters = test::reducer_parameters();
    parameters.race.film_in_approach = true;
    return parameters;
  }
};

TEST_F(CvodeBearing, TakesThePathOfDopri5) {
  const Eigen::ArrayXXd expected = loads_by_dopri5();
  const Eigen::ArrayXXd found = loads_by_cvode();
  const double largest = expected.maxCoeff();
  ASSERT_GT(largest, 0.0);
  EXPECT_LT((found - expected).abs().maxCoeff(), kLoadAgreement * largest);
  RecordProperty("largest_load_difference", std::to_string((found - expected).abs().maxCoeff() / largest));
  const auto rms = [](const Eigen::ArrayXXd& loads) { return std::sqrt(loads.square().mean()); };
  EXPECT_NEAR(rms(found), rms(expected), kLoadAgreement * rms(expected));
}

}  // namespace
}  // namespace orbearing::bench::cvode_test

#else

TEST(Cvode, NeedsSundials) {
  GTEST_SKIP() << "SUNDIALS (libsundials-dev) was not found when this build was configured";
}

#endif
