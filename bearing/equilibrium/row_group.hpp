// Any number of rows on one shaft: one static equilibrium, one stiffness.
//
//        row 1        row 2              row 3         z along the shaft; x and y across; outer rings fixed
//     -----+------------+-----o------------+----> z
//                             origin of the loads and of the displacement
//
// Each row is that of ring_balance.hpp in coordinates of its own, whose z points to where the row is pressed:
// of the shaft's motion (x, y, z, tilt in the plane of x and z, tilt in that of y and z) a row at position p
// that is pressed towards s = +1 or -1 has
//
//     (1)  (x - p tilt, y - p tilt', s z + approach, s tilt, s tilt')
#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/jones_balls.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/equilibrium/rollers.hpp"

namespace orbearing::bearing::equilibrium {

/// Eq. (1) without the approach, of tilts that are angles times `unit` [m] on the shaft and times `own_unit`
/// in the row.
inline Eigen::Matrix<double, 5, 5> motion_of_row(double position, double side, double unit, double own_unit) {
  Eigen::Matrix<double, 5, 5> motion = Eigen::Matrix<double, 5, 5>::Identity();
  motion(0, 3) = motion(1, 4) = -position / unit;
  motion(2, 2) = side;
  motion(3, 3) = motion(4, 4) = side * own_unit / unit;
  return motion;
}

/// One bearing on the shaft.
struct RowOnShaft {
  Bearing bearing;
  RowMotion motion{};     // of balls; without effect on rollers
  double position = 0.0;  // [m]  of the row along z
  double side = 1.0;      // +1 or -1: where its inner ring is pressed to
  double approach = 0.0;  // [m]  by which it is pressed there before the shaft moves: a preload by spacers
};

/// All rows: the problem of ring_balance.hpp for the shaft. Balls that turn remember where they were.
class RowGroup : public RingRow {
 public:
  /// All rows at rest. Throws std::invalid_argument as the rows do or where there are none.
  explicit RowGroup(const std::vector<RowOnShaft>& bearings);
  /// The same rows in motion: balls that move turn.
  RowGroup(const RowGroup& at_rest, const std::vector<RowOnShaft>& bearings);

  double lever() const override { return lever_; }
  double reach(double load) const override;
  void add_forces(const RingPosition& position, RingImbalance& sum) const override;
  /// Loads and angles of the first row's elements, then of the second's and so on; laminae of a single row.
  void put_loads(const RingPosition& position, RingState& state) const override;
  /// (rows)  by displacement and tilt in coordinates of their own.
  std::vector<Eigen::Matrix<double, 5, 5>> row_stiffnesses(const RingPosition& position) const;

  // As in JonesRow, for all rows with rotating balls.
  bool follows_motion() const override;
  bool settled() const;
  bool choose_control();
  void freeze(bool frozen);
  void push_unlike(int path);
  int beyond_grooves() const;
  bool has_stiffness() const;
  Eigen::VectorXd positions(const RingPosition& shaft) const;
  RingPosition put_positions(const Eigen::VectorXd& all);
  mechanics::Imbalance<Eigen::Dynamic> all_forces(const Eigen::VectorXd& all) const;

 private:
  struct Placed {
    std::variant<BallRow, RollerRow, JonesRow> row;
    double approach = 0.0;  // [m]
    // Motion of the row by that of the shaft, tilts at both levers.
    Eigen::Matrix<double, 5, 5> motion = Eigen::Matrix<double, 5, 5>::Identity();

    const RingRow& bearing() const {
      return std::visit([](const RingRow& one) -> const RingRow& { return one; }, row);
    }
    RingPosition in_row(const RingPosition& position) const;
    JonesRow* rotating() { return std::get_if<JonesRow>(&row); }
  };
  std::vector<JonesRow*> rotating() const;

  mutable std::vector<Placed> rows_;
  double lever_ = 0.0;          // [m]
  Eigen::Index positions_ = 5;  // of the shaft and of the balls that turn
};

/// Equilibrium of the shaft on all rows under `load`, which acts at the origin. For balls at speed, Newton's
/// method starts from the equilibrium at rest; if it fails, the search follows a path along which the motion
/// is introduced. An equilibrium that presses balls beyond the ends of their grooves, or has no stiffness, is
/// rejected, and the report states it. Throws as RowGroup does.
RingState balance_rows(const std::vector<RowOnShaft>& bearings, const RingLoad& load);

/// The same of a single bearing, of rollers or balls.
inline RingState balance_bearing(const Bearing& bearing, const RowMotion& motion, const RingLoad& load) {
  return balance_rows({{bearing, motion}}, load);
}
inline RingState balance_bearing(const Bearing& bearing, const RingLoad& load) {
  return balance_bearing(bearing, {}, load);
}

}  // namespace orbearing::bearing::equilibrium
