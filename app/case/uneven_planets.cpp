#include "app/case/uneven_planets.hpp"

#include <algorithm>

#include "gearset/planet_angles.hpp"

namespace orbearing::app {

namespace {

bool is_uneven(const ResolvedCase& in, const std::string& positions) {
  gearset::PlanetarySet set{.planets = in.integer("gearset.planets"), .planet_angles = in.list(positions)};
  if (in.has("gearset.teeth.sun") && in.has("gearset.teeth.ring")) {
    set.sun_teeth = in.integer("gearset.teeth.sun");
    set.ring_teeth = in.integer("gearset.teeth.ring");
  }
  return gearset::stands_unevenly(set);
}

}  // namespace

bool is_anywhere_nonzero(const ResolvedCase& resolved, std::string_view path) {
  if (!resolved.has(path)) return false;
  const std::vector<double>& values = resolved.list(path);
  return std::any_of(values.begin(), values.end(), [](double value) { return value != 0.0; });
}

std::string uneven_planets_by(const ResolvedCase& resolved) {
  for (const char* pins : {"gearset.dynamics.pin_error.radial", "gearset.dynamics.pin_error.tangential"})
    if (is_anywhere_nonzero(resolved, pins)) return pins;
  const char* positions = "gearset.planet_angles";
  for (const char* needed : {positions, "gearset.planets"})
    if (!resolved.has(needed)) return "";
  return is_uneven(resolved, positions) ? positions : "";
}

}  // namespace orbearing::app
