// From a resolved case to the dynamic model of its planetary set.
#pragma once

#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "coupling/study/gear_dynamics.hpp"
#include "coupling/study/gear_model.hpp"

namespace orbearing::app {

/// The set of a case of the model planetary-drivetrain with one set. A set without teeth has neither torque
/// nor speed: see `gear_model_at`. Throws BadInput for another case.
gearset::dynamics::SetModel gear_model_of(const ResolvedCase& resolved);

/// The same where the drivetrain of the case is at hand.
gearset::dynamics::SetModel gear_model_of(const ResolvedCase& resolved,
                                          const study::PlanetaryDrivetrain& drivetrain);

/// That of the case, its carrier turning at `carrier_speed` [rad/s] if the set has no teeth.
gearset::dynamics::SetModel gear_model_at(const ResolvedCase& resolved, double carrier_speed);

/// As they move in time: their meshes keep the mean stiffness where the case has no mesh variation.
gearset::dynamics::SetModel moving_gears_of(const ResolvedCase& resolved);

/// How a run in time is settled and observed.
study::GearRunOptions gear_run_options(const ResolvedCase& resolved);

/// Masses, inertias and stiffnesses as the model has them, for `orbearing check`.
std::vector<Derived> gear_dynamics_quantities(const ResolvedCase& resolved);

/// Warnings of teeth and foundations.
std::vector<std::string> gear_dynamics_warnings(const ResolvedCase& resolved);

}  // namespace orbearing::app
