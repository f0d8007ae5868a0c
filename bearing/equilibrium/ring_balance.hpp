// Static equilibrium of a ring on one row of rolling elements, [ISO16281]: one problem for balls and for
// rollers on laminae.
//
// The outer ring is fixed. The inner ring has five freedoms, all as lengths: x along the radial load, y
// across it, z along the axis, and both tilts at the row's lever,
//
//     position = (x, y, z, lever tan(tilt in the plane of x and z), lever tan(tilt in that of y and z))
//
// A positive tilt moves the ring forward along z where it is positive in x or y; there it presses rollers at
// negative z.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "bearing/parameters.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/convex_search.hpp"
#include "mechanics/described.hpp"

namespace orbearing::bearing::equilibrium {

using RingPosition = Eigen::Vector<double, 5>;  // [m]
using RingImbalance = mechanics::Imbalance<5>;

/// Load on the inner ring.
struct RingLoad {
  double radial = 0.0;         // [N]    along x
  double axial = 0.0;          // [N]
  double moment = 0.0;         // [N m]  in the plane of x and z
  double moment_across = 0.0;  // [N m]  in the plane of y and z
  std::optional<double> tilt;  // [rad]  in the plane of x and z, given instead of both moments; none: free
};

template <class Visitor>
void describe(Visitor& visit, RingLoad& m) {
  using namespace described;
  members(visit, m,
          input(m.radial, "load.radial", "radial load on the bearing",
                {.dimension = dimension::force, .range = {0.0, 1e9}}),
          input(m.axial, "load.axial", "axial load on the bearing",
                {.dimension = dimension::force, .range = {0.0, 1e9}, .reason = "a radial load alone"}),
          input(m.moment, "load.moment", "moment on the inner ring in the plane of the radial load",
                {.dimension = dimension::torque,
                 .range = {-1e9, 1e9},
                 .reason = "the shaft does not hold the ring against tilting"}),
          input(m.moment_across, "load.moment_across",
                "moment on the inner ring in the axial plane across the radial load",
                {.dimension = dimension::torque,
                 .range = {-1e9, 1e9},
                 .reason = "the load lies in one axial plane"}),
          input(m.tilt, "load.tilt",
                "tilt of the inner ring in the plane of the radial load, instead of its moment",
                {.dimension = dimension::angle, .range = {-10.0, 10.0}}));
}

/// Result of the search for the static equilibrium.
struct BalanceReport : mechanics::SearchReport {
  std::string message{};  // empty where converged
};

/// Displacement of the inner ring from the concentric position, and the loads of the elements, the same on
/// both races. If a nominal contact angle of zero prefers no side, that position is axially centred.
struct RingState {
  double radial = 0.0;           // [m]    along the radial load
  double lateral = 0.0;          // [m]    across it
  double axial = 0.0;            // [m]
  double tilt = 0.0;             // [rad]  in the plane of the radial load
  double lateral_tilt = 0.0;     // [rad]
  double moment = 0.0;           // [N m]  on the ring in that plane: given, or holding the given tilt
  double lateral_moment = 0.0;   // [N m]
  Eigen::ArrayXd contact_load;   // [N]    (elements)  on the inner race
  Eigen::ArrayXd contact_angle;  // [rad]  (balls)  on the inner race; empty for rollers
  Eigen::ArrayXd outer_load;     // [N]    (balls)  where it differs; else empty
  Eigen::ArrayXd outer_angle;    // [rad]  (balls)  the same
  /// (balls)  of rings that turn; else empty: surface speed against each contact [m/s], equal on ball and
  /// race, and spin of the ball on the race about its normal [rad/s].
  Eigen::ArrayXd inner_rolling, inner_spin, outer_rolling, outer_spin;
  Eigen::Array2Xd ball_position;    // [m]  (r and z, balls)  from the outer groove centre
  std::vector<bool> inner_control;  // (balls)  whether race control gave a ball to the inner race
  double friction = 0.0;        // [-]    traction over load that holds the balls' gyroscopic moments, at most
  Eigen::ArrayXXd lamina_load;  // [N]    (laminae, rollers); empty for balls
  double largest_pressure = 0.0;  // [Pa]   of both races, after Hertz; of rollers that of a lamina
  /// Stiffness of the ring against its displacement and tilt (x, y, z, tilt in the planes of x and z, of y
  /// and z): [N/m], [N/rad], [N m/m], [N m/rad].
  Eigen::Matrix<double, 5, 5> stiffness = Eigen::Matrix<double, 5, 5>::Zero();
  BalanceReport report;
};

/// The position at which a state was found. `lever` [m].
inline RingPosition position_of(const RingState& state, double lever) {
  return (RingPosition() << state.radial, state.lateral, state.axial, lever * std::tan(state.tilt),
          lever * std::tan(state.lateral_tilt))
      .finished();
}

/// Angles of the elements from the radial load [rad].
inline Eigen::ArrayXd element_angles(const Bearing& bearing) {
  const int count = bearing.element_count();
  const double pitch = constants::two_pi / count;
  return bearing.first_element + pitch * Eigen::ArrayXd::LinSpaced(count, 0.0, count - 1.0);
}

/// One row or several that support a ring.
class RingRow {
 public:
  virtual ~RingRow() = default;
  virtual double lever() const = 0;             // [m]  of the tilts
  virtual double reach(double load) const = 0;  // [m]  scale of the position under `load` [N]
  /// Adds force [N] of the elements on the ring, its stiffness, and as scale the sum of the contact loads,
  /// however they cancel.
  virtual void add_forces(const RingPosition& position, RingImbalance& sum) const = 0;
  /// Loads of all elements, and the pressure.
  virtual void put_loads(const RingPosition& position, RingState& state) const = 0;
  /// Whether its forces follow its motion, and so have no energy.
  virtual bool follows_motion() const { return false; }
};

RingImbalance row_forces(const RingRow& row, const RingPosition& position);

/// The load on the coordinates of the position [N]; a given tilt bears the moments.
RingPosition outer_load(const RingLoad& load, double lever);

/// Stiffness by displacement [m] and tilt [rad] from one by positions, whose tilts are multiplied by the
/// lever [m].
Eigen::Matrix<double, 5, 5> by_tilt(const Eigen::Matrix<double, 5, 5>& stiffness, double lever);

/// State of the ring at `position`: loads and stiffness of its row. The report is that of no search.
RingState state_at(const RingRow& row, const RingPosition& position);

/// The search begins at `start`; a tilt that is given is constant. `near` [-]: residual force over the loads,
/// if the equilibrium is a start for another; 0: round-off.
RingState balance_ring(const RingRow& row, const RingLoad& load,
                       const RingPosition& start = RingPosition::Zero(), double near = 0.0);

}  // namespace orbearing::bearing::equilibrium
