// The one line of speeds of a sweep with several axes that plots over speed show.
#pragma once

#include <nlohmann/json.hpp>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Where a line of speeds lies among the other axes.
struct SpeedSlice {
  ResolvedCase at;                 // the case with the other axes at that place
  nlohmann::ordered_json columns;  // column of the table -> value, one for each other axis; null without any
};

/// The line nearest to the case's own values; the case itself where speed is not swept or nothing else is.
SpeedSlice speed_slice(const ResolvedCase& resolved);

}  // namespace orbearing::app
