// Elastic point contact of two like bodies after Hertz, with complete elliptic integrals solved exactly.
#pragma once

#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// Curvatures of both bodies in a contact.
struct PointCurvature {
  double sum = 0.0;         // [1/m]  of the four principal curvatures, concave ones negative
  double difference = 0.0;  // [-]    of the two planes, over the sum: 0 for a sphere on a plane, less than 1
};

/// Shape of the ellipse of contact.
struct ContactEllipse {
  double axis_ratio = 1.0;  // [-]  major over minor axis
  double first = 0.0;       // [-]  complete elliptic integral K(1 - 1/ratio^2), parameter m
  double second = 0.0;      // [-]  E(1 - 1/ratio^2)
};

/// Ellipse of a curvature difference in [0, 1). Throws std::invalid_argument for another one.
ContactEllipse contact_ellipse(double curvature_difference);

/// Semi-axes and largest pressure at one load.
struct PointPressure {
  double major = 0.0;     // [m]
  double minor = 0.0;     // [m]
  double pressure = 0.0;  // [Pa]
};

/// One contact; both bodies of the same material.
struct PointContact {
  PointCurvature curvature;
  ContactEllipse ellipse;
  double modulus = 0.0;   // [Pa]       E/(1 - nu^2)
  double constant = 0.0;  // [N/m^1.5]  Q = constant approach^1.5
};

PointContact point_contact(const PointCurvature& curvature, const Material& material);

PointPressure point_pressure(const PointContact& contact, double load);

/// Load [N] at which the largest pressure is `pressure` [Pa].
double load_at_pressure(const PointContact& contact, double pressure);

/// Constant [N/m^1.5] of two contacts that carry the same load one behind the other.
double in_series(const PointContact& one, const PointContact& other);

/// Ball of `ball_diameter` [m] on the race of a bearing whose centres of balls lie on `pitch_diameter` [m];
/// `groove_radius` [m]. The race's curvature is that of [ISO16281] at `contact_angle` [rad]:
/// gamma = D cos(alpha)/d_m.
PointCurvature ball_race_curvature(Race race, double ball_diameter, double pitch_diameter,
                                   double groove_radius, double contact_angle);

}  // namespace orbearing::bearing
