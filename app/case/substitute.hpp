// Values that follow from another input and stand in place of what is stated: oil by its grade, a bearing by
// its designation.
#pragma once

#include <string>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Gives the input at `path` the value `text`, as it would be written in a case, with `reason` among the
/// assumptions. What is stated and differs is kept for those who say that it has no effect. Nothing happens
/// where the field does not take the value: it wants one of its own.
void substitute(CaseData& data, const std::string& path, const std::string& text, const std::string& reason);

/// The same where nothing is stated; what is stated stays.
void put_where_absent(CaseData& data, const std::string& path, const std::string& text,
                      const std::string& reason);

}  // namespace orbearing::app
