#include "coupling/system/driven_gears.hpp"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "coupling/integration/gear_steps.hpp"
#include "gearset/dynamics/snapshot.hpp"
#include "gearset/dynamics/static_state.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::cosim {

namespace {

using Eigen::Index;
using gearset::dynamics::BearingPorts;
using gearset::dynamics::Operation;
using gearset::dynamics::PlanetarySetEquations;
using gearset::dynamics::PortLoads;
using gearset::dynamics::SetModel;
using gearset::dynamics::SetParameters;
using gearset::dynamics::SpeedState;

// Saved state: [ kind and version | time | step | x ].
constexpr double kSavedGearsKind = 20001.0;
constexpr std::size_t kSavedGearsHead = 3;

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
  constexpr double share = 0.02, standing = 1e-6;  // [mesh period], [s]
  return operation.mesh_frequency > 0.0 ? share / operation.mesh_frequency : standing;
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

  void require_one_each(const std::vector<PlanetForceCourse>& forces) const {
    if (static_cast<Index>(forces.size()) != planets())
      mechanics::refuse("number of forces on planets", static_cast<double>(forces.size()),
                        "one for each planet");
  }

  void set_loads(const std::vector<PlanetForceCourse>& forces, double since) {
    for (Index i = 0; i < planets(); ++i) {
      const PlanetForceCourse& force = forces[static_cast<std::size_t>(i)];
      loads.force.col(i) << force.x.at(since), force.y.at(since);
      loads.moment[i] = force.moment.at(since);
    }
  }

  PlanetarySetEquations equations;
  SetModel springs;  // the same set on linear bearings, to begin with
  integration::IntegrationOptions options;
  Eigen::VectorXd x;
  double time = 0.0;  // [s]
  PortLoads loads;    // workspace
};

DrivenGears::DrivenGears(const DrivenGearsSetup& setup) : inside_(std::make_unique<Inside>(setup)) {}
DrivenGears::~DrivenGears() = default;
DrivenGears::DrivenGears(DrivenGears&&) noexcept = default;
DrivenGears& DrivenGears::operator=(DrivenGears&&) noexcept = default;

void DrivenGears::initialize(double time) {
  inside_->x = gearset::dynamics::static_state(inside_->springs);
  inside_->time = time;
  inside_->options.step = first_step(inside_->model().operation);
}

void DrivenGears::balance(const std::vector<PlanetForceCourse>& forces) {
  inside_->require_one_each(forces);
  inside_->set_loads(forces, 0.0);
  BearingPorts ports;
  inside_->equations.motion_at_ports(inside_->x, ports);
  SetModel springs = inside_->springs;
  // A spring that gives F at the displacement d has the deflection F / k there.
  for (Index i = 0; i < inside_->planets(); ++i)
    springs.bearings[static_cast<std::size_t>(i)].pin_error +=
        ports.displacement.col(i) + inside_->loads.force.col(i) / springs.parameters.planet.bearing_stiffness;
  inside_->x = gearset::dynamics::static_state(springs);
}

void DrivenGears::advance(const Window& window, const std::vector<PlanetForceCourse>& forces) {
  inside_->require_one_each(forces);
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
  out.planet_speed = nominal.planet_relative * speed.factor;
  out.carrier_speed = nominal.carrier * speed.factor;
  out.carrier_acceleration = nominal.carrier * speed.rate;
  return out;
}

int DrivenGears::planets() const {
  return static_cast<int>(inside_->planets());
}

void DrivenGears::save(SavedState& state) const {
  state = {kSavedGearsKind, inside_->time, inside_->options.step};
  state.insert(state.end(), inside_->x.begin(), inside_->x.end());
}

void DrivenGears::restore(const SavedState& state) {
  const std::size_t required = kSavedGearsHead + static_cast<std::size_t>(inside_->x.size());
  if (state.size() != required)
    mechanics::refuse("size of a saved state", static_cast<double>(state.size()), std::to_string(required));
  if (state[0] != kSavedGearsKind)
    mechanics::refuse("kind of a saved state", state[0], "that of a gear set, 20001");
  if (!(state[2] > 0.0)) mechanics::refuse("step of a saved state", state[2], "above 0");
  inside_->time = state[1];
  inside_->options.step = state[2];
  inside_->x = Eigen::Map<const Eigen::VectorXd>(state.data() + kSavedGearsHead, inside_->x.size());
}

}  // namespace orbearing::cosim
