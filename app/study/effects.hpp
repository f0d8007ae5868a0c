// The effects that a report switches one at a time, as changes of a case.
#pragma once

#include <string>
#include <vector>

#include "app/study/named_change.hpp"

namespace orbearing::app {

// Of several sets, `set` is the one whose bearing is looked at; empty for a set that is alone. What does not
// fit the case, as a clearance beyond what its cage leaves, is left out.

/// The case as it stands, then inertial terms left out, other clearances and the film, for the bearing at
/// rest.
std::vector<NamedChange> effects_at_rest(const ResolvedCase& resolved, const std::string& set = {});

/// The case as it stands, then each effect in turn, off where the case has it and on where it has not: those
/// that matter most and cost little, or with `every` all that the motion in time is asked: forms of races and
/// rollers that the case lacks, what a source prints otherwise. A constant speed has no Euler terms.
std::vector<NamedChange> effects_in_motion(const ResolvedCase& resolved, bool every,
                                           const std::string& set = {});

}  // namespace orbearing::app
