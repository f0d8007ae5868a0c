#include "app/case/defect_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/case/bearing_type.hpp"
#include "app/case/drivetrain_reader.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/mistake.hpp"
#include "app/errors.hpp"
#include "bearing/defect/scratch.hpp"
#include "coupling/analysis/vibration_record.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

void check_planet_surface(CheckedCase& in) {
  if (!in.has(keys().scratched)) return;
  const double diameter = in.has(keys().roller_diameter) ? in.quantity(keys().roller_diameter) : 0.0;
  const auto scratch = from_case<bearing::defect::Scratch>(in);
  for (const mechanics::Problem& problem : analysis::problems(scratch, true, diameter))
    in.add_error(problem.key, problem.text);
  if (scratch.race != bearing::defect::Scratched::none &&
      scratch.form == bearing::ScratchForm::literature_variant)
    in.add_error_at(keys().scratch_form, "'as-printed', which jumps at both edges",
                    "a continuous form is required where all of the bearing moves");
}

// Mistakes in the location of the scratch, for the set with the scratched bearing, whose inputs have `prefix`
// in the case.
void check_location(CheckedCase& in, const std::string& prefix) {
  const auto at_most = [&](const std::string& path, const std::string& count) {
    if (has_all(in, {path, count}) && in.integer(path) > in.integer(count))
      in.add_error_at(path, in.given(path),
                      fmt::format("at most {} ({}{}) is required", in.integer(count), prefix, count));
  };
  at_most(keys().scratched_planet, keys().planets);
  at_most(keys().scratched_bearing, keys().per_planet);
  at_most(keys().scratched_element, keys().rollers);
  const auto band = machine_of<analysis::EnvelopeBand>(in);
  for (const mechanics::Problem& problem : analysis::problems(band, in.quantity("signal.sampling_rate")))
    in.add_error(problem.key, problem.text);
}

void check_planet_defect(CheckedCase& in, const std::string& prefix) {
  if (in.has(keys().scratched) && in.has(keys().second_planet_teeth))
    in.add_error_at(keys().second_planet_teeth, "planets in pairs together with defect",
                    "a case without it is required");
  if (!in.has(keys().scratched))
    in.mistakes.push_back(
        {{}, keys().scratched, {"a block defect without it", "outer, inner, roller or none is required"}});
  check_planet_surface(in);
  check_location(in, prefix);
}

std::vector<std::string> sets_with_bearings(const ResolvedCase& in) {
  std::vector<std::string> names;
  for (const std::string& set : in.shape().sets)
    if (has_planet_bearing(in, set_prefix(set))) names.push_back(set);
  return names;
}

}  // namespace

void check_defect_of_sets(CheckedCase& in) {
  if (!is_planet_defect(in)) return;
  const std::string path(kScratchedSet);
  const std::vector<std::string> names = sets_with_bearings(in);
  const std::string required =
      fmt::format("the set with the scratched bearing, {}, is required", fmt::join(names, " or "));
  if (!in.has(path))
    return in.mistakes.push_back({{}, path, {"a block defect of several sets without it", required}});
  const std::string& set = in.text(path);
  if (std::ranges::find(names, set) == names.end()) return in.add_error_at(path, quote(set), required);
  CheckedCase of_set(in.of_set(set), in.mistakes);
  check_planet_defect(of_set, set_prefix(set));
  if (in.mistakes.empty() && !held_member_of(stated_drivetrain(in, Missing::left_out), set))
    in.add_error_at(
        path, quote(set) + ", all of whose members rotate",
        "a set with a member on a shaft with 'ground' is required: a case does not state how stiffly "
        "other sets hold the rotation");
}

bool is_planet_defect(const ResolvedCase& in) {
  return in.model() == planetary_drivetrain && in.shape().defect && in.shape().bearing;
}

void check_defect(CheckedCase& in) {
  if (is_planet_defect(in)) check_planet_defect(in, "");
}

}  // namespace orbearing::app
