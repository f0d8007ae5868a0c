// A single bearing under a static load, of rollers or balls: one way from the bearing to the loads of its
// elements.
#pragma once

#include <variant>

#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/jones_balls.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/equilibrium/rollers.hpp"

namespace orbearing::bearing::equilibrium {

using ElementRow = std::variant<RollerRow, BallRow>;

/// The row of the bearing's elements. Throws std::invalid_argument as the rows do.
ElementRow row_of(const Bearing& bearing);

/// Where the inner ring balances under `load`, and what the elements carry. Throws as above; a search that
/// fails says so in the report.
RingState balance_bearing(const Bearing& bearing, const RingLoad& load);
/// The same of rings that turn, which affect balls and not rollers.
RingState balance_bearing(const Bearing& bearing, const RowMotion& motion, const RingLoad& load);

}  // namespace orbearing::bearing::equilibrium
