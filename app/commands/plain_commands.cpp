#include "app/commands/plain_commands.hpp"

#include <fmt/format.h>

#include "app/case/machines.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/carrier_study.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/mesh_study.hpp"

namespace orbearing::app {

AnalysisResult result_of_machine(const ResolvedCase& in, const std::string& word) {
  const MachineAnalysis* analysis = machine_analysis(in.model(), word);
  if (analysis == nullptr)
    throw BadInput(fmt::format("{}: model: found {}; required: one that has {}", in.origin("model"),
                               in.choice("model"), word));
  const std::vector<std::string> unused = require_used(in, analysis->used);  // refuses before it computes
  AnalysisResult result = analysis->compute(in, {});
  result.warnings = joined(unused, result.warnings);
  return result;
}

AnalysisResult MeshCommand::compute(const ResolvedCase& in) {
  const MeshStudy study = mesh_study_with_warnings(in);
  return {.record = record_of(study), .warnings = study.warnings};
}

AnalysisResult CarrierCommand::compute(const ResolvedCase& in) {
  require_carrier(in);
  const std::vector<std::string> unused =
      require_used(in, AnalysisId::carrier);  // refuses before it computes
  return {.record = record_of(carrier_study(in)), .warnings = joined(unused, gear_warnings(in))};
}

int execute_plain(const Printing& print, const StatedCase& stated,
                  AnalysisResult (*compute)(const ResolvedCase&)) {
  const ResolvedCase point = point_of(stated);
  const AnalysisResult result = compute(point);
  present_record(point, result.record, result.warnings, print);
  return result.failed ? 1 : 0;
}

}  // namespace orbearing::app
