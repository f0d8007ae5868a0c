// Mistakes in a catalogue bearing that a case states.
#pragma once

#include <optional>
#include <string>

#include "app/case/field.hpp"
#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Message on a designation that no line has; none where one has it. `table`: the case's own catalogue, if
/// any.
std::optional<ConsistencyMessage> unknown_designation(const std::string& name, const FieldValue* table,
                                                      Model model);

/// Mistakes of a catalogue bearing: values that are not known or do not fit together.
void check_catalogue_bearing(CheckedCase& resolved);

}  // namespace orbearing::app
