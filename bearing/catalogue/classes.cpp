#include "bearing/catalogue/classes.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <utility>

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
  const std::span<const ClearanceRow> table = has_rollers(family)
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

namespace {

constexpr double kSeatMicrometre = 1e-6;
constexpr std::size_t kSteps = 11;

// Steps of diameters: each value below holds up to this [mm], from the one before, the first from 3 mm.
constexpr std::array<double, kSteps> kUpTo{6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400};

// Tolerances of the grades 4 to 8 [um].
constexpr std::array<std::array<double, kSteps>, 5> kGrades{{{4, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18},
                                                             {5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25},
                                                             {8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36},
                                                             {12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57},
                                                             {18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89}}};

// The end of a shaft's field that is nearer to the nominal diameter [um]: above it, but for f and g, which
// lie below.
struct ShaftLetter {
  std::string_view letter;
  std::array<double, kSteps> nearer;
};
constexpr std::array<ShaftLetter, 7> kShafts{{{"f", {-10, -13, -16, -20, -25, -30, -36, -43, -50, -56, -62}},
                                              {"g", {-4, -5, -6, -7, -9, -10, -12, -14, -15, -17, -18}},
                                              {"h", {}},
                                              {"k", {1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 4}},
                                              {"m", {4, 6, 7, 8, 9, 11, 13, 15, 17, 20, 21}},
                                              {"n", {8, 10, 12, 15, 17, 20, 23, 27, 31, 34, 37}},
                                              {"p", {12, 15, 18, 22, 26, 32, 37, 43, 50, 56, 62}}}};

// The letter j lies about the nominal diameter by no rule: least deviation of shafts, of grades 5 and 6, and
// most of holes, of grades 6 and 7 [um].
constexpr std::array<double, kSteps> kLeastOfJ{-2, -2, -3, -4, -5, -7, -9, -11, -13, -16, -18};
constexpr std::array<std::array<double, kSteps>, 2> kMostOfJ{
    {{5, 5, 6, 8, 10, 13, 16, 18, 22, 25, 29}, {6, 8, 10, 12, 14, 18, 22, 26, 30, 36, 39}}};

std::size_t step_of(double diameter) {
  constexpr double least = 3e-3, round_off = 1e-9;  // [m]
  const auto* const step = std::find_if(kUpTo.begin(), kUpTo.end(),
                                        [&](double most) { return diameter <= 1e-3 * most + round_off; });
  if (!(diameter > least) || step == kUpTo.end())
    throw std::invalid_argument("a diameter from 3 to 400 mm is required");
  return static_cast<std::size_t>(step - kUpTo.begin());
}

struct Class {
  std::string letter;  // small
  int grade = 0;
};

Class split(std::string_view name) {
  Class out;
  for (const char c : name) {
    if (c >= '0' && c <= '9')
      out.grade = 10 * out.grade + (c - '0');
    else
      out.letter += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  return out;
}

double tolerance(int grade, std::size_t step) {
  return kGrades.at(static_cast<std::size_t>(grade - 4)).at(step);
}

const std::array<double, kSteps>& nearer_end(const std::string& letter) {
  for (const ShaftLetter& one : kShafts)
    if (one.letter == letter) return one.nearer;
  throw std::logic_error("no class of seats with the letter '" + letter + "'");
}

// Classes of those letters in the grades up to 7, after `singles`.
std::vector<std::string> classes(std::vector<std::string> singles, const std::vector<std::string>& letters,
                                 int first_grade) {
  std::vector<std::string> all = std::move(singles);
  for (const std::string& letter : letters)
    for (int grade = first_grade; grade <= 7; ++grade) all.push_back(letter + std::to_string(grade));
  return all;
}

// Shafts of the letters f, g and h, whose holes lie above the nominal diameter.
bool lies_below(const Class& name) {
  return name.letter == "f" || name.letter == "g" || name.letter == "h";
}

// The exception that [ISO286] makes of its rule: M6 above 250 to 315 mm, -9 instead of -11 um.
constexpr std::size_t kFrom250 = 9;
constexpr double kMostOfM6 = -9;

Deviations micrometres(double least, double most) {
  return {kSeatMicrometre * least, kSeatMicrometre * most};
}

// By how much bores and outsides of normal accuracy are smaller than nominal at most [um].
constexpr std::array<double, kSteps> kBores{8, 8, 8, 10, 12, 15, 20, 25, 30, 35, 40};
// Outsides have a step of their own at 150 mm.
double outside_tolerance(double diameter) {
  constexpr double own_step = 0.15, below = 18;
  constexpr std::array<double, kSteps> outsides{8, 8, 8, 9, 11, 13, 15, 25, 30, 35, 40};
  const std::size_t step = step_of(diameter);
  return diameter > 0.12 && diameter <= own_step ? below : outsides.at(step);
}

}  // namespace

std::vector<std::string> shaft_classes() {
  return classes({"j5", "j6"}, {"g", "h", "js", "k", "m", "n", "p"}, 5);
}

std::vector<std::string> hole_classes() {
  return classes({"F7", "H8", "J6", "J7"}, {"G", "H", "JS", "K", "M", "N", "P"}, 6);
}

Deviations shaft_deviations(std::string_view shaft, double diameter) {
  const Class name = split(shaft);
  const std::size_t step = step_of(diameter);
  const double width = tolerance(name.grade, step);
  if (name.letter == "js") return micrometres(-0.5 * width, 0.5 * width);
  if (name.letter == "j") return micrometres(kLeastOfJ.at(step), kLeastOfJ.at(step) + width);
  const double nearer = nearer_end(name.letter).at(step);
  return lies_below(name) ? micrometres(nearer - width, nearer) : micrometres(nearer, nearer + width);
}

// Holes mirror shafts; of those that press, the finer grade of the shaft that goes with them makes the fit,
// so that the difference of both tolerances is added.
Deviations hole_deviations(std::string_view hole, double diameter) {
  const Class name = split(hole);
  const std::size_t step = step_of(diameter);
  const double width = tolerance(name.grade, step);
  if (name.letter == "js") return micrometres(-0.5 * width, 0.5 * width);
  if (name.letter == "j") {
    const double most = kMostOfJ.at(static_cast<std::size_t>(name.grade - 6)).at(step);
    return micrometres(most - width, most);
  }
  const double nearer = -nearer_end(name.letter).at(step);
  if (lies_below(name)) return micrometres(nearer, nearer + width);
  if (hole == "M6" && step == kFrom250) return micrometres(kMostOfM6 - width, kMostOfM6);
  const double upper = nearer + width - tolerance(name.grade - 1, step);
  return micrometres(upper - width, upper);
}

Deviations inner_interference(std::string_view shaft, double bore) {
  const Deviations pin = shaft_deviations(shaft, bore);
  return {pin.least, pin.most + kSeatMicrometre * kBores.at(step_of(bore))};
}

Deviations outer_interference(std::string_view hole, double outside_diameter) {
  const Deviations seat = hole_deviations(hole, outside_diameter);
  return {-seat.most - kSeatMicrometre * outside_tolerance(outside_diameter), -seat.least};
}

}  // namespace orbearing::bearing::catalogue
