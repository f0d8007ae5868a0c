#include "bearing/defect/scratch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/defect/scratched_bearings.hpp"

namespace orbearing::bearing::defect::scratch_test {
namespace {

constexpr double kWidth = 0.5e-3, kDeepest = 8e-6;  // [m]
constexpr double kRoundOff = 1e-12;                 // relative

ScratchLaw of_form(ScratchForm form, double depth = 1e-3) {
  return {.form = form, .width = kWidth, .bottom = depth, .deepest = kDeepest};
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
  EXPECT_NEAR(deepest_sinking(kWidth, Race::inner, geometry), inner, arc_for_chord * inner);
  EXPECT_NEAR(deepest_sinking(kWidth, Race::outer, geometry), outer, arc_for_chord * outer);
}

TEST(Scratch, IsDeepestInTheMiddle) {
  for (const auto& form : names_of(ScratchForm{}))
    EXPECT_DOUBLE_EQ(sinking(of_form(form.value), 0.0).depth, kDeepest) << form.text;
}

TEST(Scratch, EntryAndExitAreContinuousButInThePrintedForm) {
  for (const double edge : {-0.5 * kWidth, 0.5 * kWidth}) {
    for (const ScratchForm form : {ScratchForm::raised_cosine, ScratchForm::half_cosine, ScratchForm::edges})
      EXPECT_NEAR(sinking(of_form(form), edge).depth, 0.0, kRoundOff * kDeepest);
    for (const ScratchForm form : {ScratchForm::raised_cosine, ScratchForm::edges})
      EXPECT_NEAR(sinking(of_form(form), edge).slope, 0.0, kRoundOff * kDeepest / kWidth);
    EXPECT_NEAR(sinking(of_form(ScratchForm::as_printed), edge).depth, -kDeepest,
                kRoundOff * kDeepest);
  }
}

// A rigid ball on an edge a from its middle stands a^2/(2R) lower, and changes edges in the middle.
TEST(Scratch, EdgesAreThoseOfARigidBall) {
  const double radius = 0.25 * kWidth * kWidth / (2.0 * kDeepest);  // to which this sinking belongs
  const double from_edge = 0.3 * kWidth;
  EXPECT_NEAR(sinking(of_form(ScratchForm::edges), 0.5 * kWidth - from_edge).depth,
              from_edge * from_edge / (2.0 * radius), kRoundOff * kDeepest);
}

TEST(Scratch, SlopesAreThoseOfDepths) {
  constexpr double step = 1e-5 * kWidth;
  constexpr double cubic = 1e-7;  // of central differences, relative to the largest slope
  for (const auto& form : names_of(ScratchForm{}))
    for (const double share : {-0.45, -0.2, 0.13, 0.37}) {
      const double at = share * kWidth;
      const double difference = (sinking(of_form(form.value), at + step).depth -
                                 sinking(of_form(form.value), at - step).depth) /
                                (2.0 * step);
      EXPECT_NEAR(sinking(of_form(form.value), at).slope, difference,
                  cubic * 10.0 * kDeepest / kWidth)
          << form.text << " " << share;
    }
}

TEST(Scratch, AShallowOneHasABottom) {
  const ScratchLaw shallow = of_form(ScratchForm::raised_cosine, 0.4 * kDeepest);
  EXPECT_DOUBLE_EQ(sinking(shallow, 0.0).depth, 0.4 * kDeepest);
  EXPECT_EQ(sinking(shallow, 0.01 * kWidth).slope, 0.0);
  EXPECT_LT(sinking(shallow, 0.45 * kWidth).depth, 0.4 * kDeepest);
}

}  // namespace
}  // namespace orbearing::bearing::defect::scratch_test
