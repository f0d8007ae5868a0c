// The gears of a planetary set as bodies and springs, with the meshes that its teeth have.
#pragma once

#include <functional>
#include <optional>

#include "coupling/analysis/drivetrain.hpp"
#include "coupling/analysis/gear_dynamics.hpp"
#include "coupling/analysis/gear_model.hpp"
#include "gearset/dynamics/model.hpp"
#include "gearset/mesh/planetary_meshes.hpp"
#include "gearset/warning.hpp"
#include "mechanics/material.hpp"

namespace orbearing::analysis {

/// Inputs of the gears of a set beside its teeth and its drive.
struct SetGears {
  GearDynamicsChoice choice;
  mechanics::Elasticity material;
};
template <class Visitor>
void describe(Visitor& visit, SetGears& m) {
  using namespace described;
  members(visit, m,
          part(m.choice,
               [&] {
                 rows(visit, part(m.choice), part(m.choice.bodies), part(m.choice.run_up),
                      part(m.choice.frame));
               }),
          part(m.material));
}

/// Mesh periods of a run of gears in time.
struct GearRunPeriods {
  int observed = 200;   // [mesh period]
  int settling = 4000;  // [mesh period]  at most
};
template <class Visitor>
void describe(Visitor& visit, GearRunPeriods& m) {
  using namespace described;
  members(visit, m, internal(m.observed, "gearset.dynamics.observed_periods"),
          internal(m.settling, "gearset.dynamics.settling_periods"));
}
GearRunOptions gear_run_options(const GearRunPeriods& periods);

/// Geometry of the drivetrain; without a bearing that of its gears alone.
DrivetrainGeometry geometry_of(const PlanetaryDrivetrain& drivetrain);

/// Meshes of the set as its members turn at its drive. Points of a sweep and variants mostly have the same
/// teeth: meshes that were computed before are found again, from any thread.
gearset::PlanetaryMeshes set_meshes(const PlanetaryDrivetrain& drivetrain,
                                    const gearset::WorkingGeometry& geometry, const SetGears& gears);

/// The gears at the drivetrain's power and speed.
/// @param geometry geometry_of() the drivetrain
/// @throws std::domain_error where a gear has no body under its teeth, std::runtime_error where the planet
/// bearings have no equilibrium
gearset::dynamics::SetModel gear_model(const PlanetaryDrivetrain& drivetrain,
                                       const DrivetrainGeometry& geometry, const SetGears& gears);

/// A set without teeth, which are what loads it: it only vibrates, on a carrier at that speed [rad/s].
gearset::dynamics::SetModel toothless_model(const gearset::PlanetarySet& set,
                                            const GearDynamicsChoice& choice, double carrier_speed);

/// Bodies and meshes for PlanetaryDrivetrain::gear_set, built at their first use, from any thread: teeth take
/// a while, and each analysis uses them again.
std::function<gearset::dynamics::SetParameters()> gears_built_once(
    const PlanetaryDrivetrain& drivetrain, const SetGears& gears,
    const std::optional<DrivetrainGeometry>& known = {});

/// Warnings with the key of the input that gives a planet its bore: without a bearing that of a ratio.
gearset::Warnings with_key_of_bore(gearset::Warnings warnings, const PlanetaryDrivetrain& drivetrain);

/// Bodies outside the range of the foundation's formula, and edges of teeth that touch under load.
gearset::Warnings mesh_warnings(const PlanetaryDrivetrain& drivetrain, const SetGears& gears);

}  // namespace orbearing::analysis
