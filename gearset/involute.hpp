// The involute function and what follows from it.
#pragma once

namespace orbearing::gearset {

/// inv(alpha) = tan(alpha) - alpha, accurate to round-off also at small angles. Eq. (1) of gearset/README.md.
/// @param pressure_angle [rad] in [0, pi/2)
/// @return [rad]
double involute(double pressure_angle);

/// The pressure angle whose involute is given.
/// @param value [rad] not negative
/// @return [rad] in [0, pi/2)
/// @throws std::domain_error if value is negative or not finite
double inverse_involute(double value);

/// Pressure angle of an involute at a radius.
/// @param base_radius [m]
/// @param radius      [m] not below the base radius
/// @return [rad]
double pressure_angle_at(double base_radius, double radius);

/// Length of the tangent from a point at `radius` to the base circle: the radius of curvature of the
/// involute.
/// @param base_radius [m]
/// @param radius      [m] not below the base radius
/// @return [m]
double tangent_length(double base_radius, double radius);

}  // namespace orbearing::gearset
