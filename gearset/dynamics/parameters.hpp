// Parameters of the bodies, springs and meshes of a planetary set, and of its drive.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gearset/kinematics.hpp"
#include "gearset/mesh/loaded/loaded_teeth.hpp"
#include "gearset/mesh/periodic_curve.hpp"
#include "gearset/parameters.hpp"
#include "mechanics/described.hpp"

namespace orbearing::gearset::dynamics {

// Rows of the bodies in a case; their values replace those derived from the teeth.

inline std::string described_body(const std::string& name) {
  return "gearset.dynamics." + name;
}
/// On which the inertia of a body counts.
inline std::string radius_of(const std::string& body) {
  return body == "carrier" ? "centre distance" : "base radius";
}
inline described::Details described_mass() {
  using namespace described;
  return {.dimension = dimension::mass, .range = positive(1e6), .required_without_teeth = true};
}
inline described::Details described_stiffness(std::string_view reason) {
  using namespace described;
  return {.dimension = dimension::stiffness, .range = {0.0, 1e13}, .reason = reason};
}
/// Only what a case may leave out is optional.
template <class Member>
std::string if_absent(const std::string& what) {
  return described::is_optional<Member> ? "; " + what + " if absent" : "";
}
template <class Member>
described::Row<Member> mass_row(Member& mass, const std::string& body) {
  const std::string rings = body == "planet" ? " with the outer rings of its bearings" : "";
  return input(mass, described_body(body) + ".mass",
               "mass of the " + body + rings + if_absent<Member>("derived from the teeth"), described_mass());
}
template <class Member>
described::Row<Member> inertia_row(Member& inertia, const std::string& body) {
  return input(inertia, described_body(body) + ".equivalent_mass",
               "moment of inertia of the " + body + " over the square of its " + radius_of(body) +
                   if_absent<Member>("derived from the teeth"),
               described_mass());
}
/// @param reason why so stiff where a case does not say
inline described::Row<double> support_row(double& stiffness, const std::string& body,
                                          std::string_view reason = {}) {
  return input(stiffness, described_body(body) + ".support_stiffness",
               "support stiffness of the " + body + ", 0: floating", described_stiffness(reason));
}
inline described::Row<double> torsional_row(double& stiffness, const std::string& body) {
  return input(stiffness, described_body(body) + ".torsional_stiffness",
               "stiffness against rotation of the " + body + ", on " + radius_of(body) + " x angle",
               described_stiffness("free to rotate; a fixed member is then held rigidly"));
}
template <class Member>
described::Row<Member> bearing_stiffness_row(Member& stiffness) {
  using namespace described;
  return input(stiffness, described_body("planet") + ".bearing_stiffness",
               "radial stiffness of all bearings of a planet and their pins" +
                   if_absent<Member>("of the given bearing at its mean load"),
               {.dimension = dimension::stiffness,
                .range = positive(1e13),
                .reason = "two roller bearings of a planet of some 70 mm, loaded",
                .default_without_bearing = true});
}

/// Support of a central member by the housing. Rotations count as u = radius x angle.
struct Support {
  double stiffness = 0.0;            // [N/m]    x and y; 0: floating
  double damping = 0.0;              // [N s/m]  x and y
  double torsional_stiffness = 0.0;  // [N/m]    on u; 0: free to turn
  double torsional_damping = 0.0;    // [N s/m]  on u
  bool held = false;                 // x and y are zero, whatever the force
  bool held_in_rotation = false;     // u is zero
};

/// Rows of structures below `body` are those of an FMU's model, in its order.
template <class Visitor>
void describe(Visitor& visit, Support& m, const std::string& body) {
  using namespace described;
  const std::string path = described_body(body);
  const Details damping{.dimension = dimension::damping, .range = {.least = 0.0}};
  members(visit, m, support_row(m.stiffness, body),
          internal(m.damping, path + ".support_damping", "radial damping between " + body + " and housing",
                   damping),
          torsional_row(m.torsional_stiffness, body),
          internal(m.torsional_damping, path + ".torsional_damping",
                   "damping between " + body + " and housing on radius x angle", damping),
          internal(m.held, path + ".held"), internal(m.held_in_rotation, path + ".held_in_rotation"));
}

/// Sun, ring or carrier.
struct CentralMember {
  double mass = 0.0;     // [kg]
  double inertia = 0.0;  // [kg]  moment of inertia / radius^2
  double radius = 0.0;   // [m]   base radius of sun and ring, centre distance for the carrier
  Support support;
};

template <class Visitor>
void describe(Visitor& visit, CentralMember& m, const std::string& body) {
  using namespace described;
  members(visit, m, mass_row(m.mass, body), inertia_row(m.inertia, body),
          internal(m.radius, described_body(body) + ".radius"),
          part(m.support, [&] { describe(visit, m.support, body); }));
}

/// Bearings of a planet that need not be alike in all directions. With the displacement d [m] of the planet's
/// axis from its pin's, outward and in the sense of rotation, they exert on the planet
///   force - stiffness d - damping d'.
struct AffineBearing {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();      // [N]      at no displacement
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  // [N/m]
  Eigen::Matrix2d damping = Eigen::Matrix2d::Zero();    // [N s/m]
};

/// Meshes and bearings of a planet whose rim links them. Affects the linearised set.
struct LinkedPlanet {
  /// [N/m]  forces by the deflections of sun mesh, ring mesh and bearings, outward and in the sense of
  /// rotation
  Eigen::Matrix4d stiffness = Eigen::Matrix4d::Zero();
};

/// All planets are alike.
struct PlanetMember {
  double mass = 0.0;               // [kg]
  double inertia = 0.0;            // [kg]     moment of inertia / radius^2
  double radius = 0.0;             // [m]      base radius
  double bearing_stiffness = 0.0;  // [N/m]    planet to carrier, radial and tangential; all its bearings
  double bearing_damping = 0.0;    // [N s/m]  the same
  bool coupled_bearing = false;    // forces come through a port; the two above are not used
  std::optional<AffineBearing> affine_bearing;  // instead of the stiffness and damping above
  std::optional<LinkedPlanet> linked;           // instead of its own and of the mean stiffness of its meshes
};

template <class Visitor>
void describe(Visitor& visit, PlanetMember& m) {
  using namespace described;
  const std::string path = described_body("planet");
  Row<double> stiffness = bearing_stiffness_row(m.bearing_stiffness);
  stiffness.facts.meaning += "; serves only to find the state in which the run begins";
  members(visit, m, mass_row(m.mass, "planet"), inertia_row(m.inertia, "planet"),
          internal(m.radius, path + ".radius"), stiffness,
          internal(m.bearing_damping, path + ".bearing_damping"),
          internal(m.coupled_bearing, path + ".coupled_bearing"), apart(m.affine_bearing),
          apart(m.linked));  // not of FMUs
}

/// Sun or ring mesh, alike for all planets but for its phase.
struct Mesh {
  double pressure_angle = 0.0;  // [rad]    working
  PeriodicCurve stiffness;      // [N/m]    along the line of action, over a mesh period; where the teeth are
                                //          loaded ones, about the mean load
  PeriodicCurve error;    // [m]      transmission error of unloaded teeth: positive where material lacks
  double damping = 0.0;   // [N s/m]  while in contact
  double backlash = 0.0;  // [m]      between both flanks, along the line of action
  std::shared_ptr<const LoadedTeeth> loaded{};  // none: the force is stiffness times approach
  double free_approach =
      0.0;  // [m]  of loaded teeth at which a spring of the mean stiffness, which has their
            //      mean force at the mean load, would be free
};

template <class Visitor>
void describe(Visitor& visit, Mesh& m, const std::string& name) {
  using namespace described;
  const std::string path = described_body(name + "_mesh.");
  const Range not_negative{.least = 0.0};
  members(
      visit, m, internal(m.pressure_angle, path + "pressure_angle"),
      internal(m.damping, path + "damping", "damping of the " + name + " mesh while in contact",
               {.dimension = dimension::damping, .range = not_negative}),
      internal(m.backlash, path + "backlash", "backlash of the " + name + " mesh along the line of action",
               {.dimension = dimension::length, .range = not_negative}),
      internal(m.stiffness, path + "stiffness"), internal(m.error, path + "error"),
      internal(m.loaded, path + "loaded_teeth"), internal(m.free_approach, path + "free_approach"));
}

/// Terms of the carrier's rotation that act on the bodies.
struct FrameSwitches {
  bool coriolis = true;
  bool centrifugal = true;
  bool euler = true;
};

template <class Visitor>
void describe(Visitor& visit, FrameSwitches& m) {
  using namespace described;
  members(visit, m, internal(m.coriolis, "inertia.coriolis"),
          internal(m.centrifugal, "inertia.carrier_centrifugal"), internal(m.euler, "inertia.euler"));
}

/// One planetary set.
struct SetParameters {
  int planets = 0;
  std::vector<double> planet_angles;  // [rad]  (planets)  anticlockwise; empty: 2 pi n / planets
  CentralMember sun;
  CentralMember ring;
  CentralMember carrier;
  PlanetMember planet;
  Mesh sun_mesh;
  Mesh ring_mesh;
  std::vector<double> sun_phase;   // [mesh period]  (planets)  added to the common phase
  std::vector<double> ring_phase;  // [mesh period]  (planets)
  Eigen::Matrix2Xd pin_error;  // [m]  (radial and tangential, planets)  of the pin in the carrier; or empty
  FrameSwitches frame;
  double gravity = 0.0;    // [m/s^2]  across the axis, on planets only; 0: without weight
  bool separation = true;  // teeth push only, beyond half the backlash; false: they also pull
};

template <class Visitor>
void describe(Visitor& visit, SetParameters& m) {
  using namespace described;
  members(visit, m, internal(m.planets, "gearset.planets", "number of planets", {.range = positive()}),
          internal(m.planet_angles, "gearset.planet_angles"), part(m.planet),
          part(m.sun, [&] { describe(visit, m.sun, "sun"); }),
          part(m.ring, [&] { describe(visit, m.ring, "ring"); }),
          part(m.carrier, [&] { describe(visit, m.carrier, "carrier"); }),
          part(m.sun_mesh, [&] { describe(visit, m.sun_mesh, "sun"); }),
          part(m.ring_mesh, [&] { describe(visit, m.ring_mesh, "ring"); }),
          internal(m.sun_phase, "gearset.sun_phase"), internal(m.ring_phase, "gearset.ring_phase"),
          internal(m.pin_error, "gearset.dynamics.pin_error"), part(m.frame), apart(m.gravity),
          internal(m.separation, "gearset.dynamics.separation"));
}

/// Speed of all members over time: the factor on the nominal speeds goes from `from` to 1 at a constant rate.
struct RunUp {
  double from = 1.0;      // [-]  greater than 0
  double duration = 0.0;  // [s]  0: the nominal speed from the start
};
template <class Visitor>
void describe(Visitor& visit, RunUp& m) {
  using namespace described;
  members(visit, m, internal(m.from, "gearset.dynamics.run_up.from"),
          internal(m.duration, "gearset.dynamics.run_up.duration", "", {.dimension = dimension::time}));
}

/// Speeds and torques at which the set runs.
struct Operation {
  Member driven = Member::sun;
  double power = 0.0;           // [W]   enters by the driven member, whatever its speed
  Speeds speeds;                // [rad/s]  nominal
  Torques torques;              // [N m]    external, in equilibrium at nominal speed
  double mesh_frequency = 0.0;  // [Hz]  at nominal speed
  RunUp run_up;
  /// True: the load torque decreases by the friction moments of coupled bearings, and the set keeps its mean
  /// speed. False: the load torque is constant, and friction slows the set down.
  bool load_yields = true;
};

template <class Visitor>
void describe(Visitor& visit, Operation& m) {
  using namespace described;
  members(
      visit, m, internal(m.driven, "input.member"), internal(m.power, "input.power"),
      together(internal(m.speeds.sun, "operation.sun_speed"), internal(m.speeds.ring, "operation.ring_speed"),
               internal(m.speeds.carrier, "operation.carrier_speed"),
               internal(m.speeds.planet_relative, "operation.planet_speed")),
      together(internal(m.torques.sun, "operation.sun_torque"),
               internal(m.torques.ring, "operation.ring_torque"),
               internal(m.torques.carrier, "operation.carrier_torque")),
      internal(m.mesh_frequency, "operation.mesh_frequency"),
      internal(m.load_yields, "operation.load_yields"),
      together(internal(m.run_up.from, "gearset.dynamics.run_up.from"),
               internal(m.run_up.duration, "gearset.dynamics.run_up.duration")));
}

/// Operation of a set whose tooth numbers are known.
/// @throws std::invalid_argument as member_speeds and member_torques
Operation operation_of(const PlanetarySet& set, const Drive& drive);

}  // namespace orbearing::gearset::dynamics
