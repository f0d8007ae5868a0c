#include "app/case/set_case.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/case/described_case.hpp"
#include "app/case/machine_of.hpp"
#include "app/case/mistake.hpp"
#include "gearset/planet_angles.hpp"

namespace orbearing::app {

namespace {

bool is_uneven(const ResolvedCase& in, const std::string& positions) {
  gearset::PlanetarySet set{.planets = in.integer("gearset.planets"), .planet_angles = in.list(positions)};
  if (in.has("gearset.teeth.sun") && in.has("gearset.teeth.ring")) {
    set.sun_teeth = in.integer("gearset.teeth.sun");
    set.ring_teeth = in.integer("gearset.teeth.ring");
  }
  return gearset::is_unequally_spaced(set);
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

namespace {

double planet_bore_of(const ResolvedCase& in, const gearset::PlanetarySet& set) {
  if (in.has("bearing.outside_diameter")) return in.quantity("bearing.outside_diameter");
  constexpr double feet = 2.5;  // [module]  of two standard teeth
  return in.number("gearset.planet_bore_ratio") * set.module *
         (set.planet_teeth / std::cos(set.helix_angle) - feet);
}

}  // namespace

gearset::PlanetarySet set_of(const ResolvedCase& resolved) {
  gearset::PlanetarySet set = stated_set(resolved);
  set.planet_bore = planet_bore_of(resolved, set);
  set.density = resolved.quantity("material.density");
  return set;
}

gearset::PlanetarySet stated_set(const ResolvedCase& resolved) {
  return from_case<gearset::PlanetarySet>(resolved);
}

bool has_stepped_planets(const ResolvedCase& resolved) {
  return resolved.has("gearset.stepped_planet.teeth");
}

bool has_planet_pairs(const ResolvedCase& resolved) {
  return resolved.has("gearset.second_planet.teeth");
}

gearset::SecondPlanet second_planet_of(const ResolvedCase& resolved) {
  return from_case<gearset::SecondPlanet>(resolved);
}

std::string location_in_case(const ResolvedCase& resolved, const std::string& location) {
  const bool of_bore = location == "bearing.outside_diameter" && !resolved.has(location);
  return of_bore ? "gearset.planet_bore_ratio" : location;
}

gearset::StatedGeometry stated_geometry(const ResolvedCase& in) {
  return machine_of<gearset::StatedGeometry>(in);
}

void check_stated_geometry(CheckedCase& in) {
  for (const gearset::Warning& problem : gearset::geometry_problems(set_of(in), stated_geometry(in)))
    in.add_error_at(problem.key, quote(in.given(problem.key)), problem.text);
}

std::vector<std::string> ring_sign_warnings(const ResolvedCase& in) {
  std::vector<std::string> texts;
  for (const gearset::Warning& warning : gearset::ring_sign_warnings(set_of(in), stated_geometry(in)))
    texts.push_back(warning.key + ": " + warning.text);
  return texts;
}

}  // namespace orbearing::app
