// From a resolved case of the model raceway-defect to a bearing with scratches, and to the settings of its
// signal.
#pragma once

#include <optional>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "coupling/diagnosis/spectrum.hpp"
#include "coupling/study/scratch_run.hpp"
#include "gearset/parameters.hpp"

namespace orbearing::app {

/// Whether a case is that of a drivetrain with a scratched planet bearing: it has a block `defect`.
bool is_planet_defect(const ResolvedCase& resolved);

/// The member of one of several sets that the housing holds; none: all of them turn.
std::optional<gearset::Member> held_member_of(const ResolvedCase& resolved, const std::string& set);

bearing::defect::ScratchedBearing scratched_bearing_of(const ResolvedCase& resolved);

/// Balls, cage and oil of such a case, for run --fidelity dynamic. Throws BadInput where an input that only
/// this fidelity requires is missing, or where a ball is scratched.
bearing::balls::MotionParameters scratched_motion_of(const ResolvedCase& resolved);

/// [m]  error of a position that one step of that run may make
double scratched_length_error_of(const ResolvedCase& resolved);

study::Sampling sampling_of(const ResolvedCase& resolved);

/// The band of the envelope that the case gives; none: the one of largest spectral kurtosis.
std::optional<diagnosis::Band> stated_band_of(const ResolvedCase& resolved);

/// Adds what is wrong; nothing for cases of other models.
void check_defect(CheckedCase& resolved);
/// The same for a drivetrain of several sets, whose sets and shafts are checked before.
void check_defect_of_sets(CheckedCase& resolved);

}  // namespace orbearing::app
