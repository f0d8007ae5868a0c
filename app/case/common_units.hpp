// Factors of the units that most inputs have. udunits2 reads its database for other units alone, since that
// takes a quarter of the time of a short command.
#pragma once

#include <span>
#include <string_view>

namespace orbearing::app {

/// `factor` converts a number of `unit` to `si`.
struct CommonUnit {
  std::string_view unit;
  std::string_view si;
  double factor = 1.0;  // [si / unit]
};

/// Equal to the factors of udunits2 but for a round-off, which conversion removes.
std::span<const CommonUnit> common_units();

}  // namespace orbearing::app
