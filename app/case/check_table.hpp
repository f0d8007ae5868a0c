// What `orbearing check` prints: every input and derived quantity with its value, unit and standing.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/derived.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// The table as text, one line for each quantity.
std::string check_table(const ResolvedCase& resolved, const std::vector<Derived>& derived);

/// The same as JSON: `{name, model, inputs: [{path, value, unit, given, standing, reason, origin, used_by,
/// not_felt_by}], derived: [...]}`; `value` is SI and `unit` its SI unit.
nlohmann::json check_json(const ResolvedCase& resolved, const std::vector<Derived>& derived);

}  // namespace orbearing::app
