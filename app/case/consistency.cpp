#include "app/case/consistency.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

#include <cmath>
#include <optional>

#include "app/case/arrangement_case.hpp"
#include "app/case/catalogue_case.hpp"
#include "app/case/catalogue_checks.hpp"
#include "app/case/defect_case.hpp"
#include "app/case/field_table.hpp"
#include "app/case/machines.hpp"
#include "app/case/mistake.hpp"
#include "app/case/oil_case.hpp"
#include "app/case/profile_case.hpp"
#include "app/case/set_case.hpp"
#include "app/case/spectrum_case.hpp"
#include "bearing/motion/parameters.hpp"
#include "gearset/checks.hpp"
#include "gearset/planet_angles.hpp"
#include "gearset/spatial/housing_stiffness.hpp"
#include "gearset/stepped_planet.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

/// `low` must be less than `high`, or may equal it; the objection goes to `path`.
void check_order(CheckedCase& in, const char* path, const char* requirement, double low, double high,
                 bool may_equal = false) {
  // Sums of lengths that fill a space exactly may miss it by rounding.
  constexpr double rounding = 1e-12;  // [m]
  if (may_equal ? low <= high + rounding : low < high) return;
  in.add_error_at(path, quote(in.given(path)) + " does not fit",
                  fmt::format("{} ({:.4g} mm) {} {:.4g} mm is required", requirement, 1e3 * low,
                              may_equal ? "of at most" : "less than", 1e3 * high));
}

void check_traction(CheckedCase& in) {
  using bearing::TractionLaw;
  if (!has_all(in, {"bearing.rollers", "traction.law"})) return;
  const std::string stated = in.choice("traction.law");
  std::vector<std::string_view> of_rollers;
  for (const auto& [law, name] : names_of(TractionLaw{}))
    if (nature_of(law).of_rollers) of_rollers.push_back(name);
  if (std::ranges::find(of_rollers, stated) != of_rollers.end()) return;
  in.add_error_at("traction.law", fmt::format("'{}', a traction model for balls", stated),
                  fmt::format("{} is required for rollers", fmt::join(of_rollers, " or ")));
}

void check_members(CheckedCase& in) {
  if (!has_all(in, {"input.member", "gearset.fixed"})) return;
  if (in.choice("input.member") != in.choice("gearset.fixed")) return;
  in.add_error_at("input.member",
                  fmt::format("'{}' is the fixed member (gearset.fixed)", in.choice("input.member")),
                  "a member that rotates is required");
}

// The checks of the gears give "what was found; what is required" and a key.
void add_errors(CheckedCase& in, const gearset::Warnings& problems) {
  for (const gearset::Warning& problem : problems)
    in.add_error(location_in_case(in, problem.key), problem.text);
}

// One of several sets may go without.
bool has_bearing(const ResolvedCase& in) {
  return std::ranges::any_of(all_fields(), [&](const Field& field) {
    return field.path.starts_with("bearing.") && in.has(field.path);
  });
}

// Check of the tooth numbers alone: it is reported together with missing keys.
void check_spacing_alone(CheckedCase& in) {
  if (has_planet_pairs(in) ||
      !has_all(in, {"gearset.teeth.sun", "gearset.teeth.planet", "gearset.teeth.ring", "gearset.planets"}))
    return;
  add_errors(in, gearset::spacing_problems(stated_set(in)));
}

void check_gears(CheckedCase& in) {
  if (!has_all(in, {"gearset.teeth.sun", "gearset.teeth.planet", "gearset.teeth.ring", "gearset.planets",
                    "gearset.module", "gearset.pressure_angle", "gearset.addendum", "gearset.clearance",
                    "gearset.root_fillet_radius", "gearset.profile_shift.sun", "gearset.profile_shift.ring",
                    "gearset.face_width", "gearset.helix_angle", "gearset.web.rim", "material.density"}) ||
      (has_bearing(in) && !has_all(in, {"bearing.outside_diameter"})))
    return check_spacing_alone(in);
  const bool pairs = has_planet_pairs(in);
  const gearset::Warnings problems = pairs ? gearset::pair_problems(set_of(in), second_planet_of(in))
                                           : gearset::assembly_problems(set_of(in));
  add_errors(in, problems);
  if (problems.empty() && !pairs) check_stated_geometry(in);
}

void check_stage_teeth(CheckedCase& in, const char* path, const std::vector<double>& teeth) {
  constexpr double least = 5.0;  // as of a sun
  for (std::size_t i = 0; i + 1 < teeth.size(); i += 2)
    if (teeth[i] < least || teeth[i + 1] < least)
      in.add_error_at(path, fmt::format("{:g} and {:g} teeth", teeth[i], teeth[i + 1]),
                      "at least 5 of each gear, or [1, 1] for no stage, are required");
}

// Beyond it the equations of the whole train lose the digits that distinguish contradictions from round-off.
constexpr double kLargestStageRatio = 1e6;  // [-]  up or down, of all stages
constexpr std::size_t kMostStages = 20;

void check_parallel_stages(CheckedCase& in) {
  double ratio = 1.0;
  std::size_t stages = 0;
  for (const char* path : {"parallel_stage.front", "parallel_stage.behind"}) {
    if (!has_all(in, {path}) || in.list(path) == std::vector<double>{1.0, 1.0}) continue;  // none
    const std::vector<double>& teeth = in.list(path);
    check_stage_teeth(in, path, teeth);
    for (std::size_t i = 0; i + 1 < teeth.size(); i += 2, ++stages)
      ratio *= std::max(teeth[i], teeth[i + 1]) / std::min(teeth[i], teeth[i + 1]);
    if (stages > kMostStages || ratio > kLargestStageRatio)
      return in.add_error_at(
          path, fmt::format("{} parallel stages of {:.3g} in all", stages, ratio),
          fmt::format("at most {} stages, and ratios whose product (each as larger over smaller gear) is at "
                      "most 1e6, are required",
                      kMostStages));
  }
}

// Errors are listed pin by pin, and over a mesh period at more than one place.
void check_error_lists(CheckedCase& in) {
  for (const char* path : {"gearset.dynamics.pin_error.radial", "gearset.dynamics.pin_error.tangential"}) {
    if (!has_all(in, {path, "gearset.planets"})) continue;
    const std::size_t count = in.list(path).size();
    const auto planets = static_cast<std::size_t>(in.integer("gearset.planets"));
    if (count != planets)
      in.add_error_at(path, fmt::format("a list of {}", count),
                      fmt::format("one value for each of the {} planets is required", planets));
  }
  if (has_all(in, {"gearset.planet_angles", "gearset.planets"}) && !in.shape().teeth)
    add_errors(in, gearset::position_problems({.planets = in.integer("gearset.planets"),
                                               .planet_angles = in.list("gearset.planet_angles")}));
  for (const char* path :
       {"gearset.dynamics.transmission_error.sun", "gearset.dynamics.transmission_error.ring"})
    if (has_all(in, {path}) && in.list(path).size() < 3)
      in.add_error_at(path, fmt::format("a list of {}", in.list(path).size()),
                      "at least three values, at equal steps of a mesh period, are required");
}

void check_carrier_lists(CheckedCase& in) {
  const char* positions = "gearset.carrier.bearing_positions";
  if (!in.has(positions)) return;
  const std::size_t bearings = in.list(positions).size();
  if (bearings < 2)
    return in.add_error_at(positions, fmt::format("a list of {}", bearings),
                           "at least two bearings, which hold the carrier against tilting, are required");
  for (const auto& [path, count] : {std::pair{"gearset.carrier.bearing_stiffness", bearings},
                                    {"gearset.carrier.bearing_clearance", bearings},
                                    {"gearset.carrier.rotor_force", std::size_t{3}},
                                    {"gearset.carrier.rotor_moment", std::size_t{2}}})
    if (in.has(path) && in.list(path).size() != count)
      in.add_error_at(path, fmt::format("a list of {}", in.list(path).size()),
                      fmt::format("{} values are required", count));
  const char* housing = "gearset.carrier.housing_stiffness";
  const std::size_t seats = std::size_t{gearset::spatial::kSeatDirections} * bearings;
  if (in.has(housing) && in.list(housing).size() != seats * seats)
    in.add_error_at(housing, fmt::format("a list of {}", in.list(housing).size()),
                    fmt::format("{} values, {} rows and columns for {} bearings, are required", seats * seats,
                                seats, bearings));
}

void check_roller_circle(CheckedCase& in) {
  if (!has_all(in, {"bearing.rollers", "bearing.roller_diameter", "bearing.pitch_diameter"})) return;
  const int rollers = in.integer("bearing.rollers");
  const double spacing = in.quantity("bearing.pitch_diameter") * std::sin(constants::pi / rollers);  // [m]
  const double diameter = in.quantity("bearing.roller_diameter");                                    // [m]
  constexpr double round_off = 1e-12;  // rollers that touch fit
  if (diameter > spacing * (1.0 + round_off)) {
    in.add_error_at("bearing.rollers", fmt::format("{} rollers do not fit around the pitch circle", rollers),
                    fmt::format("a roller diameter ({:.6g} mm) of at most their centre distance, {:.6g} mm, "
                                "is required. Use fewer or thinner rollers",
                                1e3 * diameter, 1e3 * spacing));
  } else if (has_all(in, {"bearing.cage.pocket_clearance"}) && !is_full_complement(in)) {
    check_order(in, "bearing.cage.pocket_clearance",
                "room for bars between the pockets: a roller with its play",
                diameter + in.quantity("bearing.cage.pocket_clearance"), spacing);
  }
}

struct Races {
  double inner = 0.0;  // [m] raceway diameter
  double outer = 0.0;  // [m]
};

std::optional<Races> races_of(const ResolvedCase& in) {
  if (!has_all(in, {"bearing.pitch_diameter", "bearing.roller_diameter", "bearing.radial_clearance"}))
    return {};
  const double pitch = in.quantity("bearing.pitch_diameter");
  const double reach = in.quantity("bearing.roller_diameter") + 0.5 * in.quantity("bearing.radial_clearance");
  return Races{pitch - reach, pitch + reach};
}

void check_rings(CheckedCase& in, const Races& races) {
  check_order(in, "bearing.roller_diameter", "an inner raceway: a roller with half the clearance",
              0.5 * (races.outer - races.inner), 0.5 * (races.outer + races.inner));
  // Without a ring, seat and race are one.
  const std::string rings = has_all(in, {"bearing.rings"}) ? in.choice("bearing.rings") : "both";
  if (has_all(in, {"bearing.bore"}) && rings == "both")
    check_order(in, "bearing.bore", "a bore within the inner raceway", in.quantity("bearing.bore"),
                races.inner);
  if (has_all(in, {"bearing.bore", "bearing.fit.pin_bore"}))
    check_order(in, "bearing.fit.pin_bore", "a hole in the pin", in.quantity("bearing.fit.pin_bore"),
                in.quantity("bearing.bore"));
  if (has_all(in, {"bearing.outside_diameter"}) && rings != "none")
    check_order(in, "bearing.outside_diameter", "an outer raceway within the outside diameter", races.outer,
                in.quantity("bearing.outside_diameter"));
}

void check_cage(CheckedCase& in, const std::optional<Races>& races) {
  if (!has_all(in, {"bearing.cage.inner_diameter", "bearing.cage.outer_diameter"})) return;
  const double inner = in.quantity("bearing.cage.inner_diameter");
  const double outer = in.quantity("bearing.cage.outer_diameter");
  check_order(in, "bearing.cage.inner_diameter", "an inner diameter of the cage", inner, outer);
  if (!races) return;  // of balls, whose grooves let a cage reach past them
  check_order(in, "bearing.cage.inner_diameter", "a cage around the inner raceway: this", races->inner,
              inner);
  check_order(in, "bearing.cage.outer_diameter", "a cage within the outer raceway", outer, races->outer);
}

void check_guide_land(CheckedCase& in) {
  if (!has_all(in, {"bearing.cage.guide_land_diameter", "bearing.cage.guidance",
                    "bearing.cage.inner_diameter", "bearing.cage.outer_diameter"}))
    return;
  const double land = in.quantity("bearing.cage.guide_land_diameter");
  if (land == 0.0) return;  // rollers or balls guide the cage
  if (in.choice("bearing.cage.guidance") == "outer")
    check_order(in, "bearing.cage.guide_land_diameter", "a land around the cage: the cage's outer diameter",
                in.quantity("bearing.cage.outer_diameter"), land);
  else
    check_order(in, "bearing.cage.guide_land_diameter", "a land within the cage", land,
                in.quantity("bearing.cage.inner_diameter"));
}

void check_widths(CheckedCase& in) {
  if (has_all(in, {"bearing.roller_length", "bearing.width"}))
    check_order(in, "bearing.roller_length", "a roller within the rings",
                in.quantity("bearing.roller_length"), in.quantity("bearing.width"), true);
  if (has_all(in, {"bearing.roller_length", "bearing.cage.width"}))
    check_order(in, "bearing.cage.width", "a cage longer than its rollers: a roller",
                in.quantity("bearing.roller_length"), in.quantity("bearing.cage.width"));
  if (has_all(in, {"bearing.per_planet", "bearing.width", "gearset.face_width"}))
    check_order(in, "bearing.per_planet", "bearings within the planet's face: their widths in all",
                in.integer("bearing.per_planet") * in.quantity("bearing.width"), planet_length(in), true);
}

// A cage is given whole or not at all.
void check_whole_cage(CheckedCase& in) {
  const std::initializer_list<const char*> parts = {"bearing.cage.inner_diameter",
                                                    "bearing.cage.outer_diameter", "bearing.cage.width",
                                                    "bearing.cage.density"};
  const auto is_given = [&](const char* part) { return in.has(part); };
  const auto missing = std::ranges::find_if_not(parts, is_given);
  if (missing != parts.end() && std::ranges::any_of(parts, is_given))
    in.add_error_at("bearing.cage", fmt::format("a cage without '{}'", *missing),
                    "diameters, width and density, or no cage, are required");
}

void check_one_set(CheckedCase& in) {
  check_traction(in);
  check_members(in);
  check_gears(in);
  check_error_lists(in);
  check_carrier_lists(in);
  check_roller_circle(in);
  const std::optional<Races> races = races_of(in);
  if (races) check_rings(in, *races);
  if (!is_full_complement(in)) {
    check_cage(in, races);
    check_guide_land(in);
  }
  check_widths(in);
  check_catalogue_bearing(in);
  check_refinements(in);
  check_profile(in);
  check_static_bearing(in);
  check_machine(in);
  check_defect(in);
  if (in.model() == roller_bearing) check_whole_cage(in);
}

// Each set as a case of its own, with its mistakes under its name; then the parts that join them.
void check_multi_stage(CheckedCase& in) {
  for (const std::string& set : in.shape().sets) {
    std::vector<Mistake> of_set;
    CheckedCase one(in.of_set(set), of_set);
    check_one_set(one);
    if (has_planet_pairs(one))
      one.add_error_at("gearset.second_planet.teeth", "planets in pairs in one of several sets",
                       "a case of one set is required");
    for (Mistake& mistake : of_set) {
      mistake.path = set_prefix(set) + mistake.path;
      in.mistakes.push_back(std::move(mistake));
    }
  }
  check_arrangement(in);
  check_defect_of_sets(in);
}

}  // namespace

double planet_length(const ResolvedCase& in) {
  if (!has_stepped_planets(in)) return in.quantity("gearset.face_width");
  return gearset::gear_planes(stated_set(in)).length;
}

bool takes_part_in_consistency(std::string_view path) {
  return begins_with_one_of(path, {"gearset.", "bearing.", "sets.", "shafts.", "pair.", "load.", "spindle.",
                                   "housing.", "defect.", "signal.", "life.",
                                   "lubricant.kinematic", "parallel_stage."}) ||
         is_one_of(path,
                   {"stiffness", "arrangement", "operation.shaft_speed", "operation.outer_speed",
                    "lubricant.grade", "lubricant.temperature", "lubricant.viscosity_index", "input.member"});
}

void check_consistency(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  CheckedCase in(resolved, mistakes);
  if (in.shape().several)
    check_multi_stage(in);
  else
    check_one_set(in);
  check_parallel_stages(in);
  // The oil is that of all sets.
  check_grade(in);
  check_torque(in);
  check_speed_of(in);
  check_cleanliness(in);
  check_spectrum(in);
}

}  // namespace orbearing::app
