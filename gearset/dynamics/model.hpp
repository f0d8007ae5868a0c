// The planetary set with all constants of a run: bodies, deflection vectors, phases, speeds over time.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "gearset/dynamics/parameters.hpp"
#include "gearset/parameters.hpp"

namespace orbearing::gearset::dynamics {

// Position of each variable of the planetary set in the flat state, and its name. This is the only file that
// defines them.
//
//   positions [ sun x y u | ring x y u | carrier x y u | planet 1 x y u | ... ], then the same as velocities
//

/// Order of the state of a set with `planets` planets.
struct SetLayout {
  Eigen::Index planets = 0;

  Eigen::Index bodies() const { return 3 + planets; }
  Eigen::Index freedoms() const { return 3 * bodies(); }
  Eigen::Index size() const { return 2 * freedoms(); }

  /// First of the three indices of a body among the positions.
  static constexpr Eigen::Index sun() { return 0; }
  static constexpr Eigen::Index ring() { return 3; }
  static constexpr Eigen::Index carrier() { return 6; }
  static constexpr Eigen::Index central(Member member) {
    return member == Member::sun ? sun() : member == Member::ring ? ring() : carrier();
  }
  static constexpr Eigen::Index planet(Eigen::Index n) { return 9 + 3 * n; }
};

/// Name and unit of each variable in the order of the state, e.g. "planet_3_y [m]"; planets count from 1.
std::vector<std::string> variable_names(const SetLayout& layout);

// Deflections of teeth and bearings, as linear functions of two bodies' positions.

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

enum class MeshKind { sun, ring };

/// One mesh of one planet.
struct PlanetMesh {
  MeshKind kind = MeshKind::sun;
  Eigen::Index planet = 0;   // counted from 0
  Eigen::Index central = 0;  // index of sun or ring in the layout
  Eigen::Index planet_index = 0;  // of the planet in the layout
  DeflectionVector loaded;   // of the flank that carries the mean load
  DeflectionVector back;     // of the other
  double phase = 0.0;        // [mesh period]
};

/// Bearing of one planet on its pin.
struct PlanetBearing {
  Eigen::Index planet_index = 0;  // in the layout
  DeflectionVector radial;
  DeflectionVector tangential;
  Eigen::Vector2d pin_error = Eigen::Vector2d::Zero();  // [m]
  DeflectionVector rotation;  // [1/m]  of the planet relative to the carrier, in radians
};

/// All constants of a run.
struct SetModel {
  SetLayout layout;
  SetParameters parameters;
  Operation operation;
  std::vector<double> planet_angles;    // [rad]  of the planets on the carrier, anticlockwise
  std::vector<PlanetMesh> meshes;       // sun meshes of all planets, then ring meshes
  std::vector<PlanetBearing> bearings;  // (planets)
  Eigen::VectorXd mass;                 // [kg]    (freedoms)
  Eigen::VectorXd mobility;             // [1/kg]  (freedoms)  1 / mass; 0 where the housing holds
  Eigen::Index load_index = -1;  // of the u that delivers the power; -1: none, or the load does not yield
  double load_share = 0.0;       // [1/m]   force on it for each moment of a bearing on its planet; Eq. (16)

  const Mesh& mesh(MeshKind kind) const {
    return kind == MeshKind::sun ? parameters.sun_mesh : parameters.ring_mesh;
  }
};

/// Speeds at one instant, as factors on the nominal ones.
struct SpeedState {
  double factor = 1.0;  // [-]
  double rate = 0.0;    // [1/s]
};

/// Gives meshes of loaded teeth the stiffness that they have about their mean load; without one they keep
/// what they have. Done by set_model().
void linearise_meshes(SetParameters& set, const Operation& operation);

/// Throws std::invalid_argument, with what was found and what is required, where a mass, a stiffness or a
/// number of phases leaves the equations without meaning.
SetModel set_model(SetParameters parameters, const Operation& operation);

/// Speed factor at `time` [s].
SpeedState speed_at(const Operation& operation, double time);

/// Mesh periods since time zero.
double mesh_periods(const Operation& operation, double time);

/// The time [s] in which the nominal speeds would give the angles turned by `time` [s].
double nominal_time(const Operation& operation, double time);

/// The carrier's nominal angle [rad] since time zero.
double carrier_angle(const Operation& operation, double time);

/// The time [s] at which so many mesh periods have passed; inverse of `mesh_periods`.
double time_of_periods(const Operation& operation, double periods);

/// Places of the common mesh period, in [0, 1) and ascending, where the stiffness or the error of some mesh
/// jumps.
std::vector<double> jump_phases(const SetModel& model);

/// The same set with each mesh at its mean stiffness and mean error; loaded teeth as the spring that they are
/// about the mean load.
SetModel averaged(const SetModel& model);

}  // namespace orbearing::gearset::dynamics
