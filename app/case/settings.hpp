// --set path=value: overlays a case before it is checked.
#pragma once

#include <string>
#include <vector>

#include "app/case/field.hpp"

namespace orbearing::app {

/// Puts every setting into the tree as if it stood in the file; malformed ones become mistakes. A block or
/// list is replaced as a whole; of two settings of one path the later holds.
void apply_settings(Entry& root, const std::vector<std::string>& settings, std::vector<Mistake>& mistakes);

/// A value of a field from text as it would be written in a case.
FieldReading read_field_text(const Field& field, const std::string& text);

}  // namespace orbearing::app
