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

/// Force [N] on the planet, outward and in the sense of rotation; reversed on the pin. Eq. (6) of
/// gearset/dynamics/README.md.
/// @param q, v positions and velocities (freedoms)
inline Eigen::Vector2d bearing_force(const PlanetMember& planet, const PlanetBearing& bearing,
                                     const Eigen::Ref<const Eigen::VectorXd>& q,
                                     const Eigen::Ref<const Eigen::VectorXd>& v) {
  const Eigen::Index carrier = SetLayout::carrier();
  const Eigen::Vector2d deflection(bearing.radial.of(q, carrier, bearing.planet_index),
                                   bearing.tangential.of(q, carrier, bearing.planet_index));
  const Eigen::Vector2d rate(bearing.radial.of(v, carrier, bearing.planet_index),
                             bearing.tangential.of(v, carrier, bearing.planet_index));
  if (const auto& law = planet.affine_bearing)
    return law->force + law->stiffness * (deflection + bearing.pin_error) + law->damping * rate;
  return planet.bearing_stiffness * (deflection + bearing.pin_error) + planet.bearing_damping * rate;
}

}  // namespace orbearing::gearset::dynamics
