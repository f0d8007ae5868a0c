// Whether an arrangement of sets fixes all speeds and torques, and which members are at fault where it does
// not.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gearset/drivetrain/arrangement.hpp"

namespace orbearing::gearset {

/// What is wrong, where, and what is required. The text names the members and shafts.
struct ArrangementProblem {
  std::vector<std::size_t> shafts;  // concerned, the likeliest culprit first; empty: none to name
  std::vector<SetMember> members;   // at fault
  std::string found;
  std::string required;
};

/// Reasons why speeds or torques contradict each other or stay open; empty for a sound arrangement. A
/// contradiction names the smallest group of members that holds it, an open quantity those that can change
/// without breaking an equation.
std::vector<ArrangementProblem> arrangement_problems(const Arrangement& arrangement);

}  // namespace orbearing::gearset
