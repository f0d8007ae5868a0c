// Position of each variable of the state in the flat vector, and its name.
//
//   [ r (Z) | theta (Z) | r' (Z) | theta' (Z) | spin (Z) | end displacement (Z), where rollers tilt
//     | cage x y psi x' y' psi', where there is one | bore x y x' y' | pin x y x' y' | waves | rates of the
//     waves | turned (followed) ]
//
#pragma once

#include <Eigen/Core>
#include <string>
#include <type_traits>
#include <vector>

#include "bearing/motion/vectorised/engine.hpp"

namespace orbearing::bearing::motion {

/// Kind of a variable of the state; integrators weigh errors by kind.
enum class VariableKind { length, angle, velocity, angular_speed };

using StateLayout = vectorised::Layout<Eigen::Index, 1>;

/// Named views on a flat state, or on its derivative: the views then hold the rate of what they are named
/// for. Those of the cage must not be used without one.
template <typename Scalar>
struct StateViews {
  template <typename Plain>
  using View = Eigen::Map<std::conditional_t<std::is_const_v<Scalar>, const Plain, Plain>>;

  View<Eigen::ArrayXd> radius;          // [m]      (rollers)  from the undeformed pin axis
  View<Eigen::ArrayXd> angle;           // [rad]    (rollers)  grows without bound
  View<Eigen::ArrayXd> radial_speed;    // [m/s]    (rollers)
  View<Eigen::ArrayXd> orbital_speed;   // [rad/s]  (rollers)
  View<Eigen::ArrayXd> spin;            // [rad/s]  (rollers)  relative to the carrier
  View<Eigen::Vector2d> cage_position;  // [m]
  Scalar& cage_angle;                   // [rad]    grows without bound
  View<Eigen::Vector2d> cage_velocity;  // [m/s]
  Scalar& cage_speed;                   // [rad/s]  relative to the carrier
  View<Eigen::Vector2d> bore_position;  // [m]
  View<Eigen::Vector2d> bore_velocity;  // [m/s]
  View<Eigen::Vector2d> pin_position;   // [m]
  View<Eigen::Vector2d> pin_velocity;   // [m/s]
  View<Eigen::ArrayXd> turned;  // [rad]    (followed)  by the rollers that are followed, since the start
  View<Eigen::ArrayXd> end_displacement;  // [m]      (rollers) or none; RollerApproaches::end_displacement
  View<Eigen::VectorXd> wave;             // [m]      (waves)
  View<Eigen::VectorXd> wave_speed;       // [m/s]    (waves)
};

namespace detail {
template <typename Scalar>
StateViews<Scalar> views(const StateLayout& layout, Scalar* x) {
  const Eigen::Index z = layout.rollers;
  Scalar* cage = x + layout.cage();
  Scalar* bore = x + layout.bore();
  Scalar* pin = x + layout.pin();
  using Pair = typename StateViews<Scalar>::template View<Eigen::Vector2d>;
  return {{x, z},
          {x + z, z},
          {x + 2 * z, z},
          {x + 3 * z, z},
          {x + 4 * z, z},
          Pair(cage),
          cage[2],
          Pair(cage + 3),
          cage[5],
          Pair(bore),
          Pair(bore + 2),
          Pair(pin),
          Pair(pin + 2),
          {x + layout.turned(), layout.followed},
          {x + 5 * z, layout.tilting ? z : 0},
          {x + layout.wave(), layout.waves},
          {x + layout.wave_speed(), layout.waves}};
}
}  // namespace detail

using ConstStateViews = StateViews<const double>;
using MutableStateViews = StateViews<double>;

/// Views on `x`, which must outlive them.
inline ConstStateViews state_views(const StateLayout& layout, const double* x) {
  return detail::views(layout, x);
}
inline MutableStateViews mutable_state_views(const StateLayout& layout, double* x) {
  return detail::views(layout, x);
}

/// Kind of each variable, in the order of the state.
std::vector<VariableKind> variable_kinds(const StateLayout& layout);

/// Name and unit of each variable in the order of the state, e.g. "roller_3_spin [rad/s]"; rollers count
/// from 1.
std::vector<std::string> variable_names(const StateLayout& layout);

}  // namespace orbearing::bearing::motion
