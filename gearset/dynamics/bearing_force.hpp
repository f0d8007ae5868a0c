// Force of a planet's bearing, taken as springs and dampers between planet and pin.
#pragma once

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// The law of the bearings of a planet, whichever way it was stated.
inline AffineBearing bearing_law(const PlanetMember& planet) {
  if (planet.affine_bearing) return *planet.affine_bearing;
  return {.stiffness = planet.bearing_stiffness * Eigen::Matrix2d::Identity(),
          .damping = planet.bearing_damping * Eigen::Matrix2d::Identity()};
}

/// Displacement of the pin from the planet's axis at `q` [m], or its rate at velocities [m/s]: outward and in
/// the sense of rotation, its error left out.
inline Eigen::Vector2d bearing_deflection(const PlanetBearing& bearing,
                                          const Eigen::Ref<const Eigen::VectorXd>& q) {
  const Eigen::Index carrier = SetLayout::carrier();
  return {bearing.radial.of(q, carrier, bearing.planet_index),
          bearing.tangential.of(q, carrier, bearing.planet_index)};
}

/// Force [N] on the planet, outward and in the sense of rotation; reversed on the pin. Eq. (6) of
/// gearset/dynamics/README.md.
/// @param q, v positions and velocities (freedoms)
inline Eigen::Vector2d bearing_force(const PlanetMember& planet, const PlanetBearing& bearing,
                                     const Eigen::Ref<const Eigen::VectorXd>& q,
                                     const Eigen::Ref<const Eigen::VectorXd>& v) {
  const Eigen::Vector2d deflection = bearing_deflection(bearing, q), rate = bearing_deflection(bearing, v);
  if (const auto& law = planet.affine_bearing)
    return law->force + law->stiffness * (deflection + bearing.pin_error) + law->damping * rate;
  return planet.bearing_stiffness * (deflection + bearing.pin_error) + planet.bearing_damping * rate;
}

}  // namespace orbearing::gearset::dynamics
