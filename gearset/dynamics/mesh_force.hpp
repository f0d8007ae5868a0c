// Force of one mesh: springs of both flanks that push only, a damper in parallel, prescribed stiffness.
#pragma once

#include <algorithm>

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// Stiffness and error of a mesh at one instant, with their rates.
struct MeshExcitation {
  double stiffness = 0.0;       // [N/m]
  double stiffness_rate = 0.0;  // [N/m/s]
  double error = 0.0;           // [m]
  double error_rate = 0.0;      // [m/s]
};

/// Common place in the mesh period at one instant.
struct MeshClock {
  double periods = 0.0;    // [mesh period]
  double frequency = 0.0;  // [Hz]
};

inline MeshClock mesh_clock(const Operation& operation, double time) {
  return {mesh_periods(operation, time), operation.mesh_frequency * speed_at(operation, time).factor};
}

inline MeshExcitation excitation(const Mesh& mesh, double phase, const MeshClock& clock) {
  const CurvePoint stiffness = mesh.stiffness.at(clock.periods + phase);
  const CurvePoint error = mesh.error.at(clock.periods + phase);
  return {stiffness.value, stiffness.slope * clock.frequency, error.value, error.slope * clock.frequency};
}

/// One flank of a mesh.
struct FlankForce {
  double approach = 0.0;       // [m]    of the teeth, error and half the backlash taken off
  double approach_rate = 0.0;  // [m/s]
  double elastic = 0.0;        // [N]    positive: teeth push
  double damping = 0.0;        // [N]    added to it; their sum never pulls where teeth can separate

  double total() const { return elastic + damping; }
};

/// Eq. (5) of gearset/dynamics/README.md.
inline FlankForce flank_force(const Mesh& mesh, bool separation, double stiffness, double approach,
                              double approach_rate) {
  if (!separation) return {approach, approach_rate, stiffness * approach, mesh.damping * approach_rate};
  if (approach <= 0.0) return {approach, approach_rate, 0.0, 0.0};
  const double elastic = stiffness * approach;
  return {approach, approach_rate, elastic, std::max(-elastic, mesh.damping * approach_rate)};
}

/// Both flanks of one mesh.
struct MeshForce {
  FlankForce loaded;
  FlankForce back;
};

/// @param q, v positions and velocities (freedoms)
inline MeshForce mesh_force(const SetModel& model, const PlanetMesh& mesh, const MeshExcitation& now,
                            const Eigen::Ref<const Eigen::VectorXd>& q,
                            const Eigen::Ref<const Eigen::VectorXd>& v) {
  const Mesh& law = model.mesh(mesh.kind);
  const bool separation = model.parameters.separation;
  const double gap = separation ? 0.5 * law.backlash : 0.0;
  MeshForce force;
  force.loaded = flank_force(law, separation, now.stiffness,
                             mesh.loaded.of(q, mesh.central, mesh.place) - now.error - gap,
                             mesh.loaded.of(v, mesh.central, mesh.place) - now.error_rate);
  if (separation)
    force.back = flank_force(law, separation, now.stiffness, mesh.back.of(q, mesh.central, mesh.place) - gap,
                             mesh.back.of(v, mesh.central, mesh.place));
  return force;
}

}  // namespace orbearing::gearset::dynamics
