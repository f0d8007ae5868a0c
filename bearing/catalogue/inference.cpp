#include "bearing/catalogue/inference.hpp"

#include <cmath>
#include <functional>
#include <optional>

#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/roller_capacity.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::catalogue {

namespace {

using constants::pi;

constexpr double kOuterWall = 0.87;         // [-]  of the inner ring's
constexpr double kPitchOfRollers = 1.25;    // [-]  of their diameter
constexpr double kRollerSizes = 0.5e-3;     // [m]
constexpr int kFewest = 4, kMost = 60;      // balls

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
