#include "app/study/mesh_study.hpp"

#include "app/case/machine_of.hpp"
#include "app/case/set_case.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/gear_case.hpp"
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
  return analysis::meshes_of_set(drivetrain_without_gear_set(in), set_gears_of(in), stated_geometry(in));
}

gearset::PlanetaryMeshes planetary_meshes_of(const ResolvedCase& in) {
  const study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(in);
  return study::set_meshes(drivetrain, gearset::working_geometry(drivetrain.set), set_gears_of(in));
}

}  // namespace orbearing::app
