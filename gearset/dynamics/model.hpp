// The planetary set with all constants of a run: bodies, deflection vectors, phases, speeds over time.
#pragma once

#include <vector>

#include "gearset/dynamics/deflection.hpp"
#include "gearset/dynamics/layout.hpp"
#include "gearset/dynamics/parameters.hpp"

namespace orbearing::gearset::dynamics {

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

/// The time [s] at which so many mesh periods have passed; inverse of `mesh_periods`.
double time_of_periods(const Operation& operation, double periods);

/// Places of the common mesh period, in [0, 1) and ascending, where the stiffness or the error of some mesh
/// jumps.
std::vector<double> jump_phases(const SetModel& model);

/// The same set with each mesh at its mean stiffness and mean error; loaded teeth as the spring that they are
/// about the mean load.
SetModel averaged(const SetModel& model);

}  // namespace orbearing::gearset::dynamics
