// Mean speeds, torques and tooth forces of one set under steady power.
#pragma once

#include "gearset/kinematics.hpp"
#include "gearset/parameters.hpp"
#include "gearset/working_geometry.hpp"

namespace orbearing::gearset {

/// Loads shared equally by all planets, without friction. Frame of a planet: x outward from the sun's axis, y
/// in the direction of carrier rotation.
struct MeanLoads {
  double sun_speed = 0.0;      // [rad/s]
  double ring_speed = 0.0;     // [rad/s]
  double carrier_speed = 0.0;  // [rad/s]  never negative
  double planet_speed_relative =
      0.0;                      // [rad/s]  relative to the carrier; negative when the sun outruns the carrier
  double sun_torque = 0.0;      // [N m]    external, on the member
  double ring_torque = 0.0;     // [N m]
  double carrier_torque = 0.0;  // [N m]
  double normal_force =
      0.0;  // [N]      of one mesh of one planet in the transverse section, along the line of
            //          action; equal at sun and ring but of stepped planets, not negative
  double tangential_force =
      0.0;  // [N]      y, on one planet, both meshes; positive when the planet pulls the carrier on
  double radial_force = 0.0;  // [N]      x, on one planet, both meshes; positive outward
  // Helical teeth, along and about the axis on which the carrier turns counterclockwise:
  double tooth_force = 0.0;         // [N]    of one mesh of one planet, normal to the teeth
  double axial_force = 0.0;         // [N]    z, of the sun on one planet; the ring's is opposite and as large
  double overturning_moment = 0.0;  // [N m]  about y, on one planet: tilts its axis outward at positive z
  double sun_thrust = 0.0;          // [N]    z, of all planets on the sun; that on the ring is opposite
  // Stepped planets:
  double ring_normal_force = 0.0;  // [N]    as normal_force, of the ring mesh
  double couple_outward =
      0.0;                    // [N m]  of both meshes about the middle of a planet: leans its axis outward at
                              //        positive z
  double couple_ahead = 0.0;  // [N m]  the same in the direction of carrier rotation
};

/// Axial forces from the housing's axial bearings on members, which balance the thrust of sun and ring; z as
/// in MeanLoads.
struct AxialReactions {
  double sun = 0.0;      // [N]  from the housing on the sun
  double carrier = 0.0;  // [N]  on the carrier
  double ring = 0.0;     // [N]  on the ring
};

/// Eq. (39) of gearset/README.md.
AxialReactions axial_reactions(const PlanetarySet& set, const MeanLoads& loads);

/// Mean loads of the set. Eqs. (15) to (20) and (35) to (38) of gearset/README.md.
/// @throws std::invalid_argument if power or speed is not positive, or the driven member is fixed
MeanLoads mean_loads(const PlanetarySet& set, const WorkingGeometry& geometry, const Drive& drive);

/// Speeds and torques of the members, as the next; all forces 0.
MeanLoads member_loads(const MemberRatios& ratios, const Drive& drive);

/// Mean loads of a set whose members turn and are loaded as `ratios` of what `drive` puts into the
/// drivetrain; drive.member has no meaning here. If the carrier would turn backwards, the set is viewed from
/// its other side, so that the frame of the planet still runs with it.
/// @throws std::invalid_argument if power or speed is not positive
MeanLoads mean_loads(const PlanetarySet& set, const WorkingGeometry& geometry, const MemberRatios& ratios,
                     const Drive& drive);

/// Tangential load that the carrier's torque puts on one planet: the mean load of its bearings together.
/// @param carrier_torque  [N m]
/// @param planets         number of planets sharing it equally
/// @param centre_distance [m]
/// @return [N]
double planet_tangential_load(double carrier_torque, int planets, double centre_distance);

}  // namespace orbearing::gearset
