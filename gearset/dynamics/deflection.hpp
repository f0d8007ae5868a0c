// How far teeth and bearings are pressed together, as linear functions of two bodies' positions.
#pragma once

#include <Eigen/Core>

namespace orbearing::gearset::dynamics {

/// Coefficients of (x, y, u) of a central member and of a planet in one deflection [-].
struct DeflectionVector {
  Eigen::Vector3d central = Eigen::Vector3d::Zero();
  Eigen::Vector3d planet = Eigen::Vector3d::Zero();

  double of(const Eigen::Ref<const Eigen::VectorXd>& q, Eigen::Index central_index,
            Eigen::Index planet_index) const {
    return along(central, q.data() + central_index) + along(planet, q.data() + planet_index);
  }

 private:
  // Asked a hundred times for one right-hand side. Eigen's product of three is a call of its own in a large
  // batch.
  static double along(const Eigen::Vector3d& direction, const double* q) {
    return direction[0] * q[0] + direction[1] * q[1] + direction[2] * q[2];
  }
};

/// Which flanks touch: `driving` where a positive torque on the sun presses them together.
enum class Flank { driving, back };

/// Approach of sun and planet along the line of action. Eq. (1) of gearset/dynamics/README.md.
/// @param planet_angle   [rad] of the planet from the x axis
/// @param pressure_angle [rad]
DeflectionVector sun_mesh_deflection(double planet_angle, double pressure_angle, Flank flank);

/// Approach of ring and planet. Eq. (2).
DeflectionVector ring_mesh_deflection(double planet_angle, double pressure_angle, Flank flank);

/// Distance of the pin from the planet's axis, outward and in the sense of rotation: the deflection of the
/// planet's bearing. Eqs. (3) and (4).
DeflectionVector radial_bearing_deflection(double planet_angle);
DeflectionVector tangential_bearing_deflection(double planet_angle);

/// Rotation [rad] of the planet relative to the carrier, counterclockwise: coefficients in [1/m]. Eq. (15).
/// @param carrier_radius, planet_radius [m] of their u
DeflectionVector planet_rotation(double carrier_radius, double planet_radius);

}  // namespace orbearing::gearset::dynamics
