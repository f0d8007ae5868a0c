#include "app/study/analysis.hpp"

#include <algorithm>
#include <cmath>

#include "app/case/defect_case.hpp"
#include "app/case/described_case.hpp"
#include "app/case/machines.hpp"
#include "app/errors.hpp"
#include "app/results/life_table.hpp"
#include "app/results/verdicts.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/planetary_case.hpp"
#include "app/units.hpp"
#include "coupling/study/planet_scratch.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

template <Model model>
bool is_model(const ResolvedCase& in) {
  return in.model() == model;
}

// Columns are of lives: a vibration has none but the largest load.
void put_load(double largest, AnalysisResult& result) {
  result.row = {{"inner_load_max_N", largest}, {"outer_load_max_N", largest}};
}

template <class Study>
AnalysisResult described_result(const Study& study) {
  return {.record = record_of(study), .warnings = study.warnings};
}

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

AnalysisResult ring_on_massless_elements(const ResolvedCase& in, const AnalysisOptions& options) {
  return defect_result(defect_study(in), options.files);
}

AnalysisResult scratched_balls_in_motion(const ResolvedCase& in, const AnalysisOptions& options) {
  return defect_result(defect_study(in, DefectRung::all, options.progress), options.files);
}

AnalysisResult scratched_planet(const ResolvedCase& in, const AnalysisOptions& options) {
  const PlanetDefectStudy study = planet_defect_study(in, options.progress);
  AnalysisResult result{.record = record_of(study)};
  put_load(study.vibration.largest_load, result);
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
  const study::GearRunResult run = study::run_gears(model, gear_run_options(in));
  if (!run.completed) throw ComputationFailed(in.text("name") + ": " + run.message);
  AnalysisResult result{.warnings = gear_dynamics_warnings(in)};
  describe(result.record, run);
  if (!run.steady) result.warnings.push_back(run.message);
  result.row = {{"input_speed_rpm", kRpm * in.quantity("input.speed")},
                {"carrier_speed_rpm", kRpm * model.operation.speeds.carrier}};
  if (!run.message.empty()) result.status = run.message;
  return result;
}

// Time of `turns` [-] at `speed` [rad/s]; a run-up begins at the share `run_up_from` of that speed.
double time_of_turns(double turns, double speed, double run_up_from) {
  return constants::two_pi * turns / (0.5 * (1.0 + run_up_from) * std::abs(speed));
}

double time_of_signal(const ResolvedCase& in) {
  const study::Sampling sampling = sampling_of(in);
  return time_of_turns(sampling.settling_revolutions + sampling.revolutions,
                       in.quantity("operation.shaft_speed"), sampling.run_up_from);
}

double time_of_planet_signal(const ResolvedCase& in) {
  const auto sampling = from_case<study::PlanetSampling>(in);
  const double carrier = study::planet_frequencies(scratched_drivetrain_of(in)).carrier;
  return time_of_turns(sampling.settling_revolutions + sampling.revolutions, constants::two_pi * carrier,
                       sampling.run_up_from);
}

constexpr const char* ring_required =
    "none for the model raceway-defect, whose ring moves on balls without mass, or dynamic, for all of the "
    "bearing in "
    "motion";
constexpr const char* defect_title = "vibration of a bearing with scratches";
constexpr const char* signal_progress = "signal, in hundredths: ";
constexpr std::size_t hundredths = 100;

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
      {{.used = use::defect,
        .is_of = is_model<raceway_defect>,
        .fidelities = {"quasi-static"},
        .required = ring_required,
        .names = {"defect", defect_title, defect_file_name},
        .compute = ring_on_massless_elements,
        .derived = defect_quantities},
       {.used = use::moving_defect,
        .is_of = is_model<raceway_defect>,
        .fidelities = {"dynamic"},
        .required = ring_required,
        .names = {"defect, all in motion", defect_title, defect_file_name},
        .doing = signal_progress,
        .parts = hundredths,
        .simulated = time_of_signal,
        .compute = scratched_balls_in_motion,
        .derived = defect_quantities},
       {.used = use::defect,
        .is_of = is_model<roller_defect>,
        .fidelities = {"quasi-static"},
        .required = "none for a single scratched bearing of rollers, or a planetary drivetrain with a block "
                    "'defect', where all of its bearings move",
        .names = {"defect", defect_title, defect_file_name},
        .compute = ring_on_massless_elements,
        .derived = defect_quantities},
       {.used = use::planet_defect,
        .is_of = is_planet_defect,
        .fidelities = {"monolithic"},
        .required =
            "none, or monolithic, for a gear set with a scratched planet bearing, which is one system "
            "of gears "
            "and bearings",
        .names = {"scratched planet bearing", "vibration of a gear set with a scratched planet bearing",
                  defect_file_name},
        .doing = signal_progress,
        .parts = hundredths,
        .simulated = time_of_planet_signal,
        .compute = scratched_planet,
        .derived = planet_defect_quantities},
       {.used = use::gears,
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
  return *std::ranges::find(all_analyses(), use::gears, &Analysis::used);
}

AnalysisResult defect_result(const DefectStudy& study, bool files) {
  AnalysisResult result = described_result(study);
  put_load(study.vibration.largest_load, result);
  if (files) result.files = {{"signal.csv", signal_csv(study)}, {"signal.wav", signal_wav(study)}};
  return result;
}

}  // namespace orbearing::app
