#include "coupling/fmu/gear_fields.hpp"

namespace orbearing::fmu {

namespace {

using Setup = GearModel;
using GearFields = FieldList<Setup>;
using enum Use;
using enum Allowed;

const std::string kBlock = "gearset.dynamics.";

// `member` gives sun, ring or carrier of a setup.
template <class Member>
void add_central(GearFields& f, const std::string& name, Member member) {
  const std::string path = kBlock + name;
  f.number(
       {path + ".mass", "kg", "mass of the " + name, parameter, positive},
       [member](auto& s) -> auto& { return member(s).mass; })
      .number(
          {path + ".equivalent_mass", "kg", "moment of inertia of the " + name + " over its radius squared",
           parameter, positive},
          [member](auto& s) -> auto& { return member(s).inertia; })
      .number(
          {path + ".radius"}, [member](auto& s) -> auto& { return member(s).radius; })
      .number(
          {path + ".support_stiffness", "N/m", "radial stiffness between " + name + " and housing", parameter,
           not_negative},
          [member](auto& s) -> auto& { return member(s).support.stiffness; })
      .number(
          {path + ".support_damping", "N.s/m", "radial damping between " + name + " and housing", parameter,
           not_negative},
          [member](auto& s) -> auto& { return member(s).support.damping; })
      .number(
          {path + ".torsional_stiffness", "N/m",
           "stiffness between " + name + " and housing on radius x angle", parameter, not_negative},
          [member](auto& s) -> auto& { return member(s).support.torsional_stiffness; })
      .number(
          {path + ".torsional_damping", "N.s/m", "damping between " + name + " and housing on radius x angle",
           parameter, not_negative},
          [member](auto& s) -> auto& { return member(s).support.torsional_damping; })
      .number(
          {path + ".held_in_place"}, [member](auto& s) -> auto& { return member(s).support.held_in_place; })
      .number(
          {path + ".held_in_rotation"}, [member](auto& s) -> auto& {
            return member(s).support.held_in_rotation;
          });
}

void add_planet(GearFields& f) {
  const std::string path = kBlock + "planet";
  f.number(
       {"gearset.planets", "1", "number of planets", constant, positive},
       [](auto& s) -> auto& { return s.setup.set.planets; })
      .number(
          {path + ".mass", "kg", "mass of a planet with the outer rings of its bearings", parameter,
           positive},
          [](auto& s) -> auto& { return s.setup.set.planet.mass; })
      .number(
          {path + ".equivalent_mass", "kg", "moment of inertia of a planet over its base radius squared",
           parameter, positive},
          [](auto& s) -> auto& { return s.setup.set.planet.inertia; })
      .number(
          {path + ".radius"}, [](auto& s) -> auto& { return s.setup.set.planet.radius; })
      .number(
          {path + ".bearing_stiffness", "N/m",
           "of all bearings of a planet; serves only to find the state in which the run begins", parameter,
           positive},
          [](auto& s) -> auto& { return s.setup.set.planet.bearing_stiffness; })
      .number(
          {path + ".bearing_damping"}, [](auto& s) -> auto& { return s.setup.set.planet.bearing_damping; })
      .number(
          {path + ".coupled_bearing"}, [](auto& s) -> auto& { return s.setup.set.planet.coupled_bearing; });
}

template <class Member>
void add_mesh(GearFields& f, const std::string& name, Member member) {
  const auto add_curve = [&](const std::string& path, auto curve) {
    f.list(
        path, [curve](const Setup& s) { return curve(s).numbers(); },
        [curve](Setup& s, const std::vector<double>& numbers) {
          curve(s) = gearset::PeriodicCurve::from_numbers(numbers);
        });
  };
  const std::string path = kBlock + name + "_mesh.";
  f.number(
       {path + "pressure_angle"}, [member](auto& s) -> auto& { return member(s).pressure_angle; })
      .number(
          {path + "damping", "N.s/m", "damping of the " + name + " mesh while in contact", parameter,
           not_negative},
          [member](auto& s) -> auto& { return member(s).damping; })
      .number(
          {path + "backlash", "m", "backlash of the " + name + " mesh along the line of action", parameter,
           not_negative},
          [member](auto& s) -> auto& { return member(s).backlash; });
  add_curve(
      path + "stiffness", [member](auto& s) -> auto& { return member(s).stiffness; });
  add_curve(
      path + "error", [member](auto& s) -> auto& { return member(s).error; });
}

template <class Member>
void add_list(GearFields& f, const char* name, Member member) {
  f.list(
      name, [member](const Setup& s) { return member(s); },
      [member](Setup& s, const std::vector<double>& numbers) { member(s) = numbers; });
}

void add_phases(GearFields& f) {
  add_list(
      f, "gearset.sun_phase", [](auto& s) -> auto& { return s.setup.set.sun_phase; });
  add_list(
      f, "gearset.ring_phase", [](auto& s) -> auto& { return s.setup.set.ring_phase; });
  f.list(
      "gearset.dynamics.pin_error",
      [](const Setup& s) {
        const Eigen::Matrix2Xd& error = s.setup.set.pin_error;
        return std::vector<double>(error.data(), error.data() + error.size());
      },
      [](Setup& s, const std::vector<double>& numbers) {
        s.setup.set.pin_error = Eigen::Map<const Eigen::Matrix2Xd>(
            numbers.data(), 2, static_cast<Eigen::Index>(numbers.size() / 2));
      });
}

void add_start(GearFields& f) {
  add_list(
      f, "operation.planet_force", [](auto& s) -> auto& { return s.start_force; });
}

void add_frame(GearFields& f) {
  f.number(
       {"inertia.coriolis"}, [](auto& s) -> auto& { return s.setup.set.frame.coriolis; })
      .number(
          {"inertia.carrier_centrifugal"}, [](auto& s) -> auto& { return s.setup.set.frame.centrifugal; })
      .number(
          {"inertia.euler"}, [](auto& s) -> auto& { return s.setup.set.frame.euler; })
      .number(
          {kBlock + "separation"}, [](auto& s) -> auto& { return s.setup.set.separation; });
}

void add_operation(GearFields& f) {
  f.number(
       {"input.member"}, [](auto& s) -> auto& { return s.setup.operation.driven; })
      .number(
          {"input.power"}, [](auto& s) -> auto& { return s.setup.operation.power; })
      .number(
          {"operation.sun_speed"}, [](auto& s) -> auto& { return s.setup.operation.speeds.sun; })
      .number(
          {"operation.ring_speed"}, [](auto& s) -> auto& { return s.setup.operation.speeds.ring; })
      .number(
          {"operation.carrier_speed"}, [](auto& s) -> auto& { return s.setup.operation.speeds.carrier; })
      .number(
          {"operation.planet_speed"},
          [](auto& s) -> auto& { return s.setup.operation.speeds.planet_relative; })
      .number(
          {"operation.sun_torque"}, [](auto& s) -> auto& { return s.setup.operation.torques.sun; })
      .number(
          {"operation.ring_torque"}, [](auto& s) -> auto& { return s.setup.operation.torques.ring; })
      .number(
          {"operation.carrier_torque"}, [](auto& s) -> auto& { return s.setup.operation.torques.carrier; })
      .number(
          {"operation.mesh_frequency"}, [](auto& s) -> auto& { return s.setup.operation.mesh_frequency; })
      .number(
          {"operation.load_yields"}, [](auto& s) -> auto& { return s.setup.operation.load_yields; })
      .number(
          {kBlock + "run_up.from"}, [](auto& s) -> auto& { return s.setup.operation.run_up.from; })
      .number(
          {kBlock + "run_up.duration"}, [](auto& s) -> auto& { return s.setup.operation.run_up.duration; })
      .number(
          {"simulation.error_share", "1", "allowed error of one internal step over the mean mesh deflection",
           parameter, positive},
          [](auto& s) -> auto& { return s.setup.allowed_share; })
      .number(
          {"simulation.most_steps"}, [](auto& s) -> auto& { return s.setup.most_steps; });
}

}  // namespace

std::vector<SetupField<Setup>> gear_fields() {
  GearFields fields;
  add_planet(fields);
  add_central(
      fields, "sun", [](auto& s) -> auto& { return s.setup.set.sun; });
  add_central(
      fields, "ring", [](auto& s) -> auto& { return s.setup.set.ring; });
  add_central(
      fields, "carrier", [](auto& s) -> auto& { return s.setup.set.carrier; });
  add_mesh(
      fields, "sun", [](auto& s) -> auto& { return s.setup.set.sun_mesh; });
  add_mesh(
      fields, "ring", [](auto& s) -> auto& { return s.setup.set.ring_mesh; });
  add_phases(fields);
  add_frame(fields);
  add_operation(fields);
  add_start(fields);
  return fields.fields();
}

NumberTable numbers_of(const GearModel& model) {
  return numbers_of_fields("gearset", gear_fields(), model);
}

GearModel gears_from(const NumberTable& numbers) {
  return setup_from<Setup>(gear_fields(), numbers);
}

}  // namespace orbearing::fmu
