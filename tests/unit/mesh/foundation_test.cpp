#include "gearset/mesh/foundation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearset/mesh/elastic_ring.hpp"
#include "tests/messages.hpp"

namespace orbearing::gearset::foundation_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double nu = 0.3;

FoundationBody body(double half_angle, double ratio) {
  return {1.0, half_angle, 1.0 / ratio};
}

TEST(SainsotRange, IsThatOfItsAuthors) {
  EXPECT_TRUE(in_sainsot_range(body(0.05, 3.4)));
  EXPECT_FALSE(in_sainsot_range(body(0.05, 1.39)));
  EXPECT_FALSE(in_sainsot_range(body(0.05, 7.1)));
  EXPECT_FALSE(in_sainsot_range(body(0.121, 3.0)));
  EXPECT_FALSE(in_sainsot_range(body(0.009, 3.0)));
}

TEST(FoundationCompliance, OfAForceAlongTheToothIsItsCompressionAlone) {
  const mechanics::Material steel;
  const FoundationCoefficients c{7.0, 1.2, 5.0, 0.4};
  const double ours = foundation_compliance(c, body(0.05, 3.0), {1.03, pi / 2.0, 1.02}, 0.02, steel);
  EXPECT_NEAR(ours, 5.0 * 0.4 / (0.02 * steel.youngs_modulus), 1e-25);
}

TEST(FoundationCompliance, TakesTheLeverFromTheRootTowardsTheTip) {
  const mechanics::Material steel;
  const FoundationCoefficients c{7.0, 1.2, 5.0, 0.4};
  const double lever = 0.03, thickness = 2.0 * 0.05;
  const double closed =
      (7.0 * std::pow(lever / thickness, 2) + 1.2 * lever / thickness + 5.0) / (0.02 * steel.youngs_modulus);
  EXPECT_NEAR(foundation_compliance(c, body(0.05, 3.0), {1.04, 0.0, 1.0 + lever}, 0.02, steel), closed,
              1e-24);
  const FoundationBody ring{1.0, 0.05, 1.2};
  EXPECT_NEAR(foundation_compliance(c, ring, {0.96, 0.0, 1.0 - lever}, 0.02, steel), closed, 1e-24);
}

// Loads all round the edge (half angle pi) leave the harmonics out, and closed forms remain.
TEST(ElasticRing, TwistsLikeATubeUnderShearAllRound) {
  for (const double ratio : {1.2, 3.0, 0.8}) {
    const double held = 1.0 / ratio;
    const double per_torque =
        std::abs(1.0 / (held * held) - 1.0) / (4.0 * pi);  // [1/G], unit width and radius
    EXPECT_NEAR(elastic_ring_coefficients(body(pi, ratio), nu).shear, 2.0 * (1.0 + nu) * per_torque,
                1e-9 * per_torque);
  }
}

TEST(ElasticRing, WidensLikeATubeUnderPressureAllRound) {
  for (const double ratio : {1.2, 3.0, 0.8}) {
    const double b = 1.0 / ratio;
    // u = A r + B/r with u(b) = 0; normal stress = 2 G (A/(1 - 2 nu) - B/r^2) in plane strain.
    const double B = -b * b;
    const double stress = 2.0 * (1.0 / (1.0 - 2.0 * nu) - B);  // [G] at r = 1 for A = 1
    const double traction = b < 1.0 ? stress : -stress;
    const double closed = (1.0 + B) / traction / (2.0 * pi) * 2.0 * (1.0 + nu);
    const FoundationCoefficients ours = elastic_ring_coefficients(body(pi, ratio), nu);
    EXPECT_NEAR(ours.shear * ours.compression, closed, 1e-9 * closed);
  }
}

// A linear pressure k s on a half-plane has the slope 4 k c (1 - nu^2)/(pi E) at the middle of its length 2
// c; with k from the moment and times S^2: 24 (1 - nu^2)/pi.
TEST(ElasticRing, UnderASmallToothIsAHalfPlane) {
  const double closed = 24.0 * (1.0 - nu * nu) / pi;
  constexpr double of_the_series = 1e-3;
  for (const double ratio : {3.0, 1.0 / 3.0})
    EXPECT_NEAR(elastic_ring_coefficients(body(0.005, ratio), nu).moment, closed, of_the_series * closed);
}

// On a half-plane a shear stress q turns its middle by (1 + nu)(1 - 2 nu) q/E, and a linear pressure k s
// draws it aside by half that times k c^2: 1 + 3/2 times (1 + nu)(1 - 2 nu). A body of finite size adds some
// tooth widths.
TEST(ElasticRing, CouplesMomentAndShearUnderASmallToothAsAHalfPlaneDoes) {
  const double closed = 2.5 * (1.0 + nu) * (1.0 - 2.0 * nu);
  constexpr double half_angle = 0.002;
  for (const double ratio : {2.0, 0.5})
    EXPECT_NEAR(elastic_ring_coefficients(body(half_angle, ratio), nu).cross, closed, 10.0 * half_angle);
}

// The ring solves the problem behind the polynomials. Below a ratio of 2 the fit goes astray, not the ring.
TEST(ElasticRing, AgreesWithThePolynomialsInTheirRange) {
  constexpr double of_the_whole = 0.03;  // required of a foundation
  constexpr double of_one_term = 0.1;    // terms of little weight are fitted less well
  const mechanics::Material steel;
  for (const double half_angle : {0.03, 0.05, 0.08, 0.11})
    for (const double ratio : {2.0, 3.0, 4.0, 5.0}) {
      const FoundationBody gear = body(half_angle, ratio);
      const FoundationCoefficients ring = elastic_ring_coefficients(gear, nu);
      const FoundationCoefficients fit = sainsot_coefficients(half_angle, ratio);
      SCOPED_TRACE(testing::Message() << half_angle << " " << ratio);
      EXPECT_NEAR(ring.moment, fit.moment, of_one_term * fit.moment);
      EXPECT_NEAR(ring.cross, fit.cross, of_one_term * fit.cross);
      EXPECT_NEAR(ring.shear, fit.shear, of_one_term * fit.shear);
      EXPECT_NEAR(ring.compression, fit.compression, of_one_term * fit.compression);
      // A force at the working pressure angle that cuts the axis at 0.6 of the root's thickness above it.
      const ToothLoad load{1.0, 0.35, 1.0 + 0.6 * 2.0 * half_angle};
      const double by_fit = foundation_compliance(fit, gear, load, 1.0, steel);
      EXPECT_NEAR(foundation_compliance(ring, gear, load, 1.0, steel), by_fit, of_the_whole * by_fit);
    }
}

TEST(ElasticRing, GrowsSofterWithItsThickness) {
  double last = 0.0;
  for (const double outside : {1.02, 1.05, 1.1, 1.3, 2.0}) {
    const double shear = elastic_ring_coefficients({1.0, 0.03, outside}, nu).shear;
    EXPECT_GT(shear, last);
    last = shear;
  }
}

TEST(ElasticRing, RefusesARingWithoutThickness) {
  EXPECT_REFUSED(std::domain_error, "foundation 1", elastic_ring_coefficients({1.0, 0.03, 1.0}, nu));
  EXPECT_REFUSED(std::domain_error, "foundation 2", elastic_ring_coefficients({1.0, 0.03, 0.0}, nu));
}

}  // namespace
}  // namespace orbearing::gearset::foundation_test
