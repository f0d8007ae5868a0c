// The pin as a beam with shear, against closed forms.
#include "bearing/pin_beam.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/constants.hpp"
#include "tests/messages.hpp"

namespace orbearing::bearing::pin_beam_test {
namespace {

using constants::pi;

const PinBeam kPinInWalls{.diameter = 0.025, .span = 0.035};

double bending_stiffness(const PinBeam& pin) {
  return pin.material.youngs_modulus * pi / 64.0 * (std::pow(pin.diameter, 4) - std::pow(pin.bore, 4));
}

// G A/kappa of a solid round section: kappa = (7 + 6 nu)/(6 (1 + nu)).
double shear_stiffness(const PinBeam& pin) {
  const double nu = pin.material.poisson_ratio;
  return 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu) * pin.material.shear_modulus() * 0.25 * pi * pin.diameter *
         pin.diameter;
}

TEST(PinBeam, MiddleOfARestingPinGivesWayAsTextbooksSay) {
  const double l = kPinInWalls.span;
  const double expected =
      std::pow(l, 3) / (48.0 * bending_stiffness(kPinInWalls)) + l / (4.0 * shear_stiffness(kPinInWalls));
  EXPECT_NEAR(pin_compliance(kPinInWalls, {0.0})(0, 0) / expected, 1.0, 1e-8);
}

TEST(PinBeam, ClampedPinGivesWayAsTextbooksSay) {
  PinBeam pin = kPinInWalls;
  pin.ends = PinEnds::one;
  const double a = 0.5 * pin.span + 0.007, bending = bending_stiffness(pin);
  const Eigen::MatrixXd compliance = pin_compliance(pin, {0.007});
  EXPECT_NEAR(compliance(0, 0) / (std::pow(a, 3) / (3.0 * bending) + a / shear_stiffness(pin)), 1.0, 1e-8);
  EXPECT_NEAR(compliance(1, 0) / (a * a / (2.0 * bending)), 1.0, 1e-8);
  EXPECT_NEAR(compliance(1, 1) / (a / bending), 1.0, 1e-8);
}

// The sleeve transmits a force in the middle as that force and a moment at the free end, which keep the end
// level: L^3/(12 E I), a quarter of the clamped pin's L^3/(3 E I); elsewhere the sleeve rotates as a rigid
// body.
TEST(PinBeam, FlexpinMovesWithoutInclining) {
  PinBeam pin = kPinInWalls;
  pin.ends = PinEnds::flexpin;
  const double l = pin.span, bending = bending_stiffness(pin), shear = l / shear_stiffness(pin);
  const Eigen::MatrixXd middle = pin_compliance(pin, {0.0});
  EXPECT_NEAR(middle(0, 0) / (std::pow(l, 3) / (12.0 * bending) + shear), 1.0, 1e-8);
  EXPECT_LT(std::abs(middle(1, 0)), 1e-8 * l * l / bending);
  EXPECT_NEAR(middle(1, 1) / (l / bending), 1.0, 1e-8);
  // Rigid: displacements of three places lie on a line with the sleeve's slope.
  const double e = 0.01;
  const Eigen::MatrixXd three = pin_compliance(pin, {-e, 0.0, e});
  for (Eigen::Index load = 0; load < 6; ++load) {
    EXPECT_NEAR(three(0, load) + three(2, load), 2.0 * three(1, load), 1e-8 * three.norm());
    EXPECT_NEAR((three(2, load) - three(0, load)) / (2.0 * e), three(3, load), 1e-8 * three.norm());
    EXPECT_NEAR(three(3, load), three(5, load), 1e-8 * three.norm());
  }
  EXPECT_LT((three - three.transpose()).norm(), 1e-12 * three.norm());
  EXPECT_NEAR(three(3, 2) / (e * l / bending), 1.0, 1e-7);  // F e turns the free end by F e L/(E I)
}

// Two equal forces: no slope in the middle, opposite ones beside it.
TEST(PinBeam, EqualForcesBendARestingPinSymmetrically) {
  const Eigen::MatrixXd compliance = pin_compliance(kPinInWalls, {-0.007, 0.007});
  const Eigen::VectorXd bent = compliance * Eigen::Vector4d(1.0, 1.0, 0.0, 0.0);
  EXPECT_NEAR(bent[0], bent[1], 1e-9 * bent[0]);
  EXPECT_NEAR(bent[2], -bent[3], 1e-9 * std::abs(bent[2]));
  EXPECT_GT(bent[2], 0.0);  // rises towards the middle
  EXPECT_LT((compliance - compliance.transpose()).norm(), 1e-12 * compliance.norm());
}

// The slope is that of the displacement but for the angle of shear, which a cross-section does not turn by.
TEST(PinBeam, SlopeOfASlenderPinIsThatOfItsDisplacement) {
  PinBeam slender = kPinInWalls;
  slender.diameter = 1e-4;
  const double h = 1e-5;
  const Eigen::MatrixXd near = pin_compliance(slender, {0.004 - h, 0.004 + h, 0.004, -0.006});
  EXPECT_NEAR((near(1, 3) - near(0, 3)) / (2.0 * h) / near(6, 3), 1.0, 1e-4);
}

// A slender pin bends only: as 1 - (d/D)^4 of the solid one.
TEST(PinBeam, BoreTakesItsSecondMoment) {
  PinBeam slender = kPinInWalls, bored = slender;
  slender.diameter = bored.diameter = 1e-5;
  bored.bore = 0.6e-5;
  EXPECT_NEAR(pin_compliance(slender, {0.0})(0, 0) / pin_compliance(bored, {0.0})(0, 0), 1.0 - 0.1296, 1e-6);
}

// A short thin tube, whose shear coefficient is 2 (1 + nu)/(4 + 3 nu) [Cowper1966].
TEST(PinBeam, ThinTubeShearsAsOne) {
  PinBeam tube = kPinInWalls;
  tube.bore = 0.999 * tube.diameter;
  const double nu = tube.material.poisson_ratio, l = tube.span;
  const double area = 0.25 * pi * (tube.diameter * tube.diameter - tube.bore * tube.bore);
  const double shear = 2.0 * (1.0 + nu) / (4.0 + 3.0 * nu) * tube.material.shear_modulus() * area;
  EXPECT_NEAR(pin_compliance(tube, {0.0})(0, 0) /
                  (std::pow(l, 3) / (48.0 * bending_stiffness(tube)) + l / (4.0 * shear)),
              1.0, 1e-5);
}

// A bore of half the diameter by hand, (2) with nu = 0.3: 1/kappa = 7.8 x 1.5625/(8.8 x 1.5625 + 23.6/4).
TEST(PinBeam, HalfBoredPinShearsByBothPartsOfItsCoefficient) {
  PinBeam pin = kPinInWalls;
  pin.bore = 0.5 * pin.diameter;
  ASSERT_EQ(pin.material.poisson_ratio, 0.3);
  const double l = pin.span, area = 0.1875 * pi * pin.diameter * pin.diameter;
  const double shear = 12.1875 / 19.65 * pin.material.shear_modulus() * area;
  EXPECT_NEAR(pin_compliance(pin, {0.0})(0, 0) /
                  (std::pow(l, 3) / (48.0 * bending_stiffness(pin)) + l / (4.0 * shear)),
              1.0, 1e-8);
}

TEST(PinBeam, RefusesAPositionBeyondItsSupports) {
  EXPECT_REFUSED(std::invalid_argument, "pin_beam 1", pin_compliance(kPinInWalls, {0.02}));
}

}  // namespace
}  // namespace orbearing::bearing::pin_beam_test
