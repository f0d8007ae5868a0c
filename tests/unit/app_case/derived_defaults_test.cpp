#include "app/case/derived_defaults.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <regex>

#include "app/case/resolved_writer.hpp"
#include "bearing/default_design.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::derived_defaults_test {
namespace {

using testing::HasSubstr;

// Defaults are written in six significant digits: half a unit of the sixth, of a number that begins 1.00000,
// is the largest share that writing can take.
constexpr double kSixDigits = 5e-6;
const std::vector<std::string> kDerived{"bearing.cage.pocket_clearance", "bearing.cage.pocket_stiffness",
                                        "bearing.cage.touch_down_stiffness", "support.stiffness"};

// The shipped case without the values that it states in place of these defaults.
ResolvedCase left_out(const std::string& file = shipped_path(),
                      const std::vector<std::string>& settings = {}) {
  const std::regex stated(
      R"(\n *(pocket_clearance|pocket_stiffness|touch_down_stiffness|support|stiffness):[^\n]*)"),
      reasons(
          R"(\n  [a-z.]*(pocket_clearance|pocket_stiffness|touch_down_stiffness|support.stiffness):[^\n]*)");
  return parse_case(std::regex_replace(std::regex_replace(text_of(file), reasons, ""), stated, ""),
                    "case.yaml", settings);
}

ResolvedCase scaled(double factor) {
  const auto millimetres = [factor](double length) { return fmt::format("{:.17g} mm", factor * length); };
  return left_out().with(std::vector<Setting>{{"gearset.module", millimetres(3.0)},
                                              {"gearset.face_width", millimetres(28.0)},
                                              {"bearing.roller_diameter", millimetres(5.24)},
                                              {"bearing.roller_length", millimetres(5.7)},
                                              {"bearing.pitch_diameter", millimetres(35.64)},
                                              {"bearing.bore", millimetres(25.0)},
                                              {"bearing.outside_diameter", millimetres(47.0)},
                                              {"bearing.width", millimetres(11.9)},
                                              {"bearing.cage.inner_diameter", millimetres(33.44)},
                                              {"bearing.cage.outer_diameter", millimetres(38.54)},
                                              {"bearing.cage.width", millimetres(9.0)},
                                              {"bearing.cage.guide_land_diameter", millimetres(38.88)}});
}

// Each is a length, or modulus times length: everything ten times larger makes it ten times larger.
TEST(DerivedDefaults, ScaleWithTheBearing) {
  const ResolvedCase small = left_out(), large = scaled(10.0);
  for (const std::string& path : kDerived)
    EXPECT_NEAR(large.quantity(path) / small.quantity(path), 10.0, 20.0 * kSixDigits) << path;  // of both
}

TEST(DerivedDefaults, AreTheClosedFormsOfTheParts) {
  const ResolvedCase resolved = left_out();
  EXPECT_NEAR(resolved.quantity("bearing.cage.pocket_clearance"), 5.24e-3 / 50.0, 1e-9);
  const bearing::PlanetPin pin{.diameter = 25e-3,
                               .loaded_length = 28e-3,
                               .span = 28e-3 * 1.25,  // plates of half the face width together
                               .youngs_modulus = 206e9,
                               .poisson_ratio = 0.3};
  EXPECT_NEAR(resolved.quantity("support.stiffness") * 2.0 / bearing::pin_stiffness(pin), 1.0, kSixDigits);
  const bearing::CageBar bar{.length = 5.7e-3,
                             .height = 2.55e-3,
                             .thickness = bearing::cage_bar_thickness(5.24e-3, 5.24e-3 / 50.0, 35.64e-3, 15),
                             .youngs_modulus = 6e9};
  EXPECT_NEAR(resolved.quantity("bearing.cage.pocket_stiffness") / bearing::cage_bar_stiffness(bar), 1.0,
              kSixDigits);
}

TEST(DerivedDefaults, FollowTheCagesMaterial) {
  const ResolvedCase polyamide = left_out(), brass = polyamide.with("bearing.cage.density", "8500 kg/m3");
  for (const char* path : {"bearing.cage.pocket_stiffness", "bearing.cage.touch_down_stiffness"}) {
    EXPECT_NEAR(brass.quantity(path) / polyamide.quantity(path), 105.0 / 6.0, 40.0 * kSixDigits) << path;
    EXPECT_THAT(brass.assumed().at(path), HasSubstr("brass")) << path;
  }
}

TEST(DerivedDefaults, SayHow) {
  const ResolvedCase resolved = left_out();
  for (const std::string& path : kDerived) EXPECT_EQ(resolved.origin(path), "default") << path;
  EXPECT_THAT(resolved.assumed().at("support.stiffness"), HasSubstr("default: a solid pin of 25 mm, 35 mm"));
}

TEST(DerivedDefaults, LeaveWhatIsStated) {
  const ResolvedCase resolved = left_out().with("support.stiffness", "7e8 N/m").with("bearing.bore", "24 mm");
  EXPECT_EQ(resolved.quantity("support.stiffness"), 7e8);
  EXPECT_EQ(shipped().quantity("support.stiffness"), 5e8);
}

TEST(DerivedDefaults, AreTheSameWhenAResolvedCaseIsReadAgain) {
  const ResolvedCase resolved = left_out();
  const ResolvedCase again = parse_case(write_resolved(resolved), "again.yaml", {});
  EXPECT_TRUE(again == resolved);
}

TEST(DerivedDefaults, EachOfSeveralSetsHasItsOwnPin) {
  const ResolvedCase all = left_out(ORBEARING_SOURCE_DIR "/cases/three_sets_150kW/case.yaml");
  EXPECT_FALSE(all.has("support.stiffness"));
  const double reduction = all.of_set("reduction").quantity("support.stiffness");
  EXPECT_NEAR(reduction, left_out().quantity("support.stiffness"), kSixDigits * reduction);
  EXPECT_NE(all.of_set("coupling").quantity("support.stiffness"), reduction);
  EXPECT_NE(all.quantity("sets.coupling.bearing.cage.pocket_clearance"),
            all.quantity("sets.reduction.bearing.cage.pocket_clearance"));
}

// Without bearings there is nothing to derive.
TEST(DerivedDefaults, BelongToBearings) {
  const ResolvedCase gears = read_case(ORBEARING_SOURCE_DIR "/cases/lin_parker_1999/case.yaml", {});
  for (const std::string& path : kDerived) EXPECT_FALSE(gears.has(path)) << path;
}

}  // namespace
}  // namespace orbearing::app::derived_defaults_test
