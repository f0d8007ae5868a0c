// The dynamic model of a planetary set from its geometry and from additional parameters.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/analysis/drivetrain.hpp"
#include "gearset/dynamics/model.hpp"
#include "gearset/mesh/planetary_meshes.hpp"

namespace orbearing::analysis {

/// Sun, ring, carrier or planet: values that replace derived ones, and its support by the housing.
struct GearMemberChoice {
  std::optional<double> mass;      // [kg]   none: from the geometry
  std::optional<double> inertia;   // [kg]   moment of inertia / radius^2; none: from the geometry
  double support_stiffness = 0.0;  // [N/m]  not of planets
  double torsional_stiffness =
      0.0;  // [N/m]  on radius x angle; 0: free, or held where it is the fixed member
};

/// Parameters of the gear dynamics besides teeth and drive.
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

/// Rows of a body that the housing holds; `support`: why so stiffly where a case does not say.
template <class Visitor>
void describe_central(Visitor& visit, GearMemberChoice& m, const std::string& name,
                      std::string_view support) {
  using namespace gearset::dynamics;
  rows(visit, mass_row(m.mass, name), inertia_row(m.inertia, name),
       support_row(m.support_stiffness, name, support), torsional_row(m.torsional_stiffness, name));
}

/// Run-up and frame are stated by fields that they share, the bodies' ratios by those of the set.
template <class Visitor>
void describe(Visitor& visit, GearDynamicsChoice& m) {
  using namespace described;
  const std::string block = "gearset.dynamics.";
  const Details errors{.dimension = dimension::small_length, .range = {-1e5, 1e5}};
  Details pins = errors;
  pins.where = {"input.member"};
  const auto mesh = [&](std::optional<double>& member, const std::string& name) {
    return input(
        member, block + "mesh_stiffness." + name,
        "constant stiffness of the " + name + " mesh; from the teeth if absent",
        {.dimension = dimension::stiffness, .range = positive(1e13), .required_without_teeth = true});
  };
  members(
      visit, m, part(m.sun, [&] { describe_central(visit, m.sun, "sun", "a sun on a slender shaft"); }),
      part(m.ring, [&] { describe_central(visit, m.ring, "ring", "a ring bolted to its housing"); }),
      part(m.carrier, [&] { describe_central(visit, m.carrier, "carrier", "two bearings of the carrier"); }),
      together(gearset::dynamics::mass_row(m.planet.mass, "planet"),
               gearset::dynamics::inertia_row(m.planet.inertia, "planet")),
      gearset::dynamics::bearing_stiffness_row(m.bearing_stiffness),
      input(m.carrier_plate_ratio, block + "carrier.plate_ratio",
            "thickness of both side plates of the carrier as a share of the face width",
            {.range = positive(10.0),
             .reason = "the carrier's design is not given; discs that reach to the planets' rims"}),
      mesh(m.sun_mesh_stiffness, "sun"), mesh(m.ring_mesh_stiffness, "ring"),
      input(m.mesh_damping_ratio, block + "damping_ratio.mesh",
            "damping of the rotation of both gears on their mesh",
            {.range = {0.0, 2.0}, .reason = "typical of oiled steel gears"}),
      input(m.bearing_damping_ratio, block + "damping_ratio.bearing",
            "damping of a planet on its bearings; bearings of rollers have their own",
            {.range = {0.0, 2.0}, .reason = "oiled roller bearings in a steel structure"}),
      input(m.support_damping_ratio, block + "damping_ratio.support", "damping of a member on its support",
            {.range = {0.0, 2.0}, .reason = "bolted steel structure"}),
      input(m.backlash, block + "backlash", "backlash along the line of action",
            {.dimension = dimension::length,
             .range = {0.0, 100.0},
             .reason = "usual of modules of a few millimetres"}),
      input(m.separation, block + "separation",
            "teeth transmit compression only and can separate; false: they also transmit tension",
            {.reason = "nothing left out"}),
      input(m.sun_error, block + "transmission_error.sun",
            "missing material on the flanks of the sun mesh at equal steps of a mesh period that begins as a "
            "pair "
            "touches",
            errors),
      input(m.ring_error, block + "transmission_error.ring",
            "missing material on the flanks of the ring mesh at equal steps of a mesh period that begins as "
            "a pair "
            "touches",
            errors),
      input(m.pin_error_radial, block + "pin_error.radial",
            "radial position error of each pin, positive outward", pins),
      input(m.pin_error_tangential, block + "pin_error.tangential",
            "tangential position error of each pin, positive in the sense of rotation", pins),
      apart(m.bodies), apart(m.run_up), apart(m.frame));
}

/// A set that is stated by masses and stiffnesses only. All optional values of `choice` must be there.
/// @param angles [rad] of the planets; empty: at equal steps
gearset::dynamics::SetParameters lumped_set(const GearDynamicsChoice& choice, int planets,
                                            double pressure_angle, const std::vector<double>& positions = {});

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

}  // namespace orbearing::analysis
