// Resonances of the gears along the lines of speeds of a sweep.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_row.hpp"
#include "app/results/sweep_run.hpp"
#include "coupling/diagnosis/resonance.hpp"

namespace orbearing::app {

// Resonances of a case's gears.

/// The modes of a case of one set with teeth, in the carrier's frame at that speed [rpm].
diagnosis::ModesAtSpeed modes_at_rpm(const ResolvedCase& resolved, double rpm);

/// Resonances that the meshes excite between two speeds [rpm] and half as much beyond, ascending. Found by
/// the modes at fixed speeds, except speeds at which the bearings have no equilibrium. The case without its
/// sweep.
std::vector<Resonance> resonances(const ResolvedCase& resolved, double lowest_rpm, double highest_rpm);

/// The one nearest to a speed [rad/s]; none where none is within a factor of one and a half.
std::optional<Resonance> nearest(const std::vector<Resonance>& resonances, double speed);

/// Speeds [rpm] of the sweep; the case's own where none are swept.
std::vector<double> speeds_rpm(const ResolvedCase& resolved);

/// Resonances of the line of speeds that contains the point by these settings; those of each line are
/// computed at their first use. One thread at a time.
using ResonancesOfLine = std::function<const std::vector<Resonance>&(const std::vector<Setting>&)>;
ResonancesOfLine resonances_by_line(const ResolvedCase& resolved);

/// Makes the rows of `request` name their nearest resonance where one affects the bearings' motion.
void name_resonances(const ResolvedCase& resolved, SweepRequest& request);

}  // namespace orbearing::app
