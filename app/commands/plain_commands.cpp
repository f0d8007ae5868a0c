#include "app/commands/plain_commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/case/field_table.hpp"
#include "app/case/machines.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/carrier_study.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/mesh_study.hpp"

namespace orbearing::app {

namespace {

std::vector<std::string> models_with(const std::string& word) {
  std::vector<std::string> names;
  for (const MachineAnalysis& one : machine_analyses())
    if (one.command == word) names.emplace_back(model_name(one.model));
  return names;
}

}  // namespace

AnalysisResult result_of_machine(const ResolvedCase& in, const std::string& word) {
  const MachineAnalysis* analysis = machine_analysis(in.model(), word);
  if (analysis == nullptr)
    throw BadInput(fmt::format("{}: model: found {}; required: one of those with {}: {}", in.origin("model"),
                               in.choice("model"), word, fmt::join(models_with(word), ", ")));
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

int present_plain(const ResolvedCase& point, const AnalysisResult& result, const Printing& print) {
  present_record(point, result.record, result.warnings, print);
  return result.failed ? 1 : 0;
}

int execute_plain(const Printing& print, const StatedCase& stated,
                  AnalysisResult (*compute)(const ResolvedCase&)) {
  const ResolvedCase point = point_of(stated);
  return present_plain(point, compute(point), print);
}

}  // namespace orbearing::app
