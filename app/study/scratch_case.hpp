// Runs of bearings with scratches: from a case to the inputs that the analyses of the library take.
#pragma once

#include "app/case/resolved_case.hpp"
#include "coupling/analysis/scratched_bearing.hpp"
#include "coupling/analysis/scratched_planet.hpp"

namespace orbearing::app {

/// Whether a case is that of a single bearing with scratches.
bool is_defect(const ResolvedCase& resolved);

/// How much of the bearing moves: the outer ring alone on balls without mass, or all of it.
enum class MovingParts { ring, all };

/// The vibration of a single bearing with scratches. `disturb` may add to the recorded signal before it is
/// analysed. Throws ComputationFailed where the motion cannot be integrated, BadInput where an input is
/// missing that only MovingParts::all requires.
analysis::ScratchedVibration scratched_vibration(const ResolvedCase& resolved,
                                                 MovingParts moving = MovingParts::ring,
                                                 const analysis::Disturb& disturb = {});

/// A drivetrain with a scratched planet bearing.
analysis::ScratchedSet scratched_set_of(const ResolvedCase& resolved);

}  // namespace orbearing::app
