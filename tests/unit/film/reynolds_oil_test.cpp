// Oil under pressure, and the sinking of a half-space by Fourier transform.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bearing/film/reynolds/half_space.hpp"
#include "bearing/film/reynolds/oil.hpp"

namespace orbearing::bearing::film::reynolds_oil_test {
namespace {

constexpr ReynoldsOil mineral{.viscosity = 0.04, .pressure_viscosity = 2.2e-8};

TEST(ReynoldsOil, StartsWithTheStatedPressureViscosity) {
  const OilUnderPressure oil(mineral);
  const double step = 1e3;  // [Pa]
  EXPECT_NEAR(std::log(oil.at(step).viscosity) / step, mineral.pressure_viscosity,
              1e-5 * mineral.pressure_viscosity);
  EXPECT_EQ(oil.at(0.0).viscosity, 1.0);
  EXPECT_EQ(oil.at(0.0).density, 1.0);
}

// Eq. (8) of [Guo2013] at 1 GPa: 1 + 0.6/2.7.
TEST(ReynoldsOil, DensityAtOneGigapascal) {
  EXPECT_NEAR(OilUnderPressure(mineral).at(1e9).density, 1.0 + 0.6 / 2.7, 1e-14);
  ReynoldsOil stiff = mineral;
  stiff.compressible = false;
  EXPECT_EQ(OilUnderPressure(stiff).at(1e9).density, 1.0);
}

TEST(ReynoldsOil, SlopesAreThoseOfDifferences) {
  const OilUnderPressure oil(mineral);
  for (const double p : {1e7, 3e8, 1.5e9}) {
    const double h = 1e-4 * p;
    const OilState up = oil.at(p + h), down = oil.at(p - h), here = oil.at(p);
    EXPECT_NEAR(here.viscosity_log_slope, std::log(up.viscosity / down.viscosity) / (2.0 * h),
                1e-7 * here.viscosity_log_slope);
    EXPECT_NEAR(here.density_slope, (up.density - down.density) / (2.0 * h), 1e-6 * here.density_slope);
  }
}

// Slow shear is Newton's; fast shear makes flow along it easier than across it.
TEST(ReynoldsOil, EyringsOilIsNewtonsWhereShearIsSlow) {
  EXPECT_EQ(eyring_flow(0.0).along, 1.0);
  EXPECT_NEAR(eyring_flow(1e-2).along, 1.0 + 0.5e-4, 1e-8);
  EXPECT_NEAR(eyring_flow(1e-2).across, 1.0 + 1e-4 / 6.0, 1e-8);
  EXPECT_GT(eyring_flow(3.0).along, eyring_flow(3.0).across);
}

TEST(HalfSpacePotential, IsTheSumOverAllNodes) {
  constexpr Eigen::Index nx = 16, ny = 8;
  const double hx = 0.3, hy = 0.7;
  const HalfSpacePotential potential(nx, ny, hx, hy);
  Field pressure = Field::Zero(nx + 1, ny + 1), found;
  for (Eigen::Index j = 1; j < ny; ++j)
    for (Eigen::Index i = 1; i < nx; ++i)
      pressure(i, j) = std::sin(1.0 + 3.0 * double(i) + 5.0 * double(j * j));
  potential(pressure, found);
  for (Eigen::Index j = 0; j <= ny; ++j)
    for (Eigen::Index i = 0; i <= nx; ++i) {
      double sum = 0.0;
      for (Eigen::Index m = 1; m < ny; ++m)
        for (Eigen::Index k = 1; k < nx; ++k)
          sum += pressure(k, m) * rectangle_potential(double(i - k) * hx, double(j - m) * hy, hx, hy);
      EXPECT_NEAR(found(i, j), sum, 1e-12);
    }
}

// Hertz's pressure over a circle of radius 1: pi^2/2 in its middle, pi^2/4 on its edge. [Johnson1985]
TEST(HalfSpacePotential, OfHertzsPressure) {
  const auto error = [](Eigen::Index n) {
    const double h = 4.0 / static_cast<double>(n);
    const HalfSpacePotential potential(n, n, h, h);
    Field pressure(n + 1, n + 1), found;
    for (Eigen::Index j = 0; j <= n; ++j)
      for (Eigen::Index i = 0; i <= n; ++i) {
        const double x = -2.0 + h * double(i), y = -2.0 + h * double(j);
        pressure(i, j) = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
      }
    potential(pressure, found);
    constexpr double middle = 0.5 * std::numbers::pi * std::numbers::pi;
    EXPECT_NEAR(found(n / 2 + n / 4, n / 2) / (0.5 * middle), 1.0, 2.0 * h * std::sqrt(h));
    return std::abs(found(n / 2, n / 2) / middle - 1.0);
  };
  EXPECT_LT(error(64), 1e-3);
  EXPECT_LT(error(128), 0.5 * error(64));
}

}  // namespace
}  // namespace orbearing::bearing::film::reynolds_oil_test
