// Do the values of planets and their bearings fit each other? See consistency.hpp.
#include "app/case/consistency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

// Computed tilt of a planet: it acts on laminae, and is that of bearings at rest.
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

// Planets with two gears, or in pairs, are spur gears on rigid bodies whose bearings carry equal loads.
void check_plain_planets(CheckedCase& in, const char* teeth, const std::string& planets,
                         const std::string& alike) {
  const auto object_to = [&](const std::string& other, const std::string& required) {
    in.add_error_at(teeth, planets + " together with " + other, required + " is required");
  };
  if (is_nonzero(in, "gearset.helix_angle")) object_to("gearset.helix_angle", "0 deg");
  for (const auto& [path, choice, required] :
       {std::array{"gearset.planet_rim", "elastic", "a rigid rim"},
        {"gearset.tooth_contact", "loaded", "linear contact"},
        {"bearing.clearance_state", "unmounted", "the clearance in operation"}})
    if (in.is(path, choice)) object_to(fmt::format("{}: {}", path, choice), required);
  if (const std::string uneven = uneven_planets_by(in); !uneven.empty()) object_to(uneven, alike);
}

// The bearings of a planet with two gears hold its couple.
void check_stepped(CheckedCase& in) {
  const char *teeth = "gearset.stepped_planet.teeth", *offset = "gearset.stepped_planet.offset";
  if (!has_stepped_planets(in) || !in.has("gearset.face_width")) return;
  check_plain_planets(in, teeth, "two gears on each planet", "planets that carry alike");
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
  refuse_where(has_stepped_planets(in), "gearset.stepped_planet", "one of both");
  check_plain_planets(in, teeth, "planets in pairs", "pairs that carry alike");
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
  const char* pin = "support.pin_diameter";
  if (in.has(pin) && in.has("bearing.bore") && in.quantity(pin) >= in.quantity("bearing.bore"))
    in.add_error_at(pin, in.given(pin) + " with a bearing.bore of " + in.given("bearing.bore"),
                    "less than the bore is required: the sleeve of a flexpin lies between");
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

using bearing::PlanetBearingType;

constexpr const char* kBearingType = "bearing.type";

// Adds a mistake for an input that is not modelled with this type of bearing.
void not_with_type(CheckedCase& in, const std::string& path, const std::string& value) {
  const bool of_laminae = path == "bearing.laminae" || path == "bearing.profile.kind";
  in.add_error_at(path, fmt::format("{} together with bearing.type: {}", value, in.choice(kBearingType)),
                  fmt::format("none is required, or bearing.type: cylindrical-roller{}",
                              of_laminae ? " or tapered-roller" : ""));
}

void need(CheckedCase& in, const char* path) {
  if (!in.has(path))
    in.add_error_at(path, "missing",
                    fmt::format("a value is required with bearing.type: {}", in.choice(kBearingType)));
}

void check_type_and_refinements(CheckedCase& in) {
  const auto refuse_stated = [&](std::initializer_list<const char*> paths) {
    for (const char* path : paths)
      if (is_stated(in, path)) not_with_type(in, path, in.given(path));
  };
  refuse_stated({"bearing.designation", "bearing.clearance_class", "bearing.axial_places", "defect.race"});
  if (!in.is(kBearingType, "tapered-roller")) refuse_stated({"bearing.laminae", "bearing.profile.kind"});
  if (in.is(kBearingType, "deep-groove-ball")) refuse_stated({"spectrum"});
  for (const auto& [path, value] : {std::pair{"bearing.complement", "full"},
                                    {"bearing.clearance_state", "unmounted"},
                                    {"bearing.tilt_state", "computed"},
                                    {"gearset.planet_rim", "elastic"},
                                    {"life.viscosity_ratio_by", "film"}})
    if (in.is(path, value)) not_with_type(in, path, value);
  if (in.has("bearing.rings") && !in.is("bearing.rings", "both"))
    not_with_type(in, "bearing.rings", in.choice("bearing.rings"));
  if (is_on(in, "film.enabled")) not_with_type(in, "film.enabled", "true");
  for (const char* path : {"bearing.misalignment.planet_tilt", "bearing.misalignment.carrier_wind_up"})
    if (is_nonzero(in, path)) not_with_type(in, path, in.given(path));
  for (const char* list :
       {"bearing.roller_diameter_deviation", "bearing.inner_race.waviness.amplitude",
        "bearing.outer_race.waviness.amplitude", "bearing.inner_race.out_of_roundness.amplitude",
        "bearing.outer_race.out_of_roundness.amplitude"})
    if (is_anywhere_nonzero(in, list)) not_with_type(in, list, "a list");
  if (const std::string uneven = uneven_planets_by(in); !uneven.empty()) not_with_type(in, uneven, "a list");
}

// The moment of helical teeth needs two bearings, or a pair, to hold it.
void check_moment(CheckedCase& in) {
  if (!in.has("bearing.per_planet") || in.integer("bearing.per_planet") > 1 ||
      !is_nonzero(in, "gearset.helix_angle"))
    return;
  in.add_error_at("bearing.per_planet",
                  fmt::format("one bearing of bearing.type: {} together with gearset.helix_angle",
                              in.choice(kBearingType)),
                  "two bearings or more are required, which hold the moment of helical teeth");
}

void check_tapered(CheckedCase& in) {
  need(in, "bearing.rows.contact_angle");
  need(in, "bearing.rows.arrangement");
  if (in.has("bearing.per_planet") && in.integer("bearing.per_planet") != 2)
    in.add_error_at("bearing.per_planet",
                    fmt::format("{} tapered roller bearings", in.integer("bearing.per_planet")),
                    "2 are required: a pair whose axial forces balance");
  check_either(in, "bearing.rows.preload", "bearing.rows.approach");
  for (const char* mounted : {"bearing.rows.preload", "bearing.rows.approach"})
    if (in.has(mounted) && is_nonzero(in, "bearing.radial_clearance"))
      in.add_error_at("bearing.radial_clearance",
                      fmt::format("{} together with {}", in.given("bearing.radial_clearance"), mounted),
                      "0 um is required: mounting sets preload or play of a pair");
  if (!has_all(in, {"bearing.rows.distance", "bearing.width", "gearset.face_width"})) return;
  const double distance = in.quantity("bearing.rows.distance"), width = in.quantity("bearing.width"),
               face = in.quantity("gearset.face_width");
  if (distance < width - kFitsWithin || distance + width > face + kFitsWithin)
    in.add_error_at(
        "bearing.rows.distance", in.given("bearing.rows.distance"),
        fmt::format("a distance from the width of a bearing, {:.4g} mm, to the face less that, {:.4g} mm, is "
                    "required",
                    1e3 * width, 1e3 * (face - width)));
}

void check_ball_planets(CheckedCase& in) {
  need(in, "bearing.balls");
  need(in, "bearing.ball_diameter");
  for (const char* path : {"bearing.rollers", "bearing.roller_diameter", "bearing.roller_length"})
    if (in.has(path))
      in.add_error_at(
          path, fmt::format("{} together with bearing.type: {}", in.given(path), in.choice(kBearingType)),
          "bearing.balls and bearing.ball_diameter are required instead");
  check_ball_circle(in);
}

// Rollers and balls do not share a bearing.
void check_roller_planets(CheckedCase& in) {
  for (const char* path : {"bearing.balls", "bearing.ball_diameter"})
    if (is_stated(in, path))
      in.add_error_at(path, in.given(path) + " in a bearing with rollers",
                      "none is required, or bearing.type: deep-groove-ball without rollers");
}

// Do the values fit the type of the bearings of a set? Of cylindrical rollers nothing but their elements.
void check_bearing_type(CheckedCase& in) {
  const PlanetBearingType type = bearing_type_of(in);
  if (in.model() == planetary_drivetrain && type != PlanetBearingType::deep_groove_ball)
    check_roller_planets(in);
  if (type == PlanetBearingType::cylindrical_roller) return;
  if (in.model() != planetary_drivetrain)
    return in.add_error_at(
        kBearingType, fmt::format("'{}' in a case of one bearing", in.choice(kBearingType)),
        "cylindrical-roller is required; other types are those of planets, in cases of the model "
        "planetary-drivetrain");
  check_type_and_refinements(in);
  check_moment(in);
  if (type == PlanetBearingType::tapered_roller) check_tapered(in);
  if (type == PlanetBearingType::spherical_roller) need(in, "bearing.rows.contact_angle");
  if (type == PlanetBearingType::deep_groove_ball) check_ball_planets(in);
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
