// The balance of a ring on one row of rolling elements under a static load, [ISO16281]: one problem for balls
// and for rollers on laminae.
//
// The outer ring stands. The inner ring has five freedoms, all as lengths: x along the radial load, y across
// it, z along the axis, and both tilts at the row's lever,
//
//     place = (x, y, z, lever tan(tilt in the plane of x and z), lever tan(tilt in that of y and z))
//
// A positive tilt moves the ring forward along z where it is positive in x or y; there it presses rollers at
// negative z.
#pragma once

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>
#include <optional>
#include <string>

#include "bearing/parameters.hpp"
#include "mechanics/convex_search.hpp"
#include "mechanics/described.hpp"

namespace orbearing::bearing::equilibrium {

using RingPlace = Eigen::Vector<double, 5>;  // [m]
using RingImbalance = mechanics::Imbalance<5>;

/// Load on the inner ring.
struct RingLoad {
  double radial = 0.0;         // [N]    along x
  double axial = 0.0;          // [N]
  double moment = 0.0;         // [N m]  in the plane of x and z
  double moment_across = 0.0;  // [N m]  in the plane of y and z
  std::optional<double> tilt;  // [rad]  in the plane of x and z, given in place of both moments; none: free
};

template <class Visitor>
void describe(Visitor& visit, RingLoad& m) {
  using namespace described;
  constexpr unsigned single_bearing = roller_bearing | lone_balls;
  members(
      visit, m,
      field(m.radial, "load.radial", Felt::lone, "radial load on the bearing",
            {.models = single_bearing | raceway_defect,
             .required_by = single_bearing | raceway_defect,
             .dimension = dimension::force,
             .range = {0.0, 1e9}}),
      field(m.axial, "load.axial", Felt::lone, "axial load on the bearing",
            {.models = lone_balls,
             .dimension = dimension::force,
             .range = {0.0, 1e9},
             .reason = "a radial load alone"}),
      field(m.moment, "load.moment", Felt::lone, "moment on the inner ring in the plane of the radial load",
            {.models = single_bearing,
             .dimension = dimension::torque,
             .range = {-1e9, 1e9},
             .reason = "the shaft does not hold the ring against tilting"}),
      field(m.moment_across, "load.moment_across", Felt::lone,
            "moment on the inner ring in the axial plane across the radial load",
            {.models = single_bearing,
             .dimension = dimension::torque,
             .range = {-1e9, 1e9},
             .reason = "the load lies in one axial plane"}),
      field(m.tilt, "load.tilt", Felt::lone,
            "tilt of the inner ring in the plane of the radial load, in place of its moment",
            {.models = single_bearing, .dimension = dimension::angle, .range = {-10.0, 10.0}}));
}

/// How the search for the balance ended.
struct BalanceReport : mechanics::SearchReport {
  std::string message{};  // empty where converged
};

/// Displacement of the inner ring from the concentric position, and the loads of the elements, the same on
/// both races. Where a nominal contact angle of zero leaves no side preferred, that position is axially
/// centred.
struct RingState {
  double radial = 0.0;            // [m]    along the radial load
  double lateral = 0.0;           // [m]    across it
  double axial = 0.0;             // [m]
  double tilt = 0.0;              // [rad]  in the plane of the radial load
  double lateral_tilt = 0.0;      // [rad]
  double moment = 0.0;            // [N m]  on the ring in that plane: given, or holding the given tilt
  double lateral_moment = 0.0;    // [N m]
  Eigen::ArrayXd contact_load;    // [N]    (elements)
  Eigen::ArrayXd contact_angle;   // [rad]  (balls); empty for rollers
  Eigen::ArrayXXd lamina_load;    // [N]    (laminae, rollers); empty for balls
  double largest_pressure = 0.0;  // [Pa]   of both races, after Hertz; of rollers that of a lamina
  BalanceReport report;
};

/// Angles of the elements from the radial load [rad].
inline Eigen::ArrayXd element_angles(const Bearing& bearing) {
  const int count = bearing.element_count();
  const double pitch = boost::math::double_constants::two_pi / count;
  return bearing.first_element + pitch * Eigen::ArrayXd::LinSpaced(count, 0.0, count - 1.0);
}

/// What a row adds to the ring's balance: force [N] of the elements on the ring, its stiffness, and as scale
/// the sum of the contact loads, however they cancel.
///
/// A row is a type with
///     double lever() const;                                     // [m]  of the tilts
///     double reach(double load) const;                          // [m]  scale of the place under `load` [N]
///     void add_forces(const RingPlace&, RingImbalance&) const;
///     void put_loads(const RingPlace&, RingState&) const;       // all of the elements, and the pressure
///     double stored_energy(const RingPlace&) const;             // [J]
template <class Row>
RingImbalance row_forces(const Row& row, const RingPlace& place) {
  RingImbalance sum;
  row.add_forces(place, sum);
  return sum;
}

template <class Row>
RingState balance_ring(const Row& row, const RingLoad& load) {
  const double lever = row.lever();
  const bool tilt_given = load.tilt.has_value();
  const RingPlace outer =
      (RingPlace() << load.radial, 0.0, load.axial, tilt_given ? 0.0 : load.moment / lever,
       tilt_given ? 0.0 : load.moment_across / lever)
          .finished();
  const Eigen::Array<bool, 5, 1> held(false, false, false, tilt_given, tilt_given);
  RingPlace place = RingPlace::Zero();
  if (tilt_given) place[3] = lever * std::tan(*load.tilt);
  const double reach = row.reach(outer.norm()) + std::abs(place[3]);
  const auto imbalance_at = [&](const RingPlace& at) {
    RingImbalance sum = row_forces(row, at);
    sum.force += outer;
    sum.scale = std::max(sum.scale, outer.cwiseAbs().maxCoeff());
    mechanics::hold<5>(held, sum);
    return sum;
  };
  RingState state;
  RingImbalance now;
  const mechanics::SearchLimits limits{.reach = reach, .tolerance = 1e-13, .most_iterations = 300};
  state.report = {mechanics::find_balance<5>(imbalance_at, limits, place, now)};
  if (!state.report.converged) state.report.message = "the ring found no balance on its rolling elements";
  const RingPlace forces = -row_forces(row, place).force;
  state.radial = place[0];
  state.lateral = place[1];
  state.axial = place[2];
  state.tilt = std::atan(place[3] / lever);
  state.lateral_tilt = std::atan(place[4] / lever);
  state.moment = forces[3] * lever;
  state.lateral_moment = forces[4] * lever;
  row.put_loads(place, state);
  return state;
}

}  // namespace orbearing::bearing::equilibrium
