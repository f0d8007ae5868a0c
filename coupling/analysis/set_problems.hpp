// Inputs of a planetary set that do not fit together. What is 0 or absent is not stated, and fits.
#pragma once

#include "coupling/analysis/stated_drivetrain.hpp"
#include "mechanics/problem.hpp"

namespace orbearing::analysis {

/// Of gears, planets and their bearings. Sizes within a bearing are those of bearing::BearingDesign.
mechanics::Problems problems(const StatedSet& set);

/// Of parallel stages in front of the sets and behind them.
mechanics::Problems problems(const gearset::ParallelStages& stages);

/// Of the speed that is stated. To be called where nothing else is wrong.
/// @param torque key of the input that states the torque of the shaft whose speed it is; empty: none does
mechanics::Problems speed_problems(const StatedDrivetrain& drivetrain, const std::string& torque);

}  // namespace orbearing::analysis
