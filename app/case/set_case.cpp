#include "app/case/set_case.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/case/described_case.hpp"
#include "app/case/mistake.hpp"
#include "app/units.hpp"
#include "gearset/checks.hpp"
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

namespace {

constexpr const char *kDistance = "gearset.centre_distance", *kPlanetShift = "gearset.profile_shift.planet",
                     *kRingShift = "gearset.profile_shift.ring";
constexpr double kDistanceRounding = 1e-5;  // [m]  of drawings and of shifts printed with four digits
constexpr double kShiftRounding = 5e-3;     // [module]
constexpr double kRoundOffOfPrint = 1e-9;   // [-]

bool agrees(double stated, double derived, double rounding) {
  return std::abs(stated - derived) <= rounding * (1.0 + kRoundOffOfPrint);
}

bool fits(const ResolvedCase& in, const gearset::WorkingGeometry& geometry) {
  return (!in.has(kDistance) ||
          agrees(in.quantity(kDistance), geometry.centre_distance, kDistanceRounding)) &&
         (!in.has(kPlanetShift) || agrees(in.number(kPlanetShift), geometry.planet_shift, kShiftRounding));
}

// The same set with the ring's shift read by DIN's sign; nothing where it cannot be assembled.
std::optional<gearset::WorkingGeometry> with_opposite_sign(gearset::PlanetarySet set) {
  set.ring_shift = -set.ring_shift;
  if (set.ring_shift == 0.0 || !gearset::assembly_problems(set).empty()) return std::nullopt;
  return gearset::working_geometry(set);
}

std::string geometry_text(const gearset::WorkingGeometry& geometry) {
  return fmt::format("centre distance {:.4f} mm and planet shift {:.4f}",
                     per_milli * geometry.centre_distance, geometry.planet_shift);
}

}  // namespace

void check_stated_geometry(CheckedCase& in) {
  if (!in.has(kDistance) && !in.has(kPlanetShift)) return;
  const gearset::PlanetarySet set = set_of(in);
  const gearset::WorkingGeometry geometry = gearset::working_geometry(set);
  if (fits(in, geometry)) return;
  std::string remedy = "which follows from teeth, module, helix angle and profile shifts, is required";
  if (const auto other = with_opposite_sign(set); other && fits(in, *other))
    remedy += fmt::format(
        "; {} of the opposite sign, {:g}, gives {}: sources by DIN 3960 print a ring's "
        "shift with that sign",
        kRingShift, -set.ring_shift, geometry_text(*other));
  if (in.has(kDistance) && !agrees(in.quantity(kDistance), geometry.centre_distance, kDistanceRounding))
    in.add_error_at(
        kDistance, quote(in.given(kDistance)),
        fmt::format("{:.4f} mm within 0.01 mm, {}", per_milli * geometry.centre_distance, remedy));
  if (in.has(kPlanetShift) && !agrees(in.number(kPlanetShift), geometry.planet_shift, kShiftRounding))
    in.add_error_at(kPlanetShift, quote(in.given(kPlanetShift)),
                    fmt::format("{:.4f} within 0.005, {}", geometry.planet_shift, remedy));
}

std::vector<std::string> ring_sign_warnings(const ResolvedCase& in) {
  if (in.number(kRingShift) >= 0.0 || in.has(kDistance) || in.has(kPlanetShift)) return {};
  const gearset::PlanetarySet set = set_of(in);
  const auto other = with_opposite_sign(set);
  if (!other) return {};
  return {
      fmt::format("{}: {:g} is negative; sources by DIN 3960 print a ring's shift with the opposite sign. As "
                  "stated it gives {}; {:g} gives {}. State gearset.centre_distance, which is checked",
                  kRingShift, set.ring_shift, geometry_text(gearset::working_geometry(set)), -set.ring_shift,
                  geometry_text(*other))};
}

}  // namespace orbearing::app
