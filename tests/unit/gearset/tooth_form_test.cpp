#include "gearset/tooth_form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/messages.hpp"

namespace orbearing::gearset::tooth_form_test {
namespace {

constexpr double module = 2e-3;                // [m]
constexpr double round_off = 1e-12;            // relative
constexpr double sine = 0.342020143325668733;  // of 20 degrees

TEST(ExternalTooth, HasTheRadiiOfItsRack) {
  const ExternalTooth tooth = make_external_tooth(40, 0.3, module, {});
  EXPECT_DOUBLE_EQ(tooth.pitch_radius, 40e-3);
  EXPECT_DOUBLE_EQ(tooth.base_radius, 40e-3 * std::cos(tooth.pressure_angle));
  EXPECT_DOUBLE_EQ(tooth.tip_radius, 40e-3 + 1.3 * module);
  EXPECT_DOUBLE_EQ(tooth.root_radius, 40e-3 - 0.95 * module);
}

TEST(ExternalTooth, IsHalfAPitchThickOnTheReferenceCircleWithoutShift) {
  const ExternalTooth tooth = make_external_tooth(40, 0.0, module, {});
  EXPECT_NEAR(half_thickness_angle(tooth, tooth.pitch_radius), std::numbers::pi / 80.0, round_off);
}

TEST(ExternalTooth, IsUndercutBelowTheLimitOfSeventeenTeeth) {
  // The classical limit 2/sin^2(alpha) = 17.097 for a rack whose straight flank reaches one module deep.
  const BasicRack rack{.root_fillet_radius = 0.25 / (1.0 - sine)};
  EXPECT_TRUE(make_external_tooth(17, 0.0, module, rack).undercut);
  EXPECT_FALSE(make_external_tooth(18, 0.0, module, rack).undercut);
}

TEST(ExternalTooth, LeastShiftIsWhereUndercutBegins) {
  const double limit = least_shift_without_undercut(make_external_tooth(12, 0.0, module, {}));
  EXPECT_FALSE(make_external_tooth(12, limit + 1e-6, module, {}).undercut);
  EXPECT_TRUE(make_external_tooth(12, limit - 1e-6, module, {}).undercut);
}

TEST(ExternalTooth, FormRadiusIsContinuousAcrossTheUndercutLimit) {
  const double limit = least_shift_without_undercut(make_external_tooth(12, 0.0, module, {}));
  const double whole = make_external_tooth(12, limit + 1e-4, module, {}).form_radius;
  const double undercut = make_external_tooth(12, limit - 1e-4, module, {}).form_radius;
  const double base = make_external_tooth(12, limit, module, {}).base_radius;
  // Both leave the base circle with the square of the distance to the limit, times 1/(2 sin^2) and at most a
  // few.
  constexpr double of_second_order = 1e-4 * module;
  EXPECT_NEAR(whole, base, of_second_order);
  EXPECT_NEAR(undercut, base, of_second_order);
}

TEST(ExternalTooth, ThicknessIsContinuousWhereTrochoidMeetsInvolute) {
  for (const double shift : {-0.4, -0.1, 0.0, 0.5, 0.9}) {
    const ExternalTooth tooth = make_external_tooth(22, shift, module, {});
    const double step = 1e-9 * module;  // the slope of the angle is of the order of 1/module
    EXPECT_NEAR(half_thickness_angle(tooth, tooth.form_radius - step),
                half_thickness_angle(tooth, tooth.form_radius + step), 1e-7)
        << "shift " << shift;
  }
}

TEST(ExternalTooth, ThicknessNarrowsWithATangentJointWithoutUndercut) {
  const ExternalTooth tooth = make_external_tooth(40, 0.2, module, {});
  const double h = 1e-4 * module;
  const auto slope = [&](double from, double to) {
    return (half_thickness(tooth, to) - half_thickness(tooth, from)) / (to - from);
  };
  // One-sided differences differ by h times the jump of curvature, about 1/(0.2 module): a few 1e-4.
  EXPECT_NEAR(slope(tooth.form_radius - h, tooth.form_radius),
              slope(tooth.form_radius, tooth.form_radius + h), 5e-3);
}

TEST(Trochoid, StartsOnTheRootCircle) {
  const ExternalTooth tooth = make_external_tooth(22, -0.4594, 3e-3, {});
  EXPECT_NEAR(trochoid_point(tooth, 0.0).radius, tooth.root_radius, round_off * tooth.root_radius);
}

TEST(Trochoid, SlopeIsTheDerivativeOfTheRadius) {
  const ExternalTooth tooth = make_external_tooth(22, -0.4594, 3e-3, {});
  const double h = 1e-5;  // [rad] the error of the central difference is of the order h^2
  for (const double angle : {0.1, 0.5, 1.0, 1.2}) {
    const double difference =
        (trochoid_point(tooth, angle + h).radius - trochoid_point(tooth, angle - h).radius) / (2.0 * h);
    EXPECT_NEAR(trochoid_point(tooth, angle).radius_slope, difference, 1e-6 * std::abs(difference));
  }
}

TEST(Trochoid, NormalAngleUndoesTheRadius) {
  const ExternalTooth tooth = make_external_tooth(22, -0.4594, 3e-3, {});
  for (const double angle : {0.2, 0.6, 1.0}) {
    EXPECT_NEAR(trochoid_normal_angle(tooth, trochoid_point(tooth, angle).radius), angle, 1e-10);
  }
}

TEST(FlankPoints, RunFromRootToTip) {
  const ExternalTooth tooth = make_external_tooth(22, -0.4594, 3e-3, {});
  const auto points = flank_points(tooth, 10);
  ASSERT_EQ(points.size(), 19U);
  EXPECT_NEAR(points.front().norm(), tooth.root_radius, round_off);
  EXPECT_NEAR(points.at(9).norm(), tooth.form_radius, round_off);
  EXPECT_NEAR(points.back().norm(), tooth.tip_radius, round_off);
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_GT(points[i].norm(), points[i - 1].norm());
}

TEST(ExternalTooth, RefusesWhatCannotBeCut) {
  EXPECT_REFUSED(std::domain_error, "tooth_form 1",
                 make_external_tooth(22, 0.0, module, {.root_fillet_radius = 0.6}));
  EXPECT_REFUSED(std::domain_error, "tooth_form 2", make_external_tooth(2, -0.5, module, {}));
  EXPECT_REFUSED(std::domain_error, "tooth_form 3", make_external_tooth(5, -0.9, module, {}));
}

TEST(RingTooth, FillsThePitchTogetherWithTheSpaceOfAnExternalGear) {
  const RingTooth ring = make_ring_tooth(80, 0.25, module, {});
  const ExternalTooth gear = make_external_tooth(80, 0.25, module, {});
  const double radius = 81e-3;
  EXPECT_NEAR(half_thickness_angle(ring, radius) + half_thickness_angle(gear, radius),
              std::numbers::pi / 80.0, round_off);
  EXPECT_DOUBLE_EQ(ring.tip_radius, 80e-3 - 0.75 * module);
  EXPECT_DOUBLE_EQ(ring.root_radius, 80e-3 + 1.5 * module);
}

TEST(RingTooth, HasRadialFlanksInsideTheBaseCircle) {
  const RingTooth ring = make_ring_tooth(24, 0.0, module, {});
  ASSERT_LT(ring.tip_radius, ring.base_radius);
  EXPECT_EQ(half_thickness_angle(ring, ring.tip_radius), half_thickness_angle(ring, ring.base_radius));
}

}  // namespace
}  // namespace orbearing::gearset::tooth_form_test
