#include "app/study/mesh_study.hpp"

#include "app/case/drivetrain_reader.hpp"
#include "app/case/machines.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/study/analysis.hpp"
#include "app/study/plausibility.hpp"
#include "coupling/analysis/pair_meshes.hpp"

namespace orbearing::app {

MeshStudy mesh_study(const ResolvedCase& in) {
  if (in.model() == gear_pair) return analysis::meshes_of_pair(machine_of<analysis::ElasticPair>(in));
  if (in.model() != planetary_drivetrain)
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   "; required: gear-pair or planetary-drivetrain, which have meshes");
  if (in.shape().several)
    throw BadInput(in.file() +
                   ": sets: found several sets; required: one set, as gearset at the top of a case");
  if (!in.shape().teeth)
    throw BadInput(in.file() + ": gearset.teeth: missing; required: teeth, which the meshes follow from");
  const analysis::StatedDrivetrain& stated = stated_drivetrain(in);
  const analysis::StatedSet& set = stated.single();
  return analysis::meshes_of_set(drivetrain_of(set, drive_of(stated)), set.gears, set.geometry);
}

MeshStudy mesh_study_with_warnings(const ResolvedCase& in) {
  const MachineAnalysis* of_machine = machine_analysis(in.model(), "mesh");
  const std::vector<std::string> unused =
      require_used(in, of_machine != nullptr ? of_machine->used : AnalysisId::mesh);
  MeshStudy study = mesh_study(in);
  study.warnings = joined(study.warnings, judge(observations(in)).warnings, unused);
  return study;
}

gearset::PlanetaryMeshes planetary_meshes_of(const ResolvedCase& in) {
  const analysis::StatedDrivetrain& stated = stated_drivetrain(in);
  const analysis::PlanetaryDrivetrain drivetrain = drivetrain_of(stated.single(), drive_of(stated));
  return analysis::set_meshes(drivetrain, gearset::working_geometry(drivetrain.set), stated.single().gears);
}

}  // namespace orbearing::app
