#include "app/case/consistency.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

#include <cmath>
#include <optional>

#include "app/case/arrangement_case.hpp"
#include "app/case/bearing_type.hpp"
#include "app/case/catalogue_case.hpp"
#include "app/case/catalogue_checks.hpp"
#include "app/case/defect_case.hpp"
#include "app/case/drivetrain_reader.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machines.hpp"
#include "app/case/mistake.hpp"
#include "app/case/oil_case.hpp"
#include "app/case/profile_case.hpp"
#include "app/case/spectrum_case.hpp"
#include "bearing/design_problems.hpp"
#include "bearing/motion/starvation.hpp"
#include "coupling/analysis/set_problems.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

// Found by the library, but where the value itself is missing.
void add_problems(CheckedCase& in, const mechanics::Problems& problems) {
  for (const mechanics::Problem& problem : problems)
    if (!is_missing(in, problem.key)) in.add_error(problem.key, problem.text);
}

void check_driven_member(CheckedCase& in) {
  if (!has_all(in, {keys().driven_member, keys().fixed_member})) return;
  if (in.choice(keys().driven_member) != in.choice(keys().fixed_member)) return;
  in.add_error_at(keys().driven_member,
                  fmt::format("'{}' is the fixed member (gearset.fixed)", in.choice(keys().driven_member)),
                  "a member that rotates is required");
}

void check_design(CheckedCase& in) {
  auto design = part_of<bearing::BearingDesign>(in, Missing::left_out);
  design.caged = !is_full_complement(in);
  add_problems(in, problems(design));
  if ((in.model() & with_balls) != 0) add_problems(in, ball_problems(design));
}

// Inputs of which the library sees no difference between a stated value and a default, with other bearings
// than cylindrical rollers.
void check_stated_with_type(CheckedCase& in) {
  const std::string& type = in.choice(keys().bearing_type);
  const bool tapered = type == "tapered-roller";
  const auto refuse = [&](const std::string& path, const char* or_type) {
    if (is_stated(in, path))
      in.add_error_at(path, fmt::format("{} together with bearing.type: {}", in.given(path), type),
                      fmt::format("none is required, or bearing.type: cylindrical-roller{}", or_type));
  };
  for (const std::string& path :
       {keys().designation, keys().clearance_class, keys().axial_positions, keys().scratched})
    refuse(path, "");
  if (!tapered)
    for (const std::string& path : {keys().laminae, keys().profile_kind}) refuse(path, " or tapered-roller");
  if (type == "deep-groove-ball") refuse(kSpectrumPath, "");
  const std::vector<std::string> of_tapered{keys().rows_contact_angle, keys().rows_arrangement},
      of_spherical{keys().rows_contact_angle}, of_balls{keys().balls, keys().ball_diameter};
  for (const std::string& path : tapered ? of_tapered : type == "spherical-roller" ? of_spherical : of_balls)
    if (!in.has(path))
      in.add_error_at(path, "missing", fmt::format("a value is required with bearing.type: {}", type));
}

void check_bearing_type(CheckedCase& in) {
  if (bearing_type_of(in) == bearing::PlanetBearingType::cylindrical_roller) return;
  if (in.model() == planetary_drivetrain) return check_stated_with_type(in);
  in.add_error_at(keys().bearing_type,
                  fmt::format("'{}' in a case of one bearing", in.choice(keys().bearing_type)),
                  "cylindrical-roller is required; other types are those of planets, in cases of the model "
                  "planetary-drivetrain");
}

void check_set(CheckedCase& in) {
  const analysis::StatedSet& set = stated_drivetrain(in, Missing::left_out).single();
  add_problems(in, analysis::problems(set));
  add_problems(in, bearing::motion::starvation_problems(set.planets.dynamics.race,
                                                        has_all(in, {keys().bore, keys().outside_diameter})));
}

// A cage is given whole or not at all.
void check_whole_cage(CheckedCase& in) {
  const std::initializer_list<std::string> parts = {keys().cage_inner_diameter, keys().cage_outer_diameter,
                                                    keys().cage_width, keys().cage_density};
  const auto is_given = [&](const std::string& part) { return in.has(part); };
  const auto missing = std::ranges::find_if_not(parts, is_given);
  if (missing != parts.end() && std::ranges::any_of(parts, is_given))
    in.add_error_at("bearing.cage", fmt::format("a cage without '{}'", *missing),
                    "diameters, width and density, or no cage, are required");
}

// Codes and words name the same levels, so that the library does not see which of them is written.
void check_code_of_grease(CheckedCase& in) {
  const std::string &level = keys().cleanliness, &lubrication = keys().lubrication;
  if (has_all(in, {level, lubrication}) && in.is(lubrication, "grease") && in.choice(level).front() == '-')
    in.add_error_at(level, quote(in.choice(level)) + " for grease",
                    "one of highest, high, medium, low, lowest is required: codes of ISO 4406 are those of "
                    "oil");
}

void check_one_set(CheckedCase& in) {
  check_driven_member(in);
  check_bearing_type(in);
  if (in.model() == planetary_drivetrain) check_set(in);
  check_design(in);
  check_catalogue_bearing(in);
  check_profile(in);
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
    if (one.has(keys().second_planet_teeth))
      one.add_error_at(keys().second_planet_teeth, "planets in pairs in one of several sets",
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

bool takes_part_in_consistency(std::string_view path) {
  return begins_with_one_of(
             path, {"gearset.", "bearing.", "sets.", "shafts.", "pair.", "load.", "spindle.", "housing.",
                    "defect.", "signal.", "life.", "lubricant.kinematic", "parallel_stage."}) ||
         is_one_of(path,
                   {"stiffness", "arrangement", keys().shaft_speed, keys().outer_speed, keys().oil_grade,
                    keys().oil_temperature, keys().oil_viscosity_index, keys().driven_member});
}

void check_consistency(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  CheckedCase in(resolved, mistakes);
  if (in.shape().several)
    check_multi_stage(in);
  else
    check_one_set(in);
  if (in.model() == planetary_drivetrain)
    add_problems(in, analysis::problems(part_of<gearset::ParallelStages>(in, Missing::left_out)));
  // The oil is that of all sets.
  check_grade(in);
  check_torque(in);
  check_speed_of(in);
  add_problems(in, analysis::problems(part_of<analysis::LifeInputs>(in, Missing::left_out)));
  check_code_of_grease(in);
  check_spectrum(in);
}

}  // namespace orbearing::app
