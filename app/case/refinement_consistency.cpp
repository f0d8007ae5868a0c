#include "app/case/consistency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/case/bearing_type.hpp"
#include "app/case/mistake.hpp"
#include "app/case/set_case.hpp"
#include "app/units.hpp"
#include "gearset/stepped_planet.hpp"

namespace orbearing::app {

namespace {

// A wave needs its order and its amplitude; phases may be left out altogether.
void check_form(const ResolvedCase& resolved, const std::string& block, std::vector<Mistake>& mistakes) {
  const std::string order = block + ".order", amplitude = block + ".amplitude", phase = block + ".phase";
  const bool has_order = resolved.has(order), has_amplitude = resolved.has(amplitude);
  if (!has_order && !has_amplitude && !resolved.has(phase)) return;
  if (!has_order || !has_amplitude) {
    const std::string present = has_order ? order : has_amplitude ? amplitude : phase;
    add_error_at(resolved, present, "waves without " + std::string(has_order ? "amplitude" : "order"),
                 "orders and amplitudes in lists of equal length are required", mistakes);
    return;
  }
  const std::size_t waves = resolved.list(order).size();
  for (const std::string& other : {amplitude, phase})
    if (resolved.has(other) && resolved.list(other).size() != waves)
      add_error_at(resolved, other, fmt::format("{} values for {} waves", resolved.list(other).size(), waves),
                   "as many values as orders are required", mistakes);
}

// A rim rests on rollers that are known; springs of the gears follow from them.
void check_rim(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  const std::string rim = "gearset.planet_rim";
  if (!resolved.has(rim) || resolved.choice(rim) != "elastic") return;
  if (!has_planet_bearing(resolved))
    add_error_at(resolved, rim, "elastic without a bearing", "rollers on which the rim rests are required",
                 mistakes);
  if (const char* spring = "gearset.dynamics.planet.bearing_stiffness"; resolved.has(spring))
    add_error_at(resolved, rim, fmt::format("elastic together with {}", spring),
                 "no stiffness of the bearings is required, which follows from their rollers", mistakes);
}

// Teeth under load push only, and follow from their form.
void check_tooth_contact(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  const std::string contact = "gearset.tooth_contact", separation = "gearset.dynamics.separation";
  if (!resolved.has(contact) || resolved.choice(contact) != "loaded") return;
  if (resolved.has(separation) && !resolved.flag(separation))
    add_error_at(resolved, contact, fmt::format("loaded together with {}: false", separation),
                 "teeth that transmit compression only are required", mistakes);
  for (const char* stated : {"gearset.dynamics.mesh_stiffness.sun", "gearset.dynamics.mesh_stiffness.ring"})
    if (resolved.has(stated))
      add_error_at(resolved, contact, fmt::format("loaded together with {}", stated),
                   "no stated mesh stiffness is required, which follows from the teeth", mistakes);
}

// A planet that finds its tilt: it acts on laminae, and is that of bearings at rest.
void check_tilt(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  const std::string state = "bearing.tilt_state";
  if (!resolved.has(state) || resolved.choice(state) != "computed" || !resolved.has("bearing.per_planet"))
    return;
  const auto need = [&](bool holds, const std::string& found, const std::string& required) {
    if (!holds) add_error_at(resolved, state, "computed " + found, required, mistakes);
  };
  need(resolved.has("bearing.laminae"), "without bearing.laminae",
       "a number of laminae, which the tilt acts on, is required");
  for (const char* list : {"bearing.roller_diameter_deviation", "bearing.inner_race.waviness.amplitude",
                           "bearing.outer_race.waviness.amplitude"})
    need(!is_anywhere_nonzero(resolved, list), std::string("together with ") + list,
         "equal rollers and races without waviness are required, since the tilt is that of bearings at rest");
  const auto bearings = static_cast<std::size_t>(resolved.integer("bearing.per_planet"));
  for (const char* list : {"bearing.axial_places", "bearing.clearance_differences"})
    if (resolved.has(list) && resolved.list(list).size() != bearings)
      add_error_at(resolved, list, fmt::format("{} values", resolved.list(list).size()),
                   fmt::format("one for each of the {} bearings of a planet is required", bearings),
                   mistakes);
}

// Two gears on a planet are spur gears on a rigid body, whose couple its bearings hold.
void check_stepped(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  const std::string teeth = "gearset.stepped_planet.teeth";
  if (!has_stepped_planets(resolved) || !resolved.has("gearset.face_width")) return;
  const auto need = [&](bool holds, const std::string& other, const std::string& required) {
    if (!holds)
      add_error_at(resolved, teeth, "two gears on each planet together with " + other,
                   required + " is required", mistakes);
  };
  const auto is = [&](const char* path, const char* word) {
    return resolved.has(path) && resolved.choice(path) == word;
  };
  need(!resolved.has("gearset.helix_angle") || resolved.quantity("gearset.helix_angle") == 0.0,
       "gearset.helix_angle", "0 deg");
  need(!is("gearset.planet_rim", "elastic"), "gearset.planet_rim: elastic", "a rigid rim");
  need(!is("gearset.tooth_contact", "loaded"), "gearset.tooth_contact: loaded", "linear contact");
  need(!is("bearing.clearance_state", "unmounted"), "bearing.clearance_state: unmounted",
       "the clearance in operation");
  const std::string uneven = uneven_planets_by(resolved);
  need(uneven.empty(), uneven, "planets that carry alike");
  need(!resolved.has("bearing.tilt_state") || is("bearing.tilt_state", "computed"),
       "bearing.tilt_state: stated", "computed, by which the bearings hold the couple of both meshes,");
  const std::string offset = "gearset.stepped_planet.offset";
  const gearset::PlanetarySet set = stated_set(resolved);
  const double apart = 0.5 * (set.face_width + gearset::ring_face(set));  // [m]
  constexpr double round_off = 1e-9;                                      // [m]
  if (std::abs(set.stepped.offset) < apart - round_off)
    add_error_at(resolved, resolved.has(offset) ? offset : teeth,
                 resolved.has(offset) ? quote(resolved.given(offset)) : "no " + offset,
                 fmt::format("{} of at least {:.4g} mm either way, half of both faces, is required", offset,
                             per_milli * apart),
                 mistakes);
}

// Planets in pairs are spur gears on rigid bodies, each on bearings of its own pin that carry alike.
void check_pairs(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  const std::string teeth = "gearset.second_planet.teeth";
  if (!has_planet_pairs(resolved)) return;
  const auto need = [&](bool holds, const std::string& other, const std::string& required) {
    if (!holds)
      add_error_at(resolved, teeth, "planets in pairs together with " + other, required + " is required",
                   mistakes);
  };
  const auto is = [&](const char* path, const char* word) {
    return resolved.has(path) && resolved.choice(path) == word;
  };
  need(resolved.has("bearing.per_planet"), "no bearing", "a planet bearing, which each planet then has,");
  need(!resolved.has("gearset.helix_angle") || resolved.quantity("gearset.helix_angle") == 0.0,
       "gearset.helix_angle", "0 deg");
  need(!has_stepped_planets(resolved), "gearset.stepped_planet", "one of both");
  need(!is("gearset.planet_rim", "elastic"), "gearset.planet_rim: elastic", "a rigid rim");
  need(!is("gearset.tooth_contact", "loaded"), "gearset.tooth_contact: loaded", "linear contact");
  need(!is("bearing.tilt_state", "computed"), "bearing.tilt_state: computed", "stated");
  need(!is("bearing.clearance_state", "unmounted"), "bearing.clearance_state: unmounted",
       "the clearance in operation");
  const std::string uneven = uneven_planets_by(resolved);
  need(uneven.empty(), uneven, "pairs that carry alike");
  for (const std::string path :
       {"gearset.planet_angles", "gearset.centre_distance", "gearset.carrier.bearing_positions"})
    need(!resolved.has(path), path, "a case without it");
  need(!resolved.has("gearset.profile_shift.planet"), "gearset.profile_shift.planet",
       "gearset.second_planet.first_profile_shift instead of it");
  if (resolved.has("defect.race")) need(false, "defect", "a case without it");
}

// Bearings lie side by side within the face, or the length of a stepped planet, which lies within the
// supports of the pin.
void check_positions(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  const std::string state = "bearing.tilt_state", positions = "bearing.axial_places",
                    span = "support.pin_span";
  if (!resolved.has(state) || resolved.choice(state) != "computed" || !resolved.has("gearset.face_width"))
    return;
  const bool stepped = has_stepped_planets(resolved);
  const double face =
      stepped ? gearset::gear_planes(stated_set(resolved)).length : resolved.quantity("gearset.face_width");
  const std::string twist = "support.carrier_twist_stiffness", ends = "support.pin_ends";
  if (resolved.has(twist) && resolved.choice(ends) != "both")
    add_error_at(resolved, twist,
                 resolved.given(twist) + " together with support.pin_ends: " + resolved.choice(ends),
                 "pins between two walls are required, of which one twists against the other", mistakes);
  if (resolved.has(span) && resolved.quantity(span) < face)
    add_error_at(
        resolved, span,
        resolved.given(span) + " with a face of " +
            (stepped ? fmt::format("{:.4g} mm", per_milli * face) : resolved.given("gearset.face_width")),
        "at least the face is required: the supports lie outside it", mistakes);
  if (!resolved.has(positions) || !resolved.has("bearing.width")) return;
  const double width = resolved.quantity("bearing.width");
  std::vector<double> sorted = resolved.list(positions);
  std::sort(sorted.begin(), sorted.end());
  constexpr double round_off = 1e-9;  // [m]
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const bool within = std::abs(sorted[k]) + 0.5 * width <= 0.5 * face + round_off;
    const bool apart = k == 0 || sorted[k] - sorted[k - 1] >= width - round_off;
    if (within && apart) continue;
    add_error_at(
        resolved, positions, within ? "bearings that overlap" : "a bearing that reaches beyond the face",
        fmt::format(
            "positions at least their width of {:.4g} mm apart and within the face of {:.4g} mm are required",
            1e3 * width, 1e3 * face),
        mistakes);
    return;
  }
}

}  // namespace

void check_refinements(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  for (const char* race : {"inner_race", "outer_race"})
    for (const char* form : {"out_of_roundness", "waviness"})
      check_form(resolved, fmt::format("bearing.{}.{}", race, form), mistakes);
  check_bearing_type(resolved, mistakes);
  check_rim(resolved, mistakes);
  check_tooth_contact(resolved, mistakes);
  check_tilt(resolved, mistakes);
  check_stepped(resolved, mistakes);
  check_pairs(resolved, mistakes);
  check_positions(resolved, mistakes);
  const std::string deviations = "bearing.roller_diameter_deviation";
  if (!resolved.has(deviations) || !resolved.has("bearing.rollers")) return;
  const std::size_t given = resolved.list(deviations).size();
  if (given > static_cast<std::size_t>(resolved.integer("bearing.rollers")))
    add_error_at(resolved, deviations, fmt::format("{} values", given),
                 fmt::format("at most one for each of the {} rollers is required",
                             resolved.integer("bearing.rollers")),
                 mistakes);
}

}  // namespace orbearing::app
