// Planets with two gears: the first meshes with the sun, the second with the ring.
//
//      sun |   first  |              ring
//     -----+----------+----+--------+-----> z, along the axis, from the middle of the planet
//          |  b_1     |    | second |  b_2
//          '----------'    '--------'
//               |<---offset--->|
#pragma once

#include "gearset/parameters.hpp"

namespace orbearing::gearset {

/// Teeth of a set that has the same motions and torques with one gear on each planet. Eq. (41) of
/// gearset/README.md.
struct WillisTeeth {
  int sun = 0;
  int planet = 0;
  int ring = 0;
  int common =
      1;  // [-]  by which all could be divided: of both gears of a planet their greatest common divisor

  /// Steps round the carrier at which a planet finds its tooth spaces. Eq. (23).
  int positions() const { return (sun + ring) / common; }
};

WillisTeeth willis_teeth(const PlanetarySet& set);

/// Module of the ring and of what meshes with it, and the width of their teeth. [m]
double ring_module(const PlanetarySet& set);
double ring_face(const PlanetarySet& set);

/// Axial positions of the gears of a planet.
struct GearPlanes {
  double sun = 0.0;     // [m]  middle of the face of the sun mesh, from the middle of the planet
  double ring = 0.0;    // [m]  of the ring mesh
  double length = 0.0;  // [m]  of the planet, from the outer end of one gear to that of the other
};

GearPlanes gear_planes(const PlanetarySet& set);

}  // namespace orbearing::gearset
