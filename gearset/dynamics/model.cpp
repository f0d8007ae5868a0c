#include "gearset/dynamics/model.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "gearset/mesh/loaded/transmission_error.hpp"
#include "gearset/planet_angles.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset::dynamics {

std::vector<std::string> variable_names(const SetLayout& layout) {
  std::vector<std::string> bodies{"sun", "ring", "carrier"};
  for (Eigen::Index n = 1; n <= layout.planets; ++n) bodies.push_back("planet_" + std::to_string(n));
  std::vector<std::string> names;
  for (const std::string& body : bodies)
    for (const char* variable : {"_x [m]", "_y [m]", "_u [m]"}) names.push_back(body + variable);
  for (const std::string& body : bodies)
    for (const char* variable : {"_x_speed [m/s]", "_y_speed [m/s]", "_u_speed [m/s]"})
      names.push_back(body + variable);
  return names;
}

namespace {

// The back flank is the mirror image of the driving one: the pressure angle and the approach change sign.
struct Line {
  double sign;            // [-]
  double pressure_angle;  // [rad]
};

Line line_of(Flank flank, double pressure_angle) {
  return flank == Flank::driving ? Line{1.0, pressure_angle} : Line{-1.0, -pressure_angle};
}

}  // namespace

DeflectionVector sun_mesh_deflection(double planet_angle, double pressure_angle, Flank flank) {
  const auto [sign, alpha] = line_of(flank, pressure_angle);
  const double psi = planet_angle - alpha;
  return {sign * Eigen::Vector3d(-std::sin(psi), std::cos(psi), 1.0),
          sign * Eigen::Vector3d(-std::sin(alpha), -std::cos(alpha), 1.0)};
}

DeflectionVector ring_mesh_deflection(double planet_angle, double pressure_angle, Flank flank) {
  const auto [sign, alpha] = line_of(flank, pressure_angle);
  const double psi = planet_angle + alpha;
  return {sign * Eigen::Vector3d(-std::sin(psi), std::cos(psi), 1.0),
          sign * Eigen::Vector3d(std::sin(alpha), -std::cos(alpha), -1.0)};
}

DeflectionVector radial_bearing_deflection(double planet_angle) {
  return {{std::cos(planet_angle), std::sin(planet_angle), 0.0}, {-1.0, 0.0, 0.0}};
}

DeflectionVector tangential_bearing_deflection(double planet_angle) {
  return {{-std::sin(planet_angle), std::cos(planet_angle), 1.0}, {0.0, -1.0, 0.0}};
}

DeflectionVector planet_rotation(double carrier_radius, double planet_radius) {
  return {{0.0, 0.0, -1.0 / carrier_radius}, {0.0, 0.0, 1.0 / planet_radius}};
}

namespace {

using constants::two_pi;
using mechanics::require;
using mechanics::require_not_negative;
using mechanics::require_positive;

constexpr double same_phase = 1e-9;  // [mesh period]  jumps closer than this are one

void require_sound(const CentralMember& member) {
  require_positive(member.mass, "mass of a member of the gear set");
  require_positive(member.inertia, "inertia of a member of the gear set");
  require_positive(member.radius, "radius of a member of the gear set");
  for (const double value : {member.support.stiffness, member.support.damping,
                             member.support.torsional_stiffness, member.support.torsional_damping})
    require_not_negative(value, "stiffness or damping of a support");
}

void require_sound(const Mesh& mesh) {
  // Teeth of a contact ratio below 1 part for a share of each period: no stiffness there, not a negative one.
  require_not_negative(mesh.stiffness.least(), "least mesh stiffness");
  require_positive(mesh.stiffness.mean(), "mean mesh stiffness");
  require_not_negative(mesh.damping, "mesh damping");
  require_not_negative(mesh.backlash, "backlash");
  require(std::abs(mesh.pressure_angle) < 1.5, "working pressure angle", mesh.pressure_angle,
          "an angle well below a right one");
}

void require_sound(const SetParameters& set) {
  require(set.planets >= 1, "number of planets", set.planets, "at least 1");
  for (const CentralMember* member : {&set.sun, &set.ring, &set.carrier}) require_sound(*member);
  require_positive(set.planet.mass, "mass of a planet");
  require_positive(set.planet.inertia, "inertia of a planet");
  require_positive(set.planet.radius, "radius of a planet");
  require_not_negative(set.planet.bearing_stiffness, "stiffness of a planet's bearing");
  require_not_negative(set.planet.bearing_damping, "damping of a planet's bearing");
  if (const auto& law = set.planet.affine_bearing)
    require(law->force.allFinite() && law->stiffness.allFinite() && law->damping.allFinite(),
            "largest stiffness of a planet's bearing", law->stiffness.maxCoeff(),
            "finite numbers throughout");
  if (set.sun_mesh.loaded || set.ring_mesh.loaded)
    require(set.separation, "separation of loaded teeth", set.separation, "true: they push only");
  require_sound(set.sun_mesh);
  require_sound(set.ring_mesh);
  const auto planets = static_cast<std::size_t>(set.planets);
  for (const std::vector<double>* phases : {&set.sun_phase, &set.ring_phase})
    require(phases->size() == planets, "number of mesh phases", static_cast<double>(phases->size()),
            "one for each planet");
  require(set.planet_angles.empty() || set.planet_angles.size() == planets, "number of angles of planets",
          static_cast<double>(set.planet_angles.size()), "one for each planet, or none");
  require(set.pin_error.cols() == 0 || set.pin_error.cols() == set.planets, "number of pin errors",
          static_cast<double>(set.pin_error.cols()), "one for each planet, or none");
}

void require_sound(const Operation& operation) {
  require_positive(operation.run_up.from, "speed factor at the start of a run-up");
  require_not_negative(operation.run_up.duration, "duration of a run-up");
  require_not_negative(operation.mesh_frequency, "mesh frequency");
}

void set_masses(SetModel& model) {
  const SetParameters& set = model.parameters;
  model.mass.resize(model.layout.freedoms());
  model.mobility.resize(model.layout.freedoms());
  const auto put_central = [&](Eigen::Index index, const CentralMember& member) {
    const double planar = member.support.held ? 0.0 : 1.0 / member.mass;
    const double rotating = member.support.held_in_rotation ? 0.0 : 1.0 / member.inertia;
    model.mass.segment<3>(index) << member.mass, member.mass, member.inertia;
    model.mobility.segment<3>(index) << planar, planar, rotating;
  };
  put_central(SetLayout::sun(), set.sun);
  put_central(SetLayout::ring(), set.ring);
  put_central(SetLayout::carrier(), set.carrier);
  for (Eigen::Index n = 0; n < model.layout.planets; ++n) {
    model.mass.segment<3>(SetLayout::planet(n)) << set.planet.mass, set.planet.mass, set.planet.inertia;
    model.mobility.segment<3>(SetLayout::planet(n)) =
        model.mass.segment<3>(SetLayout::planet(n)).cwiseInverse();
  }
}

void add_mesh(SetModel& model, MeshKind kind, Eigen::Index n, double planet_angle) {
  const bool sun = kind == MeshKind::sun;
  const auto deflection = sun ? sun_mesh_deflection : ring_mesh_deflection;
  // The flanks that a torque of this sense presses together.
  const Flank loaded = model.operation.torques.sun >= 0.0 ? Flank::driving : Flank::back;
  const Flank back = loaded == Flank::driving ? Flank::back : Flank::driving;
  const double alpha = model.mesh(kind).pressure_angle;
  model.meshes.push_back(
      {kind, n, sun ? SetLayout::sun() : SetLayout::ring(), SetLayout::planet(n),
       deflection(planet_angle, alpha, loaded), deflection(planet_angle, alpha, back),
       (sun ? model.parameters.sun_phase : model.parameters.ring_phase)[static_cast<std::size_t>(n)]});
}

}  // namespace

Operation operation_of(const PlanetarySet& set, const Drive& drive) {
  Operation operation{.driven = drive.member,
                      .power = drive.load_power(),
                      .speeds = member_speeds(set, drive),
                      .torques = member_torques(set, drive)};
  operation.mesh_frequency =
      set.sun_teeth * std::abs(operation.speeds.sun - operation.speeds.carrier) / two_pi;
  return operation;
}

namespace {

// Eq. (16) of gearset/dynamics/README.md.
void set_load(SetModel& model) {
  const Operation& operation = model.operation;
  const SetParameters& set = model.parameters;
  const auto consider = [&](Member member, const CentralMember& body, double torque, double speed) {
    if (member == operation.driven || torque == 0.0 || speed == 0.0) return;
    model.load_index = SetLayout::central(member) + 2;
    model.load_share = -operation.speeds.planet_relative / (speed * body.radius);
  };
  if (!operation.load_yields) return;
  consider(Member::sun, set.sun, operation.torques.sun, operation.speeds.sun);
  consider(Member::ring, set.ring, operation.torques.ring, operation.speeds.ring);
  consider(Member::carrier, set.carrier, operation.torques.carrier, operation.speeds.carrier);
}

}  // namespace

void linearise_meshes(SetParameters& set, const Operation& operation) {
  const double force = std::abs(operation.torques.sun) / (set.planets * set.sun.radius);
  if (force == 0.0) return;
  for (Mesh* mesh : {&set.sun_mesh, &set.ring_mesh}) {
    if (!mesh->loaded) continue;
    TangentSpring spring = tangent_spring(*mesh->loaded, force);
    mesh->stiffness = std::move(spring.stiffness);
    mesh->free_approach = spring.free;
  }
}

SetModel set_model(SetParameters parameters, const Operation& operation) {
  require_sound(parameters);
  require_sound(operation);
  linearise_meshes(parameters, operation);
  SetModel model{.layout = {parameters.planets}, .parameters = std::move(parameters), .operation = operation};
  model.planet_angles = model.parameters.planet_angles;
  if (model.planet_angles.empty()) model.planet_angles = even_angles(model.parameters.planets);
  set_masses(model);
  for (const MeshKind kind : {MeshKind::sun, MeshKind::ring})
    for (Eigen::Index n = 0; n < model.layout.planets; ++n)
      add_mesh(model, kind, n, model.planet_angles[static_cast<std::size_t>(n)]);
  const Eigen::Matrix2Xd& errors = model.parameters.pin_error;
  for (Eigen::Index n = 0; n < model.layout.planets; ++n) {
    const double angle = model.planet_angles[static_cast<std::size_t>(n)];
    const Eigen::Vector2d error = errors.cols() == 0 ? Eigen::Vector2d::Zero().eval() : errors.col(n).eval();
    model.bearings.push_back(
        {SetLayout::planet(n), radial_bearing_deflection(angle), tangential_bearing_deflection(angle), error,
         planet_rotation(model.parameters.carrier.radius, model.parameters.planet.radius)});
  }
  set_load(model);
  return model;
}

SpeedState speed_at(const Operation& operation, double time) {
  const RunUp& run_up = operation.run_up;
  if (run_up.duration <= 0.0 || time >= run_up.duration) return {1.0, 0.0};
  const double rate = (1.0 - run_up.from) / run_up.duration;
  return {run_up.from + rate * time, rate};
}

double nominal_time(const Operation& operation, double time) {
  const RunUp& run_up = operation.run_up;
  if (run_up.duration <= 0.0) return time;
  const double rate = (1.0 - run_up.from) / run_up.duration;
  const double slow = std::min(time, run_up.duration);
  return slow * (run_up.from + 0.5 * rate * slow) + std::max(0.0, time - run_up.duration);
}

double mesh_periods(const Operation& operation, double time) {
  return operation.mesh_frequency * nominal_time(operation, time);
}

double carrier_angle(const Operation& operation, double time) {
  return operation.speeds.carrier * nominal_time(operation, time);
}

double time_of_periods(const Operation& operation, double periods) {
  const RunUp& run_up = operation.run_up;
  const double nominal = periods / operation.mesh_frequency;  // [s]  at nominal speed all along
  const double rising = 0.5 * run_up.duration * (run_up.from + 1.0);
  if (nominal >= rising) return run_up.duration + (nominal - rising);
  // from t + rate t^2 / 2 = nominal, in the form that stays sound for a small rate of either sign
  const double rate = (1.0 - run_up.from) / run_up.duration;
  return 2.0 * nominal / (run_up.from + std::sqrt(run_up.from * run_up.from + 2.0 * rate * nominal));
}

std::vector<double> jump_phases(const SetModel& model) {
  std::vector<double> phases;
  const auto add = [&](const PeriodicCurve& curve, double phase) {
    for (const double jump : curve.jumps()) {
      const double shifted = jump - phase;
      const double wrapped = shifted - std::floor(shifted);
      phases.push_back(wrapped > 1.0 - same_phase ? 0.0 : wrapped);
    }
  };
  for (const PlanetMesh& mesh : model.meshes) {
    const Mesh& law = model.mesh(mesh.kind);
    if (!law.loaded) add(law.stiffness, mesh.phase);  // the force of loaded teeth is continuous
    add(law.error, mesh.phase);
  }
  std::sort(phases.begin(), phases.end());
  const auto same = [](double a, double b) { return b - a < same_phase; };
  phases.erase(std::unique(phases.begin(), phases.end(), same), phases.end());
  return phases;
}

SetModel averaged(const SetModel& model) {
  SetModel mean = model;
  for (Mesh* mesh : {&mean.parameters.sun_mesh, &mean.parameters.ring_mesh}) {
    mesh->stiffness = PeriodicCurve::constant(mesh->stiffness.mean());
    mesh->error = PeriodicCurve::constant(mesh->error.mean() + mesh->free_approach);
    mesh->loaded = nullptr;
    mesh->free_approach = 0.0;
  }
  return mean;
}

}  // namespace orbearing::gearset::dynamics
