#include "app/case/use_conditions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "app/case/bearing_type.hpp"
#include "bearing/mounted_clearance.hpp"

namespace orbearing::app {

namespace {

constexpr double kSame = 1e-12;  // [m]  lengths that are stated as equal

// Whether values of bearings along the pin, or of points along a roller, are mirrored from one end to the
// other.
bool are_mirrored(const std::vector<double>& values, double sign) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i] - sign * values[values.size() - 1 - i]) > kSame) return false;
  return true;
}

// Clearances of bearings in the order of their places.
bool has_unlike_ends(const ResolvedCase& in) {
  const std::string positions = "bearing.axial_places", differences = "bearing.clearance_differences";
  std::vector<std::size_t> order;
  std::vector<double> position, clearance;
  if (in.has(positions)) position = in.list(positions);
  if (in.has(differences)) clearance = in.list(differences);
  for (std::size_t i = 0; i < std::max(position.size(), clearance.size()); ++i) order.push_back(i);
  if (!position.empty() && (clearance.empty() || clearance.size() == position.size()))
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return position[a] < position[b]; });
  const auto sorted = [&](const std::vector<double>& values) {
    std::vector<double> out;
    for (const std::size_t i : order)
      if (i < values.size()) out.push_back(values[i]);
    return out;
  };
  return !are_mirrored(sorted(position), -1.0) || !are_mirrored(sorted(clearance), 1.0);
}

bool has_unlike_roller_ends(const ResolvedCase& in) {
  if (!is_chosen(in, "bearing.profile.kind", "table")) return false;
  return !are_mirrored(in.list("bearing.profile.x"), -1.0) ||
         !are_mirrored(in.list("bearing.profile.drops"), 1.0);
}

std::string in_set(std::string_view set, const char* path) {
  return std::string(set) + path;
}

bool is_grounded(const ResolvedCase& in, const std::string& member) {
  return std::any_of(in.shape().shafts.begin(), in.shape().shafts.end(), [&](const std::string& shaft) {
    const std::vector<std::string>& joined = in.texts(shaft_path(shaft));
    const auto joins = [&](const std::string& one) {
      return std::find(joined.begin(), joined.end(), one) != joined.end();
    };
    return joins("ground") && joins(member);
  });
}

}  // namespace

bool makes_meshes(std::string_view path) {
  return is_one_of(path, {"gearset.addendum_of.sun", "gearset.addendum_of.ring", "gearset.clearance_of.sun",
                          "gearset.clearance_of.ring", "gearset.web.thickness", "gearset.web.rim",
                          "gearset.tooth_contact", "gearset.lead_slope.sun", "gearset.lead_slope.ring",
                          "gearset.dynamics.mesh_stiffness.sun", "gearset.dynamics.mesh_stiffness.ring"}) ||
         begins_with_one_of(path, {"gearset.tip_relief.", "gearset.lead_crown."});
}

bool planets_tilt(const ResolvedCase& in, std::string_view) {
  return is_nonzero(in, "gearset.helix_angle") || is_chosen(in, "support.pin_ends", "one") ||
         is_chosen(in, "support.pin_ends", "flexpin") || in.has("gearset.stepped_planet.teeth") ||
         is_nonzero(in, "support.pin_inclination.radial") ||
         is_nonzero(in, "support.pin_inclination.tangential") || in.has("support.carrier_twist_stiffness") ||
         has_unlike_ends(in) || has_unlike_roller_ends(in);
}

bool bearings_tilt(const ResolvedCase& in, std::string_view set) {
  return planets_tilt(in, set) || (in.has("bearing.per_planet") && in.integer("bearing.per_planet") > 1);
}

bool pin_links_rows(const ResolvedCase& in, std::string_view) {
  return is_chosen(in, "support.pin_ends", "one") || is_chosen(in, "support.pin_ends", "flexpin") ||
         (in.has("bearing.per_planet") && in.integer("bearing.per_planet") > 2);
}

bool carrier_rotates(const ResolvedCase& in, std::string_view set) {
  if (!in.shape().several) return !is_chosen(in, "gearset.fixed", "carrier");
  return std::any_of(in.shape().sets.begin(), in.shape().sets.end(), [&](const std::string& name) {
    return (set.empty() || set == set_prefix(name)) && !is_grounded(in, name + ".carrier");
  });
}

bool carrier_pulls(const ResolvedCase& in, std::string_view set) {
  return carrier_rotates(in, set) && is_on(in, "inertia.carrier_centrifugal");
}

bool planet_counts_at_rest(const ResolvedCase& in, std::string_view set) {
  return carrier_pulls(in, set) || is_chosen(in, in_set(set, "gearset.planet_rim"), "elastic") ||
         is_chosen(in, in_set(set, "bearing.clearance_state"), "unmounted") ||
         (is_chosen(in, in_set(set, "bearing.tilt_state"), "computed") && planets_tilt(in, set));
}

bool carrier_is_body(const ResolvedCase& in, std::string_view) {
  return in.shape().bearing && in.shape().teeth && !in.shape().several &&
         in.has("gearset.carrier.bearing_positions") && in.has("gearset.carrier.bearing_stiffness") &&
         is_chosen(in, "gearset.fixed", "ring") && !is_chosen(in, "gearset.planet_rim", "elastic") &&
         !in.has("gearset.stepped_planet.teeth") && !in.has("gearset.second_planet.teeth") &&
         has_cylindrical_rollers(in);
}

bool bearings_make_springs(const ResolvedCase& in, std::string_view) {
  return in.shape().bearing && (!is_stated(in, "gearset.dynamics.planet.bearing_stiffness") ||
                                is_chosen(in, "gearset.planet_rim", "elastic"));
}

bool loads_make_springs(const ResolvedCase& in, std::string_view set) {
  return bearings_make_springs(in, set) || is_chosen(in, "gearset.tooth_contact", "loaded");
}

bool teeth_make_meshes(const ResolvedCase& in, std::string_view) {
  return in.shape().teeth && (!is_stated(in, "gearset.dynamics.mesh_stiffness.sun") ||
                              !is_stated(in, "gearset.dynamics.mesh_stiffness.ring"));
}

bool material_makes_springs(const ResolvedCase& in, std::string_view set) {
  const bool pins = !is_stated(in, "support.stiffness");
  const bool films = is_on(in, "film.enabled");
  return teeth_make_meshes(in, set) || is_chosen(in, "gearset.planet_rim", "elastic") ||
         (bearings_make_springs(in, set) && (pins || films));
}

bool modulus_makes_springs(const ResolvedCase& in, std::string_view set) {
  if (material_makes_springs(in, set)) return true;
  return in.shape().teeth &&
         std::ranges::any_of(std::array{"sun", "ring", "carrier"}, [&](const char* member) {
           return !is_stated(in, in_set(set, "gearset.dynamics.") + member + ".support_stiffness");
         });
}

bool fits_are_warm(const ResolvedCase& in, std::string_view set) {
  constexpr const char* parts[] = {"pin", "inner_ring", "rollers", "outer_ring", "planet"};
  return std::any_of(std::begin(parts), std::end(parts), [&](const char* part) {
    const std::string path = in_set(set, "bearing.temperature.") + part;
    return in.has(path) && in.quantity(path) != bearing::kSizesTemperature;
  });
}

bool planets_have_rollers(const ResolvedCase& in, std::string_view set) {
  if (in.model() != planetary_drivetrain) return true;
  const auto rolls = [&](const std::string& prefix) {
    return bearing_type_of(in, prefix) != bearing::PlanetBearingType::deep_groove_ball;
  };
  const std::vector<std::string>& sets = in.shape().sets;
  return !set.empty() || sets.empty()
             ? rolls(std::string(set))
             : std::ranges::any_of(sets, [&](const std::string& name) { return rolls(set_prefix(name)); });
}

bool resonances_are_named(const ResolvedCase& in, std::string_view) {
  const CaseShape& shape = in.shape();
  return in.model() == planetary_drivetrain && !shape.several && shape.teeth && shape.bearing &&
         has_cylindrical_rollers(in) && !in.has("gearset.second_planet.teeth") &&
         is_on(in, "gearset.mesh_variation");
}

bool is_one_system(const ResolvedCase& in, std::string_view set) {
  return !in.shape().several && in.shape().teeth && is_chosen(in, "bearing.complement", "full") &&
         speed_is_steady(in, set) && !is_chosen(in, "bearing.tilt_state", "computed");
}

bool pin_is_race(const ResolvedCase& in, std::string_view set) {
  const std::string rings = in_set(set, "bearing.rings");
  return in.has(rings) && in.choice(rings) != "both";
}

bool speed_is_steady(const ResolvedCase& in, std::string_view) {
  return !is_nonzero(in, "input.acceleration");
}

bool gears_run_up(const ResolvedCase& in, std::string_view) {
  return is_nonzero(in, "gearset.dynamics.run_up.duration") &&
         in.number("gearset.dynamics.run_up.from") != 1.0;
}

}  // namespace orbearing::app
