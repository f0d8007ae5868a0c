// What could have been meant by a key that no field has.
#pragma once

#include <string>
#include <vector>

#include "app/case/case_shape.hpp"

namespace orbearing::app {

/// Names that may follow a prefix ("gearset.teeth.", "sets.reduction.", ""), in the order of the table.
std::vector<std::string> keys_under(const std::string& prefix, const CaseShape& shape);

/// What is required in place of the unknown `key` in the block of `prefix`.
std::string key_hint(const std::string& key, const std::string& prefix, const CaseShape& shape);

}  // namespace orbearing::app
