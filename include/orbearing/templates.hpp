// Cases to begin from.
#pragma once

#include <string>
#include <vector>

#include "orbearing/errors.hpp"

namespace orbearing {

struct CaseTemplate {
  std::string name;     // "wind-stage"
  std::string title;    // its first line up to the colon: "Wind turbine stage"
  std::string purpose;  // and behind it
  std::string text;     // of the file
};

/// In the order in which they are offered.
const std::vector<std::string>& template_names();

/// Reads the file of one of them. Throws BadInput with the list of names where there is none.
CaseTemplate case_template(const std::string& name);

}  // namespace orbearing
