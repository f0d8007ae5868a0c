#include "app/case/derived_defaults.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
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
const std::vector<std::string> kOfBearing{"bearing.cage.pocket_clearance", "bearing.cage.pocket_stiffness",
                                          "bearing.cage.touch_down_stiffness", "support.stiffness",
                                          "bearing.cage.guide_land_diameter"};
// Supports of the members of the set.
const std::vector<std::string> kSupports{"gearset.dynamics.sun.support_stiffness",
                                         "gearset.dynamics.ring.support_stiffness",
                                         "gearset.dynamics.carrier.support_stiffness"};

std::vector<std::string> all_derived() {
  std::vector<std::string> all = kOfBearing;
  all.insert(all.end(), kSupports.begin(), kSupports.end());
  return all;
}

// The shipped case without the values that it states instead of these defaults.
ResolvedCase left_out(const std::string& file = shipped_path(),
                      const std::vector<std::string>& settings = {}) {
  const std::regex stated(
      R"(\n *(pocket_clearance|pocket_stiffness|touch_down_stiffness|guide_land_diameter|dynamics|support|stiffness):[^\n]*)"),
      reasons(
          R"(\n  [a-z.]*(pocket_clearance|pocket_stiffness|touch_down_stiffness|backlash|support.stiffness):[^\n]*)");
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
                                              {"bearing.cage.width", millimetres(9.0)}});
}

// Each is a length, or modulus times length: everything ten times larger makes it ten times larger.
TEST(DerivedDefaults, ScaleWithTheBearing) {
  const ResolvedCase small = left_out(), large = scaled(10.0);
  for (const std::string& path : all_derived())
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

// Supports of the published reducer, a steel set of 111, 237 and 88.5 mm.
TEST(DerivedDefaults, SupportsAreThoseOfTheReducerAndFollowTheModulus) {
  const ResolvedCase steel = left_out(), soft = steel.with("material.youngs_modulus", "103 GPa");
  const std::vector<double> right{1e8, 1e9, 5e8};
  for (std::size_t i = 0; i < kSupports.size(); ++i) {
    EXPECT_NEAR(steel.quantity(kSupports[i]) / right[i], 1.0, kSixDigits) << kSupports[i];
    EXPECT_NEAR(soft.quantity(kSupports[i]) / right[i], 0.5, kSixDigits) << kSupports[i];
  }
}

// 2/3 (0.06 + 0.0005 a + 0.03 m_n) mm normal to the teeth, which are inclined in a helical set.
TEST(DerivedDefaults, BacklashIsTheLeastThatIsRecommended) {
  const double a = 1.5 * (37 + 22), normal = 2e-3 / 3.0 * (0.06 + 0.0005 * a + 0.03 * 3.0);
  EXPECT_NEAR(left_out().quantity("gearset.dynamics.backlash") / normal, 1.0, kSixDigits);
  const ResolvedCase wind = read_case(ORBEARING_SOURCE_DIR "/cases/wind_stage_750kW/case.yaml", {});
  const double helix = 7.5 * 3.141592653589793 / 180.0, alpha = 20.0 * 3.141592653589793 / 180.0;
  const double distance = 5.0 * (21 + 39) / std::cos(helix);
  const double of_wind = 2e-3 / 3.0 * (0.06 + 0.0005 * distance + 0.03 * 10.0);
  EXPECT_NEAR(wind.quantity("gearset.dynamics.backlash") *
                  std::cos(std::asin(std::sin(helix) * std::cos(alpha))) / of_wind,
              1.0, 2.0 * kSixDigits);
  EXPECT_EQ(shipped().quantity("gearset.dynamics.backlash"), 0.1e-3);
}

TEST(DerivedDefaults, GuideLandHasAPlayAndMayBeNone) {
  const ResolvedCase resolved = left_out();
  const char* land = "bearing.cage.guide_land_diameter";
  EXPECT_NEAR(resolved.quantity(land), 38.54e-3 + 0.06 * 5.24e-3, 1e-9);
  EXPECT_NEAR(resolved.with("bearing.cage.guidance", "inner").quantity(land), 33.44e-3 - 0.06 * 5.24e-3,
              1e-9);
  // Half of the way to the outer raceway of 40.88 mm.
  EXPECT_NEAR(resolved.with("bearing.cage.outer_diameter", "40.8 mm").quantity(land), 40.84e-3, 1e-9);
  EXPECT_EQ(resolved.with(land, "0 mm").quantity(land), 0.0);
}

TEST(DerivedDefaults, FollowTheCagesMaterial) {
  const ResolvedCase polyamide = left_out(), brass = polyamide.with("bearing.cage.density", "8500 kg/m3");
  for (const char* path : {"bearing.cage.pocket_stiffness", "bearing.cage.touch_down_stiffness"}) {
    EXPECT_NEAR(brass.quantity(path) / polyamide.quantity(path), 105.0 / 6.0, 40.0 * kSixDigits) << path;
    EXPECT_THAT(brass.assumed().at(path), HasSubstr("brass")) << path;
  }
  EXPECT_EQ(polyamide.quantity("bearing.cage.pocket_damping"), 1.0);
  EXPECT_EQ(brass.quantity("bearing.cage.pocket_damping"), 0.3);
}

TEST(DerivedDefaults, SayHow) {
  const ResolvedCase resolved = left_out();
  for (const std::string& path : all_derived()) EXPECT_EQ(resolved.origin(path), "default") << path;
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

// As the pin is held, where tilts are computed: clamped in one wall over the face, or within the sleeve of a
// flexpin; two bearings share it. Where tilts are stated the ends of the pin have no effect.
TEST(DerivedDefaults, PinStiffnessIsThatOfItsEnds) {
  const auto held = [](const std::string& ends, const std::string& tilt) {
    return left_out().with(std::vector<Setting>{
        {"bearing.laminae", "30"}, {"bearing.tilt_state", tilt}, {"support.pin_ends", ends}});
  };
  bearing::PlanetPin pin{.diameter = 25e-3,
                         .loaded_length = 28e-3,
                         .span = 28e-3,
                         .youngs_modulus = 206e9,
                         .poisson_ratio = 0.3,
                         .ends = bearing::PinEnds::one};
  const auto expect = [&](const ResolvedCase& resolved) {
    EXPECT_NEAR(resolved.quantity("support.stiffness") * 2.0 / bearing::pin_stiffness(pin), 1.0, kSixDigits);
  };
  expect(held("one", "computed"));
  pin.span = 40e-3;
  expect(held("one", "computed").with("support.pin_span", "40 mm"));
  pin = {.diameter = 0.625 * 25e-3,
         .loaded_length = 28e-3,
         .span = 28e-3,
         .youngs_modulus = 206e9,
         .poisson_ratio = 0.3,
         .ends = bearing::PinEnds::flexpin};
  const ResolvedCase flexpin = held("flexpin", "computed");
  EXPECT_NEAR(flexpin.quantity("support.pin_diameter"), pin.diameter, kSixDigits * pin.diameter);
  expect(flexpin);
  EXPECT_THAT(flexpin.assumed().at("support.stiffness"), HasSubstr("a flexpin"));
  pin.diameter = 12e-3;
  expect(flexpin.with("support.pin_diameter", "12 mm"));
  EXPECT_FALSE(held("both", "computed").has("support.pin_diameter"));
  EXPECT_EQ(held("flexpin", "stated").quantity("support.stiffness"),
            left_out().quantity("support.stiffness"));
  EXPECT_THROW((void)flexpin.with("support.pin_diameter", "25 mm"), BadInput);  // no room for a sleeve
}

// E I/l of an overhung shaft of half the sun's diameter (111 mm), 2.5 of its diameters long; a floating sun
// inclines freely, and a stiffer shaft is stiffer both ways.
TEST(DerivedDefaults, SunInclinesOnTheShaftThatHoldsIt) {
  const char* tilt = "gearset.dynamics.sun.tilt_stiffness";
  EXPECT_FALSE(left_out().has(tilt) && left_out().quantity(tilt) > 0.0);  // without a carrier in bearings
  const ResolvedCase held =
      left_out().with(std::vector<Setting>{{"gearset.carrier.bearing_positions", "[-60 mm, 60 mm]"},
                                           {"gearset.carrier.bearing_stiffness", "[1e9 N/m, 1e9 N/m]"}});
  const double diameter = 55.5e-3, length = 2.5 * diameter;
  const double angular = 206e9 * 3.141592653589793 / 64.0 * std::pow(diameter, 4) / length;  // 6.9e5 N m/rad
  EXPECT_NEAR(held.quantity(tilt) / angular, 1.0, 2.0 * kSixDigits);
  const char* support = "gearset.dynamics.sun.support_stiffness";
  EXPECT_NEAR(held.with(support, "4e8 N/m").quantity(tilt) / angular, 4.0, 8.0 * kSixDigits);
  EXPECT_EQ(held.with(support, "0 N/m").quantity(tilt), 0.0);
  const char* axial = "gearset.dynamics.sun.axial_stiffness";
  EXPECT_EQ(held.quantity(axial), 0.0);
  EXPECT_EQ(held.quantity("gearset.dynamics.planet.axial_stiffness"), 0.0);
  EXPECT_NEAR(held.with("gearset.helix_angle", "10 deg").quantity(axial) /
                  held.with("gearset.helix_angle", "10 deg").quantity(support),
              1.0, 2.0 * kSixDigits);
}

// Without bearings there is nothing to derive.
TEST(DerivedDefaults, BelongToBearings) {
  const ResolvedCase gears = read_case(ORBEARING_SOURCE_DIR "/cases/lin_parker_1999/case.yaml", {});
  for (const std::string& path : kOfBearing) EXPECT_FALSE(gears.has(path)) << path;
}

}  // namespace
}  // namespace orbearing::app::derived_defaults_test
