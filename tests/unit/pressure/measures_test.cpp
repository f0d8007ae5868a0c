#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "bearing/pressure/contact.hpp"
#include "bearing/pressure/pressure_measures.hpp"
#include "tests/half_space_contacts.hpp"
#include "tests/messages.hpp"

namespace orbearing::bearing::half_space::measures_test {
namespace {

using Eigen::ArrayXd;

constexpr double kRoundOff = 1e-13;

template <typename Call>
std::string message_of(Call call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(LengthGrid, IsSymmetricAndFinerAtTheEnds) {
  for (const int elements : {2, 17, 64}) {
    const LengthGrid grid = graded_grid(6e-3, elements);
    EXPECT_EQ(grid.edge(0), -3e-3);
    EXPECT_EQ(grid.edge(elements), 3e-3);
    EXPECT_EQ((grid.edge + grid.edge.reverse()).abs().maxCoeff(), 0.0);
    EXPECT_GT(grid.size.minCoeff(), 0.0);
    EXPECT_EQ(grid.size(0), grid.size.minCoeff());
  }
}

TEST(LengthGrid, WithoutGradingIsEven) {
  const LengthGrid grid = graded_grid(6e-3, 12, 0.0);
  EXPECT_NEAR(grid.size.minCoeff(), grid.size.maxCoeff(), 6e-3 * kRoundOff);
}

TEST(LengthGrid, MeanReliefOfAParabola) {
  // Mean of x^2 over an element: middle^2 + h^2/12.
  const LengthGrid grid = graded_grid(6e-3, 9);
  const ArrayXd mean = mean_relief(grid, [](double x) { return x * x; });
  EXPECT_LE((mean - grid.middle.square() - grid.size.square() / 12.0).abs().maxCoeff(), 9e-6 * kRoundOff);
}

TEST(PressureMeasures, EvenPressureHasNoEdge) {
  const LengthGrid grid = graded_grid(6e-3, 20);
  EXPECT_NEAR(greatest_mean(grid, ArrayXd::Constant(20, 1e9), -3e-3, 3e-3), 1e9, 1e9 * kRoundOff);
}

TEST(PressureMeasures, NarrowPeakCountsByItsShareOfTheGauge) {
  // 1000 even elements on a gauge of ten: one of them with 11 times the pressure doubles the mean.
  const LengthGrid grid = graded_grid(1.0, 1000, 0.0);
  ArrayXd pressure = ArrayXd::Ones(1000);
  pressure(400) = 11.0;
  EXPECT_NEAR(greatest_mean(grid, pressure, -0.5, 0.5), 2.0, 1e-9);
  EXPECT_NEAR(greatest_mean(grid, pressure, 0.4, 0.5), 1.0, 1e-9);
}

TEST(PressureMeasures, LaminaeShareTheLoad) {
  RollerContactPressure solution;
  const LengthGrid grid = graded_grid(6e-3, 31);
  solution.x = grid.middle;
  solution.element = grid.size;
  solution.line_load = 1e5 * (1.0 + grid.middle / 6e-3);
  solution.pressure = ArrayXd::Constant(31, 2e9);
  const ArrayXd loads = lamina_loads(solution, 4);
  EXPECT_NEAR(loads.sum(), 600.0, 600.0 * kRoundOff);
  EXPECT_GT(loads(3), loads(0));
  EXPECT_REFUSED(std::invalid_argument, "measures 1", lamina_loads(solution, 0));
}

// A pressure over a length of 1 m on a fine even grid, with the same half-width everywhere.
RollerContactPressure pressure_of(const LengthGrid& grid, const ArrayXd& pressure, double half_width) {
  RollerContactPressure solution;
  solution.x = grid.middle;
  solution.element = grid.size;
  solution.line_load = solution.pressure = pressure;
  solution.half_width = ArrayXd::Constant(pressure.size(), half_width);
  return solution;
}

TEST(FatiguePressure, OfAnEvenPressureIsThatPressure) {
  const LengthGrid grid = graded_grid(1.0, 31);
  const ArrayXd found = fatigue_pressures(pressure_of(grid, ArrayXd::Constant(31, 2e9), 0.05), 7);
  EXPECT_LT((found / 2e9 - 1.0).abs().maxCoeff(), 1e-12);
  EXPECT_EQ(fatigue_pressures(pressure_of(grid, ArrayXd::Zero(31), 0.05), 7).abs().maxCoeff(), 0.0);
  EXPECT_THROW(fatigue_pressures(pressure_of(grid, ArrayXd::Ones(31), 0.05), 0), std::invalid_argument);
}

TEST(FatiguePressure, WeighsHalfWidthsByTheirLoad) {
  const LengthGrid grid = graded_grid(1.0, 4, 0.0);
  RollerContactPressure solution = pressure_of(grid, ArrayXd::Ones(4), 0.0);
  solution.line_load << 0.0, 1.0, 3.0, 0.0;
  solution.half_width << 9.0, 0.02, 0.06, 9.0;
  EXPECT_NEAR(mean_half_width(solution), 0.05, kRoundOff);
}

// By hand: 1, but 3 in the outermost hundredth a of the length, and a half-width w of a tenth. Up to w/2 from the end the
// mean over w is 1 + 2 a/w = 1.2; from there it falls to 1 within a, whose mean of ninth powers is
// (1.2^10 - 1)/(10 0.2).
TEST(FatiguePressure, OfANarrowEdgeByHand) {
  const LengthGrid grid = graded_grid(1.0, 100, 0.0);
  ArrayXd pressure = ArrayXd::Ones(100);
  pressure(99) = 3.0;
  const double damage =
      0.05 * std::pow(1.2, 9.0) + 0.01 * (std::pow(1.2, 10.0) - 1.0) / 2.0 + (1.0 - 0.05 - 0.01);
  for (const int laminae : {1, 10, 40, 200}) {
    const ArrayXd found = fatigue_pressures(pressure_of(grid, pressure, 0.1), laminae);
    EXPECT_NEAR(found.pow(9.0).mean(), damage, 1e-12) << laminae;
  }
  EXPECT_NEAR(fatigue_pressures(pressure_of(grid, pressure, 0.1), 40)(39), 1.2, 1e-12);
  EXPECT_NEAR(fatigue_pressures(pressure_of(grid, pressure, 0.1), 40)(0), 1.0, 1e-12);
}

// p = s^-lambda at a distance s from a sharp end: the integral of p^9 has no limit, since 9 lambda is above
// 1, and grows with finer laminae by h^(1 - 9 lambda). Averaged over w it is at most w^-lambda/(1 - lambda),
// at the end, and its damage has a limit.
TEST(FatiguePressure, OfASharpEndHasALimit) {
  constexpr double lambda = 0.255, w = 0.03;
  const auto sharp = [&](int elements) {
    const LengthGrid grid = graded_grid(1.0, elements, 0.99);
    ArrayXd pressure(elements);  // means of s^-lambda over the elements, s from the right end
    for (Eigen::Index i = 0; i < elements; ++i) {
      const double near = 0.5 - grid.edge(i + 1), far = 0.5 - grid.edge(i);
      pressure(i) = (std::pow(far, 1.0 - lambda) - std::pow(std::max(near, 0.0), 1.0 - lambda)) /
                    ((1.0 - lambda) * (far - near));
    }
    return pressure_of(grid, pressure, w);
  };
  const RollerContactPressure coarse = sharp(100), fine = sharp(400);
  EXPECT_GT(fine.pressure.maxCoeff(), 1.5 * coarse.pressure.maxCoeff());
  const double limit = fatigue_pressures(fine, 1)(0);
  EXPECT_NEAR(fatigue_pressures(coarse, 1)(0), limit, 1e-3 * limit);
  for (const int laminae : {10, 40, 200})
    EXPECT_NEAR(std::pow(fatigue_pressures(fine, laminae).pow(9.0).mean(), 1.0 / 9.0), limit, 1e-12 * limit);
  // The far end of the window lies within an element, whose pressure is even.
  const double at_the_end = std::pow(w, -lambda) / (1.0 - lambda);
  EXPECT_NEAR(fatigue_pressures(fine, 400)(399), at_the_end, 2e-4 * at_the_end);
}

TEST(Elasticity, TwoEqualBodiesHaveHalfTheModulusOfOne) {
  EXPECT_NEAR(contact_modulus(reducer_roller()), 0.5 * 206e9 / 0.91, 1e-2);
}

TEST(Elasticity, MirrorFactorOfSteelByHand) {
  // 1.29 - (0.08 - 0.15)/0.7 for the roller; the race continues, so half of it.
  EXPECT_NEAR(mirror_factor(EndSurface::corrected, 0.3), 1.39, kRoundOff);
  EXPECT_NEAR(mirror_factor(reducer_roller()), 0.695, kRoundOff);
  EXPECT_EQ(mirror_factor(reducer_roller(EndSurface::continuing)), 0.0);
}

TEST(HalfSpaceInput, ErrorsSayWhatIsRequired) {
  HalfSpaceContact contact = reducer_roller();
  contact.length = -1.0;
  EXPECT_NE(message_of([&] {
              StripContact{contact};
            }).find("length of a half-space contact [m]: found -1; required"),
            std::string::npos);
  contact = reducer_roller();
  contact.roller.poisson_ratio = 0.7;
  EXPECT_NE(message_of([&] { StripContact{contact}; }).find("required: 0 to 0.5"), std::string::npos);
  const StripContact strips(reducer_roller());
  const ArrayXd flat = strips.relief(straight());
  EXPECT_REFUSED(std::invalid_argument, "measures 2", strips.under_load(flat, 0.0, 0.0));
  EXPECT_REFUSED(std::invalid_argument, "measures 3",
                 strips.under_load(flat, std::numeric_limits<double>::quiet_NaN(), 0.0));
  EXPECT_REFUSED(std::invalid_argument, "measures 4", strips.under_load(flat.head(3), 1.0, 0.0));
  EXPECT_REFUSED(std::invalid_argument, "measures 5",
                 strips.under_load(flat, 1.0, std::numeric_limits<double>::infinity()));
  EXPECT_REFUSED(std::invalid_argument, "measures 6", graded_grid(1.0, 1));
  EXPECT_REFUSED(std::invalid_argument, "measures 7",
                 contact_map(reducer_roller(), straight(), 1.0, 0.0, {.rows = 2}));
}

TEST(HalfSpaceInput, AnIterationThatDoesNotEndIsAnError) {
  const auto strips = [] {
    return contact_pressure(reducer_roller(), straight(), kRollerLoad, 0.0, {.most_iterations = 2});
  };
  EXPECT_THROW(strips(), std::runtime_error);
  EXPECT_NE(message_of(strips).find("after 2 iterations"), std::string::npos);
  const auto plane = [] {
    return contact_map(reducer_roller(), straight(), kRollerLoad, 0.0, {.most_iterations = 3});
  };
  EXPECT_NE(message_of(plane).find("after 3 iterations"), std::string::npos);
}

TEST(HalfSpaceInput, BodiesApartCarryNothing) {
  const StripContact strips(reducer_roller());
  const RollerContactPressure apart = strips.at_approach(strips.relief(straight()), -1e-6, 0.0);
  EXPECT_EQ(apart.load, 0.0);
  EXPECT_EQ(apart.energy, 0.0);
  EXPECT_EQ(apart.peak_pressure, 0.0);
  EXPECT_TRUE(apart.pressure.allFinite());
  EXPECT_REFUSED(std::runtime_error, "measures 9", contact_map_at(reducer_roller(), straight(), -1e-6, 0.0));
}

}  // namespace
}  // namespace orbearing::bearing::half_space::measures_test
