// Which inputs need not be stated, since others give them.
#pragma once

#include <string_view>
#include <vector>

#include "app/case/field_use.hpp"

namespace orbearing::app {

/// Where one of these holds, the input at `path` follows from another one and may be left out; none: it never
/// does.
std::vector<Condition> given_by(std::string_view path);

}  // namespace orbearing::app
