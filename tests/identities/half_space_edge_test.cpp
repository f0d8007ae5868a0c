// The ends of a roller: what converges there and what grows, what a profile does, where laminae hold.
#include <gtest/gtest.h>

#include <cmath>

#include "bearing/pressure/contact.hpp"
#include "bearing/pressure/pressure_measures.hpp"
#include "mechanics/constants.hpp"
#include "tests/half_space_contacts.hpp"

namespace orbearing::bearing::half_space::half_space_edge_test {
namespace {

using constants::pi;
using Eigen::ArrayXd;
using Eigen::Index;

constexpr double kStated = 0.005;      // two digits after the point
constexpr double kTwoModels = 0.02;    // ellipses across against free pressures, at a sharp corner
constexpr double kSmoothEnds = 0.002;  // the same where the profile brings the pressure down before the end
constexpr double kExponent = 0.02;  // of the law of growth, from elements still a hundredth of the half width

RollerContactPressure sharp(EndSurface ends, int elements, double grading = StripSettings().grading) {
  return contact_pressure(reducer_roller(ends), straight(), kRollerLoad, 0.0,
                          {.elements = elements, .grading = grading});
}

// The pressure of a sharp corner grows as r^-lambda without bound, so that of the outermost element grows
// with refinement as h^-lambda, cos(pi lambda) = mirror factor: 1/2 for the half-space, 0.255 with the free
// end of the roller.
TEST(HalfSpaceEdge, SharpCornerGrowsByItsLaw) {
  for (const EndSurface ends : {EndSurface::continuing, EndSurface::mirrored, EndSurface::corrected}) {
    const RollerContactPressure coarse = sharp(ends, 100, 0.999), fine = sharp(ends, 200, 0.999);
    const double growth =
        std::log(fine.element_peak / coarse.element_peak) / std::log(coarse.element(0) / fine.element(0));
    EXPECT_NEAR(growth, corner_exponent(mirror_factor(reducer_roller(ends))), kExponent);
  }
}

// Its mean over a hundredth of the length does not: refinement halves its error each time or better.
TEST(HalfSpaceEdge, MeanOverTheGaugeConverges) {
  for (const EndSurface ends : {EndSurface::continuing, EndSurface::mirrored, EndSurface::corrected}) {
    const double coarse = sharp(ends, 40).edge_ratio, middle = sharp(ends, 80).edge_ratio;
    const double fine = sharp(ends, 160).edge_ratio;
    EXPECT_LT(std::abs(fine - middle), 0.6 * std::abs(middle - coarse) + 5e-4 * fine);
    EXPECT_NEAR(fine, middle, 0.01 * fine);
  }
}

// The limits that the folder's README states, from the grid that is finest at the ends.
TEST(HalfSpaceEdge, LimitsAreThoseStated) {
  EXPECT_NEAR(sharp(EndSurface::continuing, 200, 0.999).edge_ratio, 2.17, kStated);
  EXPECT_NEAR(sharp(EndSurface::mirrored, 200, 0.999).edge_ratio, 1.43, kStated);
  EXPECT_NEAR(sharp(EndSurface::corrected, 200, 0.999).edge_ratio, 1.24, kStated);
}

TEST(HalfSpaceEdge, FreeEndIsLessStiffAndCarriesLess) {
  const double plain = sharp(EndSurface::continuing, 64).edge_ratio;
  const double mirrored = sharp(EndSurface::mirrored, 64).edge_ratio;
  const double corrected = sharp(EndSurface::corrected, 64).edge_ratio;
  EXPECT_GT(plain, 1.2 * mirrored);
  EXPECT_GT(mirrored, 1.1 * corrected);
  EXPECT_GT(corrected, 1.1);  // a race that continues still dents at the corner
}

TEST(HalfSpaceEdge, LogarithmicProfileRemovesThePeak) {
  for (const EndSurface ends : {EndSurface::continuing, EndSurface::corrected}) {
    const auto profiled = contact_pressure(reducer_roller(ends), reference_profile(), kRollerLoad, 0.0);
    EXPECT_LT(profiled.edge_ratio, 1.0);
    EXPECT_LT(profiled.peak_pressure, 0.9 * sharp(ends, 64).peak_pressure);
    // Nothing rises towards the ends: the pressure falls from the middle to both.
    for (Index i = 33; i < 64; ++i) {
      EXPECT_LE(profiled.pressure(i), profiled.pressure(i - 1) * (1.0 + 1e-9)) << i;
    }
  }
}

TEST(HalfSpaceEdge, StripsAgreeWithThePlane) {
  for (const double tilt : {0.0, 1e-3}) {
    for (const bool profiled : {false, true}) {
      const Relief relief = profiled ? reference_profile() : straight();
      const auto strips = contact_pressure(reducer_roller(), relief, kRollerLoad, tilt);
      const auto plane = contact_map(reducer_roller(), relief, kRollerLoad, tilt).along;
      const double allowed = profiled ? kSmoothEnds : kTwoModels;
      EXPECT_NEAR(strips.peak_pressure, plane.peak_pressure, allowed * plane.peak_pressure);
      EXPECT_NEAR(strips.edge_ratio, plane.edge_ratio, allowed * plane.edge_ratio);
      EXPECT_NEAR(strips.approach, plane.approach, kSmoothEnds * plane.approach);
      // Pressures given by ellipses hold more energy at the same load than free ones; grids differ by their
      // squares.
      EXPECT_NEAR(strips.energy, plane.energy, kSmoothEnds * plane.energy);
      EXPECT_NEAR(strips.moment, plane.moment, kSmoothEnds * kRollerLoad * 5.7e-3);
    }
  }
}

/// Lamina loads of [ISO16281] under `load` at no tilt: proportional to (a - drop)^(10/9).
ArrayXd lamina_law(const ArrayXd& drop, double load) {
  const auto total = [&](double approach) { return (approach - drop).max(0.0).pow(10.0 / 9.0); };
  const double n = static_cast<double>(drop.size());
  const double constant =
      35948.0 * std::pow(2.0, 10.0 / 9.0) * std::pow(5.7, 8.0 / 9.0) * std::pow(1e3, 10.0 / 9.0);
  double low = 0.0, high = 1e-3;
  for (int k = 0; k < 60; ++k) {
    const double approach = 0.5 * (low + high);
    (constant / n * total(approach).sum() > load ? high : low) = approach;
  }
  return constant / n * total(high);
}

// Away from the ends both give the same pressure: the reference profile within 3 %, in the middle eight
// tenths.
TEST(HalfSpaceEdge, LaminaeHoldAwayFromTheEnds) {
  const int laminae = 40;
  const HalfSpaceContact contact = reducer_roller();
  const double width = contact.length / laminae;
  ArrayXd drop(laminae);
  for (int k = 0; k < laminae; ++k) {
    drop(k) = reference_profile()((k + 0.5) * width - 0.5 * contact.length);
  }
  const ArrayXd by_law = lamina_law(drop, kRollerLoad);
  ASSERT_NEAR(by_law.sum(), kRollerLoad, 1e-9 * kRollerLoad);
  const ArrayXd hertz = (by_law / width * contact_modulus(contact) / (pi * contact.equivalent_radius)).sqrt();
  const auto solution = contact_pressure(contact, reference_profile(), kRollerLoad, 0.0);
  const ArrayXd pressure = fatigue_pressures(solution, laminae), loads = lamina_loads(solution, laminae);
  for (int k = laminae / 10; k < laminae - laminae / 10; ++k) {
    EXPECT_NEAR(pressure(k), hertz(k), 0.03 * hertz(k)) << k;
    EXPECT_NEAR(loads(k), by_law(k), 0.06 * by_law(k)) << k;
  }
}

}  // namespace
}  // namespace orbearing::bearing::half_space::half_space_edge_test
