#include "bearing/equilibrium/static_bearing.hpp"

#include "bearing/equilibrium/row_group.hpp"

namespace orbearing::bearing::equilibrium {

namespace {

struct RowOf {
  const Bearing& bearing;

  ElementRow operator()(const CylindricalRollers&) const { return RollerRow(bearing); }
  ElementRow operator()(const Balls&) const { return BallRow(bearing); }
};

}  // namespace

ElementRow row_of(const Bearing& bearing) {
  return std::visit(RowOf{bearing}, bearing.elements);
}

RingState balance_bearing(const Bearing& bearing, const RingLoad& load) {
  return std::visit([&](const auto& row) { return balance_ring(row, load); }, row_of(bearing));
}

RingState balance_bearing(const Bearing& bearing, const RowMotion& motion, const RingLoad& load) {
  return bearing.has_rollers() ? balance_bearing(bearing, load) : balance_rows({{bearing, motion}}, load);
}

}  // namespace orbearing::bearing::equilibrium
