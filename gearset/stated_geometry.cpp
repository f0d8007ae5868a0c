#include "gearset/stated_geometry.hpp"

#include <cmath>

#include "gearset/checks.hpp"
#include "gearset/working_geometry.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::gearset {

namespace {

constexpr const char *kDistance = "gearset.centre_distance", *kPlanetShift = "gearset.profile_shift.planet",
                     *kRingShift = "gearset.profile_shift.ring";
constexpr double kDistanceRounding = 1e-5;  // [m]  of drawings and of shifts printed with four digits
constexpr double kShiftRounding = 5e-3;     // [module]
constexpr double kRoundOffOfPrint = 1e-9;   // [-]
constexpr int kDigits = 6;

bool agrees(const std::optional<double>& stated, double derived, double rounding) {
  return !stated || std::abs(*stated - derived) <= rounding * (1.0 + kRoundOffOfPrint);
}

bool distance_fits(const StatedGeometry& stated, const WorkingGeometry& geometry) {
  return agrees(stated.centre_distance, geometry.centre_distance, kDistanceRounding);
}
bool shift_fits(const StatedGeometry& stated, const WorkingGeometry& geometry) {
  return agrees(stated.planet_shift, geometry.planet_shift, kShiftRounding);
}
bool fits(const StatedGeometry& stated, const WorkingGeometry& geometry) {
  return distance_fits(stated, geometry) && shift_fits(stated, geometry);
}

// The same set with the ring's shift read by DIN's sign; nothing where it cannot be assembled.
std::optional<WorkingGeometry> with_opposite_sign(PlanetarySet set) {
  set.ring_shift = -set.ring_shift;
  if (set.ring_shift == 0.0 || !assembly_problems(set).empty()) return std::nullopt;
  return working_geometry(set);
}

std::string distance_text(const WorkingGeometry& geometry) {
  return decimal(1e3 * geometry.centre_distance, 4) + " mm";
}
std::string geometry_text(const WorkingGeometry& geometry) {
  return "centre distance " + distance_text(geometry) + " and planet shift " +
         decimal(geometry.planet_shift, 4);
}
std::string number(double value) {
  return mechanics::significant(value, kDigits);
}

}  // namespace

Warnings geometry_problems(const PlanetarySet& set, const StatedGeometry& stated) {
  if (!stated.centre_distance && !stated.planet_shift) return {};
  const WorkingGeometry geometry = working_geometry(set);
  if (fits(stated, geometry)) return {};
  std::string remedy = "which follows from teeth, module, helix angle and profile shifts, is required";
  if (const auto other = with_opposite_sign(set); other && fits(stated, *other))
    remedy += std::string("; ") + kRingShift + " of the opposite sign, " + number(-set.ring_shift) +
              ", gives " + geometry_text(*other) +
              ": sources by DIN 3960 print a ring's shift with that sign";
  Warnings problems;
  if (!distance_fits(stated, geometry))
    problems.push_back({kDistance, distance_text(geometry) + " within 0.01 mm, " + remedy});
  if (!shift_fits(stated, geometry))
    problems.push_back({kPlanetShift, decimal(geometry.planet_shift, 4) + " within 0.005, " + remedy});
  return problems;
}

Warnings ring_sign_warnings(const PlanetarySet& set, const StatedGeometry& stated) {
  if (set.ring_shift >= 0.0 || stated.centre_distance || stated.planet_shift) return {};
  const auto other = with_opposite_sign(set);
  if (!other) return {};
  return {{kRingShift,
           number(set.ring_shift) +
               " is negative; sources by DIN 3960 print a ring's shift with the opposite sign. As stated it "
               "gives " +
               geometry_text(working_geometry(set)) + "; " + number(-set.ring_shift) + " gives " +
               geometry_text(*other) + ". State gearset.centre_distance, which is checked"}};
}

}  // namespace orbearing::gearset
