// From a resolved case to the dynamic model of its planetary set.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "coupling/analysis/gear_modes.hpp"
#include "coupling/analysis/set_gears.hpp"

namespace orbearing::app {

using analysis::campbell;
using analysis::mode_study;
using analysis::ModeStudy;

/// The set of a case of the model planetary-drivetrain with one set. A set without teeth has neither torque
/// nor speed: its carrier turns at `carrier_speed` [rad/s]. Throws BadInput for another case.
gearset::dynamics::SetModel gear_model_of(const ResolvedCase& resolved, double carrier_speed = 0.0);

/// The drivetrain, whose gears throw BadInput where one has no body under its teeth.
analysis::PlanetaryDrivetrain with_sound_gears(const ResolvedCase& resolved,
                                               analysis::PlanetaryDrivetrain drivetrain);
/// The same; they throw it for another bearing than cylindrical rollers as well, whose springs are not known.
analysis::PlanetaryDrivetrain with_refused_gears(const ResolvedCase& resolved,
                                                 analysis::PlanetaryDrivetrain drivetrain);

/// As they move in time: their meshes keep the mean stiffness where the case has no mesh variation.
gearset::dynamics::SetModel moving_gears_of(const ResolvedCase& resolved);

/// How a run in time is settled and observed.
analysis::GearRunOptions gear_run_options(const ResolvedCase& resolved);

/// Masses, inertias and stiffnesses as the model has them, for `orbearing check`.
std::vector<Derived> gear_dynamics_quantities(const ResolvedCase& resolved);

/// Warnings of teeth and foundations.
std::vector<std::string> gear_dynamics_warnings(const ResolvedCase& resolved);

}  // namespace orbearing::app
