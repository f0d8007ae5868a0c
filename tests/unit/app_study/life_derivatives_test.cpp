// Issue 18, Build 5: derivatives of the life of a case that are known in closed form, and what has none.
#include "app/study/life_derivatives.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "app/case/case_file.hpp"
#include "app/errors.hpp"

namespace orbearing::app::life_derivatives_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

// Of an elasticity: what balances and slopes of explicit maps leave.
constexpr double kAgreement = 1e-8;

ResolvedCase shipped(const std::string& name, const std::vector<std::string>& settings = {}) {
  return read_point(ORBEARING_SOURCE_DIR "/cases/" + name + "/case.yaml", settings);
}

double elasticity(const LifeDerivatives& derivatives, const std::string& path) {
  for (const LifeDerivative& one : derivatives.inputs)
    if (one.path == path && one.elasticity) return *one.elasticity;
  return std::nan("");
}

const NoDerivative* without(const LifeDerivatives& derivatives, const std::string& path) {
  for (const NoDerivative& one : derivatives.not_differentiable)
    if (one.path == path) return &one;
  return nullptr;
}

// Without clearance all loads go with the load on the ring, whatever the contact's stiffness: L ~ C^p / F^p
// with p = 4 for the lines and 3 for the points of Lundberg and Palmgren.
TEST(LifeDerivatives, WithoutClearanceAreThePowersOfTheLifeEquation) {
  const LifeDerivatives rollers = life_derivatives(shipped("planet_bearing_iso16281"));
  EXPECT_EQ(rollers.quantity, "L10r_Mrev");
  EXPECT_NEAR(elasticity(rollers, "load.radial"), -4.0, kAgreement);
  const LifeDerivatives balls = life_derivatives(shipped("ball_6305_iso16281"));
  EXPECT_NEAR(elasticity(balls, "load.radial"), -3.0, kAgreement);
  EXPECT_NEAR(elasticity(balls, "bearing.dynamic_capacity"), 3.0, kAgreement);
  EXPECT_THAT(balls.without_effect, Contains("material.youngs_modulus"));
}

// Loads of rollers follow no capacity, and inertia goes with the square of the speed while gear forces go
// with P / n: L(P, n) in revolutions over n is homogeneous where P ~ n^3.
TEST(LifeDerivatives, OfAReducerWithoutClearanceScale) {
  const LifeDerivatives found = life_derivatives(shipped("reducer_150kW"));
  EXPECT_EQ(found.quantity, "life_h");
  EXPECT_NEAR(elasticity(found, "life.reduction_factor"), 4.0, kAgreement);
  // Forces ~ n^2 then: life in revolutions ~ n^-8, in hours ~ n^-9.
  EXPECT_NEAR(3.0 * elasticity(found, "input.power") + elasticity(found, "input.speed"), -9.0, kAgreement);
}

TEST(LifeDerivatives, StandInTheOrderOfTheirElasticities) {
  const LifeDerivatives found = life_derivatives(shipped("harris_209"));
  double before = 1e300;
  for (const LifeDerivative& one : found.inputs) {
    if (!one.elasticity) continue;
    EXPECT_LE(std::abs(*one.elasticity), before) << one.path;
    before = std::abs(*one.elasticity);
  }
  for (const LifeDerivative& one : found.inputs) {
    if (one.path == "bearing.radial_clearance") {
      EXPECT_EQ(one.unit, "um");
      EXPECT_EQ(one.step, "1 um");
      EXPECT_DOUBLE_EQ(one.change, one.derivative);
    }
    if (one.path == "load.radial") {
      EXPECT_EQ(one.step, "1 %");
      EXPECT_NEAR(one.change, 0.01 * *one.elasticity * found.life, 1e-9 * found.life);
    }
  }
}

TEST(LifeDerivatives, TellWhatHasNone) {
  const LifeDerivatives found = life_derivatives(shipped("reducer_nu204"));
  ASSERT_NE(without(found, "gearset.planets"), nullptr);
  EXPECT_EQ(without(found, "gearset.planets")->reason, "a whole number");
  EXPECT_EQ(without(found, "contact.law")->reason, "a choice");
  EXPECT_EQ(without(found, "film.enabled")->reason, "on or off");
  EXPECT_EQ(without(found, "bearing.roller_diameter")->reason, "another input decides it");
  EXPECT_THAT(found.without_effect, Contains("bearing.cage.pocket_clearance"));
}

TEST(LifeDerivatives, OfSomePathsAlone) {
  const LifeDerivatives found = life_derivatives(shipped("harris_209"), {"load.radial"});
  ASSERT_EQ(found.inputs.size(), 1u);
  EXPECT_EQ(found.inputs.front().path, "load.radial");
  EXPECT_TRUE(found.not_differentiable.empty());
}

TEST(LifeDerivatives, RefuseWhatHasNoLifeAtRest) {
  for (const char* name : {"mesh_62_62", "deep_groove_motor", "duplex_7020", "lin_parker_1999"})
    EXPECT_THROW(life_derivatives(shipped(name)), BadInput) << name;
}

// The map is a number itself, ln of the life that number.
std::variant<NumberSlope, std::string> found(const std::function<double(double)>& map) {
  return slope_by_number([&](double x) { return Eigen::VectorXd::Constant(1, map(x)); },
                         [](const Eigen::VectorXd& change) { return change[0]; },
                         Eigen::VectorXd::Constant(1, map(0.0)), 1.0);
}

TEST(LifeDerivatives, ByOneNumberAreFoundOrRefused) {
  EXPECT_NEAR(std::get<NumberSlope>(found([](double x) { return std::sin(x); })).value, 1.0, 1e-12);
  EXPECT_THAT(std::get<std::string>(found([](double x) { return std::abs(x) + x; })), HasSubstr("kink"));
  // Rounded, as a text of six digits is.
  const auto stairs = [](double x) { return std::round(271828.18 * (x + 0.123456789)) / 271828.18; };
  EXPECT_THAT(std::get<std::string>(found(stairs)), HasSubstr("no smooth map"));
  const auto root_of = [](double x) {
    if (x < 0.0) throw std::domain_error("below zero");
    return 3.0 * x + x * x;
  };
  const auto one_sided = std::get<NumberSlope>(found(root_of));
  EXPECT_EQ(one_sided.side, 1);
  EXPECT_NEAR(one_sided.value, 3.0, 1e-9);
  EXPECT_THAT(std::get<std::string>(found([](double x) -> double {
                if (x != 0.0) throw std::domain_error("a fixed number");
                return 1.0;
              })),
              HasSubstr("a fixed number"));
}

}  // namespace
}  // namespace orbearing::app::life_derivatives_test
