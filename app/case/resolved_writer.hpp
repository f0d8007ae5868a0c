// The resolved case as text: what was computed, in a form that gives the same bits when it is read again.
#pragma once

#include <string>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// YAML with every independent value as written, defaults spelled out, assumptions and sweep axes.
std::string write_resolved(const ResolvedCase& resolved);

/// A text as YAML: plain where that is safe, else in double quotes.
std::string write_scalar(const std::string& text);

/// Sixteen hexadecimal digits that name the resolved case (64-bit FNV-1a of `write_resolved`).
std::string case_hash(const ResolvedCase& resolved);

}  // namespace orbearing::app
