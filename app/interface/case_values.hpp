// What a case states, as JSON: for the interfaces to other languages. An unknown path throws BadInput.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/case/resolved_case.hpp"
#include "orbearing/participant.hpp"

namespace orbearing::app {

/// The present value in SI: a number, a text, a switch, a list, or rows as a case writes them; null: none.
nlohmann::ordered_json value_of(const ResolvedCase& stated, const std::string& path);

/// The present value as written, with its unit; null: none.
nlohmann::ordered_json given_of(const ResolvedCase& stated, const std::string& path);

/// [SI] of a text for that input.
double number_in_si(const ResolvedCase& stated, const std::string& path, const std::string& text);

/// [unit, [[column, unit], ...]] of the numbers at a path of any case, in SI; null: no input has that path.
nlohmann::ordered_json si_units(const std::string& path);

/// All inputs of the case: path, kind, unit, si_unit, meaning, given, source and reason of each. The source
/// is given, assumed, default or absent.
nlohmann::ordered_json inputs_of(const ResolvedCase& stated);

/// Swept inputs and their values as written.
nlohmann::ordered_json axes_of(const ResolvedCase& stated);

/// As Participant::advance. Ctrl-C ends a long step.
void advance_until_stopped(Participant& participant, double length);

}  // namespace orbearing::app
