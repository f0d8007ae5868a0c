// The linearly implicit steppers on equations whose solutions are known.
#include "coupling/integration/rosenbrock3.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace orbearing::integration::rosenbrock2_test {
namespace {

constexpr std::size_t kLanes = 8;  // the stepper asks for multiples of eight
using State = Rosenbrock2::state_type;

// x' = -2 t x^2: x = 1 / (c + t^2) with 1/c at the start. Neither linear nor free of time.
struct Hyperbola {
  std::array<double, kLanes> slope{}, divisor{};

  void derivative(double t, const double* x, double* dx) const {
    for (std::size_t i = 0; i < kLanes; ++i) dx[i] = -2.0 * t * x[i] * x[i];
  }
  void linearise(double t, const double* x, double* dx) {
    derivative(t, x, dx);
    for (std::size_t i = 0; i < kLanes; ++i) {
      slope[i] = -4.0 * t * x[i];
      by_time[i] = -2.0 * x[i] * x[i];
    }
  }
  void time_slope(double, double* dx) const { std::copy(by_time.begin(), by_time.end(), dx); }
  bool factor(double g) {
    for (std::size_t i = 0; i < kLanes; ++i) divisor[i] = 1.0 - g * slope[i];
    return true;
  }
  void solve(const double* rhs, double* k) const {
    for (std::size_t i = 0; i < kLanes; ++i) k[i] = rhs[i] / divisor[i];
  }

  std::array<double, kLanes> by_time{};
};

State starts() {
  State x;
  for (std::size_t i = 0; i < kLanes; ++i) x.push_back(1.0 / (1.0 + 0.25 * static_cast<double>(i)));
  return x;
}

double error_of(const State& x, double t) {
  double worst = 0.0;
  for (std::size_t i = 0; i < kLanes; ++i)
    worst = std::max(worst, std::abs(x[i] - 1.0 / (1.0 + 0.25 * static_cast<double>(i) + t * t)));
  return worst;
}

template <class Stepper>
double error_at_two(int steps) {
  Hyperbola system;
  Stepper stepper(State(kLanes, 0.0), 1.0);  // nothing is weighed: no step is refused
  State x = starts();
  double t = 0.0;
  for (int i = 0; i < steps; ++i) {
    double h = 2.0 * (i + 1) / steps - t;
    EXPECT_EQ(stepper.try_step(system, x, t, h), boost::numeric::odeint::success);
  }
  return error_of(x, 2.0);
}

TEST(Rosenbrock2, ConvergesAtOrderTwo) {
  constexpr double kMargin = 0.1;  // the term of next order, at steps of 1/100 and less
  for (int steps : {200, 400, 800})
    EXPECT_NEAR(std::log2(error_at_two<Rosenbrock2>(steps) / error_at_two<Rosenbrock2>(2 * steps)), 2.0,
                kMargin)
        << steps;
}

// Issue 17, Build 2: ROS3 of [Sandu1997].
TEST(Rosenbrock3, ConvergesAtOrderThree) {
  constexpr double kMargin = 0.1;
  for (int steps : {200, 400, 800})
    EXPECT_NEAR(std::log2(error_at_two<Rosenbrock3>(steps) / error_at_two<Rosenbrock3>(2 * steps)), 3.0,
                kMargin)
        << steps;
}

// Its estimate is the error of a step of order 2, that is of third power in the step.
TEST(Rosenbrock3, EstimatesTheErrorOfAStepOfOrderTwo) {
  const auto estimate = [](double h) {
    Hyperbola system;
    Rosenbrock3 stepper(State(kLanes, 1.0), 1.0);
    const State x = starts();
    stepper.begin(system, x, 0.3);
    return stepper.attempt(system, x, 0.3, h);
  };
  constexpr double kMargin = 0.1;
  for (const double h : {0.02, 0.01, 0.005})
    EXPECT_NEAR(std::log2(estimate(h) / estimate(0.5 * h)), 3.0, kMargin) << h;
}

// Steps that reach the allowed error at `order`, from a first one that is too long on purpose.
template <class Stepper>
void expect_controlled_steps(double order) {
  for (const double allowed : {1e-4, 1e-6, 1e-8}) {
    Hyperbola system;
    Stepper stepper(State(kLanes, allowed), 0.5);
    State x = starts();
    double t = 0.0, h = 0.4;
    int steps = 0, refused = 0;
    while (t < 2.0) {
      h = std::min(h, 2.0 - t);
      stepper.try_step(system, x, t, h) == boost::numeric::odeint::success ? ++steps : ++refused;
      ASSERT_LT(steps + refused, 1'000'000);
    }
    // Errors die out along this solution: they cannot add up to more than their number.
    EXPECT_LT(error_of(x, 2.0), steps * allowed);
    EXPECT_GT(refused, 0) << "the first step is too long on purpose";
    EXPECT_LT(steps, 10.0 * std::pow(allowed, -1.0 / order)) << "steps as long as the estimate allows";
  }
}

TEST(Rosenbrock2, ControlledStepsKeepToTheAllowedError) {
  expect_controlled_steps<Rosenbrock2>(2.0);
}

// Issue 17, Build 2.
TEST(Rosenbrock3, ControlledStepsKeepToTheAllowedError) {
  expect_controlled_steps<Rosenbrock3>(3.0);
}

// x' = -L (x - cos t) - sin t keeps to cos t however large L is.
struct StiffCosine {
  double decay;
  double divisor = 1.0;

  void derivative(double t, const double* x, double* dx) const {
    for (std::size_t i = 0; i < kLanes; ++i) dx[i] = -decay * (x[i] - std::cos(t)) - std::sin(t);
  }
  void linearise(double t, const double* x, double* dx) const { derivative(t, x, dx); }
  void time_slope(double t, double* dx) const {
    std::fill(dx, dx + kLanes, -decay * std::sin(t) - std::cos(t));
  }
  bool factor(double g) {
    divisor = 1.0 + g * decay;
    return true;
  }
  void solve(const double* rhs, double* k) const {
    for (std::size_t i = 0; i < kLanes; ++i) k[i] = rhs[i] / divisor;
  }
};

// The same equations, which leave what time does by itself out.
struct WithoutTimeSlope : private Hyperbola {
  using Hyperbola::derivative, Hyperbola::linearise, Hyperbola::factor, Hyperbola::solve;
};
struct WithZeroTimeSlope : Hyperbola {
  void time_slope(double, double* dx) const { std::fill_n(dx, kLanes, 0.0); }
};

// Issue 17, Build 5: a system need not say a slope by time that it leaves out: the same steps to the last bit.
TEST(Rosenbrock2, TakesNoTimeSlopeForZero) {
  const auto end = [](auto system) {
    Rosenbrock2 stepper(State(kLanes, 1e-5), 1.0);
    State x = starts();
    double t = 0.0, h = 0.01;
    while (t < 1.0) stepper.try_step(system, x, t, h);
    return x;
  };
  EXPECT_EQ(end(WithoutTimeSlope{}), end(WithZeroTimeSlope{}));
  EXPECT_NE(end(WithoutTimeSlope{}), end(Hyperbola{}));
}

// L-stable: one step, however long, takes away what is stiff. Of what lies off the curve it leaves, with z =
// -h L,
//   (1 + (1 - 2 gamma) z) / (1 - gamma z)^2, which for large -z is below 4.83 / -z.
TEST(Rosenbrock2, DampsWhatIsStiffInOneStep) {
  const double h = 0.01;
  for (const double decay : {1e6, 1e9}) {
    StiffCosine system{decay};
    Rosenbrock2 stepper(State(kLanes, 0.0), 1.0);
    State x(kLanes, 2.0);  // one off the curve
    double t = 0.0, step = h;
    stepper.try_step(system, x, t, step);
    EXPECT_NEAR(x[0], std::cos(h), 4.83 / (h * decay) + h * h) << decay;  // h^2: the bend of the curve
  }
}

// Issue 17, Build 2: of what lies off the curve ROS3 leaves, with z = -h L and its gamma,
//   (1 + (1 - 3 gamma) z + (1/2 - 3 gamma + 3 gamma^2) z^2) / (1 - gamma z)^3, which for large -z is
//   below 2.9 / -z.
TEST(Rosenbrock3, DampsWhatIsStiffInOneStep) {
  const double h = 0.01;
  for (const double decay : {1e6, 1e9}) {
    StiffCosine system{decay};
    Rosenbrock3 stepper(State(kLanes, 0.0), 1.0);
    State x(kLanes, 2.0);  // one off the curve
    double t = 0.0, step = h;
    stepper.try_step(system, x, t, step);
    EXPECT_NEAR(x[0], std::cos(h), 2.9 / (h * decay) + h * h) << decay;
  }
}

}  // namespace
}  // namespace orbearing::integration::rosenbrock2_test
