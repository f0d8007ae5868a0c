// Structures of which a case chooses one: what it may state, and which defaults it has.
#pragma once

#include <string>
#include <vector>

#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Whether the case may state the field: it belongs to no other alternative than the case chooses.
bool is_chosen(const CaseData& data, const Field& field);

/// Refuses what is stated of other alternatives than the chosen ones, leaves out their defaults and fills in
/// those of the chosen ones.
void settle_alternatives(CaseData& data, Model model, std::vector<Mistake>& mistakes);

/// Paths of the inputs of the other alternatives, joined by "or".
std::string inputs_of_others(const Field& field, const Field::Alternative& mine);

}  // namespace orbearing::app
