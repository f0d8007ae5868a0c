// The words for what is wrong with an arrangement.
#pragma once

#include <string>
#include <vector>

#include "gearset/drivetrain/arrangement.hpp"

namespace orbearing::gearset {

/// "a, b and c".
std::string listed(const std::vector<std::string>& words);

/// "'first' and 'second'", of shafts.
std::string shaft_names(const Arrangement& arrangement, const std::vector<std::size_t>& shafts);

/// "reduction.sun (on 'input') and reduction.ring (on 'housing')": members with their shafts.
std::string member_positions(const Arrangement& arrangement, const std::vector<SetMember>& members);

/// All members of a set.
std::vector<SetMember> members_of_set(std::size_t set);

}  // namespace orbearing::gearset
