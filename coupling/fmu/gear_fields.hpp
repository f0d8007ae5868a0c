// The setup of a driven gear set, described for FMUs.
#pragma once

#include <string>
#include <vector>

#include "coupling/fmu/number_table.hpp"
#include "coupling/system/driven_gears.hpp"
#include "mechanics/described.hpp"

namespace orbearing::fmu {

/// A gear set and the forces on its planets with which an FMU of it starts.
struct GearModel {
  cosim::DrivenGearsSetup setup;
  std::vector<double> start_force;  // [N], [N], [N m]  (planets)  outward, tangential, moment
};

namespace gear_rows {

using namespace described;

inline const std::string kBlock = "gearset.dynamics.";

inline Details shown(const Dimension& dimension, Range range) {
  return {.dimension = dimension, .range = range, .fmu = InFmu::parameter};
}
inline constexpr Range kNotNegative{.least = 0.0};

template <class Visitor>
void describe_support(Visitor& visit, const std::string& name, gearset::dynamics::Support& m) {
  const std::string path = kBlock + name;
  members(
      visit, m,
      internal(m.stiffness, path + ".support_stiffness", "radial stiffness between " + name + " and housing",
               shown(dimension::stiffness, kNotNegative)),
      internal(m.damping, path + ".support_damping", "radial damping between " + name + " and housing",
               shown(dimension::damping, kNotNegative)),
      internal(m.torsional_stiffness, path + ".torsional_stiffness",
               "stiffness between " + name + " and housing on radius x angle",
               shown(dimension::stiffness, kNotNegative)),
      internal(m.torsional_damping, path + ".torsional_damping",
               "damping between " + name + " and housing on radius x angle",
               shown(dimension::damping, kNotNegative)),
      internal(m.held_in_place, path + ".held_in_place"),
      internal(m.held_in_rotation, path + ".held_in_rotation"));
}

template <class Visitor>
void describe_central(Visitor& visit, const std::string& name, gearset::dynamics::CentralMember& m) {
  const std::string path = kBlock + name;
  members(visit, m,
          internal(m.mass, path + ".mass", "mass of the " + name, shown(dimension::mass, positive())),
          internal(m.inertia, path + ".equivalent_mass",
                   "moment of inertia of the " + name + " over its radius squared",
                   shown(dimension::mass, positive())),
          internal(m.radius, path + ".radius"),
          part(m.support, [&] { describe_support(visit, name, m.support); }));
}

template <class Visitor>
void describe_planet(Visitor& visit, gearset::dynamics::PlanetMember& m) {
  const std::string path = kBlock + "planet";
  members(visit, m,
          internal(m.mass, path + ".mass", "mass of a planet with the outer rings of its bearings",
                   shown(dimension::mass, positive())),
          internal(m.inertia, path + ".equivalent_mass",
                   "moment of inertia of a planet over its base radius squared",
                   shown(dimension::mass, positive())),
          internal(m.radius, path + ".radius"),
          internal(m.bearing_stiffness, path + ".bearing_stiffness",
                   "of all bearings of a planet; serves only to find the state in which the run begins",
                   shown(dimension::stiffness, positive())),
          internal(m.bearing_damping, path + ".bearing_damping"),
          internal(m.coupled_bearing, path + ".coupled_bearing"),
          apart(m.affine_bearing));  // not of FMUs
}

template <class Visitor>
void describe_mesh(Visitor& visit, const std::string& name, gearset::dynamics::Mesh& m) {
  const std::string path = kBlock + name + "_mesh.";
  members(
      visit, m, internal(m.pressure_angle, path + "pressure_angle"),
      internal(m.damping, path + "damping", "damping of the " + name + " mesh while in contact",
               shown(dimension::damping, kNotNegative)),
      internal(m.backlash, path + "backlash", "backlash of the " + name + " mesh along the line of action",
               shown(dimension::length, kNotNegative)),
      internal(m.stiffness, path + "stiffness"), internal(m.error, path + "error"));
}

template <class Visitor>
void describe_frame(Visitor& visit, gearset::dynamics::FrameSwitches& m) {
  members(visit, m, internal(m.coriolis, "inertia.coriolis"),
          internal(m.centrifugal, "inertia.carrier_centrifugal"), internal(m.euler, "inertia.euler"));
}

template <class Visitor>
void describe_set(Visitor& visit, gearset::dynamics::SetParameters& m) {
  members(visit, m,
          internal(m.planets, "gearset.planets", "number of planets",
                   {.range = positive(), .fmu = InFmu::constant}),
          part(m.planet, [&] { describe_planet(visit, m.planet); }),
          part(m.sun, [&] { describe_central(visit, "sun", m.sun); }),
          part(m.ring, [&] { describe_central(visit, "ring", m.ring); }),
          part(m.carrier, [&] { describe_central(visit, "carrier", m.carrier); }),
          part(m.sun_mesh, [&] { describe_mesh(visit, "sun", m.sun_mesh); }),
          part(m.ring_mesh, [&] { describe_mesh(visit, "ring", m.ring_mesh); }),
          internal(m.sun_phase, "gearset.sun_phase"), internal(m.ring_phase, "gearset.ring_phase"),
          internal(m.pin_error, "gearset.dynamics.pin_error"),
          part(m.frame, [&] { describe_frame(visit, m.frame); }),
          internal(m.separation, kBlock + "separation"));
}

template <class Visitor>
void describe_operation(Visitor& visit, gearset::dynamics::Operation& m) {
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
      together(internal(m.run_up.from, kBlock + "run_up.from"),
               internal(m.run_up.duration, kBlock + "run_up.duration")));
}

}  // namespace gear_rows

/// All that a gear set's future depends on beside its inputs, in a fixed order.
template <class Visitor>
void describe(Visitor& visit, GearModel& m) {
  using namespace gear_rows;
  cosim::DrivenGearsSetup& setup = m.setup;
  members(visit, setup, part(setup.set, [&] { describe_set(visit, setup.set); }),
          part(setup.operation, [&] { describe_operation(visit, setup.operation); }),
          internal(setup.allowed_share, "simulation.error_share",
                   "allowed error of one internal step over the mean mesh deflection",
                   {.range = positive(), .fmu = InFmu::parameter}),
          internal(setup.most_steps, "simulation.most_steps"));
  members(visit, m, apart(m.setup), internal(m.start_force, "operation.planet_force"));
}

NumberTable numbers_of(const GearModel& model);

/// Throws std::invalid_argument where a number is missing or makes no sense.
GearModel gears_from(const NumberTable& numbers);

}  // namespace orbearing::fmu
