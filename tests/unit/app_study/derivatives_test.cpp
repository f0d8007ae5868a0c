// Derivatives of a result that are known in closed form, inputs without a derivative, and the stated error of
// the others.
#include "app/study/derivatives.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "app/case/case_file.hpp"
#include "app/errors.hpp"

namespace orbearing::app::derivatives_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

// Tolerance of an elasticity: errors of equilibria and of the step.
constexpr double kAgreement = 1e-8;

ResolvedCase shipped(const std::string& name, const std::vector<std::string>& settings = {}) {
  return read_point(ORBEARING_SOURCE_DIR "/cases/" + name + "/case.yaml", settings);
}

Derivatives by_all(const ResolvedCase& in, const DerivativeOptions& options = {}) {
  const ScalarResult life = scalar_result(in);
  return derivatives(in, life, value_here(in, life), options);
}

double elasticity(const Derivatives& derivatives, const std::string& path) {
  for (const Derivative& one : derivatives.inputs)
    if (one.path == path && one.elasticity) return *one.elasticity;
  return std::nan("");
}

const NoDerivative* without(const Derivatives& derivatives, const std::string& path) {
  for (const NoDerivative& one : derivatives.not_differentiable)
    if (one.path == path) return &one;
  return nullptr;
}

// Without clearance all loads go with the load on the ring, whatever the contact's stiffness: L ~ C^p / F^p
// with p = 4 for the lines and 3 for the points of Lundberg and Palmgren.
TEST(Derivatives, WithoutClearanceAreThePowersOfTheLifeEquation) {
  const Derivatives rollers = by_all(shipped("planet_bearing_iso16281"));
  EXPECT_EQ(rollers.quantity, "L10r_Mrev");
  EXPECT_NEAR(elasticity(rollers, "load.radial"), -4.0, kAgreement);
  const Derivatives balls = by_all(shipped("ball_6305_iso16281"));
  EXPECT_NEAR(elasticity(balls, "load.radial"), -3.0, kAgreement);
  EXPECT_NEAR(elasticity(balls, "bearing.dynamic_capacity"), 3.0, kAgreement);
  EXPECT_THAT(balls.without_effect, Contains("material.youngs_modulus"));
}

// Loads of rollers do not depend on capacities, and inertia is proportional to the square of the speed while
// gear forces are proportional to P / n: L(P, n) in revolutions over n is homogeneous where P ~ n^3.
TEST(Derivatives, OfAReducerWithoutClearanceScale) {
  const Derivatives found = by_all(shipped("reducer_150kW"));
  EXPECT_EQ(found.quantity, "life_h");
  EXPECT_NEAR(elasticity(found, "life.reduction_factor"), 4.0, kAgreement);
  // Forces ~ n^2 then: life in revolutions ~ n^-8, in hours ~ n^-9.
  EXPECT_NEAR(3.0 * elasticity(found, "input.power") + elasticity(found, "input.speed"), -9.0, kAgreement);
}

TEST(Derivatives, StandInTheOrderOfTheirElasticities) {
  const Derivatives found = by_all(shipped("harris_209"));
  double before = 1e300;
  for (const Derivative& one : found.inputs) {
    if (!one.elasticity) continue;
    EXPECT_LE(std::abs(*one.elasticity), before) << one.path;
    before = std::abs(*one.elasticity);
  }
  for (const Derivative& one : found.inputs) {
    if (one.path == "bearing.radial_clearance") {
      EXPECT_EQ(one.unit, "um");
      EXPECT_EQ(one.step, "1 um");
      EXPECT_DOUBLE_EQ(one.change, one.derivative);
    }
    if (one.path == "load.radial") {
      EXPECT_EQ(one.step, "1 %");
      EXPECT_NEAR(one.change, 0.01 * *one.elasticity * found.value, 1e-9 * found.value);
    }
  }
}

TEST(Derivatives, TellWhatHasNone) {
  const Derivatives found = by_all(shipped("reducer_nu204"));
  ASSERT_NE(without(found, "gearset.planets"), nullptr);
  EXPECT_EQ(without(found, "gearset.planets")->reason, "a whole number");
  EXPECT_EQ(without(found, "contact.law")->reason, "a choice");
  EXPECT_EQ(without(found, "film.enabled")->reason, "on or off");
  EXPECT_EQ(without(found, "bearing.roller_diameter")->reason, "another input decides it");
  EXPECT_THAT(found.without_effect, Contains("bearing.cage.pocket_clearance"));
}

TEST(Derivatives, OfSomePathsAlone) {
  const Derivatives found = by_all(shipped("harris_209"), {.paths = {"load.radial"}});
  ASSERT_EQ(found.inputs.size(), 1u);
  EXPECT_EQ(found.inputs.front().path, "load.radial");
  EXPECT_TRUE(found.not_differentiable.empty());
}

TEST(Derivatives, RefuseWhatHasNoLifeAtRest) {
  for (const char* name : {"mesh_62_62", "duplex_7020", "lin_parker_1999"})
    EXPECT_THROW(scalar_result(shipped(name)), BadInput) << name;
}

Slope found(const std::function<double(double)>& result, double scatter, int side = 0) {
  const double step = step_for(scatter);
  const std::array<double, 2> there = side == 0 ? std::array{result(-step), result(step)}
                                                : std::array{result(side * step), result(2 * side * step)};
  return slope_of(result(0.0), there, side, scatter);
}

// Offsets are those of ln of a number: a power has no error but that of round-off.
TEST(Derivatives, OfPowersAreExact) {
  const double scatter = scatter::at_rest;
  const Slope power = found([](double t) { return 5.0 * std::exp(4.0 * t); }, scatter);
  EXPECT_NEAR(power.value, 20.0, 20.0 * 1e-15 / step_for(scatter));
  EXPECT_LT(power.error, 20.0 * 1e-9);
  const Slope above = found([](double t) { return 2.0 + 3.0 * t + t * t; }, scatter, 1);
  EXPECT_NEAR(above.value, 3.0, above.error);
  EXPECT_NEAR(found([](double t) { return std::sin(t); }, scatter).value, 1.0, 1e-9);  // of both signs
}

TEST(Slopes, OfOneSideSayWhich) {
  const auto remark = [](int side) {
    described::Record row;
    describe(row, Derivative{.path = "a", .side = side});
    return std::get<std::string>(row.entry("remark").content);
  };
  EXPECT_EQ(remark(1), "to larger values alone");
  EXPECT_EQ(remark(-1), "to smaller values alone");
}

// At the end of a range the slope is one to one side, with the sign of the result's growth.
TEST(Derivatives, OfPowersToOneSideAreExact) {
  const double scatter = scatter::at_rest;
  for (const int side : {-1, 1}) {
    EXPECT_NEAR(found([](double t) { return 5.0 * std::exp(4.0 * t); }, scatter, side).value, 20.0, 1e-8);
    EXPECT_NEAR(found([](double t) { return -7.0 + 3.0 * t; }, scatter, side).value, 3.0, 1e-8) << side;
  }
}

TEST(Derivatives, StateHowMuchTheSlopesToBothSidesDiffer) {
  const Slope kink = found([](double t) { return 1.0 + (t > 0.0 ? 3.0 * t : t); }, scatter::at_rest);
  EXPECT_NEAR(kink.value, 2.0, 1e-4);
  EXPECT_NEAR(kink.error, 1.0, 1e-4);
}

// A result that scatters by three parts in a thousand: nine of ten errors lie within what is stated.
TEST(Derivatives, OfScatteredResultsStayWithinTheirErrors) {
  std::mt19937 engine(3);
  std::normal_distribution<double> noise(0.0, scatter::in_motion);
  int within = 0;
  for (int i = 0; i < 1000; ++i) {
    double slope_here = 0.0;  // the result that the slope refers to
    const Slope slope = found(
        [&](double t) {
          const double result = std::exp(-3.0 * t + noise(engine));
          if (t == 0.0) slope_here = result;
          return result;
        },
        scatter::in_motion);
    if (std::abs(slope.value / slope_here + 3.0) <= slope.error / slope_here) ++within;
  }
  EXPECT_GE(within, 900);
}

}  // namespace
}  // namespace orbearing::app::derivatives_test
