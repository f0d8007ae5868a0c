#include "app/case/consistency.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

#include <cmath>
#include <optional>

#include "app/case/arrangement_case.hpp"
#include "app/case/catalogue_case.hpp"
#include "app/case/defect_case.hpp"
#include "app/case/duplex_case.hpp"
#include "app/case/field_table.hpp"
#include "app/case/mistake.hpp"
#include "app/case/oil_case.hpp"
#include "app/case/profile_case.hpp"
#include "app/case/set_case.hpp"
#include "app/case/spectrum_case.hpp"
#include "bearing/motion/parameters.hpp"
#include "gearset/checks.hpp"
#include "gearset/planet_angles.hpp"
#include "gearset/stepped_planet.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

class Checker {
 public:
  Checker(const ResolvedCase& resolved, std::vector<Mistake>& mistakes)
      : resolved_(resolved), mistakes_(mistakes) {}

  bool has(std::initializer_list<const char*> paths) const {
    for (const char* path : paths)
      if (!resolved_.has(path)) return false;
    return true;
  }

  double length(const char* path) const { return resolved_.quantity(path); }  // [m]
  int count(const char* path) const { return resolved_.integer(path); }
  const std::string& choice(const char* path) const { return resolved_.choice(path); }

  void add_error(const std::string& path, std::string found, std::string required) {
    mistakes_.push_back({location_of(path), path, {std::move(found), std::move(required)}});
  }

  /// `low` must be less than `high`, or may equal it; the objection goes to `path`.
  void ordered(const char* path, const char* requirement, double low, double high, bool may_equal = false) {
    // Sums of lengths that fill a space exactly may miss it by rounding.
    constexpr double rounding = 1e-12;  // [m]
    if (may_equal ? low <= high + rounding : low < high) return;
    add_error(path, quote(resolved_.given(path)) + " does not fit",
              fmt::format("{} ({:.4g} mm) {} {:.4g} mm is required", requirement, 1e3 * low,
                          may_equal ? "of at most" : "less than", 1e3 * high));
  }

 private:
  // Of a value, or of the first value in a block.
  Location location_of(const std::string& path) const {
    if (resolved_.has(path)) return resolved_.location(path);
    for (const Field& field : all_fields())
      if (field.path.starts_with(path + ".") && resolved_.has(field.path))
        return resolved_.location(field.path);
    return {};
  }

  const ResolvedCase& resolved_;
  std::vector<Mistake>& mistakes_;
};

void check_traction(Checker& check) {
  using bearing::motion::TractionLaw;
  if (!check.has({"bearing.rollers", "traction.law"})) return;
  const std::string stated = check.choice("traction.law");
  std::vector<std::string_view> of_rollers;
  for (const auto& [law, name] : names_of(TractionLaw{}))
    if (nature_of(law).of_rollers) of_rollers.push_back(name);
  if (std::ranges::find(of_rollers, stated) != of_rollers.end()) return;
  check.add_error("traction.law", fmt::format("'{}', a traction model for balls", stated),
                  fmt::format("{} is required for rollers", fmt::join(of_rollers, " or ")));
}

void check_members(Checker& check) {
  if (!check.has({"input.member", "gearset.fixed"})) return;
  if (check.choice("input.member") != check.choice("gearset.fixed")) return;
  check.add_error("input.member",
                  fmt::format("'{}' is the fixed member (gearset.fixed)", check.choice("input.member")),
                  "a member that rotates is required");
}

// The checks of the gears give "what was found; what is required" and a key.
void add_errors(Checker& check, const ResolvedCase& resolved, const gearset::Warnings& problems) {
  for (const gearset::Warning& problem : problems) {
    const auto split = problem.text.find("; ");  // found; required
    check.add_error(location_in_case(resolved, problem.key), problem.text.substr(0, split),
                    problem.text.substr(split + 2));
  }
}

// One of several sets may go without.
bool has_bearing(const ResolvedCase& resolved) {
  for (const Field& field : all_fields())
    if (field.path.starts_with("bearing.") && resolved.has(field.path)) return true;
  return false;
}

void check_gears(Checker& check, const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  if (!check.has({"gearset.teeth.sun", "gearset.teeth.planet", "gearset.teeth.ring", "gearset.planets",
                  "gearset.module", "gearset.pressure_angle", "gearset.addendum", "gearset.clearance",
                  "gearset.root_fillet_radius", "gearset.profile_shift.sun", "gearset.profile_shift.ring",
                  "gearset.face_width", "gearset.helix_angle", "gearset.web.rim", "material.density"}) ||
      (has_bearing(resolved) && !check.has({"bearing.outside_diameter"})))
    return;
  const bool pairs = has_planet_pairs(resolved);
  const gearset::Warnings problems =
      pairs ? gearset::pair_problems(set_of(resolved), second_planet_of(resolved))
            : gearset::assembly_problems(set_of(resolved));
  add_errors(check, resolved, problems);
  if (problems.empty() && !pairs) check_stated_geometry(resolved, mistakes);
}

bool two_values(Checker& check, const ResolvedCase& resolved, const char* path) {
  const std::size_t count = resolved.list(path).size();
  if (count == 2) return true;
  check.add_error(path, fmt::format("a list of {}", count),
                  "two values, of the driving and the driven gear, are required");
  return false;
}

void check_stage_teeth(Checker& check, const char* path, const std::vector<double>& teeth) {
  constexpr double least = 5.0;  // as of a sun
  for (std::size_t i = 0; i + 1 < teeth.size(); i += 2)
    if (teeth[i] < least || teeth[i + 1] < least)
      check.add_error(path, fmt::format("{:g} and {:g} teeth", teeth[i], teeth[i + 1]),
                      "at least 5 of each gear, or [1, 1] for no stage, are required");
}

// Beyond it the equations of the whole train lose the digits by which contradictions are told.
constexpr double kLargestStageRatio = 1e6;  // [-]  up or down, of all stages
constexpr std::size_t kMostStages = 20;

void check_parallel_stages(Checker& check, const ResolvedCase& resolved) {
  double ratio = 1.0;
  std::size_t stages = 0;
  for (const char* path : {"parallel_stage.front", "parallel_stage.behind"}) {
    if (!check.has({path}) || resolved.list(path) == std::vector<double>{1.0, 1.0}) continue;  // none
    const std::vector<double>& teeth = resolved.list(path);
    check_stage_teeth(check, path, teeth);
    for (std::size_t i = 0; i + 1 < teeth.size(); i += 2, ++stages)
      ratio *= std::max(teeth[i], teeth[i + 1]) / std::min(teeth[i], teeth[i + 1]);
    if (stages > kMostStages || ratio > kLargestStageRatio)
      return check.add_error(
          path, fmt::format("{} parallel stages of {:.3g} in all", stages, ratio),
          fmt::format("at most {} stages, and ratios whose product (each as larger over smaller gear) is at "
                      "most 1e6, are required",
                      kMostStages));
  }
}

void check_pair(Checker& check, const ResolvedCase& resolved) {
  if (!check.has({"pair.teeth", "pair.profile_shift", "pair.module", "pair.face_width", "pair.bore",
                  "pair.pressure_angle", "pair.addendum", "pair.clearance", "pair.root_fillet_radius",
                  "pair.helix_angle", "pair.web.rim", "pair.kind", "pair.ring_outside_ratio"}))
    return;
  const bool teeth = two_values(check, resolved, "pair.teeth");
  const bool shifts = two_values(check, resolved, "pair.profile_shift");
  if (teeth && shifts) add_errors(check, resolved, gearset::pair_problems(pair_of(resolved)));
}

// Errors are listed pin by pin, and over a mesh period at more than one place.
void check_error_lists(Checker& check, const ResolvedCase& resolved) {
  for (const char* path : {"gearset.dynamics.pin_error.radial", "gearset.dynamics.pin_error.tangential"}) {
    if (!check.has({path, "gearset.planets"})) continue;
    const std::size_t count = resolved.list(path).size();
    const auto planets = static_cast<std::size_t>(check.count("gearset.planets"));
    if (count != planets)
      check.add_error(path, fmt::format("a list of {}", count),
                      fmt::format("one value for each of the {} planets is required", planets));
  }
  if (check.has({"gearset.planet_angles", "gearset.planets"}) && !resolved.shape().teeth)
    add_errors(check, resolved,
               gearset::position_problems({.planets = check.count("gearset.planets"),
                                           .planet_angles = resolved.list("gearset.planet_angles")}));
  for (const char* path :
       {"gearset.dynamics.transmission_error.sun", "gearset.dynamics.transmission_error.ring"})
    if (check.has({path}) && resolved.list(path).size() < 3)
      check.add_error(path, fmt::format("a list of {}", resolved.list(path).size()),
                      "at least three values, at equal steps of a mesh period, are required");
}

void check_roller_circle(Checker& check, const ResolvedCase& resolved) {
  if (!check.has({"bearing.rollers", "bearing.roller_diameter", "bearing.pitch_diameter"})) return;
  const int rollers = check.count("bearing.rollers");
  const double spacing = check.length("bearing.pitch_diameter") * std::sin(constants::pi / rollers);  // [m]
  const double diameter = check.length("bearing.roller_diameter");                                    // [m]
  constexpr double round_off = 1e-12;  // rollers that touch fit
  if (diameter > spacing * (1.0 + round_off)) {
    check.add_error("bearing.rollers", fmt::format("{} rollers do not fit around the pitch circle", rollers),
                    fmt::format("a roller diameter ({:.6g} mm) of at most their centre distance, {:.6g} mm, "
                                "is required. Use fewer or thinner rollers",
                                1e3 * diameter, 1e3 * spacing));
  } else if (check.has({"bearing.cage.pocket_clearance"}) && !is_full_complement(resolved)) {
    check.ordered("bearing.cage.pocket_clearance",
                  "room for bars between the pockets: a roller with its play",
                  diameter + check.length("bearing.cage.pocket_clearance"), spacing);
  }
}

struct Races {
  double inner = 0.0;  // [m] raceway diameter
  double outer = 0.0;  // [m]
};

std::optional<Races> races_of(const Checker& check) {
  if (!check.has({"bearing.pitch_diameter", "bearing.roller_diameter", "bearing.radial_clearance"}))
    return {};
  const double pitch = check.length("bearing.pitch_diameter");
  const double reach =
      check.length("bearing.roller_diameter") + 0.5 * check.length("bearing.radial_clearance");
  return Races{pitch - reach, pitch + reach};
}

void check_rings(Checker& check, const Races& races) {
  check.ordered("bearing.roller_diameter", "an inner raceway: a roller with half the clearance",
                0.5 * (races.outer - races.inner), 0.5 * (races.outer + races.inner));
  // Without a ring, seat and race are one.
  const std::string rings = check.has({"bearing.rings"}) ? check.choice("bearing.rings") : "both";
  if (check.has({"bearing.bore"}) && rings == "both")
    check.ordered("bearing.bore", "a bore within the inner raceway", check.length("bearing.bore"),
                  races.inner);
  if (check.has({"bearing.bore", "bearing.fit.pin_bore"}))
    check.ordered("bearing.fit.pin_bore", "a hole in the pin", check.length("bearing.fit.pin_bore"),
                  check.length("bearing.bore"));
  if (check.has({"bearing.outside_diameter"}) && rings != "none")
    check.ordered("bearing.outside_diameter", "an outer raceway within the outside diameter", races.outer,
                  check.length("bearing.outside_diameter"));
}

void check_cage(Checker& check, const std::optional<Races>& races) {
  if (!check.has({"bearing.cage.inner_diameter", "bearing.cage.outer_diameter"})) return;
  const double inner = check.length("bearing.cage.inner_diameter");
  const double outer = check.length("bearing.cage.outer_diameter");
  check.ordered("bearing.cage.inner_diameter", "an inner diameter of the cage", inner, outer);
  if (!races) return;  // of balls, whose grooves let a cage reach past them
  check.ordered("bearing.cage.inner_diameter", "a cage around the inner raceway: this", races->inner, inner);
  check.ordered("bearing.cage.outer_diameter", "a cage within the outer raceway", outer, races->outer);
}

void check_guide_land(Checker& check) {
  if (!check.has({"bearing.cage.guide_land_diameter", "bearing.cage.guidance", "bearing.cage.inner_diameter",
                  "bearing.cage.outer_diameter"}))
    return;
  const double land = check.length("bearing.cage.guide_land_diameter");
  if (land == 0.0) return;  // rollers or balls guide the cage
  if (check.choice("bearing.cage.guidance") == "outer")
    check.ordered("bearing.cage.guide_land_diameter", "a land around the cage: the cage's outer diameter",
                  check.length("bearing.cage.outer_diameter"), land);
  else
    check.ordered("bearing.cage.guide_land_diameter", "a land within the cage", land,
                  check.length("bearing.cage.inner_diameter"));
}

// The face of the planet; of a stepped one its whole length.
double planet_length(const ResolvedCase& resolved) {
  if (!has_stepped_planets(resolved)) return resolved.quantity("gearset.face_width");
  return gearset::gear_planes(stated_set(resolved)).length;
}

void check_widths(Checker& check, const ResolvedCase& resolved) {
  if (check.has({"bearing.roller_length", "bearing.width"}))
    check.ordered("bearing.roller_length", "a roller within the rings", check.length("bearing.roller_length"),
                  check.length("bearing.width"), true);
  if (check.has({"bearing.roller_length", "bearing.cage.width"}))
    check.ordered("bearing.cage.width", "a cage longer than its rollers: a roller",
                  check.length("bearing.roller_length"), check.length("bearing.cage.width"));
  if (check.has({"bearing.per_planet", "bearing.width", "gearset.face_width"}))
    check.ordered("bearing.per_planet", "bearings within the planet's face: their widths in all",
                  check.count("bearing.per_planet") * check.length("bearing.width"), planet_length(resolved),
                  true);
}

// A cage is given whole or not at all.
void check_whole_cage(Checker& check, const ResolvedCase& resolved) {
  const std::initializer_list<const char*> parts = {"bearing.cage.inner_diameter",
                                                    "bearing.cage.outer_diameter", "bearing.cage.width",
                                                    "bearing.cage.density"};
  std::string missing;
  bool any = false;
  for (const char* part : parts) {
    any = any || resolved.has(part);
    if (!resolved.has(part) && missing.empty()) missing = part;
  }
  if (any && !missing.empty())
    check.add_error("bearing.cage", fmt::format("a cage without '{}'", missing),
                    "diameters, width and density, or no cage, are required");
}

// A contact is an ellipse or a line; a line is solved and does not spin.
void check_contact(const ResolvedCase& in, std::vector<Mistake>& mistakes) {
  if (in.model() != spin_film || !in.has("film.solver")) return;
  if (!in.has("contact.length")) {
    const bool reported = std::any_of(mistakes.begin(), mistakes.end(), [](const Mistake& mistake) {
      return mistake.path == "contact.ellipticity";
    });
    if (!in.has("contact.ellipticity") && !reported)
      mistakes.push_back({in.location("model"),
                          "contact.ellipticity",
                          {"neither an ellipse nor a line",
                           "contact.ellipticity, or contact.length of a line contact, is required"}});
    return;
  }
  if (in.choice("film.solver") != "reynolds")
    add_error_at(in, "contact.length",
                 "a line contact together with film.solver: " + in.choice("film.solver"),
                 "film.solver: reynolds is required: the regressions are for ellipses only", mistakes);
  if (!in.has("points")) return;
  const std::vector<double>& rows = in.list("points");
  for (std::size_t i = 2; i < rows.size(); i += 3)
    if (rows[i] != 0.0) {
      add_error_at(in, "points", "a line contact that spins",
                   "no spin is required together with contact.length", mistakes);
      return;
    }
}

void check_one_set(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  Checker check(resolved, mistakes);
  check_traction(check);
  check_members(check);
  check_gears(check, resolved, mistakes);
  check_pair(check, resolved);
  check_error_lists(check, resolved);
  check_roller_circle(check, resolved);
  const std::optional<Races> races = races_of(check);
  if (races) check_rings(check, *races);
  if (!is_full_complement(resolved)) {
    check_cage(check, races);
    check_guide_land(check);
  }
  check_widths(check, resolved);
  check_catalogue_bearing(resolved, mistakes);
  check_refinements(resolved, mistakes);
  check_profile(resolved, mistakes);
  check_static_bearing(resolved, mistakes);
  check_defect(resolved, mistakes);
  check_duplex(resolved, mistakes);
  check_contact(resolved, mistakes);
  if (resolved.model() == roller_bearing) check_whole_cage(check, resolved);
}

// Each set as a case of its own, what is said of it under its name; then what joins them.
void check_multi_stage(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  for (const std::string& set : resolved.shape().sets) {
    std::vector<Mistake> of_set;
    const ResolvedCase one = resolved.of_set(set);
    check_one_set(one, of_set);
    if (has_planet_pairs(one))
      add_error_at(one, "gearset.second_planet.teeth", "planets in pairs in one of several sets",
                   "a case of one set is required", of_set);
    for (Mistake& mistake : of_set) {
      mistake.path = set_prefix(set) + mistake.path;
      mistakes.push_back(std::move(mistake));
    }
  }
  check_arrangement(resolved, mistakes);
  check_defect_of_sets(resolved, mistakes);
}

}  // namespace

bool takes_part_in_consistency(std::string_view path) {
  return path.starts_with("gearset.") || path.starts_with("bearing.") || path.starts_with("sets.") ||
         path.starts_with("shafts.") || path.starts_with("pair.") || path.starts_with("load.") ||
         path.starts_with("spindle.") || path.starts_with("housing.") || path.starts_with("measured.") ||
         path.starts_with("identification.") || path == "stiffness" || path == "arrangement" ||
         path.starts_with("defect.") || path.starts_with("signal.") || path == "operation.shaft_speed" ||
         path.starts_with("life.") || path.starts_with("lubricant.kinematic") || path == "input.member" ||
         path.starts_with("parallel_stage.");
}

void check_consistency(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  if (resolved.shape().several)
    check_multi_stage(resolved, mistakes);
  else
    check_one_set(resolved, mistakes);
  Checker check(resolved, mistakes);
  check_parallel_stages(check, resolved);
  // The oil is that of all sets.
  check_grade(resolved, mistakes);
  check_torque(resolved, mistakes);
  check_speed_of(resolved, mistakes);
  check_cleanliness(resolved, mistakes);
  check_spectrum(resolved, mistakes);
}

}  // namespace orbearing::app
