#include "bearing/defect/scratch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/messages.hpp"
#include "tests/unit/defect/scratched_bearings.hpp"

namespace orbearing::bearing::defect::scratch_test {
namespace {

constexpr double kWidth = 0.5e-3, kDeepest = 8e-6;  // [m]
constexpr double kRoundOff = 1e-12;                 // relative

ScratchLaw of_form(ScratchForm form, double depth = 1e-3) {
  ScratchLaw law{.form = form, .width = kWidth, .bottom = depth, .deepest = kDeepest};
  for (int i = 0; i < DefectDepthTable::kPoints; ++i) {  // of a profile: the raised cosine as a table
    const double turn = 6.283185307179586 * (static_cast<double>(i) / (DefectDepthTable::kPoints - 1) - 0.5);
    law.table.depth[i] = 0.5 * kDeepest * (1.0 + std::cos(turn));
    law.table.slope[i] = -3.141592653589793 * kDeepest / kWidth * std::sin(turn);
  }
  return law;
}

// Radius less the distance of a chord from the centre; chord and arc differ by parts of the square of w/R.
double height_over_chord(double radius) {
  return radius - std::sqrt(radius * radius - 0.25 * kWidth * kWidth);
}

TEST(Scratch, ABallSinksByItsArcMoreOnAConvexRaceAndLessOnAConcaveOne) {
  const BearingGeometry geometry = geometry_of(nine_balls().bearing);
  const double ball = height_over_chord(geometry.element_radius);
  const double inner = ball + height_over_chord(geometry.inner_radius);
  const double outer = ball - height_over_chord(geometry.outer_radius);
  const double arc_for_chord = std::pow(kWidth / geometry.element_radius, 2);
  EXPECT_NEAR(greatest_depth(kWidth, Race::inner, geometry), inner, arc_for_chord * inner);
  EXPECT_NEAR(greatest_depth(kWidth, Race::outer, geometry), outer, arc_for_chord * outer);
}

TEST(Scratch, IsDeepestInTheMiddle) {
  for (const auto& form : names_of(ScratchForm{}))
    EXPECT_DOUBLE_EQ(defect_depth(of_form(form.value), 0.0).depth, kDeepest) << form.text;
}

TEST(Scratch, EntryAndExitAreContinuousButInThePrintedForm) {
  for (const double edge : {-0.5 * kWidth, 0.5 * kWidth}) {
    for (const ScratchForm form : {ScratchForm::raised_cosine, ScratchForm::half_cosine, ScratchForm::edges})
      EXPECT_NEAR(defect_depth(of_form(form), edge).depth, 0.0, kRoundOff * kDeepest);
    for (const ScratchForm form : {ScratchForm::raised_cosine, ScratchForm::edges})
      EXPECT_NEAR(defect_depth(of_form(form), edge).slope, 0.0, kRoundOff * kDeepest / kWidth);
    EXPECT_NEAR(defect_depth(of_form(ScratchForm::literature_variant), edge).depth, -kDeepest,
                kRoundOff * kDeepest);
  }
}

// A rigid ball on an edge, at a from the middle, is a^2/(2R) lower, and changes edges in the middle.
TEST(Scratch, EdgesAreThoseOfARigidBall) {
  const double radius = 0.25 * kWidth * kWidth / (2.0 * kDeepest);  // to which this sinking belongs
  const double from_edge = 0.3 * kWidth;
  EXPECT_NEAR(defect_depth(of_form(ScratchForm::edges), 0.5 * kWidth - from_edge).depth,
              from_edge * from_edge / (2.0 * radius), kRoundOff * kDeepest);
}

TEST(Scratch, SlopesAreThoseOfDepths) {
  constexpr double step = 1e-5 * kWidth;
  constexpr double cubic = 1e-7;  // of central differences, relative to the largest slope
  for (const auto& form : names_of(ScratchForm{}))
    for (const double share : {-0.45, -0.2, 0.13, 0.37}) {
      const double at = share * kWidth;
      const double difference = (defect_depth(of_form(form.value), at + step).depth -
                                 defect_depth(of_form(form.value), at - step).depth) /
                                (2.0 * step);
      EXPECT_NEAR(defect_depth(of_form(form.value), at).slope, difference, cubic * 10.0 * kDeepest / kWidth)
          << form.text << " " << share;
    }
}

TEST(Scratch, BendsAreTheSlopesOfSlopes) {
  constexpr double step = 1e-5 * kWidth;
  for (const auto& form : names_of(ScratchForm{}))
    for (const double share : {-0.44, -0.2, 0.13, 0.37}) {
      const double at = share * kWidth;
      const double difference = (defect_depth(of_form(form.value), at + step).slope -
                                 defect_depth(of_form(form.value), at - step).slope) /
                                (2.0 * step);
      EXPECT_NEAR(defect_depth(of_form(form.value), at).bend, difference,
                  1e-5 * kDeepest / (kWidth * kWidth) * 40.0)
          << form.text << " " << share;
    }
}

// A measured groove with two sharp edges and a floor out of reach equals the path of a rigid element over two
// edges.
TEST(Scratch, AMeasuredProfileIsRolledOverByTheArcOfTheElement) {
  const BearingGeometry geometry = geometry_of(nine_balls().bearing);
  Scratch measured{.race = Scratched::inner, .width = kWidth, .depth = 1e-3, .form = ScratchForm::profile};
  measured.profile.assign(401, 1.0);  // walls as steep as the table is fine
  for (const Race race : {Race::inner, Race::outer}) {
    const ScratchLaw law = scratch_law(measured, race, geometry);
    const double deepest = greatest_depth(kWidth, race, geometry);
    const ScratchLaw edges{.form = ScratchForm::edges, .width = kWidth, .bottom = 1e-3, .deepest = deepest};
    for (const double share : {-0.5, -0.3, -0.11, 0.0, 0.24, 0.5})
      EXPECT_NEAR(defect_depth(law, share * kWidth).depth, defect_depth(edges, share * kWidth).depth,
                  0.02 * deepest)
          << share;
  }
  // A shallow one is followed where the element fits into it.
  measured.depth = 1e-7;
  measured.profile = {0.0, 0.5, 1.0, 0.5, 0.0};
  const ScratchLaw shallow = scratch_law(measured, Race::outer, geometry);
  EXPECT_NEAR(defect_depth(shallow, 0.125 * kWidth).depth, 0.75e-7, 2e-9);
  EXPECT_NEAR(defect_depth(shallow, 0.5 * kWidth).depth, 0.0, kRoundOff * shallow.bottom);
  measured.profile = {0.0, -0.1, 0.0};
  EXPECT_REFUSED(std::invalid_argument, "scratch 1", scratch_law(measured, Race::outer, geometry));
}

TEST(Scratch, AShallowOneHasABottom) {
  const ScratchLaw shallow = of_form(ScratchForm::raised_cosine, 0.4 * kDeepest);
  EXPECT_DOUBLE_EQ(defect_depth(shallow, 0.0).depth, 0.4 * kDeepest);
  EXPECT_EQ(defect_depth(shallow, 0.01 * kWidth).slope, 0.0);
  EXPECT_LT(defect_depth(shallow, 0.45 * kWidth).depth, 0.4 * kDeepest);
}

}  // namespace
}  // namespace orbearing::bearing::defect::scratch_test
