// Lists of quantities on the command line: "0 mrad, 1 mrad" or "0 um : 16 um : 2 um".
#pragma once

#include <string>
#include <vector>

#include "app/case/units.hpp"

namespace orbearing::app {

/// Parts between commas, without the blanks around them.
std::vector<std::string> parts_of(const std::string& text, char separator);

/// Numbers [dimension.si] in the order given; "FROM : TO : STEP" stands for all in between. `mistakes` takes
/// what is wrong, each beginning with `option`.
std::vector<double> quantity_list(const std::string& option, const std::string& text,
                                  const Dimension& dimension, std::vector<std::string>& mistakes);

/// One quantity [dimension.si]; 0 where it is wrong.
double option_quantity(const std::string& option, const std::string& text, const Dimension& dimension,
                       std::vector<std::string>& mistakes);

}  // namespace orbearing::app
