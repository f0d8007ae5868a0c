// Properties of every contact of half-spaces: load, moment, energy, symmetry, similarity.
#include <gtest/gtest.h>

#include <numbers>
#include <cmath>
#include <cstdlib>
#include <random>

#include "bearing/pressure/contact.hpp"
#include "mechanics/constants.hpp"
#include "tests/half_space_contacts.hpp"

namespace orbearing::bearing::half_space::half_space_balance_test {
namespace {

using Eigen::ArrayXd;

constexpr double kRoundOff = 1e-11;  // sums over thousands of elements, solved with matrices of condition 1e3
constexpr double kStep = 1e-3;       // of approach or tilt
constexpr double kDifference = 1e-5;  // C kStep^2 of central differences; loaded elements come and go by one
constexpr double kSolver = 1e-10;     // tolerance required here
constexpr double kMisfit = 1e-9;      // widths to kSolver move displacements by about as much
const double kTenthOfRoundOff = 1e-12;  // gradients stop as far from symmetry as from the solution
const StripSettings kStrips{.tolerance = kSolver};
const SurfaceSettings kPlane{.elements = 32, .reach = 120e-6, .rows = 12, .tolerance = kSolver};

TEST(HalfSpaceBalance, PressuresAddUpToTheLoad) {
  const RollerContactMap map = contact_map(reducer_roller(), reference_profile(), kRollerLoad, 1e-3);
  const double spacing = map.y(1) - map.y(0);
  ArrayXd count = ArrayXd::Constant(map.y.size(), 2.0);
  count(0) = 1.0;
  const double sum =
      spacing * (map.along.element.matrix().transpose() * map.pressure.matrix() * count.matrix()).value();
  EXPECT_NEAR(sum, kRollerLoad, kRoundOff * kRollerLoad);
  const RollerContactPressure strips =
      contact_pressure(reducer_roller(), reference_profile(), kRollerLoad, 1e-3);
  const double ellipses =
      (constants::half_pi * strips.pressure * strips.half_width * strips.element).sum();
  EXPECT_NEAR(ellipses, kRollerLoad, 1e-6 * kRollerLoad);  // widths to the default tolerance
  EXPECT_NEAR(strips.load, kRollerLoad, kRoundOff * kRollerLoad);
}

TEST(HalfSpaceBalance, SymmetricLoadGivesSymmetricPressure) {
  for (const Relief& relief : {straight(), reference_profile()}) {
    const RollerContactPressure strips = contact_pressure(reducer_roller(), relief, kRollerLoad, 0.0);
    EXPECT_LE((strips.pressure - strips.pressure.reverse()).abs().maxCoeff(),
              kRoundOff * strips.element_peak);
    EXPECT_NEAR(strips.moment, 0.0, kRoundOff * kRollerLoad * 5.7e-3);
    const RollerContactMap map =
        contact_map(reducer_roller(), relief, kRollerLoad, 0.0, {.tolerance = kTenthOfRoundOff});
    EXPECT_LE((map.pressure - map.pressure.colwise().reverse()).abs().maxCoeff(),
              kRoundOff * map.along.element_peak);
  }
}

TEST(HalfSpaceBalance, TiltLoadsTheSideItCloses) {
  for (const EndSurface ends : {EndSurface::continuing, EndSurface::corrected}) {
    const auto left = contact_pressure(reducer_roller(ends), reference_profile(), kRollerLoad, -5e-4);
    const auto right = contact_pressure(reducer_roller(ends), reference_profile(), kRollerLoad, 5e-4);
    EXPECT_GT(right.moment, 0.1);  // [N m]
    EXPECT_GT(right.line_load(50), right.line_load(13));
    // The other tilt is the same seen from the other side.
    EXPECT_LE((left.pressure - right.pressure.reverse()).abs().maxCoeff(), kRoundOff * right.element_peak);
    const auto map = contact_map(reducer_roller(ends), reference_profile(), kRollerLoad, 5e-4);
    EXPECT_NEAR(map.along.moment, right.moment, 0.005 * right.moment);  // two models
  }
}

/// Central differences of the energy of `solve(approach, tilt)` about one state.
template <typename Solve>
void expect_slopes_of_energy(Solve solve, double approach, double tilt) {
  const RollerContactPressure here = solve(approach, tilt);
  ASSERT_GT(here.load, 0.0);
  const double step = kStep * approach, turn = kStep * approach / 3e-3;
  const double load =
      (solve(approach + step, tilt).energy - solve(approach - step, tilt).energy) / (2.0 * step);
  const double moment =
      (solve(approach, tilt + turn).energy - solve(approach, tilt - turn).energy) / (2.0 * turn);
  EXPECT_NEAR(load, here.load, kDifference * here.load);
  EXPECT_NEAR(moment, here.moment, kDifference * here.load * 3e-3);
}

TEST(HalfSpaceBalance, LoadAndMomentAreSlopesOfTheEnergy) {
  for (const EndSurface ends : {EndSurface::continuing, EndSurface::corrected}) {
    for (const Relief& relief : {straight(), reference_profile()}) {
      const StripContact contact(reducer_roller(ends), kStrips);
      const ArrayXd mean = contact.relief(relief);
      const auto strips = [&](double approach, double tilt) {
        return contact.at_approach(mean, approach, tilt);
      };
      expect_slopes_of_energy(strips, 9e-6, 0.0);
      expect_slopes_of_energy(strips, 9e-6, 7e-4);
      const auto plane = [&](double approach, double tilt) {
        return contact_map_at(reducer_roller(ends), relief, approach, tilt, kPlane).along;
      };
      expect_slopes_of_energy(plane, 9e-6, 7e-4);
    }
  }
}

TEST(HalfSpaceBalance, LoadAndApproachAreInverse) {
  const StripContact contact(reducer_roller(), kStrips);
  const ArrayXd mean = contact.relief(reference_profile());
  const RollerContactPressure loaded = contact.under_load(mean, kRollerLoad, 7e-4);
  EXPECT_NEAR(contact.at_approach(mean, loaded.approach, 7e-4).load, kRollerLoad, 1e-8 * kRollerLoad);
  const RollerContactMap map = contact_map(reducer_roller(), reference_profile(), kRollerLoad, 7e-4, kPlane);
  const RollerContactMap back =
      contact_map_at(reducer_roller(), reference_profile(), map.along.approach, 7e-4, kPlane);
  EXPECT_NEAR(back.along.load, kRollerLoad, 1e-8 * kRollerLoad);
}

TEST(HalfSpaceBalance, StifferBodiesUnderMoreLoadDeformTheSame) {
  HalfSpaceContact stiff = reducer_roller();
  stiff.roller.youngs_modulus *= 4.0;
  stiff.race.youngs_modulus *= 4.0;
  const auto soft = contact_pressure(reducer_roller(), reference_profile(), kRollerLoad, 1e-3);
  const auto same = contact_pressure(stiff, reference_profile(), 4.0 * kRollerLoad, 1e-3);
  EXPECT_LE((same.pressure - 4.0 * soft.pressure).abs().maxCoeff(), kRoundOff * same.element_peak);
  EXPECT_NEAR(same.approach, soft.approach, kRoundOff * soft.approach);
}

/// Greatest distance by which surfaces overlap or loaded ones gape over the greatest displacement [-], from
/// the influence of the solution's strips; elements without load may have any width, here `width` [m].
double misfit(const HalfSpaceContact& contact, const Relief& relief, const RollerContactPressure& solution,
              double width) {
  const LengthGrid grid = graded_grid(contact.length, static_cast<int>(solution.x.size()));
  const ArrayXd b = (solution.line_load > 0.0).select(solution.half_width, width);
  StripMatrices strips;
  StripInfluence(grid, mirror_factor(contact)).evaluate(b, strips);
  const double compliance = std::numbers::inv_pi / contact_modulus(contact);
  const ArrayXd displacement =
      compliance * (strips.influence * solution.line_load.matrix()).array() / grid.size;
  const ArrayXd gap = displacement + b.square() / (8.0 * contact.equivalent_radius) +
                      mean_relief(grid, relief) - solution.approach - solution.tilt * grid.middle;
  return (solution.line_load > 0.0).select(gap.abs(), (-gap).max(0.0)).maxCoeff() / displacement.maxCoeff();
}

// Chamfers, crowns, steps and rough tables, from a touch at one end to loads far beyond use, tilted or not.
TEST(HalfSpaceBalance, RandomContactsAreSolved) {
  const char* text = std::getenv("RANDOM_BEARINGS");
  const int draws = text == nullptr ? 100 : std::atoi(text);
  std::mt19937 generator(20260101);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  const auto magnitude = [&](double low, double high) {
    return low * std::pow(high / low, between(0.0, 1.0));
  };
  for (int k = 0; k < draws; ++k) {
    HalfSpaceContact contact = reducer_roller(static_cast<EndSurface>(k % 3));
    contact.equivalent_radius = contact.length * magnitude(0.1, 1.0);
    profile::Table table;
    const double depth = magnitude(1e-7, 1e-4);
    for (int i = -10; i <= 10; ++i) {
      table.x.push_back(0.05 * i * contact.length);
      table.drop.push_back(depth * (k % 2 ? between(0.0, 1.0) : 1e-2 * i * i));
    }
    const double load = magnitude(1.0, 3e4), tilt = between(-1.0, 1.0) * magnitude(1e-5, 1e-2);
    SCOPED_TRACE(::testing::Message() << "draw " << k << " of seed 20260101: load " << load << " N, tilt "
                                      << tilt << " rad, depth " << depth << " m");
    const auto solution = contact_pressure(contact, relief_of(table), load, tilt, kStrips);
    for (const double width : {0.1, 1.0}) {
      const double overlap =
          misfit(contact, relief_of(table), solution, width * solution.half_width.maxCoeff());
      EXPECT_LE(overlap, kMisfit);
    }
    EXPECT_NEAR(solution.load, load, kRoundOff * load);
    EXPECT_GE(solution.pressure.minCoeff(), 0.0);
    EXPECT_TRUE(solution.pressure.allFinite());
  }
}

}  // namespace
}  // namespace orbearing::bearing::half_space::half_space_balance_test
