#include "bearing/equilibrium/static_bearing.hpp"

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

}  // namespace orbearing::bearing::equilibrium
