// From a resolved case to the dynamic model of its planetary set.
#pragma once

#include <optional>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "coupling/study/gear_dynamics.hpp"
#include "coupling/study/gear_model.hpp"
#include "gearset/dynamics/modes.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// The set of a case of the model planetary-drivetrain with one set. A set without teeth has neither torque
/// nor speed: its carrier turns at `carrier_speed` [rad/s]. Throws BadInput for another case.
gearset::dynamics::SetModel gear_model_of(const ResolvedCase& resolved, double carrier_speed = 0.0);

/// The same where the drivetrain of the case is at hand, and perhaps its geometry.
gearset::dynamics::SetModel gear_model_of(const ResolvedCase& resolved,
                                          const study::PlanetaryDrivetrain& drivetrain,
                                          const std::optional<study::DrivetrainGeometry>& known = {});

/// As they move in time: their meshes keep the mean stiffness where the case has no mesh variation.
gearset::dynamics::SetModel moving_gears_of(const ResolvedCase& resolved);

/// How a run in time is settled and observed.
study::GearRunOptions gear_run_options(const ResolvedCase& resolved);

/// Masses, inertias and stiffnesses as the model has them, for `orbearing check`.
std::vector<Derived> gear_dynamics_quantities(const ResolvedCase& resolved);

/// Warnings of teeth and foundations.
std::vector<std::string> gear_dynamics_warnings(const ResolvedCase& resolved);

// Modes and vibration of a planetary set as results.

/// "rotational", "translational" or "planet".
const char* kind_name(gearset::dynamics::ModeKind kind);

/// Modes and the frequency by which published ones may be recognised.
struct ModeStudy {
  std::vector<gearset::dynamics::Mode> modes;
  double planet_frequency = 0.0;  // [Hz]  of a planet on its bearing alone
};
void describe(described::Record& record, const ModeStudy& study);

/// Displacements of a mode over the largest of them: a row (x, y, u) for sun, ring, carrier and each planet,
/// as the state has them. Those of a planet are outward and in the sense of carrier rotation; u is a rotation
/// times the member's radius. Of several shapes of one frequency the combination in which one displacement is
/// as large as it can be: of equal ones, the first.
struct ModeShape {
  Eigen::MatrixX3d position;  // [-]  (members, 3)  where the largest has its largest value
  Eigen::MatrixX3d quarter;   // [-]  (members, 3)  a quarter of a period later; zero without rotation
};
ModeShape shape_of(const gearset::dynamics::Mode& mode);

/// Modes without rotation, or in the frame of the carrier at the speed of the model.
ModeStudy mode_study(const gearset::dynamics::SetModel& model, bool at_speed = false);

/// Natural frequencies over speed from rest to the nominal speed [rad/s], and mesh harmonics, for a Campbell
/// diagram.
void describe_campbell(described::Record& record, const gearset::dynamics::SetModel& model,
                       double nominal_speed);

/// Statistics of each planet, load sharing, what the run took, and the time series of the last periods.
void describe_gear_run(described::Record& record, const study::GearRunResult& result);

}  // namespace orbearing::app
