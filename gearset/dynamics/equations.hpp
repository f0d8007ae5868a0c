// Equations of motion of a planetary set in the frame of its carrier, in the form x' = f(t, x).
#pragma once

#include <Eigen/Core>
#include <utility>

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// Outputs of the gear set to bearings that are computed elsewhere: each planet's axis relative to its pin,
/// outward and in the sense of rotation, and its rotation relative to the carrier, counterclockwise.
/// Conjugate to force and moment of the bearing on the planet.
struct BearingPorts {
  Eigen::Matrix2Xd displacement;  // [m]      (2, planets)
  Eigen::Matrix2Xd velocity;      // [m/s]    (2, planets)
  Eigen::VectorXd angle;          // [rad]    (planets)  beyond the nominal rotation
  Eigen::VectorXd speed;          // [rad/s]  (planets)  beyond the nominal rotation
};

/// Loads of coupled bearings on their planets; reversed on carrier and pins.
struct PortLoads {
  Eigen::Matrix2Xd force;  // [N]    (2, planets)  outward and in the sense of rotation
  Eigen::VectorXd moment;  // [N m]  (planets)  about the planet's axis, counterclockwise
};

/// Right-hand side. Pure and free of allocation; one object may serve several threads.
class PlanetarySetEquations {
 public:
  explicit PlanetarySetEquations(SetModel model) : model_(std::move(model)) {}

  /// Rate `dx` of the state `x` at `time` [s]; both have the order of SetLayout. Coupled bearings give no
  /// force.
  void derivative(double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                  Eigen::Ref<Eigen::VectorXd> dx) const;

  /// The same with the loads of coupled bearings.
  void derivative(double time, const Eigen::Ref<const Eigen::VectorXd>& x, const PortLoads& loads,
                  Eigen::Ref<Eigen::VectorXd> dx) const;

  /// Motion at the ports; `ports` is resized where it has not the right size.
  void motion_at_ports(const Eigen::Ref<const Eigen::VectorXd>& x, BearingPorts& ports) const;

  const SetModel& model() const { return model_; }

 private:
  SetModel model_;
};

/// All generalised forces [N] but those of coupled bearings, held freedoms included.
/// @param force (freedoms)
void add_forces(const SetModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                Eigen::Ref<Eigen::VectorXd> force);

/// Generalised forces [N] of coupled bearings, added.
/// @param force (freedoms)
void add_port_loads(const SetModel& model, const PortLoads& loads, Eigen::Ref<Eigen::VectorXd> force);

/// Force [N] of the driving and the delivering side on the u of each central member: (sun, ring, carrier).
/// Eq. (10).
/// @param speed [m/s] of the u of the driven member, beyond the nominal rotation
Eigen::Vector3d drive_forces(const SetModel& model, const SpeedState& speed_state, double speed);

}  // namespace orbearing::gearset::dynamics
