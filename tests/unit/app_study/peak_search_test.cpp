// The search for the peak of life on made-up curves: what it adds, and what it must not miss.
#include "app/study/life_peak.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace orbearing::app::peak_search_test {
namespace {

using Life = std::function<double(double)>;  // [h] over [rpm]

constexpr std::size_t kMostRounds = 60;  // far beyond any halving of 10000 rpm down to 1 rpm

std::vector<LivedSpeed> grid(const Life& life, double from = 1000.0, double to = 12000.0,
                             double step = 1000.0) {
  std::vector<LivedSpeed> points;
  for (double rpm = from; rpm <= to; rpm += step) points.push_back({rpm, life(rpm)});
  return points;
}

// All points after the search, ascending.
std::vector<LivedSpeed> searched(const Life& life, const PeakSearch& search, std::vector<LivedSpeed> points) {
  for (std::size_t round = 0;; ++round) {
    const std::vector<double> speeds = next_speeds(points, search);
    if (speeds.empty()) return points;
    EXPECT_LT(round, kMostRounds);
    if (round >= kMostRounds) return points;
    for (const double rpm : speeds) points.push_back({rpm, life(rpm)});
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.rpm < b.rpm; });
    for (std::size_t i = 1; i < points.size(); ++i)
      EXPECT_LT(points[i - 1].rpm, points[i].rpm) << "asked twice";
  }
}

std::size_t best_position(const std::vector<LivedSpeed>& points) {
  const auto best = std::max_element(points.begin(), points.end(),
                                     [](const auto& a, const auto& b) { return a.life_h < b.life_h; });
  return static_cast<std::size_t>(best - points.begin());
}

LivedSpeed best_of(const std::vector<LivedSpeed>& points) {
  return points[best_position(points)];
}

// Rises as the cube of speed, falls as its inverse sixth power: the shape of life at constant power.
Life smooth(double peak_rpm) {
  return [=](double rpm) {
    const double v = rpm / peak_rpm;
    return 150e3 / (2.0 / std::pow(v, 3.0) + std::pow(v, 6.0));
  };
}

// A dip as of a resonance: `depth` of the life at `rpm`, half of that at `half_width` [of rpm] beside it.
Life with_dip(Life life, double at_rpm, double depth, double half_width) {
  return [=](double rpm) {
    const double x = (rpm / at_rpm - 1.0) / half_width;
    return life(rpm) * (1.0 - depth / (1.0 + x * x));
  };
}

// The same scatter for the same speed, as the computation of one point repeats itself.
Life with_scatter(Life life, double scatter) {
  return [=](double rpm) {
    std::mt19937 random(static_cast<unsigned>(std::lround(rpm * 10.0)));
    return life(rpm) * (1.0 + scatter * std::normal_distribution<double>()(random));
  };
}

double longest_life_of_fine_grid(const Life& life, double from = 1000.0, double to = 12000.0) {
  return best_of(grid(life, from, to, 25.0)).life_h;
}

void expect_bracketed(const std::vector<LivedSpeed>& points, bool in_motion) {
  const std::size_t best = best_position(points);
  // Speeds are requested in whole rpm: half of an odd gap is one longer.
  const double widest = peak_resolution(points[best].rpm, in_motion) + 1.0;
  if (best > 0) {
    EXPECT_LE(points[best].rpm - points[best - 1].rpm, widest);
  }
  if (best + 1 < points.size()) {
    EXPECT_LE(points[best + 1].rpm - points[best].rpm, widest);
  }
}

constexpr PeakSearch kQuasiStatic{};
const PeakSearch kMotion{.in_motion = true};

// 2 rpm at rest and 10 rpm in motion; of slow shafts 1/1000 and 1/200 of the speed.
TEST(PeakSearch, ResolutionIsThatOfTheSpeed) {
  EXPECT_DOUBLE_EQ(peak_resolution(6000.0, false), 2.0);
  EXPECT_DOUBLE_EQ(peak_resolution(20.0, false), 0.02);
  EXPECT_DOUBLE_EQ(peak_resolution(6000.0, true), 10.0);
  EXPECT_DOUBLE_EQ(peak_resolution(20.0, true), 0.1);
}

// The top of the parabola through three points: 99.9 exp(0.0024) above the middle one where they lean, the
// middle one itself where they do not. A hill whose top is below the best point is left.
TEST(PeakSearch, AHillIsSearchedWhereItsTopMayBeHigher) {
  const auto asked = [](double left, double right) {
    const std::vector<double> speeds = next_speeds({{1000.0, 10.0},
                                                    {1999.0, 99.0},
                                                    {2000.0, 100.0},
                                                    {2001.0, 99.0},
                                                    {6180.0, left},
                                                    {6200.0, 99.9},
                                                    {6220.0, right},
                                                    {9000.0, 20.0}},
                                                   kQuasiStatic);
    return std::ranges::count_if(speeds, [](double rpm) { return rpm > 6180.0 && rpm < 6220.0; });
  };
  EXPECT_EQ(asked(97.0, 99.5), 2);
  EXPECT_EQ(asked(99.5, 97.0), 2);
  EXPECT_EQ(asked(97.0, 97.0), 0);
  EXPECT_EQ(asked(99.5, 99.5), 0);
}

TEST(PeakSearch, FindsASmoothPeakToTwoRpmInFewPoints) {
  for (const double peak : {1700.0, 4321.0, 5000.0, 5999.0, 9400.0}) {
    const std::vector<LivedSpeed> points = searched(smooth(peak), kQuasiStatic, grid(smooth(peak)));
    EXPECT_NEAR(best_of(points).rpm, peak,
                2.0);  // the curve's own maximum: v^3 terms 6 v^-4 = 6 v^5 at v = 1
    expect_bracketed(points, false);
    EXPECT_LE(points.size(), 12U + 24U);
  }
}

TEST(PeakSearch, FindsASmoothPeakInMotionToTenRpm) {
  const std::vector<LivedSpeed> points = searched(smooth(5432.0), kMotion, grid(smooth(5432.0)));
  EXPECT_NEAR(best_of(points).rpm, 5432.0, 10.0);
  expect_bracketed(points, true);
}

TEST(PeakSearch, AsksForSpeedsThatAreShortToWrite) {
  for (const double rpm : next_speeds(grid(smooth(5432.0), 1000.0, 12000.0, 333.0), kQuasiStatic))
    EXPECT_EQ(rpm, std::round(rpm));
}

TEST(PeakSearch, LooksOnBothSidesOfADip) {
  // The grid's best is 5000 rpm; dips at other places make either side the better one.
  for (const double at : {5600.0, 5700.0, 5850.0, 6000.0, 6100.0, 6250.0, 6400.0})
    for (const double width : {0.02, 0.035, 0.06}) {
      const Life life = with_dip(smooth(5800.0), at, 0.3, width);
      const std::vector<LivedSpeed> points = searched(life, kMotion, grid(life));
      EXPECT_GE(best_of(points).life_h, 0.995 * longest_life_of_fine_grid(life)) << at << " " << width;
      expect_bracketed(points, true);
    }
}

// Within a gap of share 0.087 life may rise by a factor 1.304: from 80 h beyond the best, 100 h, from 50 h
// not. The higher end of a gap decides, on either side of the best.
TEST(PeakSearch, LooksWhereTheHigherEndOfAGapCouldReachTheBest) {
  const PeakSearch search{.in_motion = true};
  EXPECT_EQ(next_speeds({{1000.0, 100.0}, {1100.0, 80.0}, {1200.0, 50.0}, {1300.0, 50.0}}, search),
            (std::vector<double>{1050.0, 1150.0}));
  EXPECT_EQ(next_speeds({{1000.0, 50.0}, {1100.0, 50.0}, {1200.0, 80.0}, {1300.0, 100.0}}, search),
            (std::vector<double>{1150.0, 1250.0}));
}

// Without motion the best point is brought in between its own neighbours, each to its own side.
TEST(PeakSearch, HalvesBothGapsBesideTheBest) {
  EXPECT_EQ(next_speeds({{1000.0, 50.0}, {1200.0, 100.0}, {1300.0, 60.0}, {1400.0, 10.0}}, {}),
            (std::vector<double>{1100.0, 1250.0}));
}

TEST(PeakSearch, FindsTheHillBetweenTwoDips) {
  const Life life = with_dip(with_dip(smooth(5800.0), 5000.0, 0.3, 0.04), 6000.0, 0.35, 0.04);
  const std::vector<LivedSpeed> points = searched(life, kMotion, grid(life));
  EXPECT_GE(best_of(points).life_h, 0.995 * longest_life_of_fine_grid(life));
}

TEST(PeakSearch, RunsAPointWhereAResonanceIsExpected) {
  const PeakSearch search{.in_motion = true, .resonances_rpm = {2210.4, 6110.2, 6112.0, 7000.0, 20000.0}};
  const std::vector<double> first = next_speeds(grid(smooth(5432.0)), search);
  EXPECT_EQ(first, (std::vector<double>{2210.0, 6110.0}))
      << "one of two close ones, none at a grid point or outside";
}

// Scatter moves the best point about on a flat top, and never by more life than itself.
TEST(PeakSearch, EndsAndMissesNothingWherePointsScatter) {
  constexpr double scatter = 0.005;  // standard deviation
  constexpr double allowed = 0.02;   // what the printed peak may fall short of any point of a 25 rpm grid
  for (const double peak : {3300.0, 5050.0, 5432.0, 6777.0}) {
    const Life life = with_scatter(with_dip(smooth(peak), 1.03 * peak, 0.2, 0.03), scatter);
    const std::vector<LivedSpeed> points = searched(life, kMotion, grid(life));
    EXPECT_GE(best_of(points).life_h * (1.0 + allowed), longest_life_of_fine_grid(life)) << peak;
    EXPECT_LE(points.size(), 120U) << peak;
    expect_bracketed(points, true);
  }
}

TEST(PeakSearch, StaysInTheRangeWherePeaksLieBeyondIt) {
  for (const PeakSearch& search : {kQuasiStatic, kMotion}) {
    const std::vector<LivedSpeed> falling = searched(smooth(500.0), search, grid(smooth(500.0)));
    EXPECT_EQ(best_of(falling).rpm, 1000.0);
    expect_bracketed(falling, search.in_motion);
    const std::vector<LivedSpeed> rising = searched(smooth(20000.0), search, grid(smooth(20000.0)));
    EXPECT_EQ(best_of(rising).rpm, 12000.0);
    expect_bracketed(rising, search.in_motion);
  }
}

TEST(PeakSearch, FindsAPeakNextToAnEndOfTheRange) {
  EXPECT_NEAR(best_of(searched(smooth(1030.0), kQuasiStatic, grid(smooth(1030.0)))).rpm, 1030.0, 2.0);
  EXPECT_NEAR(best_of(searched(smooth(11900.0), kQuasiStatic, grid(smooth(11900.0)))).rpm, 11900.0, 2.0);
}

TEST(PeakSearch, GoesAroundPointsThatFail) {
  const Life life = [](double rpm) { return rpm > 5400.0 && rpm < 5460.0 ? 0.0 : smooth(5432.0)(rpm); };
  for (const PeakSearch& search : {kQuasiStatic, kMotion}) {
    const std::vector<LivedSpeed> points = searched(life, search, grid(life));
    EXPECT_GE(best_of(points).life_h, 0.999 * longest_life_of_fine_grid(life));
    expect_bracketed(points, search.in_motion);
  }
}

TEST(PeakSearch, EndsOnAPlateau) {
  const Life flat = [](double rpm) { return std::min(smooth(5432.0)(rpm), 40e3); };
  for (const PeakSearch& search : {kQuasiStatic, kMotion}) {
    const std::vector<LivedSpeed> points = searched(flat, search, grid(flat));
    EXPECT_EQ(best_of(points).life_h, 40e3);
    EXPECT_LE(points.size(), 120U);
  }
}

TEST(PeakSearch, AddsNothingWhereThereIsNothingToFind) {
  EXPECT_TRUE(next_speeds({}, kMotion).empty());
  EXPECT_TRUE(next_speeds({{6000.0, 1.0}}, kMotion).empty());
  EXPECT_TRUE(next_speeds({{5000.0, 0.0}, {6000.0, 0.0}}, kMotion).empty());
  EXPECT_TRUE(next_speeds(grid(smooth(5432.0), 5000.0, 6000.0, 1.0), kMotion).empty());
}

TEST(PeakSearch, KnowsSlowShaftsAsWell) {
  // The rotor of a wind turbine: 5 to 20 rpm.
  const Life life = smooth(11.3);
  const std::vector<LivedSpeed> points = searched(life, kQuasiStatic, grid(life, 5.0, 20.0, 1.0));
  EXPECT_NEAR(best_of(points).rpm, 11.3, 11.3 / 500.0);
}

}  // namespace
}  // namespace orbearing::app::peak_search_test
