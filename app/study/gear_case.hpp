// From a resolved case to the dynamic model of its planetary set.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "coupling/analysis/gear_modes.hpp"
#include "coupling/study/set_gears.hpp"

namespace orbearing::app {

using analysis::campbell;
using analysis::mode_study;
using analysis::ModeStudy;

/// Inputs of the gears of a case of one set, or of one of several by ResolvedCase::of_set().
study::SetGears set_gears_of(const ResolvedCase& resolved);

/// The set of a case of the model planetary-drivetrain with one set. A set without teeth has neither torque
/// nor speed: its carrier turns at `carrier_speed` [rad/s]. Throws BadInput for another case.
gearset::dynamics::SetModel gear_model_of(const ResolvedCase& resolved, double carrier_speed = 0.0);

/// The same where the drivetrain of the case is at hand, and perhaps its geometry.
gearset::dynamics::SetModel gear_model_of(const ResolvedCase& resolved,
                                          const study::PlanetaryDrivetrain& drivetrain,
                                          const std::optional<study::DrivetrainGeometry>& known = {});

/// Bodies and meshes of the gears of one set for PlanetaryDrivetrain::gear_set. They throw BadInput where the
/// case has no such gears.
std::function<gearset::dynamics::SetParameters()> gears_of(
    const ResolvedCase& resolved, const study::PlanetaryDrivetrain& drivetrain,
    const std::optional<study::DrivetrainGeometry>& known = {});

/// As they move in time: their meshes keep the mean stiffness where the case has no mesh variation.
gearset::dynamics::SetModel moving_gears_of(const ResolvedCase& resolved);

/// How a run in time is settled and observed.
study::GearRunOptions gear_run_options(const ResolvedCase& resolved);

/// Masses, inertias and stiffnesses as the model has them, for `orbearing check`.
std::vector<Derived> gear_dynamics_quantities(const ResolvedCase& resolved);

/// Warnings of teeth and foundations.
std::vector<std::string> gear_dynamics_warnings(const ResolvedCase& resolved);

}  // namespace orbearing::app
