#include "coupling/system/driven_gears.hpp"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "coupling/integration/integrate_pieces.hpp"
#include "gearset/dynamics/snapshot.hpp"
#include "gearset/dynamics/static_state.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::system {

namespace {

using Eigen::Index;
using gearset::dynamics::BearingPorts;
using gearset::dynamics::Operation;
using gearset::dynamics::PlanetarySetEquations;
using gearset::dynamics::PortLoads;
using gearset::dynamics::SetModel;
using gearset::dynamics::SetParameters;
using gearset::dynamics::SpeedState;

constexpr double kSavedGearsKind = 20001.0;  // and version
constexpr Index kForcesOfPlanet = 3;         // x, y, moment

std::vector<Input> force_inputs(const DrivenGearsSetup& setup) {
  std::vector<Input> inputs;
  const auto add = [&](const std::string& name, const char* unit, const std::string& meaning) {
    const std::size_t position = inputs.size();
    inputs.push_back(
        {name, unit, meaning, position < setup.start_force.size() ? setup.start_force[position] : 0.0});
  };
  for (int i = 1; i <= setup.set.planets; ++i) {
    const std::string planet = "planet[" + std::to_string(i) + "].", all = "of all bearings on the planet, ";
    add(planet + "force.x", "N", "force " + all + "outward");
    add(planet + "force.y", "N", "force " + all + "in the sense of carrier rotation");
    add(planet + "moment", "N.m", "moment " + all + "about its axis");
  }
  return inputs;
}

std::vector<Output> motion_outputs(int planets) {
  std::vector<Output> outputs;
  const auto add = [&](const std::string& name, const char* unit, const std::string& meaning) {
    outputs.push_back({name, unit, meaning, {}, {}});
  };
  for (int i = 1; i <= planets; ++i) {
    const std::string planet = "planet[" + std::to_string(i) + "].";
    const std::string along = ", in the sense of carrier rotation";
    add(planet + "displacement.x", "m", "of the planet's axis from that of its pin, outward");
    add(planet + "displacement.y", "m", "of the planet's axis from that of its pin" + along);
    add(planet + "velocity.x", "m/s", "slope of displacement.x by time");
    add(planet + "velocity.y", "m/s", "slope of displacement.y by time");
    add(planet + "speed", "rad/s", "of the planet about its axis, relative to the carrier");
    add(planet + "angle", "rad", "of the planet beyond its nominal rotation");
    add(planet + "sun_mesh_force", "N", "force of the sun mesh along its line of action");
    add(planet + "ring_mesh_force", "N", "force of the ring mesh along its line of action");
  }
  outputs.push_back({"carrier.speed", "rad/s", "nominal speed of the carrier", {}, {}, false});
  outputs.push_back({"carrier.acceleration", "rad/s2", "slope of carrier.speed by time", {}, {}, false});
  return outputs;
}

SetParameters with_ports(const SetParameters& set) {
  if (!(set.planet.bearing_stiffness > 0.0))
    mechanics::refuse("stiffness of the planet's bearing", set.planet.bearing_stiffness,
                      "a value greater than 0, to find the state in which the run begins");
  return set;
}

SetModel on_springs(SetParameters set, const Operation& operation) {
  set.planet.coupled_bearing = false;
  return gearset::dynamics::set_model(std::move(set), operation);
}

// Longest first step: well below a mesh period.
double first_step(const Operation& operation) {
  constexpr double share = 0.02, stationary = 1e-6;  // [mesh period], [s]
  return operation.mesh_frequency > 0.0 ? share / operation.mesh_frequency : stationary;
}

integration::IntegrationOptions options_of(const DrivenGearsSetup& setup, const SetModel& model) {
  if (!(setup.allowed_share > 0.0))
    mechanics::refuse("allowed error of a step", setup.allowed_share, "above 0");
  integration::IntegrationOptions options;
  options.allowed_error = integration::gear_allowed_errors(model, setup.allowed_share);
  options.step = first_step(model.operation);
  options.smallest_step = 0.0;  // a window may end a hair behind a jump
  options.most_steps = setup.most_steps;
  options.most_seconds = std::numeric_limits<double>::infinity();  // a result shall not depend on the clock
  return options;
}

}  // namespace

struct DrivenGears::Inside {
  explicit Inside(const DrivenGearsSetup& setup)
      : equations(gearset::dynamics::set_model(with_ports(setup.set), setup.operation)),
        springs(on_springs(setup.set, setup.operation)),
        options(options_of(setup, equations.model())),
        x(Eigen::VectorXd::Zero(equations.model().layout.size())) {
    loads.force.setZero(2, planets());
    loads.moment.setZero(planets());
  }

  Index planets() const { return equations.model().layout.planets; }
  const SetModel& model() const { return equations.model(); }

  void require_one_each(std::size_t forces) const {
    if (static_cast<Index>(forces) != kForcesOfPlanet * planets())
      mechanics::refuse("number of forces on planets", static_cast<double>(forces), "three for each planet");
  }

  void set_loads(const std::vector<InputPolynomial>& forces, double since) {
    for (Index i = 0; i < planets(); ++i) {
      const InputPolynomial* force = &forces[static_cast<std::size_t>(kForcesOfPlanet * i)];
      loads.force.col(i) << force[0].at(since), force[1].at(since);
      loads.moment[i] = force[2].at(since);
    }
  }

  // Every number of the state in turn, for `visit(double* first, size)`.
  template <class Visit>
  void each(Visit visit) {
    visit(&time, 1);
    visit(&options.step, 1);
    visit(x.data(), static_cast<long>(x.size()));
  }

  PlanetarySetEquations equations;
  SetModel springs;  // the same set on linear bearings, to begin with
  integration::IntegrationOptions options;
  Eigen::VectorXd x;
  double time = 0.0;  // [s]
  PortLoads loads;    // workspace
};

DrivenGears::DrivenGears(const DrivenGearsSetup& setup)
    : Participant(force_inputs(setup), motion_outputs(setup.set.planets)),
      inside_(std::make_unique<Inside>(setup)) {}
DrivenGears::~DrivenGears() = default;
DrivenGears::DrivenGears(DrivenGears&&) noexcept = default;
DrivenGears& DrivenGears::operator=(DrivenGears&&) noexcept = default;

void DrivenGears::initialize(double time, const std::vector<double>&) {
  inside_->x = gearset::dynamics::static_state(inside_->springs);
  inside_->time = time;
  inside_->options.step = first_step(inside_->model().operation);
}

void DrivenGears::balance(double, const std::vector<double>& forces) {
  inside_->require_one_each(forces.size());
  BearingPorts ports;
  inside_->equations.motion_at_ports(inside_->x, ports);
  SetModel springs = inside_->springs;
  // A spring that gives F at the displacement d has the deflection F / k there.
  for (Index i = 0; i < inside_->planets(); ++i)
    springs.bearings[static_cast<std::size_t>(i)].pin_error +=
        ports.displacement.col(i) +
        Eigen::Map<const Eigen::Vector2d>(&forces[static_cast<std::size_t>(kForcesOfPlanet * i)]) /
            springs.parameters.planet.bearing_stiffness;
  inside_->x = gearset::dynamics::static_state(springs);
}

void DrivenGears::advance(const Window& window, const std::vector<InputPolynomial>& forces) {
  inside_->require_one_each(forces.size());
  if (!(window.end > window.begin)) mechanics::refuse("length of a window", window.length(), "above 0");
  const auto derivative = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                              Eigen::Ref<Eigen::VectorXd> dx) {
    inside_->set_loads(forces, time - window.begin);
    inside_->equations.derivative(time, x, inside_->loads, dx);
  };
  Eigen::VectorXd x = inside_->x;
  const integration::IntegrationReport report = integration::integrate_pieces(
      derivative, x, {window.begin, window.length(), 1},
      integration::jumps_of(inside_->model(), window.begin), inside_->options, {});
  if (!report.completed) throw std::runtime_error("gears: " + report.message);
  inside_->x = x;
  inside_->time = window.end;
  inside_->options.step = report.next_step;
}

const Eigen::VectorXd& DrivenGears::state() const {
  return inside_->x;
}

DrivenGearsOutput DrivenGears::output() const {
  BearingPorts ports;
  inside_->equations.motion_at_ports(inside_->x, ports);
  Eigen::VectorXd dx;
  gearset::dynamics::SetSnapshot snapshot;
  take_snapshot(inside_->equations, inside_->time, inside_->x, dx, snapshot);
  const SpeedState speed = speed_at(inside_->model().operation, inside_->time);
  const gearset::Speeds& nominal = inside_->model().operation.speeds;
  DrivenGearsOutput out;
  for (Index i = 0; i < inside_->planets(); ++i)
    out.planets.push_back({.displacement = ports.displacement.col(i),
                           .velocity = ports.velocity.col(i),
                           .angle = ports.angle[i],
                           .speed = nominal.planet_relative * speed.factor + ports.speed[i],
                           .sun_mesh_force = snapshot.sun_mesh_force[i],
                           .ring_mesh_force = snapshot.ring_mesh_force[i]});
  out.carrier_speed = nominal.carrier * speed.factor;
  out.carrier_acceleration = nominal.carrier * speed.rate;
  return out;
}

int DrivenGears::planets() const {
  return static_cast<int>(inside_->planets());
}

std::vector<double> DrivenGears::values(const std::vector<double>&, std::size_t) const {
  const DrivenGearsOutput now = output();
  std::vector<double> values;
  for (const PlanetMotion& planet : now.planets)
    values.insert(values.end(),
                  {planet.displacement.x(), planet.displacement.y(), planet.velocity.x(), planet.velocity.y(),
                   planet.speed, planet.angle, planet.sun_mesh_force, planet.ring_mesh_force});
  values.insert(values.end(), {now.carrier_speed, now.carrier_acceleration});
  return values;
}

std::vector<double> DrivenGears::slopes(const std::vector<double>&, std::size_t) const {
  return std::vector<double>(outputs().size(), 0.0);
}

void DrivenGears::save(SavedState& state) const {
  state = saved_state({kSavedGearsKind}, *inside_);
}

void DrivenGears::restore(const SavedState& state) {
  restore_state(state, "gears", {kSavedGearsKind}, *inside_);
}

}  // namespace orbearing::system
