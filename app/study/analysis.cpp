#include "app/study/analysis.hpp"

#include <algorithm>
#include <cmath>

#include "app/case/defect_case.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machines.hpp"
#include "app/errors.hpp"
#include "app/results/life_table.hpp"
#include "app/results/verdicts.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/scratch_case.hpp"
#include "app/units.hpp"
#include "coupling/analysis/scratched_planet.hpp"

namespace orbearing::app {

namespace {

// Lives first, then how they meet the requirements.
AnalysisResult rated(const ResolvedCase& in, AnalysisResult result) {
  if (!result.lives) return result;
  const std::vector<Verdict> verdicts = verdicts_of(stated_requirements(in), result.lives->value);
  describe_verdicts(result.record, verdicts);
  result.heading =
      lives_text(*result.lives) + "\n" + verdicts_text(verdicts) + (verdicts.empty() ? "" : "\n");
  return result;
}

AnalysisResult result_of(const MachineAnalysis& machine, const ResolvedCase& in,
                         const AnalysisOptions& options) {
  AnalysisResult result = rated(in, machine.compute(in, options));
  if (result.lives && !machine.in_time) result.warnings = joined(rating_warnings(in), result.warnings);
  return result;
}

AnalysisResult scratched_planet(const ResolvedCase& in, const AnalysisOptions& options) {
  const auto found =
      result_for(in, [&] { return vibration_of_scratched_set(scratched_set_of(in), options.progress); });
  AnalysisResult result{.record = record_of(found)};
  put_largest_load(found.largest_load(), result);
  return result;
}

bool runs_gears_alone(const ResolvedCase& in) {
  return in.model() == planetary_drivetrain && !in.shape().several && !in.shape().bearing;
}

AnalysisResult vibration_of_gears(const ResolvedCase& in, const AnalysisOptions&) {
  const gearset::dynamics::SetModel model = moving_gears_of(in);
  if (!in.shape().teeth)
    throw BadInput(in.file() +
                   ": gearset.teeth: missing; required: teeth, which give loads and mesh frequency; "
                   "orbearing modes shows the natural frequencies of a set without");
  const analysis::GearRunResult run = analysis::run_gears(model, gear_run_options(in));
  if (!run.completed) throw ComputationFailed(in.text("name") + ": " + run.message);
  AnalysisResult result{.warnings = gear_dynamics_warnings(in)};
  describe(result.record, run);
  if (!run.steady) result.warnings.push_back(run.message);
  result.row = {{"input_speed_rpm", kRpm * in.quantity(keys().speed)},
                {"carrier_speed_rpm", kRpm * model.operation.speeds.carrier}};
  if (!run.message.empty()) result.status = run.message;
  return result;
}

double time_of_planet_signal(const ResolvedCase& in) {
  return analysis::time_of_signal(scratched_set_of(in));
}

std::vector<Derived> scratched_set_quantities(const ResolvedCase& in) {
  const analysis::ScratchedSetQuantities quantities{
      analysis::planet_frequencies(scratched_drivetrain_of(in))};
  return derived_rows(record_of(quantities), "defect.");
}

std::vector<Analysis> with_machines(std::vector<Analysis> table) {
  for (const MachineAnalysis& one : machine_analyses())
    if (one.command == "run")
      table.push_back({.used = one.used,
                       .is_of = nullptr,
                       .machine = one.model,
                       .fidelities = {one.in_time ? "dynamic" : "quasi-static"},
                       .required = one.other_fidelity,
                       .names = one.names,
                       .scatter = one.scatter,
                       .doing = one.progress.doing,
                       .parts = one.progress.parts,
                       .simulated = one.simulated,
                       .compute = [&one](const ResolvedCase& in, const AnalysisOptions& options) {
                         return result_of(one, in, options);
                       }});
  return table;
}

const std::vector<Analysis>& all_analyses() {
  static const std::vector<Analysis> table = with_machines(
      {{.used = AnalysisId::planet_defect,
        .is_of = is_planet_defect,
        .fidelities = {"monolithic"},
        .required =
            "none, or monolithic, for a gear set with a scratched planet bearing, which is one system "
            "of gears "
            "and bearings",
        .names = {"scratched planet bearing", "vibration of a gear set with a scratched planet bearing",
                  defect_file_name},
        .doing = signal_progress.doing,
        .parts = signal_progress.parts,
        .simulated = time_of_planet_signal,
        .compute = scratched_planet,
        .derived = scratched_set_quantities},
       {.used = AnalysisId::gears,
        .is_of = runs_gears_alone,
        .fidelities = {},
        .required = "none for a gear set without a bearing, which runs alone",
        .names = {"gears", "vibration of the gear set"},
        .compute = vibration_of_gears}});
  return table;
}

}  // namespace

namespace {

bool fits(const Analysis& one, const ResolvedCase& in) {
  return one.is_of != nullptr ? one.is_of(in) : in.model() == one.machine;
}

}  // namespace

const Analysis* analysis_of(const ResolvedCase& resolved, const std::string& fidelity) {
  const Analysis* first = nullptr;
  for (const Analysis& one : all_analyses()) {
    if (!fits(one, resolved)) continue;
    if (fidelity.empty() || std::ranges::find(one.fidelities, fidelity) != one.fidelities.end()) return &one;
    if (first == nullptr) first = &one;
  }
  if (first == nullptr) return nullptr;
  throw BadInput("--fidelity: found " + fidelity + "; required: " + first->required);
}

const Analysis& gears_alone() {
  return *std::ranges::find(all_analyses(), AnalysisId::gears, &Analysis::used);
}

}  // namespace orbearing::app
