#include "gearset/involute.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "tests/messages.hpp"

namespace orbearing::gearset::involute_test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double round_off = 1e-12;  // relative; the cancellation in tan(a) - a costs three to four digits

TEST(Involute, OfTwentyDegreesIsTheTabulatedValue) {
  constexpr double half_printed_digit = 0.5e-7;
  EXPECT_NEAR(involute(20.0 * degree), 0.0149044, half_printed_digit);
}

TEST(Involute, OfSmallAngleIsAThirdOfItsCube) {
  const double angle = 1e-5;  // the next term of the series is angle^2 * 2/5 of the first
  EXPECT_NEAR(involute(angle) / (angle * angle * angle / 3.0), 1.0, angle * angle);
}

TEST(Involute, SeriesMeetsTheClosedForm) {
  const double switch_angle = 0.05;
  const double below = involute(switch_angle * (1.0 - 1e-15));
  EXPECT_NEAR(below / (std::tan(switch_angle) - switch_angle), 1.0, round_off);
}

TEST(InverseInvolute, UndoesTheInvolute) {
  for (const double angle : {0.0, 1e-6, 1e-3, 0.049, 0.051, 0.2, 0.35, 0.6, 1.0, 1.4, 1.55}) {
    EXPECT_NEAR(inverse_involute(involute(angle)), angle, round_off * angle) << "angle " << angle;
  }
}

TEST(InverseInvolute, RefusesWhatNoAngleHas) {
  EXPECT_REFUSED(std::domain_error, "involute 1", inverse_involute(-1e-9));
  EXPECT_REFUSED(std::domain_error, "involute 2", inverse_involute(std::numeric_limits<double>::infinity()));
  EXPECT_REFUSED(std::domain_error, "involute 3", inverse_involute(std::numeric_limits<double>::quiet_NaN()));
}

TEST(PressureAngle, BelongsToTheTriangleOfBaseRadiusAndTangent) {
  EXPECT_NEAR(tangent_length(3.0, 5.0), 4.0, round_off);
  EXPECT_NEAR(pressure_angle_at(3.0, 5.0), std::acos(3.0 / 5.0), round_off);
  EXPECT_EQ(pressure_angle_at(3.0, 3.0), 0.0);
}

}  // namespace
}  // namespace orbearing::gearset::involute_test
