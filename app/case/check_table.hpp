// Output of `orbearing check`: every input and derived quantity with its value, unit and status.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// Result of `compute`; where that fails, one row at `path` without a value, whose meaning is the reason.
/// Mistakes of the case itself (BadInput) are rethrown.
std::vector<Derived> or_reason(const std::string& path, const std::function<std::vector<Derived>()>& compute);

/// The table as text, one line for each quantity.
std::string check_table(const ResolvedCase& resolved, const std::vector<Derived>& derived);

/// The value of an input in SI, as "value": a number, a text, a switch, a list, or rows as a case writes
/// them.
void describe_value(described::Record& record, const ResolvedCase& resolved, const Input& input);

/// The table as `{name, model, inputs: [{path, used_by, not_modelled_by, value, unit, given, standing,
/// reason, origin}], derived: [...]}`; `value` of an input is in SI and `unit` is its SI unit.
void describe_check(described::Record& record, const ResolvedCase& resolved,
                    const std::vector<Derived>& derived);
/// Units of those values by their paths.
std::map<std::string, std::string> check_units(const ResolvedCase& resolved,
                                               const std::vector<Derived>& derived);

}  // namespace orbearing::app
