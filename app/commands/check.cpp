#include "app/commands/check.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "app/case/bearing_type.hpp"
#include "app/case/catalogue_quantities.hpp"
#include "app/case/catalogue_warnings.hpp"
#include "app/case/check_table.hpp"
#include "app/case/drivetrain_reader.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machine_fields.hpp"
#include "app/case/machines.hpp"
#include "app/case/uncertain_case.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/presentation.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/analysis.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/mesh_study.hpp"
#include "app/study/motion_budget.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/plausibility.hpp"
#include "app/study/sensitivity.hpp"
#include "coupling/analysis/drivetrain_warnings.hpp"

namespace orbearing::app {

namespace {

struct Checked {
  std::vector<Derived> derived{};
  std::vector<std::string> warnings{};
  bool has_power = false;  // a drivetrain whose members have speeds
};

Checked check(const ResolvedCase& resolved) {
  const Analysis* analysis = analysis_of(resolved);
  if (!fields_of_machine(resolved.model()).empty()) {
    Checked machine;
    machine.derived = or_reason(analysis != nullptr ? analysis->names.name : "", [&] {
      MachineQuantities found = machine_quantities(resolved);
      machine.warnings = std::move(found.warnings);
      return found.rows;
    });
    return machine;
  }
  const std::vector<Derived> own =
      analysis != nullptr && analysis->derived != nullptr
          ? or_reason(analysis->names.name, [&] { return analysis->derived(resolved); })
          : std::vector<Derived>{};
  if (resolved.model() != planetary_drivetrain) return {own};
  const std::vector<analysis::NamedSet> sets = stated_sets(resolved);
  Checked checked{derived_quantities(resolved),
                  joined(gear_warnings(resolved), overturning_warnings(resolved.without_sweep()),
                         rim_warnings(resolved.without_sweep()), analysis::cage_warnings(sets),
                         analysis::clearance_warnings(sets)),
                  resolved.shape().several || resolved.shape().teeth};
  if (gears_can_move(stated_drivetrain(resolved)))
    for (const Derived& row : gear_dynamics_quantities(resolved))
      if (!resolved.has(row.path)) checked.derived.push_back(row);
  checked.derived = joined(checked.derived, own);
  return checked;
}

// Whether lives are computed for the bearing of the case.
bool has_governing_life(const ResolvedCase& resolved) {
  if (!resolved.has(keys().life_method)) return false;
  return resolved.model() != planetary_drivetrain || resolved.shape().several || has_planet_bearing(resolved);
}

void describe_governing_life(Record& record, const ResolvedCase& resolved) {
  record.value("key", "of the governing life among the results", governing_life_key(resolved));
  record.value("method", keys().life_method, resolved.choice(keys().life_method));
  const auto reason = resolved.assumed().find(keys().life_method);
  record.value("reason", "of a method that the case does not state",
               reason == resolved.assumed().end() ? "" : reason->second);
}

}  // namespace

int execute(const CheckOptions& options) {
  const ResolvedCase resolved = case_of(options.stated);
  auto [derived, warnings, has_power] = check(resolved);
  warnings = joined(warnings, default_warnings(resolved, derived), inferred_warnings(resolved),
                    uncertain_warnings(resolved), former_key_warnings(resolved), idle_inputs(resolved));
  derived = joined(derived, catalogue_quantities(resolved),
                   or_reason("simulation", [&] { return motion_time_quantities(resolved); }));
  // A quantity that the case states as a check is listed among its inputs.
  std::erase_if(derived, [&](const Derived& row) { return resolved.has(row.path); });
  if (options.print.json) {
    Record record;
    describe_check(record, resolved, derived);
    if (has_power) describe(record, power_of(resolved));
    if (has_governing_life(resolved))
      record.child("governing_life", "by which results go", resolved, describe_governing_life);
    nlohmann::ordered_json object = json_of(record);
    if (!resolved.uncertain().inputs.empty()) object["uncertain"] = uncertain_json(resolved);
    object["warnings"] = warnings;
    object["units"] = check_units(resolved, derived);
    print_result(std::move(object), record, options.print);
    return 0;
  }
  if (options.print.quiet) return 0;
  fmt::print("{}", check_table(resolved, derived));
  if (has_power) {
    Record power;
    describe(power, power_of(resolved));
    fmt::print("\n{}", text_of(power));
  }
  if (has_governing_life(resolved))
    fmt::print("\ngoverning life: {} (life.method: {})\n", governing_life_key(resolved),
               resolved.choice(keys().life_method));
  print_warnings(warnings);
  return 0;
}

}  // namespace orbearing::app
