#include "app/case/consistency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/case/mistake.hpp"
#include "app/case/set_case.hpp"

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

// How planets share a load follows from springs of the gears that know no rim; a rim rests on rollers that
// are known.
void check_rim(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  const std::string rim = "gearset.planet_rim";
  if (!resolved.has(rim) || resolved.choice(rim) != "elastic") return;
  if (!resolved.has("bearing.rollers"))
    add_error_at(resolved, rim, "elastic without a bearing", "rollers on which the rim rests are required",
                 mistakes);
  if (const char* spring = "gearset.dynamics.planet.bearing_stiffness"; resolved.has(spring))
    add_error_at(resolved, rim, fmt::format("elastic together with {}", spring),
                 "no stiffness of the bearings is required, which follows from their rollers", mistakes);
  if (const char* helix = "gearset.helix_angle"; resolved.has(helix) && resolved.quantity(helix) != 0.0)
    add_error_at(
        resolved, rim, fmt::format("elastic together with {}", helix),
        "rigid is required with helical teeth: an elastic rim is computed in the plane of spur gears",
        mistakes);
  if (const std::string uneven = uneven_planets_by(resolved); !uneven.empty())
    add_error_at(resolved, rim, fmt::format("elastic together with {}", uneven),
                 "rigid is required where planets carry unequal loads", mistakes);
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

// A planet that finds its tilt: it acts on laminae, one rigid rim and planets that carry alike are what it is
// computed for.
void check_tilt(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  const std::string state = "bearing.tilt_state";
  if (!resolved.has(state) || resolved.choice(state) != "computed" || !resolved.has("bearing.per_planet"))
    return;
  const auto need = [&](bool holds, const std::string& found, const std::string& required) {
    if (!holds) add_error_at(resolved, state, "computed " + found, required, mistakes);
  };
  need(resolved.has("bearing.laminae"), "without bearing.laminae",
       "a number of laminae, which the tilt acts on, is required");
  need(!resolved.has("gearset.planet_rim") || resolved.choice("gearset.planet_rim") == "rigid",
       "together with gearset.planet_rim: elastic", "a rigid rim is required");
  const std::string uneven = uneven_planets_by(resolved);
  need(uneven.empty(), "together with " + uneven, "planets with equal loads are required");
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

// Bearings lie side by side within the face, which lies within the supports of the pin.
void check_positions(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  const std::string state = "bearing.tilt_state", positions = "bearing.axial_places",
                    span = "support.pin_span";
  if (!resolved.has(state) || resolved.choice(state) != "computed" || !resolved.has("gearset.face_width"))
    return;
  const double face = resolved.quantity("gearset.face_width");
  const std::string twist = "support.carrier_twist_stiffness", ends = "support.pin_ends";
  if (resolved.has(twist) && resolved.choice(ends) == "one")
    add_error_at(resolved, twist, resolved.given(twist) + " together with support.pin_ends: one",
                 "pins between two walls are required, of which one twists against the other", mistakes);
  if (resolved.has(span) && resolved.quantity(span) < face)
    add_error_at(resolved, span,
                 resolved.given(span) + " with a face of " + resolved.given("gearset.face_width"),
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
  check_rim(resolved, mistakes);
  check_tooth_contact(resolved, mistakes);
  check_tilt(resolved, mistakes);
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
