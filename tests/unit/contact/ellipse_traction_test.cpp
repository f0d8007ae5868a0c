// Friction over the ellipse of a point contact against closed forms.
#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "bearing/contact/ellipse_traction.hpp"

namespace orbearing::bearing::ellipse_traction_test {
namespace {

constexpr double kLoad = 400.0, kAcross = 0.9e-3, kAlong = 0.12e-3, kBall = 10e-3;

ShearParameters coulomb(double friction = 0.07) {
  return {.law = TractionLaw::regularised_coulomb, .friction = friction, .sliding_scale = 1e-9};
}
LoadedEllipse<double> ellipse(double across = kAcross, double curvature = 1.0 / 5.1e-3) {
  return {kLoad, across, kAlong, 1.5 * kLoad / (3.141592653589793 * across * kAlong), 1e7, curvature, kBall};
}
template <class Law>
Traction<double> traction(const Law& law, const ShearParameters& shear, const EllipsePoints& points,
                          const LoadedEllipse<double>& contact, const Sliding<double>& motion,
                          TractionSlopes<double>* slopes = nullptr) {
  Traction<double> sum;
  TractionSlopes<double> unused{};
  add_traction<true>(law, shear, points, contact, motion, sum, slopes ? *slopes : unused);
  return sum;
}

TEST(EllipseTraction, SharesOfTheLoadAddUpAndHaveHertzMoments) {
  for (const auto& [slices, rows] : {std::pair{5, 1}, {9, 3}, {16, 8}}) {
    const EllipsePoints points = ellipse_points(slices, rows);
    double load = 0.0, square = 0.0;
    for (int i = 0; i < points.count; ++i) {
      load += points.share[i];
      square += points.share[i] * points.across[i] * points.across[i];
    }
    EXPECT_NEAR(load, 1.0, 1e-14);
    EXPECT_NEAR(square, 0.2, 1e-14);  // <X^2> = a^2/5 of a semi-ellipsoid
  }
}

TEST(EllipseTraction, PureCreepIsCoulombsFriction) {
  const Traction<double> t = traction(CoulombShear{}, coulomb(), ellipse_points(9, 1), ellipse(kAcross, 0.0),
                                      {.along = 0.3, .across = -0.4});
  EXPECT_NEAR(t.along, 0.07 * kLoad * 0.6, 1e-7);
  EXPECT_NEAR(t.across, -0.07 * kLoad * 0.8, 1e-7);
}

TEST(EllipseTraction, PureSpinIsTheMomentOfSlidingFriction) {
  // 3/8 mu Q a E(e), [Harris2006] Eq. (2.29) of the second volume: with points enough.
  const double e = std::sqrt(1.0 - kAlong * kAlong / (kAcross * kAcross));
  const double exact = 0.375 * 0.07 * kLoad * kAcross * boost::math::ellint_2(e);
  const auto spin = [&](int slices, int rows) {
    return traction(CoulombShear{}, coulomb(), ellipse_points(slices, rows), ellipse(), {.spin = 3000.0})
        .spin;
  };
  EXPECT_NEAR(spin(32, 8) / exact, 1.0, 2e-3);
  EXPECT_LT(std::abs(spin(32, 8) / exact - 1.0), 0.2 * std::abs(spin(8, 2) / exact - 1.0));
}

TEST(EllipseTraction, HeathcoteSlipOfABallInAGrooveOfItsOwnRadius) {
  // Free rolling: no net force; two lines of rest at 0.3473 a, resistance 0.0806 mu Q (a/R)^2
  // [Johnson1985] Section 8.5 (printed 0.08).
  constexpr double radius = 0.5 * kBall;
  const EllipsePoints points = ellipse_points(128, 1);
  const LoadedEllipse<double> contact = ellipse(kAcross, 1.0 / radius);
  const double rolling = 200.0;  // [rad/s]
  const auto force = [&](double along) {
    return traction(CoulombShear{}, coulomb(), points, contact, {.along = along, .turn_across = rolling})
        .along;
  };
  std::uintmax_t most = 200;
  const auto [low, high] = boost::math::tools::bisect(
      force, -0.2, 0.2, [](double a, double b) { return std::abs(a - b) < 1e-13; }, most);
  const double along = 0.5 * (low + high);
  const Traction<double> t =
      traction(CoulombShear{}, coulomb(), points, contact, {.along = along, .turn_across = rolling});
  const double power = t.along * along + t.turn_across * rolling;
  const double resistance = power / (rolling * radius);
  EXPECT_NEAR(resistance / (0.0806 * 0.07 * kLoad * std::pow(kAcross / radius, 2)), 1.0, 0.01);
}

TEST(EllipseTraction, ThreeWaysOfMovingMakeTheLawsEnergyFallAlways) {
  const EllipsePoints points = ellipse_points(7, 2);
  const ShearParameters oil{.limiting_friction = 0.06, .viscosity = 0.02, .pressure_viscosity = 1.8e-8};
  for (const Sliding<double>& m :
       {Sliding<double>{0.01, -0.02, 5.0, 900.0, 300.0}, {-0.3, 0.0, 0.0, -2000.0, 50.0}}) {
    const auto power = [&](const Traction<double>& t) {
      return t.along * m.along + t.across * m.across + t.turn_along * m.turn_along +
             t.turn_across * m.turn_across + t.spin * m.spin;
    };
    EXPECT_GT(power(traction(LimitedEyringShear{}, oil, points, ellipse(), m)), 0.0);
    EXPECT_GT(power(traction(LimitedNewtonianShear{}, oil, points, ellipse(), m)), 0.0);
  }
}

template <class Law>
void expect_slopes(const Law& law, const ShearParameters& shear) {
  const EllipsePoints points = ellipse_points(7, 2);
  const double at[4] = {0.013, -0.007, 1500.0, 400.0}, step[4] = {1e-6, 1e-6, 1e-2, 1e-2};
  const auto sliding = [](const double(&v)[4]) { return Sliding<double>{v[0], v[1], 0.0, v[2], v[3]}; };
  const auto forces = [&](const double(&v)[4]) {
    const Traction<double> t = traction(law, shear, points, ellipse(), sliding(v));
    return std::array{t.along, t.across, t.turn_across, t.spin};
  };
  TractionSlopes<double> slopes{};
  traction(law, shear, points, ellipse(), sliding(at), &slopes);
  for (int k = 0; k < 4; ++k) {
    double above[4], below[4];
    std::copy_n(at, 4, above);
    std::copy_n(at, 4, below);
    above[k] += step[k];
    below[k] -= step[k];
    const auto high = forces(above), low = forces(below);
    for (std::size_t i = 0; i < 4; ++i) {
      const double slope = (high[i] - low[i]) / (2.0 * step[k]);
      const double scale = std::sqrt(std::abs(slopes.by[i][i] * slopes.by[k][k]));
      EXPECT_NEAR(slopes.by[i][k], slope, 1e-6 * scale) << i << k;
    }
  }
}

TEST(EllipseTraction, SlopesAreThoseOfDifferences) {
  expect_slopes(CoulombShear{}, {.friction = 0.05, .sliding_scale = 0.1});
  expect_slopes(LimitedNewtonianShear{}, {.viscosity = 0.02, .pressure_viscosity = 1e-9});
  expect_slopes(LimitedEyringShear{}, {.eyring_stress = 4e6, .viscosity = 0.02, .pressure_viscosity = 6e-9});
}

TEST(EllipseTraction, LawsMeetTheirLimits) {
  const ShearParameters p{.limiting_friction = 0.06, .eyring_stress = 5e6, .viscosity = 0.01};
  const PressedOil<double> oil{5e8, 50.0, 1.0 / 0.4e-6};
  constexpr double slow = 1e-5, fast = 1e3;
  const double newtonian = oil.viscosity * slow * oil.per_film / oil.pressure;
  EXPECT_NEAR(LimitedNewtonianShear::friction(p, oil, slow) / newtonian, 1.0, 1e-3);
  EXPECT_NEAR(LimitedEyringShear::friction(p, oil, slow) / newtonian, 1.0, 1e-2);
  EXPECT_NEAR(LimitedNewtonianShear::friction(p, oil, fast), 0.06, 1e-9);
  // Between: the stress of Ree and Eyring, led to its limit.
  const double stress = 5e6 * std::asinh(oil.viscosity * 0.05 * oil.per_film / 5e6);
  EXPECT_NEAR(LimitedEyringShear::friction(p, oil, 0.05), 0.06 * (1.0 - std::exp(-stress / (0.06 * 5e8))),
              1e-12);
}

}  // namespace
}  // namespace orbearing::bearing::ellipse_traction_test
