// Force of a planet's bearing, taken as springs and dampers between planet and pin.
#pragma once

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// Force [N] on the planet, outward and in the sense of rotation; reversed on the pin. Eq. (6) of
/// gearset/dynamics/README.md.
/// @param q, v positions and velocities (freedoms)
inline Eigen::Vector2d bearing_force(const PlanetMember& planet, const PlanetBearing& bearing,
                                     const Eigen::Ref<const Eigen::VectorXd>& q,
                                     const Eigen::Ref<const Eigen::VectorXd>& v) {
  const Eigen::Index carrier = SetLayout::carrier();
  const Eigen::Vector2d deflection(bearing.radial.of(q, carrier, bearing.place),
                                   bearing.tangential.of(q, carrier, bearing.place));
  const Eigen::Vector2d rate(bearing.radial.of(v, carrier, bearing.place),
                             bearing.tangential.of(v, carrier, bearing.place));
  return planet.bearing_stiffness * (deflection + bearing.pin_error) + planet.bearing_damping * rate;
}

}  // namespace orbearing::gearset::dynamics
