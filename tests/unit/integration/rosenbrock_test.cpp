// The linearly implicit steppers on equations whose solutions are known.
#include "coupling/integration/rosenbrock3.hpp"
#include "coupling/integration/rosenbrock4.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

namespace orbearing::integration::rosenbrock_test {
namespace {

constexpr std::size_t kLanes = 8;  // the stepper requires multiples of eight
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

// From zero to `end` in equal steps, none of which is refused, since nothing is weighed.
template <class Stepper, class System>
State after_equal_steps(System system, State x, double end, int steps) {
  Stepper stepper(State(kLanes, 0.0), end);
  double t = 0.0;
  for (int i = 0; i < steps; ++i) {
    double h = end * (i + 1) / steps - t;
    EXPECT_EQ(stepper.try_step(system, x, t, h), boost::numeric::odeint::success);
  }
  return x;
}

template <class Stepper>
double error_at_two(int steps) {
  return error_of(after_equal_steps<Stepper>(Hyperbola(), starts(), 2.0, steps), 2.0);
}

template <class Stepper>
void expect_order(double order, int steps) {
  constexpr double kMargin = 0.1;  // the term of next order
  for (const int count : {steps, 2 * steps, 4 * steps})
    EXPECT_NEAR(std::log2(error_at_two<Stepper>(count) / error_at_two<Stepper>(2 * count)), order, kMargin)
        << count;
}

TEST(Rosenbrock2, ConvergesAtOrderTwo) {
  expect_order<Rosenbrock2>(2.0, 200);
}

// ROS3 of [Sandu1997].
TEST(Rosenbrock3, ConvergesAtOrderThree) {
  expect_order<Rosenbrock3>(3.0, 200);
}

// Two right-hand sides, order 4. x^2 and t have the conditions with second and mixed third derivatives.
TEST(Rosenbrock4, ConvergesAtOrderFour) {
  expect_order<Rosenbrock4>(4.0, 20);
}

// x'' = -sin x in lanes 0 and 1, swinging by two radians: third derivatives are as large as second ones.
struct Pendulum {
  double slope = 0.0, g = 0.0;

  void derivative(double, const double* x, double* dx) const {
    std::fill(dx, dx + kLanes, 0.0);
    dx[0] = x[1];
    dx[1] = -std::sin(x[0]);
  }
  void linearise(double t, const double* x, double* dx) {
    derivative(t, x, dx);
    slope = -std::cos(x[0]);
  }
  void time_slope(double, double* dx) const { std::fill(dx, dx + kLanes, 0.0); }
  bool factor(double share) {
    g = share;
    return true;
  }
  void solve(const double* rhs, double* k) const {
    std::copy(rhs, rhs + kLanes, k);
    k[1] = (rhs[1] + g * slope * rhs[0]) / (1.0 - g * g * slope);
    k[0] = rhs[0] + g * k[1];
  }
};

template <class Stepper>
double pendulum_after_ten(int steps) {
  State x(kLanes, 0.0);
  x[0] = 2.0;
  return after_equal_steps<Stepper>(Pendulum(), x, 10.0, steps)[0];
}

TEST(Rosenbrock4, ConvergesOnAPendulum) {
  const double exact = pendulum_after_ten<Rosenbrock4>(20'000);
  const auto error = [&](int steps) { return std::abs(pendulum_after_ten<Rosenbrock4>(steps) - exact); };
  for (int steps : {40, 80}) EXPECT_GT(std::log2(error(steps) / error(2 * steps)), 3.9) << steps;
  EXPECT_LT(error(160), 1e-3 * std::abs(pendulum_after_ten<Rosenbrock3>(160) - exact));
}

// A vibration, x' = i w x in lanes 0 and 1, keeps its amplitude, which steps of order 3 reduce: one step
// multiplies it by R(i w h), with the rational function of order 4 whose pole 4 is fivefold.
TEST(Rosenbrock4, KeepsTheHeightOfAVibration) {
  struct Vibration {
    double w, g = 0.0;
    void derivative(double, const double* x, double* dx) const {
      std::fill(dx, dx + kLanes, 0.0);
      dx[0] = -w * x[1];
      dx[1] = w * x[0];
    }
    void linearise(double t, const double* x, double* dx) const { derivative(t, x, dx); }
    void time_slope(double, double* dx) const { std::fill(dx, dx + kLanes, 0.0); }
    bool factor(double share) {
      g = share;
      return true;
    }
    void solve(const double* rhs, double* k) const {
      std::copy(rhs, rhs + kLanes, k);
      const std::complex<double> z = std::complex<double>(rhs[0], rhs[1]) / std::complex<double>(1.0, -g * w);
      k[0] = z.real();
      k[1] = z.imag();
    }
  };
  const auto left = [](auto stepper, double angle) {
    Vibration system{angle};
    State x(kLanes, 0.0);
    x[0] = 1.0;
    double t = 0.0, step = 1.0;
    stepper.try_step(system, x, t, step);
    return std::complex<double>(x[0], x[1]);
  };
  for (const double angle : {0.1, 0.3, 1.0}) {  // [rad]  of it in a step
    const std::complex<double> z(0.0, angle);
    const std::complex<double> numerator =
        1.0 - z / 4.0 - z * z / 8.0 + z * z * z / 96.0 + 7.0 * z * z * z * z / 768.0;
    const auto found = left(Rosenbrock4(State(kLanes, 0.0), 1.0), angle);
    EXPECT_LT(std::abs(found - numerator / std::pow(1.0 - z / 4.0, 5)), 1e-14) << angle;
    EXPECT_LT(std::abs(1.0 - std::abs(found)), 1e-3 * std::pow(angle, 6)) << angle;
    EXPECT_GT(1.0 - std::abs(left(Rosenbrock3(State(kLanes, 0.0), 1.0), angle)), 1e-2 * std::pow(angle, 4));
  }
}

template <class Stepper>
void expect_estimate_of_third_power() {
  const auto estimate = [](double h) {
    Hyperbola system;
    Stepper stepper(State(kLanes, 1.0), 1.0);
    const State x = starts();
    stepper.begin(system, x, 0.3);
    return stepper.attempt(system, x, 0.3, h);
  };
  constexpr double kMargin = 0.1;
  for (const double h : {0.02, 0.01, 0.005})
    EXPECT_NEAR(std::log2(estimate(h) / estimate(0.5 * h)), 3.0, kMargin) << h;
}

// Its estimate is the error of a step of order 2.
TEST(Rosenbrock3, EstimatesTheErrorOfAStepOfOrderTwo) {
  expect_estimate_of_third_power<Rosenbrock3>();
}

// Its estimate holds all that is not linear.
TEST(Rosenbrock4, EstimatesWhatIsNotLinear) {
  expect_estimate_of_third_power<Rosenbrock4>();
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

TEST(Rosenbrock3, ControlledStepsKeepToTheAllowedError) {
  expect_controlled_steps<Rosenbrock3>(3.0);
}

TEST(Rosenbrock4, ControlledStepsKeepToTheAllowedError) {
  expect_controlled_steps<Rosenbrock4>(3.0);  // the order of the estimate
}

// Once it has forgotten, a stepper continues as a new one: the same steps to the bit.
TEST(Rosenbrock4, ForgetsTheErrorsBefore) {
  Hyperbola system;
  const auto steps_from = [&](Rosenbrock4& stepper, double t, State x) {
    std::vector<double> lengths;
    for (double h = 0.05; t < 1.5;) {
      stepper.try_step(system, x, t, h);
      lengths.push_back(h);
    }
    return lengths;
  };
  Rosenbrock4 used(State(kLanes, 1e-6), 0.5, StepRule::two_errors);
  Rosenbrock4 fresh = used;
  const auto before = steps_from(used, 0.0, starts());
  const auto unlike = steps_from(used, 0.0, starts());
  EXPECT_NE(before, unlike) << "the last error counts";
  used.forget();
  EXPECT_EQ(steps_from(used, 0.0, starts()), steps_from(fresh, 0.0, starts()));
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

// A system need not define a slope by time that is zero: the same steps to the last bit.
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

// L-stable: one step, however long, takes away what is stiff. Of what lies off the curve it leaves R(z), z =
// -h L, for large -z below `left` / -z.
template <class Stepper>
void expect_damped(double left) {
  const double h = 0.01;
  for (const double decay : {1e6, 1e9}) {
    const State one_off(kLanes, 2.0);
    const State x = after_equal_steps<Stepper>(StiffCosine{decay}, one_off, h, 1);
    EXPECT_NEAR(x[0], std::cos(h), left / (h * decay) + h * h) << decay;  // h^2: the bend of the curve
  }
}

// R = (1 + (1 - 2 gamma) z) / (1 - gamma z)^2.
TEST(Rosenbrock2, DampsWhatIsStiffInOneStep) {
  expect_damped<Rosenbrock2>(4.83);
}

// R = (1 + (1 - 3 gamma) z + (1/2 - 3 gamma + 3 gamma^2) z^2) / (1 - gamma z)^3.
TEST(Rosenbrock3, DampsWhatIsStiffInOneStep) {
  expect_damped<Rosenbrock3>(2.9);
}

// R as of the vibration above, with -28/3 / z.
TEST(Rosenbrock4, DampsWhatIsStiffInOneStep) {
  expect_damped<Rosenbrock4>(9.4);
}

}  // namespace
}  // namespace orbearing::integration::rosenbrock_test
