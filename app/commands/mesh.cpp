#include "app/commands/mesh.hpp"

#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/study/mesh_study.hpp"

namespace orbearing::app {

int execute(const MeshOptions& options) {
  const ResolvedCase resolved = point_of(options.stated);
  const MeshStudy study = mesh_study_with_warnings(resolved);
  present_record(resolved, record_of(study), study.warnings, options.print);
  return 0;
}

}  // namespace orbearing::app
