#include "app/case/consistency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/case/bearing_type.hpp"
#include "app/case/set_case.hpp"
#include "app/units.hpp"
#include "gearset/stepped_planet.hpp"

namespace orbearing::app {

namespace {

constexpr double kFitsWithin = 1e-9;  // [m]

// A wave needs its order and its amplitude; phases may be left out altogether.
void check_form(CheckedCase& in, const std::string& block) {
  const std::string order = block + ".order", amplitude = block + ".amplitude", phase = block + ".phase";
  const bool has_order = in.has(order), has_amplitude = in.has(amplitude);
  if (!has_order && !has_amplitude && !in.has(phase)) return;
  if (!has_order || !has_amplitude)
    return in.add_error_at(has_order       ? order
                           : has_amplitude ? amplitude
                                           : phase,
                           "waves without " + std::string(has_order ? "amplitude" : "order"),
                           "orders and amplitudes in lists of equal length are required");
  const std::size_t waves = in.list(order).size();
  for (const std::string& other : {amplitude, phase})
    if (in.has(other) && in.list(other).size() != waves)
      in.add_error_at(other, fmt::format("{} values for {} waves", in.list(other).size(), waves),
                      "as many values as orders are required");
}

// A rim rests on rollers that are known; springs of the gears follow from them.
void check_rim(CheckedCase& in) {
  const char *rim = "gearset.planet_rim", *spring = "gearset.dynamics.planet.bearing_stiffness";
  if (!in.is(rim, "elastic")) return;
  if (!has_planet_bearing(in))
    in.add_error_at(rim, "elastic without a bearing", "rollers on which the rim rests are required");
  if (in.has(spring))
    in.add_error_at(rim, fmt::format("elastic together with {}", spring),
                    "no stiffness of the bearings is required, which follows from their rollers");
}

// Teeth under load push only, and follow from their form.
void check_tooth_contact(CheckedCase& in) {
  const char *contact = "gearset.tooth_contact", *separation = "gearset.dynamics.separation";
  if (!in.is(contact, "loaded")) return;
  if (in.has(separation) && !in.flag(separation))
    in.add_error_at(contact, fmt::format("loaded together with {}: false", separation),
                    "teeth that transmit compression only are required");
  for (const char* stated : {"gearset.dynamics.mesh_stiffness.sun", "gearset.dynamics.mesh_stiffness.ring"})
    if (in.has(stated))
      in.add_error_at(contact, fmt::format("loaded together with {}", stated),
                      "no stated mesh stiffness is required, which follows from the teeth");
}

// A planet that finds its tilt: it acts on laminae, and is that of bearings at rest.
void check_tilt(CheckedCase& in) {
  const char* state = "bearing.tilt_state";
  if (!in.is(state, "computed") || !in.has("bearing.per_planet")) return;
  if (!in.has("bearing.laminae"))
    in.add_error_at(state, "computed without bearing.laminae",
                    "a number of laminae, which the tilt acts on, is required");
  for (const char* list : {"bearing.roller_diameter_deviation", "bearing.inner_race.waviness.amplitude",
                           "bearing.outer_race.waviness.amplitude"})
    if (is_anywhere_nonzero(in, list))
      in.add_error_at(state, std::string("computed together with ") + list,
                      "equal rollers and races without waviness are required, since the tilt is that of "
                      "bearings at rest");
  const auto bearings = static_cast<std::size_t>(in.integer("bearing.per_planet"));
  for (const char* list : {"bearing.axial_places", "bearing.clearance_differences"})
    if (in.has(list) && in.list(list).size() != bearings)
      in.add_error_at(list, fmt::format("{} values", in.list(list).size()),
                      fmt::format("one for each of the {} bearings of a planet is required", bearings));
}

// Planets with two gears, or in pairs, are spur gears on rigid bodies whose bearings carry alike.
void check_plain_planets(CheckedCase& in, const char* teeth, const std::string& planets,
                         const std::string& alike) {
  const auto refuse = [&](const std::string& other, const std::string& required) {
    in.add_error_at(teeth, planets + " together with " + other, required + " is required");
  };
  if (is_nonzero(in, "gearset.helix_angle")) refuse("gearset.helix_angle", "0 deg");
  for (const auto& [path, choice, required] :
       {std::array{"gearset.planet_rim", "elastic", "a rigid rim"},
        {"gearset.tooth_contact", "loaded", "linear contact"},
        {"bearing.clearance_state", "unmounted", "the clearance in operation"}})
    if (in.is(path, choice)) refuse(fmt::format("{}: {}", path, choice), required);
  if (const std::string uneven = uneven_planets_by(in); !uneven.empty())
    refuse(uneven, alike + " that carry alike");
}

// The bearings of a planet with two gears hold its couple.
void check_stepped(CheckedCase& in) {
  const char *teeth = "gearset.stepped_planet.teeth", *offset = "gearset.stepped_planet.offset";
  if (!has_stepped_planets(in) || !in.has("gearset.face_width")) return;
  check_plain_planets(in, teeth, "two gears on each planet", "planets");
  if (in.has("bearing.tilt_state") && !in.is("bearing.tilt_state", "computed"))
    in.add_error_at(teeth, "two gears on each planet together with bearing.tilt_state: stated",
                    "computed, by which the bearings hold the couple of both meshes, is required");
  const gearset::PlanetarySet set = stated_set(in);
  const double apart = 0.5 * (set.face_width + gearset::ring_face(set));  // [m]
  if (std::abs(set.stepped.offset) < apart - kFitsWithin)
    in.add_error_at(in.has(offset) ? offset : teeth,
                    in.has(offset) ? quote(in.given(offset)) : fmt::format("no {}", offset),
                    fmt::format("{} of at least {:.4g} mm either way, half of both faces, is required",
                                offset, per_milli * apart));
}

// Each planet of a pair is on bearings of its own pin.
void check_pairs(CheckedCase& in) {
  const char* teeth = "gearset.second_planet.teeth";
  if (!has_planet_pairs(in)) return;
  const auto refuse_where = [&](bool stated, const char* other, const std::string& required) {
    if (stated)
      in.add_error_at(teeth, fmt::format("planets in pairs together with {}", other),
                      required + " is required");
  };
  refuse_where(!in.has("bearing.per_planet"), "no bearing", "a planet bearing, which each planet then has,");
  check_plain_planets(in, teeth, "planets in pairs", "pairs");
  refuse_where(has_stepped_planets(in), "gearset.stepped_planet", "one of both");
  refuse_where(in.is("bearing.tilt_state", "computed"), "bearing.tilt_state: computed", "stated");
  for (const char* path :
       {"gearset.planet_angles", "gearset.centre_distance", "gearset.carrier.bearing_positions"})
    refuse_where(in.has(path), path, "a case without it");
  refuse_where(in.has("gearset.profile_shift.planet"), "gearset.profile_shift.planet",
               "gearset.second_planet.first_profile_shift instead of it");
  refuse_where(in.has("defect.race"), "defect", "a case without it");
}

// Bearings lie side by side within the face, or the length of a stepped planet, which lies within the
// supports of the pin.
void check_positions(CheckedCase& in) {
  const char *positions = "bearing.axial_places", *span = "support.pin_span", *ends = "support.pin_ends",
             *twist = "support.carrier_twist_stiffness";
  if (!in.is("bearing.tilt_state", "computed") || !in.has("gearset.face_width")) return;
  const double face = planet_length(in);
  if (in.has(twist) && in.choice(ends) != "both")
    in.add_error_at(twist, in.given(twist) + " together with support.pin_ends: " + in.choice(ends),
                    "pins between two walls are required, of which one twists against the other");
  if (in.has(span) && in.quantity(span) < face)
    in.add_error_at(span,
                    in.given(span) + " with a face of " +
                        (has_stepped_planets(in) ? fmt::format("{:.4g} mm", per_milli * face)
                                                 : in.given("gearset.face_width")),
                    "at least the face is required: the supports lie outside it");
  if (!in.has(positions) || !in.has("bearing.width")) return;
  const double width = in.quantity("bearing.width");
  std::vector<double> sorted = in.list(positions);
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const bool within = std::abs(sorted[k]) + 0.5 * width <= 0.5 * face + kFitsWithin;
    const bool apart = k == 0 || sorted[k] - sorted[k - 1] >= width - kFitsWithin;
    if (within && apart) continue;
    return in.add_error_at(
        positions, within ? "bearings that overlap" : "a bearing that reaches beyond the face",
        fmt::format(
            "positions at least their width of {:.4g} mm apart and within the face of {:.4g} mm are required",
            1e3 * width, 1e3 * face));
  }
}

}  // namespace

void check_refinements(CheckedCase& in) {
  for (const char* race : {"inner_race", "outer_race"})
    for (const char* form : {"out_of_roundness", "waviness"})
      check_form(in, fmt::format("bearing.{}.{}", race, form));
  check_bearing_type(in);
  check_rim(in);
  check_tooth_contact(in);
  check_tilt(in);
  check_stepped(in);
  check_pairs(in);
  check_positions(in);
  const char* deviations = "bearing.roller_diameter_deviation";
  if (!has_all(in, {deviations, "bearing.rollers"})) return;
  const std::size_t given = in.list(deviations).size();
  const int rollers = in.integer("bearing.rollers");
  if (given > static_cast<std::size_t>(rollers))
    in.add_error_at(deviations, fmt::format("{} values", given),
                    fmt::format("at most one for each of the {} rollers is required", rollers));
}

}  // namespace orbearing::app
