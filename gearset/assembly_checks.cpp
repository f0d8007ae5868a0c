#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "gearset/checks.hpp"
#include "gearset/planet_angles.hpp"
#include "gearset/stepped_planet.hpp"
#include "gearset/warning.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

// Beyond these a shift is a slip of the pen: the rack would cut no usable tooth.
constexpr double largest_shift = 2.0;                                    // [module]
constexpr double largest_pressure_angle = 45.0 * constants::pi / 180.0;  // [rad]

std::string found(double value, const std::string& required) {
  return "found " + decimal(value, 4) + "; " + required;
}

void check_count(int value, const std::string& position, Warnings& problems) {
  if (value > 0) return;
  problems.push_back(
      {position, "found " + std::to_string(value) + "; a whole number of at least 1 is required"});
}

void check_positive(double value, const std::string& position, Warnings& problems) {
  if (value > 0.0 && std::isfinite(value)) return;
  problems.push_back({position, found(value, "a positive, finite value is required")});
}

void check_shift(double shift, const std::string& position, Warnings& problems) {
  if (std::abs(shift) <= largest_shift) return;
  problems.push_back({position, found(shift, "a profile shift between -2 and 2 modules is required")});
}

void check_fillet(const BasicRack& rack, const std::string& block, Warnings& problems) {
  const double tangent = std::tan(rack.pressure_angle);
  const double half_tip = constants::pi / 4.0 - (rack.addendum + rack.clearance) * tangent;  // [module]
  const double largest = half_tip / (1.0 / std::cos(rack.pressure_angle) - tangent);
  if (largest <= 0.0) {
    problems.push_back({block + ".addendum", found(rack.addendum,
                                                   "the rack's teeth end in a point; a smaller "
                                                   "addendum or pressure angle is required")});
  } else if (!(rack.root_fillet_radius >= 0.0 && rack.root_fillet_radius <= largest)) {
    problems.push_back({block + ".root_fillet_radius",
                        found(rack.root_fillet_radius,
                              "from 0 to " + decimal(largest, 4) + " module fits on the rack's tip")});
  }
}

void check_rack(const BasicRack& rack, const std::string& block, Warnings& problems) {
  if (!(rack.pressure_angle > 0.0 && rack.pressure_angle < largest_pressure_angle)) {
    constexpr double per_degree = 180.0 / constants::pi;
    problems.push_back({block + ".pressure_angle", found(per_degree * rack.pressure_angle,
                                                         "an angle between 0 and 45 deg is required")});
    return;
  }
  check_positive(rack.addendum, block + ".addendum", problems);
  if (!(rack.clearance >= 0.0 && std::isfinite(rack.clearance))) {
    problems.push_back(
        {block + ".clearance", found(rack.clearance, "a bottom clearance that is not negative is required")});
  }
  check_fillet(rack, block, problems);
}

Warnings count_problems(const PlanetarySet& set) {
  Warnings problems;
  check_count(set.sun_teeth, "gearset.teeth.sun", problems);
  check_count(set.planet_teeth, "gearset.teeth.planet", problems);
  check_count(set.ring_teeth, "gearset.teeth.ring", problems);
  check_count(set.planets, "gearset.planets", problems);
  return problems;
}

Warnings single_value_problems(const PlanetarySet& set) {
  Warnings problems = count_problems(set);
  check_positive(set.module, "gearset.module", problems);
  check_positive(set.face_width, "gearset.face_width", problems);
  check_shift(set.sun_shift, "gearset.profile_shift.sun", problems);
  check_shift(set.ring_shift, "gearset.profile_shift.ring", problems);
  check_rack(set.rack, "gearset", problems);
  if (!problems.empty()) return problems;
  for (const OwnHeights* own : {&set.sun_heights, &set.planet_heights, &set.ring_heights})
    if (own->addendum || own->clearance) check_rack(rack_of(set, *own), "gearset", problems);
  return problems;
}

// Planets find their tooth spaces only if the step from one to the next moves whole teeth. Eq. (23).
void check_spacing(const PlanetarySet& set, Warnings& problems) {
  if (!set.planet_angles.empty()) {
    for (const Warning& problem : position_problems(set)) problems.push_back(problem);
    return;
  }
  const int sum = willis_teeth(set).positions();
  if (sum % set.planets == 0) return;
  const std::string nearest = nearest_to_even(set);
  if (set.stepped.present()) {
    problems.push_back({"gearset.planets", "found " + std::to_string(set.planets) +
                                               " equally spaced stepped planets; a divisor of (sun x second "
                                               "+ ring x first planet teeth)/(greatest "
                                               "common divisor of both planet gears) = " +
                                               std::to_string(sum) +
                                               " is required; change the number of planets or the teeth"});
    return;
  }
  problems.push_back(
      {"gearset.planets",
       "found " + std::to_string(set.planets) +
           " equally spaced planets; a divisor of sun + ring teeth = " + std::to_string(sum) +
           " is required. Change the number of planets or the teeth, or state gearset.planet_angles" +
           (nearest.empty() ? "" : ": " + nearest + " are nearest to equal steps")});
}

// Eq. (24).
void check_neighbours(const PlanetarySet& set, const WorkingGeometry& geometry, Warnings& problems) {
  if (set.planets < 2) return;
  const double step = std::min(least_step(angles_of_planets(set)), constants::pi);
  const double pitch = 2.0 * geometry.centre_distance * std::sin(0.5 * step);
  const double tip_diameter = 2.0 * std::max(geometry.planet.tip_radius, geometry.at_ring().tip_radius);
  if (tip_diameter < pitch) return;
  problems.push_back({"gearset.planets", "found planets with a tip diameter of " + millimetres(tip_diameter) +
                                             " whose axes lie " + millimetres(pitch) +
                                             " apart; neighbours must not touch; use fewer planets"});
}

void check_rim(const PlanetarySet& set, const WorkingGeometry& geometry, Warnings& problems) {
  const double root_diameter = 2.0 * std::min(geometry.planet.root_radius, geometry.at_ring().root_radius);
  if (set.planet_bore >= 0.0 && set.planet_bore < root_diameter) return;
  problems.push_back({"bearing.outside_diameter",
                      "found a planet bore of " + millimetres(set.planet_bore) +
                          "; less than the planet's root diameter " + millimetres(root_diameter) +
                          " is required; use a smaller bearing or a larger module"});
}

void check_pointed(double tip_half_angle, const std::string& gear, Warnings& problems) {
  if (tip_half_angle > 0.0) return;
  problems.push_back({"gearset.profile_shift", "found flanks that cross before the tip circle of the " +
                                                   gear +
                                                   "; a tooth with a tip is required; lower the shift or the "
                                                   "addendum"});
}

void check_reach(const MeshGeometry& mesh, const std::string& name, Warnings& problems) {
  if (mesh.path.length() > 0.0) return;
  problems.push_back(
      {"gearset.profile_shift",
       "found no path of contact in the " + name +
           " mesh; teeth that reach each other are required; change the shifts of sun and ring"});
}

// For a set that cannot be assembled: checks the tooth numbers before the profile shifts.
void check_tooth_sum(const PlanetarySet& set, Warnings& problems) {
  constexpr int by_shifts = 2;  // teeth that usual shifts make up
  const int sum = set.sun_teeth + 2 * set.planet_teeth;
  if (std::abs(set.ring_teeth - sum) <= by_shifts) return;
  problems.push_back({"gearset.teeth.ring", "found " + std::to_string(set.ring_teeth) +
                                                ", where sun + 2 planet = " + std::to_string(set.sun_teeth) +
                                                " + 2 x " + std::to_string(set.planet_teeth) + " = " +
                                                std::to_string(sum) +
                                                "; a ring with about this number of teeth is required. "
                                                "Profile shifts compensate one or two teeth"});
}

void check_geometry(const PlanetarySet& set, Warnings& problems) {
  const WorkingGeometry geometry = working_geometry(set);
  if (position_problems(set).empty()) check_neighbours(set, geometry, problems);
  check_rim(set, geometry, problems);
  check_pointed(half_thickness_angle(geometry.sun, geometry.sun.tip_radius), "sun", problems);
  check_pointed(half_thickness_angle(geometry.planet, geometry.planet.tip_radius), "planet", problems);
  if (geometry.second)
    check_pointed(half_thickness_angle(*geometry.second, geometry.second->tip_radius), "planet's second gear",
                  problems);
  check_pointed(half_thickness_angle(geometry.ring, geometry.ring.tip_radius), "ring", problems);
  check_reach(geometry.sun_mesh, "sun", problems);
  check_reach(geometry.ring_mesh, "ring", problems);
}

}  // namespace

Warnings rack_problems(const BasicRack& rack, const std::string& block) {
  Warnings problems;
  check_rack(rack, block, problems);
  return problems;
}

Warnings spacing_problems(const PlanetarySet& set) {
  Warnings problems = count_problems(set);
  if (problems.empty()) check_spacing(set, problems);
  return problems;
}

Warnings assembly_problems(const PlanetarySet& set) {
  Warnings problems = single_value_problems(set);
  if (!problems.empty()) return problems;
  check_spacing(set, problems);
  Warnings of_geometry;
  try {
    check_geometry(set, of_geometry);
  } catch (const std::domain_error& error) {
    of_geometry.push_back({"gearset.profile_shift", error.what()});
  }
  if (!of_geometry.empty() && !set.stepped.present()) check_tooth_sum(set, problems);
  problems.insert(problems.end(), of_geometry.begin(), of_geometry.end());
  return problems;
}

}  // namespace orbearing::gearset
