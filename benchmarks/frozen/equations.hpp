// Frozen: the plain equations of motion of the planet bearing as commit d33b5f5 had them, cut to what the
// benchmark's bearing has: round races, equal straight rollers, film in the approach, Coulomb friction, a
// cage with a short film on the outer land, constant load and speeds. They are what `speedup_over_dopri5` is
// timed against, and stay as they are: a reference that changes with the program measures nothing.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "benchmarks/frozen/cage.hpp"
#include "benchmarks/frozen/contact.hpp"

namespace orbearing::bench::frozen {

/// Carrier motion; a term that is switched off has a zero factor.
struct CarrierFrame {
  double coriolis_speed = 0.0;  // [rad/s]
  double centrifugal = 0.0;     // [rad^2/s^2]
  double euler = 0.0;           // [rad/s^2]
  double own_orbit = 1.0;       // [-]
  double orbit_radius = 0.0;    // [m]
};

/// Drag -coefficient speed |speed|.
struct QuadraticDrag {
  double coefficient = 0.0;  // [N s^2/m^2] or [N m s^2/rad^2]

  double force(double speed) const { return -coefficient * speed * std::abs(speed); }
};

/// All constants of a run. State: r, theta, r', theta', spin of all rollers each; cage x y psi x' y' psi';
/// bore and pin x y x' y' each.
struct Model {
  Eigen::Index rollers = 0;
  CarrierFrame frame;
  double roller_mass = 0.0, roller_inertia = 0.0;  // [kg], [kg m^2]
  double cage_mass = 0.0, cage_inertia = 0.0;      // [kg], [kg m^2]
  double bore_mass = 0.0, pin_mass = 0.0;          // [kg]
  double outer_speed = 0.0, inner_speed = 0.0;     // [rad/s]
  Vector2 bore_load = Vector2::Zero();             // [N]
  Race inner, outer;
  Pocket pocket;
  std::vector<Vector2> pocket_direction;  // [-]  of each pocket at cage angle zero
  Guidance guidance;
  double support_stiffness = 0.0, support_damping = 0.0;  // [N/m], [N s/m]
  QuadraticDrag orbit_drag, spin_drag, cage_drag;
};

class Equations {
 public:
  explicit Equations(Model model) : model_(std::move(model)) {}

  /// Rate `dx` of the state `x`.
  void derivative(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> dx) const;

 private:
  Model model_;
};

}  // namespace orbearing::bench::frozen
