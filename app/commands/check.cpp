#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "app/case/bearing_type.hpp"
#include "app/case/catalogue_case.hpp"
#include "app/case/check_table.hpp"
#include "app/case/set_case.hpp"
#include "app/case/uncertain_case.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/presentation.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/analysis.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/mesh_study.hpp"
#include "app/study/motion_budget.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/sensitivity.hpp"

namespace orbearing::app {

namespace {

struct Checked {
  std::vector<Derived> derived;
  std::vector<std::string> warnings;
  std::optional<PowerTable> power;  // of a drivetrain
};

Checked check(const ResolvedCase& resolved) {
  if (resolved.model() == gear_pair) {
    const MeshStudy meshes = mesh_study(resolved.without_sweep());
    return {pair_quantities(resolved, meshes), meshes.warnings};
  }
  const Analysis* analysis = analysis_of(resolved);
  const std::vector<Derived> own = analysis != nullptr && analysis->derived != nullptr
                                       ? analysis->derived(resolved)
                                       : std::vector<Derived>{};
  if (resolved.model() != planetary_drivetrain) return {own, {}, {}};
  Checked checked{derived_quantities(resolved), gear_warnings(resolved), {}};
  if (resolved.shape().several || resolved.shape().teeth) checked.power = power_table(resolved);
  if (!resolved.shape().several && !has_stepped_planets(resolved) && !has_planet_pairs(resolved) &&
      has_cylindrical_rollers(resolved))
    for (const Derived& row : gear_dynamics_quantities(resolved))
      if (!resolved.has(row.path)) checked.derived.push_back(row);
  checked.derived.insert(checked.derived.end(), own.begin(), own.end());
  return checked;
}

}  // namespace

int check_command(const Options& options) {
  const ResolvedCase resolved = case_of(options);
  Checked checked = check(resolved);
  if (resolved.model() == planetary_drivetrain) {
    for (std::string& warning : overturning_warnings(resolved.without_sweep()))
      checked.warnings.push_back(std::move(warning));
    for (std::string& warning : cage_warnings(resolved)) checked.warnings.push_back(std::move(warning));
    for (std::string& warning : clearance_warnings(resolved)) checked.warnings.push_back(std::move(warning));
  }
  for (std::string& warning : default_warnings(resolved, checked.derived))
    checked.warnings.push_back(std::move(warning));
  for (const Derived& row : catalogue_quantities(resolved)) checked.derived.push_back(row);
  for (const Derived& row : motion_time_quantities(resolved)) checked.derived.push_back(row);
  for (std::string& warning : inferred_warnings(resolved)) checked.warnings.push_back(std::move(warning));
  for (std::string& warning : uncertain_warnings(resolved)) checked.warnings.push_back(std::move(warning));
  for (std::string& warning : former_key_warnings(resolved)) checked.warnings.push_back(std::move(warning));
  // What the case states as a check stands among its inputs.
  std::erase_if(checked.derived, [&](const Derived& row) { return resolved.has(row.path); });
  const std::vector<std::string> idle = idle_inputs(resolved);
  checked.warnings.insert(checked.warnings.end(), idle.begin(), idle.end());
  if (options.json) {
    Record record;
    describe_check(record, resolved, checked.derived);
    if (checked.power) describe(record, *checked.power);
    nlohmann::ordered_json object = json_of(record);
    if (!resolved.uncertain().inputs.empty()) object["uncertain"] = uncertain_json(resolved);
    object["warnings"] = checked.warnings;
    object["units"] = check_units(resolved, checked.derived);
    print_result(std::move(object), record, options);
    return 0;
  }
  if (options.quiet) return 0;
  fmt::print("{}", check_table(resolved, checked.derived));
  if (checked.power) fmt::print("\n{}", text_of(record_of(*checked.power)));
  print_warnings(checked.warnings);
  return 0;
}

}  // namespace orbearing::app
