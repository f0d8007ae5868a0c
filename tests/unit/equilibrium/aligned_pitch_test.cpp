// Aligned rollers on laminae, all cage angles of a pitch at once, against the readable searches, on bearings,
// loads and motions drawn at random.
#include "bearing/equilibrium/aligned_pitch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "mechanics/constants.hpp"
#include "tests/random_bearings.hpp"

namespace orbearing::bearing::vectorised::level_pitch_test {
namespace {

using laminae::LaminaBearing;
using mechanics::InstructionSet;

constexpr double kAgreement = 1e-9;  // of the largest force at hand, as both searches require
constexpr double kSlopes = 1e-6;     // of the largest stiffness: a contact that just touches has none
constexpr int kBearings = 60;

// Whole contacts, straight rollers and crowned ones on even and uneven numbers of laminae.
Draw next_level(RandomBearings& bearings, int kind) {
  Draw draw = bearings.next();
  CylindricalRollers& rollers = draw.bearing.rollers();
  rollers.laminae = std::array{0, 1, 7, 12, 30}[static_cast<std::size_t>(kind % 5)];
  if (kind % 5 > 2) rollers.profile = profile::Iso16281{rollers.length, rollers.diameter, 1.0};
  draw.options.film.reset();
  draw.options.cage_positions = kind % 3 == 0 ? 20 : 4;  // more than a block, and less
  draw.point.bore_tilt.setZero();
  return draw;
}

TEST(AlignedPitch, RandomBearingsAgreeWithTheReadableSearches) {
  RandomBearings bearings;
  int unbalanced = 0;
  for (int i = 0; i < kBearings; ++i) {
    const Draw draw = next_level(bearings, i);
    std::optional<AlignedPitch> level = AlignedPitch::of(draw.bearing, draw.options);
    ASSERT_TRUE(level && AlignedPitch::holds(draw.point)) << draw;
    PitchResults pitch;
    level->solve(draw.point, pitch);
    const QuasiStaticResult expected =
        quasi_static_bearing(LaminaBearing(draw.bearing), draw.point, draw.options);
    const double allowed = kAgreement * std::max({draw.point.bore_load.norm(), expected.inner_load.maxCoeff(),
                                                  expected.outer_load.maxCoeff()});
    for (Eigen::Index p = 0; p < pitch.inner_load.rows(); ++p) {
      if (!pitch.reports[static_cast<std::size_t>(p)].converged) {
        ++unbalanced;
        continue;
      }
      for (Eigen::Index j = 0; j < pitch.inner_load.cols(); ++j) {
        const Eigen::Index position = p + j * pitch.inner_load.rows();
        EXPECT_NEAR(pitch.inner_load(p, j), expected.inner_load[position], allowed)
            << "bearing " << i << ": " << draw;
        EXPECT_NEAR(pitch.outer_load(p, j), expected.outer_load[position], allowed)
            << "bearing " << i << ": " << draw;
      }
    }
  }
  RecordProperty("unbalanced", unbalanced);
  EXPECT_LE(unbalanced, kBearings / 20);
}

TEST(AlignedPitch, LaminaLoadsAndMeansAreThoseOfTheReadableSearch) {
  RandomBearings bearings;
  for (int i = 0; i < kBearings; ++i) {
    const Draw draw = next_level(bearings, i);
    const LaminaBearing cut(draw.bearing);
    const std::optional<QuasiStaticResult> found =
        AlignedPitch::of(draw.bearing, draw.options)->under(cut, draw.point);
    if (!found) continue;
    const QuasiStaticResult expected = quasi_static_bearing(cut, draw.point, draw.options);
    const double largest = std::max(
        {draw.point.bore_load.norm(), expected.inner_load.maxCoeff(), expected.outer_load.maxCoeff()});
    EXPECT_LE((found->inner_load - expected.inner_load).abs().maxCoeff(), kAgreement * largest) << draw;
    EXPECT_LE((found->outer_load - expected.outer_load).abs().maxCoeff(), kAgreement * largest) << draw;
    if (!cut.is_cut()) continue;
    EXPECT_LE((found->inner_lamina_load - expected.inner_lamina_load).abs().maxCoeff(), kAgreement * largest)
        << draw;
    EXPECT_LE((found->outer_lamina_load - expected.outer_lamina_load).abs().maxCoeff(), kAgreement * largest)
        << draw;
    EXPECT_LE((found->angle - expected.angle).abs().maxCoeff(), 0.0);
    EXPECT_EQ(found->total_bore_load, expected.total_bore_load);
  }
}

TEST(AlignedPitch, StiffnessIsTheSlopeOfTheForces) {
  RandomBearings bearings;
  for (int i = 0; i < kBearings; ++i) {
    const Draw draw = next_level(bearings, i);
    std::optional<AlignedPitch> level = AlignedPitch::of(draw.bearing, draw.options);
    PitchResults pitch;
    level->solve(draw.point, pitch);
    for (std::size_t p = 0; p < pitch.reports.size(); ++p) {
      if (!pitch.reports[p].converged) continue;
      const double angle = draw.options.first_roller + constants::two_pi * static_cast<double>(p) /
                                                           static_cast<double>(pitch.reports.size()) /
                                                           draw.bearing.rollers().count;
      const Eigen::Matrix2d expected =
          quasi_static_state(LaminaBearing(draw.bearing), draw.point, draw.options, angle).stiffness;
      EXPECT_LE((pitch.stiffness[p] - expected).cwiseAbs().maxCoeff(),
                kSlopes * expected.cwiseAbs().maxCoeff() + 1.0)
          << draw;
    }
  }
}

// From the equilibria under another load, near and far.
TEST(AlignedPitch, BalancesFromNeighboursAreTheSame) {
  RandomBearings bearings;
  int from_near = 0, by_itself = 0;
  for (int i = 0; i < kBearings; ++i) {
    Draw draw = next_level(bearings, i);
    std::optional<AlignedPitch> level = AlignedPitch::of(draw.bearing, draw.options);
    PitchResults near, alone, found;
    level->solve(draw.point, near);
    for (const double share : {0.0, 1e-6, 0.03, 0.5}) {
      OperatingPoint other = draw.point;
      other.bore_load += share * Eigen::Vector2d(draw.point.bore_load.y(), draw.point.bore_load.x());
      level->solve(other, alone);
      level->solve(other, found, &near);
      const double largest = std::max(other.bore_load.norm(), alone.outer_load.maxCoeff());
      for (std::size_t p = 0; p < found.reports.size(); ++p) {
        if (!found.reports[p].converged || !alone.reports[p].converged || !near.reports[p].converged)
          continue;
        const auto row = static_cast<Eigen::Index>(p);
        EXPECT_LE((found.outer_load.row(row) - alone.outer_load.row(row)).abs().maxCoeff(),
                  kAgreement * largest)
            << share << ": " << draw;
        from_near += found.reports[p].iterations;
        by_itself += alone.reports[p].iterations;
      }
    }
  }
  EXPECT_LT(2 * from_near, by_itself);  // or it would have no advantage
}

TEST(AlignedPitch, EveryInstructionSetGivesTheSameBits) {
  RandomBearings bearings;
  for (int i = 0; i < kBearings; ++i) {
    const Draw draw = next_level(bearings, i);
    PitchResults first;
    AlignedPitch::of(draw.bearing, draw.options, InstructionSet::baseline)->solve(draw.point, first);
    for (const InstructionSet set : mechanics::instruction_sets()) {
      PitchResults again;
      AlignedPitch::of(draw.bearing, draw.options, set)->solve(draw.point, again);
      EXPECT_TRUE((again.inner_load == first.inner_load).all()) << name_of(set) << ": " << draw;
      EXPECT_TRUE((again.outer_load == first.outer_load).all()) << name_of(set) << ": " << draw;
      EXPECT_TRUE((again.displacement == first.displacement).all()) << name_of(set) << ": " << draw;
      EXPECT_EQ(again.stiffness, first.stiffness) << name_of(set) << ": " << draw;
    }
  }
}

TEST(AlignedPitch, LeavesTiltsFilmsAndRacesThatAreNotRoundToOthers) {
  RandomBearings bearings;
  const Draw level = next_level(bearings, 3);
  ASSERT_TRUE(AlignedPitch::holds(level.point) && AlignedPitch::of(level.bearing, level.options));
  OperatingPoint tilted = level.point;
  tilted.bore_tilt.x() = 1e-4;
  EXPECT_FALSE(AlignedPitch::holds(tilted));
  Draw filmed = level, oval = level, unlike = level;
  filmed.options.film = Lubricant{};
  oval.bearing.outer.form.push_back({.order = 2, .amplitude = 20e-6});
  unlike.bearing.inner.profile =
      profile::Iso16281{level.bearing.rollers().length, level.bearing.rollers().diameter, 1.0};
  for (const Draw* draw : {&filmed, &oval, &unlike})
    EXPECT_FALSE(AlignedPitch::of(draw->bearing, draw->options));
}

}  // namespace
}  // namespace orbearing::bearing::vectorised::level_pitch_test
