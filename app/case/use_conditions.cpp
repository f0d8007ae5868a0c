#include "app/case/use_conditions.hpp"

#include <algorithm>
#include <cmath>

namespace orbearing::app {

namespace {

constexpr double kSame = 1e-12;  // [m]  lengths that are stated as equal

bool is_nonzero(const ResolvedCase& in, const char* path) {
  return in.has(path) && in.quantity(path) != 0.0;
}

bool is_chosen(const ResolvedCase& in, const char* path, const char* value) {
  return in.has(path) && in.choice(path) == value;
}

// Of values of bearings along the pin, or of points along a roller, from one end to the other.
bool are_mirrored(const std::vector<double>& values, double sign) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i] - sign * values[values.size() - 1 - i]) > kSame) return false;
  return true;
}

// Clearances of bearings in the order of their places.
bool has_unlike_ends(const ResolvedCase& in) {
  const std::string places = "bearing.axial_places", differences = "bearing.clearance_differences";
  std::vector<std::size_t> order;
  std::vector<double> place, clearance;
  if (in.has(places)) place = in.list(places);
  if (in.has(differences)) clearance = in.list(differences);
  for (std::size_t i = 0; i < std::max(place.size(), clearance.size()); ++i) order.push_back(i);
  if (!place.empty() && (clearance.empty() || clearance.size() == place.size()))
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
  const auto sorted = [&](const std::vector<double>& values) {
    std::vector<double> out;
    for (const std::size_t i : order)
      if (i < values.size()) out.push_back(values[i]);
    return out;
  };
  return !are_mirrored(sorted(place), -1.0) || !are_mirrored(sorted(clearance), 1.0);
}

bool has_unlike_roller_ends(const ResolvedCase& in) {
  if (!is_chosen(in, "bearing.profile.kind", "table")) return false;
  return !are_mirrored(in.list("bearing.profile.x"), -1.0) ||
         !are_mirrored(in.list("bearing.profile.drops"), 1.0);
}

bool turns(const ResolvedCase& in) {
  return is_nonzero(in, "operation.shaft_speed");
}

}  // namespace

bool planets_tilt(const ResolvedCase& in) {
  return is_nonzero(in, "gearset.helix_angle") || is_chosen(in, "support.pin_ends", "one") ||
         is_nonzero(in, "support.pin_inclination.radial") ||
         is_nonzero(in, "support.pin_inclination.tangential") || in.has("support.carrier_twist_stiffness") ||
         has_unlike_ends(in) || has_unlike_roller_ends(in);
}

bool bearings_tilt(const ResolvedCase& in) {
  return planets_tilt(in) || (in.has("bearing.per_planet") && in.integer("bearing.per_planet") > 1);
}

bool pair_has_linear_column(const ResolvedCase& in) {
  return in.has("arrangement") && in.choice("arrangement") != "back-to-back" && !turns(in);
}

bool pair_run_has_linear_column(const ResolvedCase& in) {
  return pair_has_linear_column(in) ||
         (in.has("measured.preload") && in.choice("arrangement") != "back-to-back");
}

}  // namespace orbearing::app
