// Force of one mesh: springs of both flanks that push only, a damper in parallel; their stiffness prescribed,
// or teeth that touch as the load closes their gaps.
#pragma once

#include <algorithm>

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// Phase common to all meshes at one instant.
struct MeshClock {
  double periods = 0.0;    // [mesh period]
  double frequency = 0.0;  // [Hz]
};

inline MeshClock mesh_clock(const Operation& operation, double time) {
  return {mesh_periods(operation, time), operation.mesh_frequency * speed_at(operation, time).factor};
}

/// Quantities of a mesh at one instant that depend on time only.
struct MeshExcitation {
  double phase = 0.0;           // [mesh period]
  double frequency = 0.0;       // [Hz]
  double stiffness = 0.0;       // [N/m]    not of loaded teeth
  double stiffness_rate = 0.0;  // [N/m/s]  not of loaded teeth
  double error = 0.0;           // [m]
  double error_rate = 0.0;      // [m/s]
};

inline MeshExcitation excitation(const Mesh& mesh, double phase, const MeshClock& clock) {
  const double in_period = clock.periods + phase;
  const CurvePoint stiffness = mesh.loaded ? CurvePoint{} : mesh.stiffness.at(in_period);
  const CurvePoint error = mesh.error.at(in_period);
  return {in_period,       clock.frequency,
          stiffness.value, stiffness.slope * clock.frequency,
          error.value,     error.slope * clock.frequency};
}

/// One flank of a mesh.
struct FlankForce {
  double approach = 0.0;       // [m]    of the teeth, error and half the backlash taken off
  double approach_rate = 0.0;  // [m/s]
  double elastic = 0.0;        // [N]    positive: teeth push
  double damping = 0.0;        // [N]    added to it; their sum never pulls where teeth can separate
  double stiffness = 0.0;      // [N/m]  slope of `elastic` by the approach
  double energy = 0.0;         // [J]    of which `elastic` is the slope
  double energy_rate = 0.0;    // [W]    of the energy at a fixed approach

  double total() const { return elastic + damping; }
};

/// The elastic part of a flank: a spring of the instant's stiffness, or loaded teeth. Eq. (5) of
/// gearset/dynamics/README.md.
inline FlankForce elastic_flank(const Mesh& mesh, const MeshExcitation& now, double approach,
                                double approach_rate) {
  if (mesh.loaded) {
    const ToothForce teeth = mesh.loaded->at(now.phase, approach);
    return {approach,
            approach_rate,
            teeth.force,
            0.0,
            teeth.stiffness,
            teeth.energy,
            teeth.energy_by_phase * now.frequency};
  }
  const double half_square = 0.5 * approach * approach;
  return {approach,
          approach_rate,
          now.stiffness * approach,
          0.0,
          now.stiffness,
          now.stiffness * half_square,
          now.stiffness_rate * half_square};
}

/// The same with the damper; nothing where the teeth are apart.
inline FlankForce flank_force(const Mesh& mesh, bool separation, const MeshExcitation& now, double approach,
                              double approach_rate) {
  if (separation && approach <= 0.0) return {.approach = approach, .approach_rate = approach_rate};
  FlankForce force = elastic_flank(mesh, now, approach, approach_rate);
  if (!separation)
    force.damping = mesh.damping * approach_rate;
  else if (force.elastic > 0.0)
    force.damping = std::max(-force.elastic, mesh.damping * approach_rate);
  return force;
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
  force.loaded =
      flank_force(law, separation, now, mesh.loaded.of(q, mesh.central, mesh.planet_index) - now.error - gap,
                  mesh.loaded.of(v, mesh.central, mesh.planet_index) - now.error_rate);
  if (separation)
    force.back = flank_force(law, separation, now, mesh.back.of(q, mesh.central, mesh.planet_index) - gap,
                             mesh.back.of(v, mesh.central, mesh.planet_index));
  return force;
}

}  // namespace orbearing::gearset::dynamics
