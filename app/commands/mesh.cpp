#include "app/commands/mesh.hpp"

#include "app/case/machines.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/study/mesh_study.hpp"
#include "app/study/plausibility.hpp"

namespace orbearing::app {

int execute(const MeshOptions& options) {
  const ResolvedCase resolved = point_of(options.stated);
  const MachineAnalysis* of_machine = machine_analysis(resolved.model(), "mesh");
  // Refuses before it computes.
  const std::vector<std::string> unused =
      require_used(resolved, of_machine != nullptr ? of_machine->used : use::mesh);
  const MeshStudy study = mesh_study(resolved);
  present_record(resolved, record_of(study),
                 joined(study.warnings, judge(observations(resolved)).warnings, unused), options.print);
  return 0;
}

}  // namespace orbearing::app
