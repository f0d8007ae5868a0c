// Resonances of a case's gears.
#pragma once

#include <optional>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/result_row.hpp"
#include "coupling/diagnosis/resonance.hpp"

namespace orbearing::app {

/// The modes of a case of one set with teeth, in the carrier's frame at that speed [rpm].
diagnosis::ModesAtSpeed modes_at_rpm(const ResolvedCase& resolved, double rpm);

/// Whether the motion of a case's bearings feels resonances of its gears: one set with bearings, whose meshes
/// vary. Several sets have no gear dynamics yet.
bool has_resonances(const ResolvedCase& resolved);

/// Resonances that the meshes excite between two speeds [rpm] and half as much beyond, ascending. Found by
/// the modes at fixed speeds, of which those are left out at which the bearings find no balance. The case
/// without its sweep.
std::vector<Resonance> resonances(const ResolvedCase& resolved, double lowest_rpm, double highest_rpm);

/// The one nearest to a speed [rad/s]; none where none is within a factor of one and a half.
std::optional<Resonance> nearest(const std::vector<Resonance>& resonances, double speed);

}  // namespace orbearing::app
