#include "bearing/catalogue/entries.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/roller_capacity.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::catalogue {

namespace {

constexpr double mm = 1e-3;
constexpr std::array<std::string_view, 3> kRollerTypes{"NU ", "NJ ", "NUP "};

constexpr Entry rollers(std::string_view number, double bore, double outside, double width, double inner_race,
                        double dynamic_rating, double static_rating) {
  return {.number = number,
          .family = Family::cylindrical,
          .bore = mm * bore,
          .outside = mm * outside,
          .width = mm * width,
          .dynamic_rating = dynamic_rating,
          .static_rating = static_rating,
          .inner_race = mm * inner_race};
}

constexpr Entry deep_groove(std::string_view number, double bore, double outside, double width,
                            double dynamic_rating, double static_rating, double static_factor) {
  return {.number = number,
          .family = Family::deep_groove,
          .bore = mm * bore,
          .outside = mm * outside,
          .width = mm * width,
          .dynamic_rating = dynamic_rating,
          .static_rating = static_rating,
          .static_factor = static_factor};
}

constexpr Entry angular(std::string_view number, double degrees, double bore, double outside, double width,
                        double dynamic_rating, double static_rating) {
  return {.number = number,
          .family = Family::angular_contact,
          .bore = mm * bore,
          .outside = mm * outside,
          .width = mm * width,
          .dynamic_rating = dynamic_rating,
          .static_rating = static_rating,
          .contact_angle = degrees * constants::degree};
}

// [NSKE1102]: pages B84 to B87 (suffixes ET, EW), B8 to B13, B50 to B53.
const std::vector<Entry> kEntries{
    rollers("204", 20, 47, 14, 26.5, 25700, 22600),      rollers("2204", 20, 47, 18, 26.5, 30500, 28300),
    rollers("304", 20, 52, 15, 27.5, 31500, 26900),      rollers("205", 25, 52, 15, 31.5, 29300, 27700),
    rollers("2205", 25, 52, 18, 31.5, 35000, 34500),     rollers("305", 25, 62, 17, 34, 41500, 37500),
    rollers("2305", 25, 62, 24, 34, 57000, 56000),       rollers("206", 30, 62, 16, 37.5, 39000, 37500),
    rollers("2206", 30, 62, 20, 37.5, 49000, 50000),     rollers("306", 30, 72, 19, 40.5, 53000, 50000),
    rollers("2306", 30, 72, 27, 40.5, 74500, 77500),     rollers("207", 35, 72, 17, 44, 50500, 50000),
    rollers("2207", 35, 72, 23, 44, 61500, 65500),       rollers("307", 35, 80, 21, 46.2, 66500, 65500),
    rollers("2307", 35, 80, 31, 46.2, 93000, 101000),    rollers("208", 40, 80, 18, 49.5, 55500, 55500),
    rollers("2208", 40, 80, 23, 49.5, 72500, 77500),     rollers("308", 40, 90, 23, 52, 83000, 81500),
    rollers("2308", 40, 90, 33, 52, 114000, 122000),     rollers("209", 45, 85, 19, 54.5, 63000, 66500),
    rollers("2209", 45, 85, 23, 54.5, 76000, 84500),     rollers("309", 45, 100, 25, 58.5, 97500, 98500),
    rollers("210", 50, 90, 20, 59.5, 69000, 76500),      rollers("2210", 50, 90, 23, 59.5, 83500, 97000),
    rollers("310", 50, 110, 27, 65, 110000, 113000),     rollers("211", 55, 100, 21, 66, 86500, 98500),
    rollers("311", 55, 120, 29, 70.5, 137000, 143000),   deep_groove("6200", 10, 30, 9, 5100, 2390, 13.2),
    deep_groove("6201", 12, 32, 10, 6800, 3050, 12.3),   deep_groove("6202", 15, 35, 11, 7650, 3750, 13.2),
    deep_groove("6203", 17, 40, 12, 9550, 4800, 13.2),   deep_groove("6303", 17, 47, 14, 13600, 6650, 12.4),
    deep_groove("6004", 20, 42, 12, 9400, 5000, 13.8),   deep_groove("6204", 20, 47, 14, 12800, 6600, 13.1),
    deep_groove("6304", 20, 52, 15, 15900, 7900, 12.4),  deep_groove("6005", 25, 47, 12, 10100, 5850, 14.5),
    deep_groove("6205", 25, 52, 15, 14000, 7850, 13.9),  deep_groove("6305", 25, 62, 17, 20600, 11200, 13.2),
    deep_groove("6006", 30, 55, 13, 13200, 8300, 14.7),  deep_groove("6206", 30, 62, 16, 19500, 11300, 13.8),
    deep_groove("6306", 30, 72, 19, 26700, 15000, 13.3), angular("7204 A", 30, 20, 47, 14, 14500, 8300),
    angular("7204 B", 40, 20, 47, 14, 13300, 7650),      angular("7204 C", 15, 20, 47, 14, 14600, 8050),
    angular("7005 A", 30, 25, 47, 12, 11300, 7400),      angular("7005 C", 15, 25, 47, 12, 11700, 7400),
    angular("7205 A", 30, 25, 52, 15, 16200, 10300),     angular("7205 B", 40, 25, 52, 15, 14800, 9400),
    angular("7205 C", 15, 25, 52, 15, 16600, 10200),     angular("7305 A", 30, 25, 62, 17, 26400, 15800),
    angular("7305 B", 40, 25, 62, 17, 24400, 14600),     angular("7206 A", 30, 30, 62, 16, 22500, 14800),
    angular("7206 B", 40, 30, 62, 16, 20500, 13500),     angular("7206 C", 15, 30, 62, 16, 23000, 14700),
    angular("7207 A", 30, 35, 72, 17, 29700, 20100),     angular("7207 B", 40, 35, 72, 17, 27100, 18400),
    angular("7207 C", 15, 35, 72, 17, 30500, 19900)};

std::vector<std::string> all_designations() {
  std::vector<std::string> all;
  for (const Entry& entry : kEntries) {
    if (entry.family != Family::cylindrical)
      all.emplace_back(entry.number);
    else
      for (const std::string_view type : kRollerTypes)
        all.push_back(std::string(type) + std::string(entry.number));
  }
  return all;
}

}  // namespace

const std::vector<Entry>& entries() {
  return kEntries;
}

const std::vector<std::string>& designations() {
  static const std::vector<std::string> all = all_designations();
  return all;
}

const Entry* find(std::string_view designation) {
  bool of_rollers = false;
  for (const std::string_view type : kRollerTypes)
    if (!of_rollers && designation.starts_with(type)) {
      of_rollers = true;
      designation.remove_prefix(type.size());
    }
  const auto found = std::find_if(kEntries.begin(), kEntries.end(), [&](const Entry& entry) {
    return entry.number == designation && (entry.family == Family::cylindrical) == of_rollers;
  });
  return found == kEntries.end() ? nullptr : &*found;
}

namespace {

using constants::pi;

constexpr double kOuterWall = 0.87;       // [-]  of the inner ring's
constexpr double kPitchOfRollers = 1.25;  // [-]  of their diameter
constexpr double kRollerSizes = 0.5e-3;   // [m]
constexpr int kFewest = 4, kMost = 60;    // balls

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

Inside rollers_inside(const Entry& entry) {
  const double inner_wall = 0.5 * (entry.inner_race - entry.bore);
  const double room = 0.5 * (entry.outside - entry.bore) - (1.0 + kOuterWall) * inner_wall;
  rating::RollerSet set{.diameter = kRollerSizes * std::round(room / kRollerSizes), .length = 1e-3};
  set.pitch_diameter = entry.inner_race + set.diameter;
  set.rollers = static_cast<int>(std::lround(pi * set.pitch_diameter / (kPitchOfRollers * set.diameter)));
  set.length *= entry.static_rating / rating::static_capacity(set);  // C_0 is proportional to it
  return {.elements = set.rollers,
          .diameter = set.diameter,
          .length = set.length,
          .pitch_diameter = set.pitch_diameter,
          .dynamic_rating = rating::dynamic_capacity(set),
          .static_rating = rating::static_capacity(set),
          .per_element = -1.0 / (set.rollers + 1.0)};
}

}  // namespace

Inside inside_of(const Entry& entry) {
  return entry.family == Family::cylindrical ? rollers_inside(entry) : balls_inside(entry);
}

}  // namespace orbearing::bearing::catalogue
