// What `orbearing check` prints: every input and derived quantity with its value, unit and standing.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// What `compute` gives; where that fails, one row at `path` without a value, whose meaning is the reason.
/// What is wrong with the case itself (BadInput) is thrown on.
std::vector<Derived> or_reason(const std::string& path, const std::function<std::vector<Derived>()>& compute);

/// The table as text, one line for each quantity.
std::string check_table(const ResolvedCase& resolved, const std::vector<Derived>& derived);

/// The value of an input in SI, as "value": a number, a text, a switch, a list, or rows as a case writes
/// them.
void describe_value(described::Record& record, const ResolvedCase& resolved, const Input& input);

/// That table as `{name, model, inputs: [{path, used_by, not_modelled_by, value, unit, given, standing,
/// reason, origin}], derived: [...]}`; of inputs `value` is SI and `unit` its SI unit.
void describe_check(described::Record& record, const ResolvedCase& resolved,
                    const std::vector<Derived>& derived);
/// Units of those values by their paths.
std::map<std::string, std::string> check_units(const ResolvedCase& resolved,
                                               const std::vector<Derived>& derived);

}  // namespace orbearing::app
