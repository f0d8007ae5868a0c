#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "bearing/pressure/elasticity.hpp"
#include "bearing/pressure/pressure_measures.hpp"
#include "tests/messages.hpp"
#include "tests/half_space_contacts.hpp"

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
  EXPECT_NEAR(lamina_pressures(solution, 7)(3), 2e9, 2e9 * kRoundOff);
  EXPECT_REFUSED(std::invalid_argument, "measures 1", lamina_loads(solution, 0));
}

TEST(Elasticity, TwoEqualBodiesHaveHalfTheModulusOfOne) {
  EXPECT_NEAR(contact_modulus(reducer_roller()), 0.5 * 206e9 / 0.91, 1e-2);
}

TEST(Elasticity, MirrorFactorOfSteelByHand) {
  // 1.29 - (0.08 - 0.15)/0.7 for the roller; the race goes on, so half of it.
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
