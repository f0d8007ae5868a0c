// Do the values of planet bearings fit their type? See consistency.hpp.
#include <fmt/format.h>

#include <utility>

#include "app/case/bearing_type.hpp"
#include "app/case/consistency.hpp"
#include "app/case/set_case.hpp"

namespace orbearing::app {

namespace {

using bearing::PlanetBearingType;

constexpr const char* kBearingType = "bearing.type";

// What these bearings are not computed with.
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
  constexpr double round_off = 1e-9;  // [m]
  if (distance < width - round_off || distance + width > face + round_off)
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

}  // namespace

void check_bearing_type(CheckedCase& in) {
  const PlanetBearingType type = bearing_type_of(in);
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

}  // namespace orbearing::app
