// A driven bearing in time: against the free bearing whose bore it follows, its order, its energy.
#include <gtest/gtest.h>

#include "bearing/motion/driven_start.hpp"
#include "bearing/motion/vector_bearing.hpp"
#include "coupling/integration/integrate.hpp"
#include "coupling/integration/rosenbrock2.hpp"
#include "coupling/integration/window.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "coupling/system/driven_system.hpp"
#include "tests/unit/cosim/driven_reducer.hpp"

namespace orbearing::system::cosim_driven_bearing_test {
namespace {

using bearing::motion::BearingModel;
using bearing::motion::BoreMotion;

// Cubic through places and velocities at both ends; its slope as velocity.
void join(double h, double from, double v_from, double to, double v_to, InputPolynomial& position,
          InputPolynomial& velocity) {
  const double mean = (to - from) / h;
  const double c2 = (3.0 * mean - 2.0 * v_from - v_to) / h, c3 = (v_from + v_to - 2.0 * mean) / (h * h);
  position = {{from, v_from, c2, c3}};
  velocity = {{v_from, 2.0 * c2, 3.0 * c3, 0.0}};
}

// The free bearing at tight tolerance records the path of its bore; a driven one follows it.
TEST(DrivenBearingPath, FollowsTheFreeBearing) {
  const DrivenBearingSetup setup = [] {
    DrivenBearingSetup s = test::driven_reducer();
    s.allowed_length_error = 1e-14;
    return s;
  }();
  bearing::OperatingPoint point = test::reducer_point(6000.0);
  const BearingModel model = bearing_model(setup.bearing, point, setup.dynamics);
  BoreMotion motion = test::pressed_motion();
  Eigen::VectorXd x = driven_start(setup.bearing, model, setup.dynamics, motion, setup.first_roller);
  DrivenBearing driven(setup);
  driven.initialize(motion);

  constexpr double kStep = 0.5e-6;  // [s]
  constexpr long kSteps = 600;      // 0.3 ms
  bearing::vectorised::VectorBearing equations(model);
  integration::IntegrationOptions options;
  options.step = 1e-8;
  options.allowed_error = allowed_errors(model, 1e-15);
  const auto derivative = [&](double t, const Eigen::Ref<const Eigen::VectorXd>& state,
                              Eigen::Ref<Eigen::VectorXd> rate) { equations.derivative(t, state, rate); };
  const Eigen::Index bore = model.layout.bore();
  Eigen::VectorXd before = x;
  double worst = 0.0, largest = 0.0;
  const auto observe = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& now) {
    BoreInputs inputs = test::constant_polynomial(motion);
    join(kStep, before[bore], before[bore + 2], now[bore], now[bore + 2], inputs.x, inputs.v_x);
    join(kStep, before[bore + 1], before[bore + 3], now[bore + 1], now[bore + 3], inputs.y, inputs.v_y);
    driven.advance({time - kStep, time}, inputs);
    BoreMotion here = inputs.at(kStep);
    here.angle = point.outer_speed * time;
    const Eigen::Vector2d expected = driven_snapshot(model, here, now).on_bore.force;
    worst = std::max(worst, (driven.reaction(here).force - expected).norm());
    largest = std::max(largest, expected.norm());
    before = now;
  };
  const auto report = integration::integrate(derivative, x, {0.0, kStep, kSteps}, options, observe);
  ASSERT_TRUE(report.completed) << report.message;
  EXPECT_GT((x.segment<2>(bore) - motion.position).norm(), 1e-6) << "the bore has moved [m]";
  RecordProperty("worst_share", std::to_string(worst / largest));
  EXPECT_LT(worst, 3e-4 * largest);  // found 3e-5
}

// Fixed steps on a path without touch-downs: halving them quarters the error.
TEST(DrivenBearingPath, HasOrderTwo) {
  const DrivenBearingSetup setup = test::driven_reducer();
  const BearingModel model = system::driven_model(setup);
  const BoreMotion about = test::pressed_motion();
  const BoreInputs inputs = test::swinging_polynomial(about, 0.5e-6, 1e4, 0.0);
  bearing::vectorised::VectorBearing vectorised(model);
  constexpr double kLength = 16e-6;  // [s]
  const auto end_state = [&](int steps) {
    const double h = kLength / steps;
    std::vector<double> x =
        vectorised.padded(driven_start(setup.bearing, model, setup.dynamics, inputs.at(0.0), 0.3));
    integration::Rosenbrock2 stepper(std::vector<double>(x.size(), 0.0), h);
    LoadsAtStep loads(setup.bearing.rollers().count);
    DrivenSystem system(vectorised, inputs, {}, loads);
    double step = h;
    integration::through_window(stepper, system, x, kLength, {}, step);
    Eigen::VectorXd flat(model.layout.size());
    vectorised.flatten(x.data(), flat);
    return flat;
  };
  const Eigen::VectorXd scale = allowed_errors(model, 1.0).cwiseInverse();
  const Eigen::VectorXd exact = end_state(4096);
  std::vector<double> errors;
  for (const int steps : {32, 64, 128, 256})
    errors.push_back((end_state(steps) - exact).cwiseProduct(scale).norm());
  for (std::size_t i = 1; i < errors.size(); ++i) {
    const double order = std::log2(errors[i - 1] / errors[i]);
    RecordProperty("order_" + std::to_string(i), std::to_string(order));
    EXPECT_GT(order, 1.8);
    EXPECT_LT(order, 2.3);
  }
}

}  // namespace
}  // namespace orbearing::system::cosim_driven_bearing_test
