#include "bearing/catalogue/clearance_class.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

#include "mechanics/checks.hpp"

namespace orbearing::bearing::catalogue {

namespace {

constexpr double kMicrometre = 1e-6;
constexpr double kLeastBore = 10e-3;  // [m]  not included

// Bores up to `most_bore` [mm]; C2, CN, C3, C4, C5, each from least to most [um].
struct ClearanceRow {
  double most_bore;
  std::array<std::array<double, 2>, 5> classes;
};

constexpr std::array<ClearanceRow, 13> kDeepGroove{
    {{18, {{{0, 9}, {3, 18}, {11, 25}, {18, 33}, {25, 45}}}},
     {24, {{{0, 10}, {5, 20}, {13, 28}, {20, 36}, {28, 48}}}},
     {30, {{{1, 11}, {5, 20}, {13, 28}, {23, 41}, {30, 53}}}},
     {40, {{{1, 11}, {6, 20}, {15, 33}, {28, 46}, {40, 64}}}},
     {50, {{{1, 11}, {6, 23}, {18, 36}, {30, 51}, {45, 73}}}},
     {65, {{{1, 15}, {8, 28}, {23, 43}, {38, 61}, {55, 90}}}},
     {80, {{{1, 15}, {10, 30}, {25, 51}, {46, 71}, {65, 105}}}},
     {100, {{{1, 18}, {12, 36}, {30, 58}, {53, 84}, {75, 120}}}},
     {120, {{{2, 20}, {15, 41}, {36, 66}, {61, 97}, {90, 140}}}},
     {140, {{{2, 23}, {18, 48}, {41, 81}, {71, 114}, {105, 160}}}},
     {160, {{{2, 23}, {18, 53}, {46, 91}, {81, 130}, {120, 180}}}},
     {180, {{{2, 25}, {20, 61}, {53, 102}, {91, 147}, {135, 200}}}},
     {200, {{{2, 30}, {25, 71}, {63, 117}, {107, 163}, {150, 230}}}}}};

constexpr std::array<ClearanceRow, 12> kCylindrical{
    {{24, {{{0, 25}, {20, 45}, {35, 60}, {50, 75}, {65, 90}}}},
     {30, {{{0, 25}, {20, 45}, {35, 60}, {50, 75}, {70, 95}}}},
     {40, {{{5, 30}, {25, 50}, {45, 70}, {60, 85}, {80, 105}}}},
     {50, {{{5, 35}, {30, 60}, {50, 80}, {70, 100}, {95, 125}}}},
     {65, {{{10, 40}, {40, 70}, {60, 90}, {80, 110}, {110, 140}}}},
     {80, {{{10, 45}, {40, 75}, {65, 100}, {90, 125}, {130, 165}}}},
     {100, {{{15, 50}, {50, 85}, {75, 110}, {105, 140}, {155, 190}}}},
     {120, {{{15, 55}, {50, 90}, {85, 125}, {125, 165}, {180, 220}}}},
     {140, {{{15, 60}, {60, 105}, {100, 145}, {145, 190}, {200, 245}}}},
     {160, {{{20, 70}, {70, 120}, {115, 165}, {165, 215}, {225, 275}}}},
     {180, {{{25, 75}, {75, 125}, {120, 170}, {170, 220}, {250, 300}}}},
     {200, {{{35, 90}, {90, 145}, {140, 195}, {195, 250}, {275, 330}}}}}};

}  // namespace

ClearanceRange clearance_range(Family family, ClearanceClass which, double bore) {
  if (family == Family::angular_contact)
    throw std::invalid_argument("a clearance class of an angular-contact bearing, which has none");
  const std::span<const ClearanceRow> table = family == Family::cylindrical
                                                  ? std::span<const ClearanceRow>(kCylindrical)
                                                  : std::span<const ClearanceRow>(kDeepGroove);
  constexpr double rounding = 1e-9;  // [m]
  const auto row = std::find_if(table.begin(), table.end(), [bore](const ClearanceRow& one) {
    return bore <= 1e-3 * one.most_bore + rounding;
  });
  mechanics::require(
      bore > kLeastBore + rounding && row != table.end(), "bore", bore,
      "more than 10 mm and at most 200 mm, for which the table of clearance classes was entered");
  const auto& ends = row->classes[static_cast<std::size_t>(which)];
  return {.least = kMicrometre * ends[0], .most = kMicrometre * ends[1]};
}

}  // namespace orbearing::bearing::catalogue
