// The program's catalogue: inferred interiors of its bearings compared with makers' data, dimensions with the
// rules of ISO 15, and the designations nearest to an unknown one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/case/catalogue_file.hpp"
#include "bearing/catalogue/entries.hpp"
#include "bearing/life/ball_capacity.hpp"
#include "tests/messages.hpp"

namespace orbearing::app::catalogue_lines_test {
namespace {

using namespace bearing::catalogue;
using bearing::catalogue::Entry;  // not that of a case's tree
using testing::ElementsAre;
using testing::UnorderedElementsAre;

constexpr double kWithin = 0.01;    // [-]  of printed ratings
constexpr double kWorst = 0.037;    // [-]  of the few beyond, all of them printed in a second edition as well
constexpr double kRoundOff = 1e-9;  // [-]  of a root that is bisected

const Entry& line(const std::string& designation) {
  const Entry* found = find(built_in_catalogue(), designation);
  if (found == nullptr) throw std::out_of_range(designation);
  return *found;
}

double miss(double found, double published) {
  return found / published - 1.0;
}

// Lines whose C is off by more than 1 %, but within 4 %; C_0 is met by each.
std::vector<std::string> beyond_one_percent(Family family) {
  std::vector<std::string> beyond;
  for (const Entry& entry : built_in_catalogue()) {
    if (entry.family != family) continue;
    const Inside inside = inside_of(entry);
    EXPECT_LT(std::abs(miss(inside.static_rating, entry.static_rating)), kRoundOff) << entry.designations[0];
    const double off = std::abs(miss(inside.dynamic_rating, entry.dynamic_rating));
    EXPECT_LT(off, kWorst) << entry.designations[0];
    if (off > kWithin) beyond.push_back(entry.designations[0]);
  }
  return beyond;
}

// The rules use C of no roller bearing, and C_0 of none but the bearing itself.
TEST(CatalogueLines, DynamicRatingsOfRollerBearingsArePredicted) {
  EXPECT_THAT(beyond_one_percent(Family::cylindrical),
              UnorderedElementsAre("NU 216", "NU 2216", "NU 316", "NU 2316", "NU 319", "NU 224", "NU 2332",
                                   "NU 2336", "NU 2338", "NU 2340"));
  for (const Entry& entry : built_in_catalogue()) {
    if (!has_rollers(entry.family)) continue;
    const Inside inside = inside_of(entry);
    EXPECT_LT(inside.length, entry.width) << entry.designations[0];
    if (entry.family == Family::cylindrical) {
      EXPECT_LT(entry.inner_race + 2.0 * inside.diameter, entry.outside) << entry.designations[0];
    }
  }
}

TEST(CatalogueLines, DynamicRatingsOfBallBearingsArePredicted) {
  EXPECT_THAT(beyond_one_percent(Family::deep_groove), UnorderedElementsAre("6302", "6303", "6310"));
  EXPECT_THAT(beyond_one_percent(Family::angular_contact), UnorderedElementsAre("7002 A", "7210 C"));
}

TEST(CatalogueLines, DynamicRatingsOfNeedleCagesArePredicted) {
  EXPECT_THAT(beyond_one_percent(Family::needle_cage), ElementsAre());
  const Inside inside = inside_of(line("K 20x24x10"));
  EXPECT_DOUBLE_EQ(inside.diameter, 2e-3);
  EXPECT_DOUBLE_EQ(inside.pitch_diameter, 22e-3);
  EXPECT_NEAR(inside.length, 7.4e-3, 0.1e-3);  // needles of 7.8 mm
}

// FAG states NU 2205 E with 13 rollers and races of 31.5 and 46.5 mm.
TEST(CatalogueLines, InsideOfNu2205IsAsAMakerStatesIt) {
  const Inside inside = inside_of(line("NU 2205"));
  EXPECT_EQ(inside.elements, 13);
  EXPECT_DOUBLE_EQ(inside.diameter, 7.5e-3);
  EXPECT_DOUBLE_EQ(inside.pitch_diameter, 39e-3);
}

// If a line states the outer race as well, its rollers follow.
TEST(CatalogueLines, OuterRaceDecidesTheDiameterOfTheRollers) {
  Entry entry = line("NU 2205");
  entry.outer_race = 47.5e-3;
  EXPECT_DOUBLE_EQ(inside_of(entry).diameter, 8e-3);
}

// Balls by f_0 instead of C: the diameter whose C_0 for one ball is f_0 D_b^2 [N, mm], then Z to the next
// whole number.
int balls_by_static_factor(const Entry& entry) {
  constexpr double mm2 = 1e6;
  const double pitch = 0.5 * (entry.bore + entry.outside);
  const auto factor = [&](double diameter) {
    return bearing::rating::static_capacity(bearing::rating::BallSet{.balls = 1,
                                                                     .diameter = diameter,
                                                                     .pitch_diameter = pitch,
                                                                     .contact_angle = entry.contact_angle}) /
           (mm2 * diameter * diameter);
  };
  double small = 0.09 * pitch, large = 0.4 * pitch;  // between them f_0 falls
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (small + large);
    (factor(middle) > entry.static_factor ? small : large) = middle;
  }
  return static_cast<int>(std::lround(entry.static_rating / (entry.static_factor * mm2 * small * small)));
}

// With f_0, which catalogues print for the axial factors, C takes no part at all.
TEST(CatalogueLines, NumbersOfBallsAreThoseOfTheStaticFactor) {
  int alike = 0, all = 0;
  for (const Entry& entry : built_in_catalogue()) {
    if (entry.family != Family::deep_groove) continue;
    ++all;
    if (inside_of(entry).elements == balls_by_static_factor(entry)) ++alike;
  }
  EXPECT_EQ(all, 96);
  EXPECT_GE(alike, all - 4);
}

// Balls are made in sizes of 1/32 inch up to 1 inch, which the inference does not use.
TEST(CatalogueLines, BallsOfSmallAngularContactBearingsAreOfSizesInWhichTheyAreMade) {
  constexpr double size = 25.4e-3 / 32.0;
  for (const char* name : {"7204 A", "7204 B", "7204 C", "7005 A", "7005 C", "7205 A", "7205 B", "7205 C",
                           "7305 A", "7305 B", "7206 A", "7206 B", "7206 C", "7207 A", "7207 B", "7207 C"}) {
    const double steps = inside_of(line(name)).diameter / size;
    EXPECT_LT(std::abs(steps - std::round(steps)), 0.05) << name;
  }
}

TEST(CatalogueLines, OneMoreElementLeavesLessForEach) {
  EXPECT_NEAR(inside_of(line("NU 205")).per_element, -1.0 / 14.0, kRoundOff);
  EXPECT_LT(inside_of(line("6205")).per_element, -0.02);
}

TEST(CatalogueLines, TypesWithRibsShareALine) {
  EXPECT_EQ(&line("NJ 205"), &line("NU 205"));
  EXPECT_EQ(&line("NUP 2306"), &line("NU 2306"));
  for (const char* unknown : {"205", "NU 6205", "NU 299", "6299", "NUP204-E", ""})
    EXPECT_EQ(find(built_in_catalogue(), unknown), nullptr) << unknown;
}

// --- ISO 15

std::string digits_of(const std::string& designation) {
  const std::size_t first = designation.find_first_of("0123456789");
  return designation.substr(first, designation.find_first_not_of("0123456789", first) - first);
}

double bore_of_code(int code) {
  const std::map<int, double> small{{0, 10.0}, {1, 12.0}, {2, 15.0}, {3, 17.0}};
  return small.contains(code) ? small.at(code) : 5.0 * code;
}

// Bores by their code; one outside diameter for all of a bore and diameter series, whatever the family.
TEST(CatalogueLines, DimensionsFollowTheGeneralPlan) {
  std::map<std::string, double> outside;
  int lines = 0;
  for (const Entry& entry : built_in_catalogue()) {
    if (entry.family == Family::needle_cage) continue;
    const std::string digits = digits_of(entry.designations[0]);
    const std::string series_and_code = digits.substr(digits.size() - 3);
    EXPECT_NEAR(1e3 * entry.bore, bore_of_code(std::stoi(series_and_code.substr(1))), 1e-9) << digits;
    const auto [first, fresh] = outside.emplace(series_and_code, entry.outside);
    if (!fresh) {
      EXPECT_DOUBLE_EQ(first->second, entry.outside) << digits;
    }
    EXPECT_EQ(entry.maker, "NSK");
    ++lines;
  }
  EXPECT_EQ(lines, 411);
}

// The larger bearing of a series carries more, but for the third digit of its rating.
TEST(CatalogueLines, RatingsRiseWithTheBore) {
  constexpr double rounding = 0.01;
  std::map<std::string, const Entry*> before;
  for (const Entry& entry : built_in_catalogue()) {
    if (entry.family == Family::needle_cage) continue;
    std::string series = entry.designations[0];
    series.erase(series.find_first_of("0123456789") + digits_of(series).size() - 2, 2);
    if (const Entry* smaller = before[series]) {
      EXPECT_GT(entry.bore, smaller->bore) << entry.designations[0];
      EXPECT_GT(entry.dynamic_rating, (1.0 - rounding) * smaller->dynamic_rating) << entry.designations[0];
      EXPECT_GT(entry.static_rating, (1.0 - rounding) * smaller->static_rating) << entry.designations[0];
    }
    before[series] = &entry;
  }
}

TEST(CatalogueLines, ReachTheSizesOfIndustrialGearboxes) {
  for (const char* name :
       {"NU 240", "NU 2240", "NU 340", "NJ 2340", "6040", "6240", "6340", "7240 B", "7222 C"})
    EXPECT_NE(find(built_in_catalogue(), name), nullptr) << name;
  EXPECT_DOUBLE_EQ(line("NU 2340").dynamic_rating, 1.91e6);
  EXPECT_EQ(full_name(line("NU 2340"), "NU 2340"), "NSK NU 2340 EM");
}

// --- the nearest of them

std::vector<std::string> all_designations() {
  std::vector<std::string> names;
  for (const Entry& entry : built_in_catalogue())
    names.insert(names.end(), entry.designations.begin(), entry.designations.end());
  return names;
}

TEST(CatalogueLines, FiveNearestAreOfTheSameFamilyInTheOrderOfTheirNearness) {
  const std::vector<std::string> names = all_designations();
  EXPECT_THAT(nearest(names, "6204x", 5), ElementsAre("6204", "6203", "6205", "6202", "6206"));
  EXPECT_EQ(nearest(names, "NUP204-E", 5).front(), "NUP 204");
  EXPECT_EQ(nearest(names, "nu-2210 ecp", 5).front(), "NU 2210");
  EXPECT_EQ(nearest(names, "NU 2242", 5).front(), "NU 2240");
  EXPECT_EQ(nearest(names, "7210 BEP", 5).front().substr(0, 4), "7210");
  EXPECT_EQ(nearest(names, "K 20x26x17", 5).front(), "K 20x26x12");  // same bore, same outside diameter
  for (const std::string& name : nearest(names, "K 20x24x12", 5)) EXPECT_TRUE(name.starts_with("K ")) << name;
  EXPECT_EQ(nearest(names, "22210 E", 5).size(), 5u);  // of no family that is listed
}

}  // namespace
}  // namespace orbearing::app::catalogue_lines_test
