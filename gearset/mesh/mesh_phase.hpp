// When the meshes of a planetary set begin, one against another.
#pragma once

#include "gearset/mesh/mesh_stiffness.hpp"

namespace orbearing::gearset {

/// How the set runs, as seen from its carrier.
struct MeshMotion {
  bool sun_drives = true;         // power flows from the sun to the planets, seen from the carrier
  bool sun_anticlockwise = true;  // the sun turns anticlockwise relative to the carrier
};

/// @param sun_torque         [N m]    external, on the sun
/// @param sun_speed_relative [rad/s]  to the carrier, anticlockwise
MeshMotion mesh_motion(double sun_torque, double sun_speed_relative);

/// The part of `periods` beyond whole ones, in [0, 1); a whole number but for round-off gives 0.
double whole_periods_off(double periods);

/// How far the sun mesh of a planet lags behind that of a planet at angle zero, in mesh periods; the ring
/// meshes lag alike, by the condition of assembly. Eq. (11) of gearset/mesh/README.md [ParkerLin2004].
/// @param planet_angle [rad] anticlockwise
/// @return in [0, 1)
double sun_mesh_lag(int sun_teeth, double planet_angle, const MeshMotion& motion);
double ring_mesh_lag(int ring_teeth, double planet_angle, const MeshMotion& motion);

/// How far the ring mesh of a planet lags behind its sun mesh, contact of a pair of teeth beginning at
/// fraction zero in both. Eq. (12) of gearset/mesh/README.md.
/// @param sun_mesh, ring_mesh of the same planet, which is `second` in both
/// @return [mesh period] in [0, 1)
double ring_to_sun_lag(const MeshingGears& sun_mesh, const MeshingGears& ring_mesh, double sun_working_angle,
                       double ring_working_angle);

}  // namespace orbearing::gearset
