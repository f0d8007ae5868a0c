#include "app/commands/stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/machines.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/stiffness_study.hpp"

namespace orbearing::app {

std::vector<std::string> problems(const StiffnessOptions& options) {
  return problems(ResultPlace{options.output, options.resume}, options.print);
}

namespace {

// Modes of a duplex pair have the same inputs. Models without stiffness are refused by the study.
std::vector<std::string> unused_by_stiffness(const ResolvedCase& in) {
  if (in.model() == planetary_drivetrain) return require_used(in, AnalysisId::planet_stiffness, Axes::all);
  for (const char* command : {"stiffness", "modes"})
    if (const MachineAnalysis* machine = machine_analysis(in.model(), command))
      return require_used(in, machine->used, Axes::all);
  return {};
}

}  // namespace

int execute(const StiffnessOptions& options) {
  const ResolvedCase resolved = case_of(options.stated);
  const std::vector<std::string> unused = unused_by_stiffness(resolved);
  const StiffnessStudy study = stiffness_study(resolved);
  const ResultPlace place{options.output, options.resume};
  const ResultNames names{"stiffness", "stiffness"};
  return compute_and_keep(resolved, place, options.print, names, [&]() -> AnalysisResult {
    AnalysisResult result{.record = record_of(study), .warnings = joined(unused, study.warnings)};
    result.files = {{"stiffness.csv", stiffness_csv(study)}};
    result.failed = std::any_of(study.points.begin(), study.points.end(),
                                [](const StiffnessPoint& point) { return !point.stiffness; });
    // A table for ROSS has no load: one for each.
    for (std::size_t series = 0; series < study.series; ++series)
      result.files.emplace_back(study.series == 1 ? "ross.xls" : fmt::format("ross_{}.xls", series + 1),
                                ross_table(study, series));
    return result;
  });
}

}  // namespace orbearing::app
