// Defaults that follow from the size and the material of the parts they belong to.
#pragma once

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Rule from which the default of this field follows; empty for a field without such a rule.
std::string_view default_rule(std::string_view path);
/// Whether that rule gives a value in each case that has the input.
bool follows_always(std::string_view path);

/// Gives a value to each input with a `default_rule` that the case leaves out and whose own inputs it has,
/// and updates it where it was a default before: so they follow whatever is set. The reason states the rule.
void fill_derived_defaults(CaseData& data);

}  // namespace orbearing::app
