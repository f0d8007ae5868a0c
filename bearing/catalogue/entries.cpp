#include "bearing/catalogue/entries.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/roller_capacity.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::catalogue {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

// A designation as words and numbers: NU, 22, 10, E of "NU 2210-E"; the last two digits of the first number
// are the bore's where it has three or more.
struct Parts {
  std::string letters;
  int series = 0;
  std::vector<double> sizes;  // code of the bore, then what follows: 20, 24, 10 of "K 20x24x10"
  std::string suffix;
};

Parts parts_of(std::string_view designation) {
  Parts parts;
  std::string number;
  const auto end_number = [&] {
    if (number.empty()) return;
    int value = 0;
    for (const char c : number) value = std::min(10 * value + (c - '0'), 10'000'000);
    const bool coded = parts.sizes.empty() && number.size() > 2;
    parts.series += coded ? value / 100 : 0;
    parts.sizes.push_back(coded ? value % 100 : value);
    number.clear();
  };
  for (const char c : designation) {
    if (is_digit(c)) {
      number += c;
      continue;
    }
    end_number();
    if (is_letter(c) && !(upper(c) == 'X' && !parts.sizes.empty()))
      (parts.sizes.empty() ? parts.letters : parts.suffix) += upper(c);
  }
  end_number();
  return parts;
}

// Rollers with rings, needle cages, deep grooves, angular contact: by letters, else by the first digit.
std::string family_of(const Parts& parts) {
  if (parts.letters == "N" || parts.letters == "NU" || parts.letters == "NJ" || parts.letters == "NUP")
    return "N";
  return parts.letters.empty() ? std::to_string(parts.series).substr(0, 1) : parts.letters;
}

// Steps of the bore count most, then the series, then ribs and suffix. A width, which is behind bore and
// outside diameter of a needle cage, counts less than both.
double distance(const Parts& a, const Parts& b) {
  constexpr double per_size = 0.4, per_width = 0.05, per_series = 1.0, per_letters = 0.7, per_suffix = 0.3;
  constexpr std::size_t width = 2;
  double sum = (a.series != b.series ? per_series : 0.0) + (a.letters != b.letters ? per_letters : 0.0) +
               (a.suffix != b.suffix ? per_suffix : 0.0);
  const std::size_t most = std::max(a.sizes.size(), b.sizes.size());
  for (std::size_t i = 0; i < most; ++i)
    sum += (i < width ? per_size : per_width) *
           (i < a.sizes.size() && i < b.sizes.size() ? std::abs(a.sizes[i] - b.sizes[i]) : 1.0);
  return sum;
}

// "NU210" as "NU 210".
std::string without_blanks(std::string_view designation) {
  std::string text;
  std::copy_if(designation.begin(), designation.end(), std::back_inserter(text),
               [](char c) { return c != ' '; });
  return text;
}

}  // namespace

std::string full_name(const Entry& entry, std::string_view designation) {
  std::string name = entry.maker.empty() ? "" : entry.maker + " ";
  name += designation;
  return entry.suffix.empty() ? name : name + " " + entry.suffix;
}

const Entry* find(const std::vector<Entry>& entries, std::string_view designation) {
  const std::string wanted = without_blanks(designation);
  for (const Entry& entry : entries)
    for (const std::string& known : entry.designations)
      if (without_blanks(known) == wanted) return &entry;
  return nullptr;
}

std::vector<std::string> nearest(const std::vector<std::string>& designations, std::string_view unknown,
                                 std::size_t count) {
  const Parts given = parts_of(unknown);
  std::vector<std::pair<double, std::string>> near, others;
  for (const std::string& designation : designations) {
    const Parts parts = parts_of(designation);
    (family_of(parts) == family_of(given) ? near : others).emplace_back(distance(parts, given), designation);
  }
  if (near.empty()) near = std::move(others);
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> found;
  for (const auto& [distance, designation] : near)
    if (found.size() < count) found.push_back(designation);
  return found;
}

namespace {

using constants::pi;

constexpr double kOuterWall = 0.87;                   // [-]  of the inner ring's
constexpr double kPitchOfRollers = 1.25;              // [-]  of their diameter
constexpr double kRollerSizes = 0.5e-3;               // [m]
constexpr int kFewest = 4, kMost = 60;                // balls
constexpr double kMillimetre = 1e-3;                  // [m]
constexpr double kOfCage = 2e-3;                      // [m]  of its width besides the needles, at least
constexpr double kShorter = 0.2, kRoundedEnds = 0.4;  // [mm]  of a needle
constexpr double kWholeNumber = 0.01;                 // [-]  ratings are printed with three digits

// The argument between `low` and `high` at which the rising or falling `value` is 0; none where it does not
// change its sign.
std::optional<double> root_of(const std::function<double(double)>& value, double low, double high) {
  const bool rises = value(high) > 0.0;
  if (rises == (value(low) > 0.0)) return std::nullopt;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    ((value(middle) > 0.0) == rises ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

rating::BallSet ball_set_of(const Entry& entry, int balls, double diameter) {
  return {.balls = balls,
          .diameter = diameter,
          .pitch_diameter = 0.5 * (entry.bore + entry.outside),
          .contact_angle = entry.contact_angle};
}

// Eq. (5).
std::optional<double> ball_diameter(const Entry& entry, int balls) {
  const double most = 0.5 * (entry.bore + entry.outside) * std::sin(pi / balls);
  return root_of(
      [&](double diameter) {
        return rating::static_capacity(ball_set_of(entry, balls, diameter)) - entry.static_rating;
      },
      0.1 * most, most);
}

Inside of_balls(const Entry& entry, int balls, double diameter) {
  const rating::BallSet set = ball_set_of(entry, balls, diameter);
  const std::optional<double> with_one_more = ball_diameter(entry, balls + 1);
  return {.elements = balls,
          .diameter = diameter,
          .pitch_diameter = set.pitch_diameter,
          .dynamic_rating = rating::dynamic_capacity(set),
          .static_rating = rating::static_capacity(set),
          .per_element = with_one_more ? *with_one_more / diameter - 1.0 : 0.0};
}

Inside balls_inside(const Entry& entry) {
  std::optional<Inside> best;
  const auto miss = [&](const Inside& inside) {
    return std::abs(std::log(inside.dynamic_rating / entry.dynamic_rating));
  };
  for (int balls = kFewest; balls <= kMost; ++balls) {
    const std::optional<double> diameter = ball_diameter(entry, balls);
    if (!diameter) continue;
    const Inside inside = of_balls(entry, balls, *diameter);
    if (!best || miss(inside) < miss(*best)) best = inside;
  }
  mechanics::require(best.has_value(), "static rating", entry.static_rating,
                     "one that balls of this section have");
  return *best;
}

// Eq. (1), or what both races leave.
double roller_diameter(const Entry& entry) {
  if (entry.outer_race > 0.0) return 0.5 * (entry.outer_race - entry.inner_race);
  const double inner_wall = 0.5 * (entry.inner_race - entry.bore);
  const double room = 0.5 * (entry.outside - entry.bore) - (1.0 + kOuterWall) * inner_wall;
  return kRollerSizes * std::round(room / kRollerSizes);
}

rating::RollerSet roller_set_of(const Entry& entry) {
  const double diameter = roller_diameter(entry);
  mechanics::require(diameter > 0.0, "diameter of the rollers", diameter,
                     "more than 0 between the inner race and the outer ring");
  return {.diameter = diameter, .length = kMillimetre, .pitch_diameter = entry.inner_race + diameter};
}

// Product of number and length [m] of rollers with the static rating of the line.
double rollers_times_length(const Entry& entry, rating::RollerSet one) {
  one.rollers = 1;
  return one.length * entry.static_rating / rating::static_capacity(one);
}

Inside of_rollers(rating::RollerSet set, int rollers, double rollers_times_length) {
  set.rollers = rollers;
  set.length = rollers_times_length / rollers;
  return {.elements = rollers,
          .diameter = set.diameter,
          .length = set.length,
          .pitch_diameter = set.pitch_diameter,
          .dynamic_rating = rating::dynamic_capacity(set),
          .static_rating = rating::static_capacity(set),
          .per_element = -1.0 / (rollers + 1.0)};
}

Inside rollers_inside(const Entry& entry) {
  const rating::RollerSet set = roller_set_of(entry);
  const int rollers =
      static_cast<int>(std::lround(pi * set.pitch_diameter / (kPitchOfRollers * set.diameter)));
  return of_rollers(set, rollers, rollers_times_length(entry, set));
}

// Eq. (8).
Inside needles_inside(const Entry& entry) {
  const rating::RollerSet set = roller_set_of(entry);
  const double product = rollers_times_length(entry, set);
  const int most = static_cast<int>(pi / std::asin(set.diameter / set.pitch_diameter));
  for (int size = static_cast<int>((entry.width - kOfCage) / kMillimetre + kShorter); size > 1; --size) {
    const double length = (size - kShorter - kRoundedEnds) * kMillimetre;
    const double number = product / length;
    const int whole = static_cast<int>(std::lround(number));
    if (whole <= most && std::abs(number / whole - 1.0) < kWholeNumber)
      return of_rollers(set, whole, product);
  }
  mechanics::refuse("static rating", entry.static_rating, "one that a whole number of needles has");
}

}  // namespace

Inside inside_of(const Entry& entry) {
  switch (entry.family) {
    case Family::cylindrical:
      return rollers_inside(entry);
    case Family::needle_cage:
      return needles_inside(entry);
    default:
      return balls_inside(entry);
  }
}

}  // namespace orbearing::bearing::catalogue
