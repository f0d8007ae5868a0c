#include <fmt/format.h>

#include <algorithm>

#include "app/case/machines.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/stiffness_study.hpp"

namespace orbearing::app {

int stiffness_command(const Options& options) {
  require_output(options);
  const ResolvedCase resolved = case_of(options);
  // Of a machine, its modes have the same inputs.
  const MachineAnalysis* modes = machine_analysis(resolved.model(), "modes");
  const use::Analysis used = modes != nullptr                           ? modes->used
                             : resolved.model() == planetary_drivetrain ? use::planet_stiffness
                                                                        : use::stiffness;
  const std::vector<std::string> unused = require_used(resolved, used, Axes::all);
  const StiffnessStudy study = stiffness_study(resolved);
  return compute_and_keep(resolved, options, {"stiffness", "stiffness"}, [&]() -> AnalysisResult {
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
