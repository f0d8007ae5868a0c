// Units that most inputs are written in, with their factors: udunits2 reads its database, which takes longer
// than all else at the start of a command, for the other ones alone.
#pragma once

#include <span>
#include <string_view>

namespace orbearing::app {

/// One unit: a number of it times `factor` is the number of the SI unit, that times `inverse` the first
/// again.
struct CommonUnit {
  std::string_view unit;
  std::string_view si;
  double factor = 1.0;   // [si / unit]
  double inverse = 1.0;  // [unit / si]
};

/// The same factors as those of udunits2, but for a round-off that conversion removes.
std::span<const CommonUnit> common_units();

}  // namespace orbearing::app
