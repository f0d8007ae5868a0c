// A planetary set in three dimensions at rest: what holds carrier, planets and sun, and what loads them.
// The ring is fixed to the housing. Axial positions are from the middle of the face width, toward the side to
// which the axis of rotation z points.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "mechanics/described.hpp"

namespace orbearing::gearset::spatial {

/// A bearing of the carrier in the housing.
struct CarrierBearing {
  double position = 0.0;          // [m]    axial
  double radial_stiffness = 0.0;  // [N/m]
  double axial_stiffness = 0.0;   // [N/m]  0: it locates nothing
  double clearance = 0.0;         // [m]    radial: half of the difference of diameters
};

/// One row of rolling elements between planet and pin, the pin's own compliance included.
struct PlanetBearing {
  double position = 0.0;          // [m]    axial
  double radial_stiffness = 0.0;  // [N/m]
  double clearance = 0.0;         // [m]    radial
};

/// One of the two meshes of a planet.
struct SpatialMesh {
  double stiffness = 0.0;       // [N/m2]  mean, along the normal of the flank and per face width
  double pressure_angle = 0.0;  // [rad]   working, transverse
  double base_helix = 0.0;      // [rad]   positive: the sun's teeth are right-handed
  // [m]  between both flanks, along the line of action of the transverse section; infinite: no back flanks
  double backlash = std::numeric_limits<double>::infinity();
};

/// Forces and moments of the rotor on the carrier, in a frame fixed to the housing: x across, y
/// upward, z along the axis. They act on the axis, at the middle of the face width.
struct RotorLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // [N m]  without the torque, which is `torque`
};

struct SpatialSet {
  std::vector<double> angles;       // [rad]  of the planets on the carrier
  double centre_distance = 0.0;     // [m]
  double face_width = 0.0;          // [m]    common to sun, planets and ring
  double planet_base_radius = 0.0;  // [m]
  SpatialMesh sun, ring;
  std::vector<PlanetBearing> planet_bearings;  // the same on each pin
  /// [m/N]  (planet bearings, the same)  of a pin at them, in any one plane, besides their own compliance;
  /// they then have no clearance; none: in their stiffness
  Eigen::MatrixXd pin_compliance;
  double planet_axial_stiffness = 0.0;  // [N/m]  between planet and pin
  std::vector<CarrierBearing> carrier_bearings;
  /// [N/m]  (3 x carrier bearings, the same)  of the housing at the bearings' seats, in series with them: x,
  /// y and z of the housing, bearing by bearing; none: rigid
  Eigen::MatrixXd housing_stiffness;
  double sun_axial_stiffness = 0.0;          // [N/m]  its spline or bearing
  double sun_radial_stiffness = 0.0;         // [N/m]  of its shaft, in the middle of the face; 0: it floats
  double sun_tilt_stiffness = 0.0;           // [N m/rad]  the same against tilting
  double planet_mass = 0.0, sun_mass = 0.0;  // [kg]   their middles are those of the face width
  double carrier_mass = 0.0;                 // [kg]   with what hangs on it
  double carrier_centre = 0.0;               // [m]    axial position of its centre of mass
  Eigen::Matrix2Xd pin_errors;               // [m]  (radial and tangential, planets); none: without columns
};

struct SpatialLoad {
  double torque = 0.0;     // [N m]  on the carrier about z; the sun bears it
  double speed = 0.0;      // [rad/s]  of the carrier
  double gravity = 0.0;    // [m/s2]  toward -y of the housing
  double axis_tilt = 0.0;  // [rad]  of z over the horizontal
  RotorLoad rotor;
};

/// The carrier as a body in a case: its support by the housing, and its loads besides torque.
struct CarrierMounting {
  std::vector<double> positions;         // [m]    (bearings)  axial
  std::vector<double> radial_stiffness;  // [N/m]  (bearings)
  std::vector<double> clearances;    // [m]    (bearings) or empty: none; of diameters, as catalogues have it
  std::vector<double> housing;       // [N/m]  rows of SpatialSet::housing_stiffness or empty: rigid
  double centre_of_mass = 0.0;       // [m]
  double axis_tilt = 0.0;            // [rad]
  double gravity = 9.80665;          // [m/s2]
  std::vector<double> rotor_force;   // [N]    (3) or empty
  std::vector<double> rotor_moment;  // [N m]  (2) or empty
  double sun_tilt_stiffness = 0.0;   // [N m/rad]  of its shaft; 0: it inclines freely
  double sun_axial_stiffness = 0.0;  // [N/m]  in small vibration
  double planet_axial_stiffness = 0.0;  // [N/m]  of all bearings of a planet, the same
};

template <class Visitor>
void describe(Visitor& visit, CarrierMounting& m) {
  using namespace described;
  constexpr Dimension acceleration{"acceleration", "m/s2", "m/s2", "9.81 m/s2"};
  const std::string block = "gearset.carrier.";
  const auto list = [&](std::vector<double>& member, const std::string& name, const std::string& meaning,
                        const Dimension& of, double least, double most, std::string_view beside) {
    return input(member, block + name, meaning,
                 {.dimension = of, .range = {least, most}, .where = {.path = beside}});
  };
  constexpr std::string_view held = "gearset.carrier.bearing_positions";
  const auto number = [&](double& member, const std::string& name, const std::string& meaning,
                          const Dimension& of, Range range, std::string_view reason) {
    return input(member, block + name, meaning,
                 {.dimension = of, .range = range, .reason = reason, .where = {.path = held}});
  };
  members(
      visit, m,
      list(m.positions, "bearing_positions",
           "axial positions of the carrier's bearings, from the middle of the face", dimension::length, -1e5,
           1e5, {}),
      list(m.radial_stiffness, "bearing_stiffness",
           "radial stiffness of each bearing of the carrier; the first also locates it axially with this "
           "stiffness",
           dimension::stiffness, 1.0, 1e13, held),
      list(m.clearances, "bearing_clearance",
           "radial internal clearance of each bearing of the carrier; none if absent",
           dimension::small_length, 0.0, 1e5, held),
      list(m.housing, "housing_stiffness",
           "stiffness matrix of the housing at the seats of the carrier's bearings, row by row or in a file; "
           "across, upward and along the axis for each bearing; rigid if absent",
           dimension::stiffness, -1e16, 1e16, held),
      number(m.centre_of_mass, "centre_of_mass",
             "axial position of the carrier's centre of mass, from the middle of the face", dimension::length,
             {-1e5, 1e5}, "between its walls"),
      number(m.axis_tilt, "axis_tilt", "angle of the axis over the horizontal", dimension::angle,
             {-90.0, 90.0}, "a horizontal gearbox"),
      number(m.gravity, "gravity", "acceleration of gravity, 0: without weight", acceleration, {0.0, 100.0},
             "standard gravity"),
      list(m.rotor_force, "rotor_force",
           "force of the rotor on the carrier at the middle of the face: across, upward, along the axis",
           dimension::force, -1e9, 1e9, held),
      list(m.rotor_moment, "rotor_moment",
           "moment of the rotor on the carrier about the middle of the face: about the axis across and the "
           "upward one",
           dimension::torque, -1e9, 1e9, held),
      input(m.sun_tilt_stiffness, "gearset.dynamics.sun.tilt_stiffness",
            "stiffness of the sun's shaft against tilting of the sun, 0: it inclines freely",
            {.dimension = dimension::rotating_stiffness,
             .range = {0.0, 1e13},
             .reason = "a floating sun in a spline",
             .where = {.path = held}}),
      input(m.sun_axial_stiffness, "gearset.dynamics.sun.axial_stiffness",
            "axial stiffness that holds the sun in small vibration",
            {.dimension = dimension::stiffness,
             .range = {0.0, 1e13},
             .reason = "a spline, in which friction alone holds",
             .where = {.path = held}}),
      input(m.planet_axial_stiffness, "gearset.dynamics.planet.axial_stiffness",
            "axial stiffness between planet and pin in small vibration, of all bearings of a planet",
            {.dimension = dimension::stiffness,
             .range = {0.0, 1e13},
             .reason = "cylindrical and needle rollers slide along their raceways; friction alone holds",
             .where = {.path = held}}));
}

}  // namespace orbearing::gearset::spatial
