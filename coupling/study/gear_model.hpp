// The dynamic model of a planetary set from its geometry and from what the user states beside it.
#pragma once

#include <optional>
#include <vector>

#include "coupling/study/drivetrain.hpp"
#include "gearset/dynamics/model.hpp"
#include "gearset/mesh/planetary_meshes.hpp"

namespace orbearing::study {

/// Sun, ring, carrier or planet: values that stand in for derived ones, and how the housing holds it.
struct GearMemberChoice {
  std::optional<double> mass;      // [kg]   none: from the geometry
  std::optional<double> inertia;   // [kg]   moment of inertia / radius^2; none: from the geometry
  double support_stiffness = 0.0;  // [N/m]  not of planets
  double torsional_stiffness =
      0.0;  // [N/m]  on radius x angle; 0: free, or held where it is the fixed member
};

/// What the dynamics of the gears need beyond teeth and drive.
struct GearDynamicsChoice {
  GearMemberChoice sun;
  GearMemberChoice ring;
  GearMemberChoice carrier;
  GearMemberChoice planet;
  std::optional<double> bearing_stiffness;    // [N/m]  of all bearings of a planet
  std::optional<double> sun_mesh_stiffness;   // [N/m]  constant; none: from tooth geometry
  std::optional<double> ring_mesh_stiffness;  // [N/m]
  double mesh_damping_ratio = 0.0;            // [-]  of both gears turning on their mesh
  double bearing_damping_ratio = 0.0;         // [-]  of a planet on its bearings
  double support_damping_ratio = 0.0;         // [-]  of a member on its support
  double backlash = 0.0;                      // [m]  along the line of action
  bool separation = true;
  double carrier_plate_ratio = 0.5;  // [-]  thickness of both plates of the carrier / face width
  gearset::BodyRatios bodies;
  std::vector<double> sun_error;             // [m]  at equal steps of a mesh period; empty: none
  std::vector<double> ring_error;            // [m]
  std::vector<double> pin_error_radial;      // [m]  (planets) or empty
  std::vector<double> pin_error_tangential;  // [m]
  gearset::dynamics::RunUp run_up;
  gearset::dynamics::FrameSwitches frame;
};

/// A set that is stated by masses and stiffnesses alone. All optional values of `choice` must be there.
gearset::dynamics::SetParameters lumped_set(const GearDynamicsChoice& choice, int planets,
                                            double pressure_angle);

/// A set with teeth. Masses, inertias and mesh stiffness follow from geometry where `choice` has none.
/// @param planet_rings [kg] of rings of the bearings that turn with a planet
/// @param bearing_stiffness [N/m] where `choice` has none
gearset::dynamics::SetParameters geometric_set(const GearDynamicsChoice& choice,
                                               const gearset::PlanetarySet& set,
                                               const gearset::WorkingGeometry& geometry,
                                               const gearset::PlanetaryMeshes& meshes, double planet_rings,
                                               double bearing_stiffness);

/// A curve through samples at equal steps of the period: the trigonometric polynomial of least order.
/// No samples: zero.
gearset::PeriodicCurve curve_through(const std::vector<double>& samples);

}  // namespace orbearing::study
