// Parts of a text that a user wrote.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace orbearing::app {

/// A text without the blanks around it.
std::string trimmed(std::string_view text);

/// Parts of a text between separators, without the blanks around them.
std::vector<std::string> parts_of(std::string_view text, char separator);

void replace_all(std::string& text, std::string_view what, std::string_view by);

}  // namespace orbearing::app
