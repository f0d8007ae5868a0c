// Lists of quantities on the command line: "0 mrad, 1 mrad" or "0 um : 16 um : 2 um".
#pragma once

#include <string>
#include <vector>

#include "app/case/units.hpp"

namespace orbearing::app {

/// Parts between commas, without the blanks around them.
std::vector<std::string> parts_of(const std::string& text, char separator);

/// What values of a list may be.
struct ListRange {
  double least = 0.0, most = 0.0;  // [dimension.si]
  std::string words;               // "tilts from 0 to 100 mrad"
};

/// Numbers [dimension.si] in the order given; "FROM : TO : STEP" stands for all in between. `mistakes` takes
/// what is wrong, as it was written, each beginning with `option`.
std::vector<double> quantity_list(const std::string& option, const std::string& text, const Dimension& dimension,
                                  const ListRange& range, std::vector<std::string>& mistakes);

/// One quantity [dimension.si]; 0 where it is wrong.
double option_quantity(const std::string& option, const std::string& text, const Dimension& dimension,
                       std::vector<std::string>& mistakes);

}  // namespace orbearing::app
