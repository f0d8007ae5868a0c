#include "coupling/cosim/monolithic.hpp"

#include <sstream>
#include <stdexcept>

#include "bearing/motion/driven_bore.hpp"
#include "coupling/cosim/coupled_integration.hpp"
#include "coupling/cosim/driven_output.hpp"
#include "coupling/cosim/driven_setup.hpp"
#include "gearset/dynamics/snapshot.hpp"

namespace orbearing::cosim {

namespace {

using bearing::dynamics::BoreMotion;
using bearing::dynamics::Snapshot;

}  // namespace

struct Monolithic::Inside : CoupledIntegration {
  explicit Inside(const CoupledSetup& setup)
      : CoupledIntegration(setup), gears(CoupledIntegration::model().gears) {}

  gearset::dynamics::PlanetarySetEquations gears;
};

Monolithic::Monolithic(const CoupledSetup& setup) : inside_(std::make_unique<Inside>(setup)) {}
Monolithic::~Monolithic() = default;
Monolithic::Monolithic(Monolithic&&) noexcept = default;
Monolithic& Monolithic::operator=(Monolithic&&) noexcept = default;

void Monolithic::initialize(double time) {
  initialize(time, coupled_start(inside_->setup(), inside_->model(), time));
}
void Monolithic::initialize(double time, const CoupledStart& start) {
  inside_->start(time, start);
}
void Monolithic::forget() {
  inside_->forget();
}

void Monolithic::advance(const Window& window) {
  require_length(window);
  const SavedState before = inside_->saved();
  try {
    inside_->advance(window);
  } catch (...) {
    inside_->put(before);
    throw;
  }
}
void Monolithic::follow(double time) {
  inside_->follow(time);
}

int Monolithic::planets() const {
  return static_cast<int>(inside_->model().ports.size());
}
int Monolithic::bearings() const {
  return inside_->system().bearings();
}
double Monolithic::time() const {
  return inside_->time();
}
long Monolithic::steps() const {
  return inside_->system().steps;
}
long Monolithic::rejected() const {
  return inside_->stepper().rejected();
}
long Monolithic::refined() const {
  return inside_->stepper().refined();
}

DrivenGearsOutput Monolithic::gears() const {
  const Inside& in = *inside_;
  Eigen::VectorXd workspace;
  gearset::dynamics::SetSnapshot snapshot;
  gearset::dynamics::take_snapshot(in.gears, in.time(), in.gear_state(), workspace, snapshot);
  DrivenGearsOutput out;
  for (int i = 0; i < planets(); ++i) {
    const BoreMotion motion = in.motion(i * in.model().per_planet);
    out.planets.push_back({.displacement = motion.position,
                           .velocity = motion.velocity,
                           .angle = in.model().ports[static_cast<std::size_t>(i)].turn(
                               in.gear_state().head(in.model().gears.layout.freedoms())),
                           .speed = motion.speed,
                           .sun_mesh_force = snapshot.sun_mesh_force[i],
                           .ring_mesh_force = snapshot.ring_mesh_force[i]});
    out.carrier_speed = motion.carrier_speed;
    out.carrier_acceleration = motion.carrier_acceleration;
  }
  return out;
}

bearing::dynamics::BoreReaction Monolithic::reaction(int b) const {
  return bearing::dynamics::reaction(inside_->model().bearing_of(b), inside_->motion(b),
                                     inside_->bearing_state(b));
}

DrivenBearingOutput Monolithic::bearing(int b) const {
  const Inside& in = *inside_;
  const BoreMotion motion = in.motion(b);
  const bearing::dynamics::BearingModel& model = in.model().bearing_of(b);
  return driven_output(model.geometry, motion.speed, driven_snapshot(model, motion, in.bearing_state(b)),
                       reaction(b), in.turned(b), life(b).bearing);
}

void Monolithic::take_snapshot(int b, Snapshot& into) const {
  into = driven_snapshot(inside_->model().bearing_of(b), inside_->motion(b), inside_->bearing_state(b));
}

void Monolithic::collect_loads(int b, bearing::dynamics::StatisticsCollector* collector) {
  inside_->system().loads[static_cast<std::size_t>(b)].collector = collector;
}

bearing::BearingLife Monolithic::life(int b) const {
  const DrivenBearingSetup& setup = inside_->setup().bearing;
  return inside_->system().sums[static_cast<std::size_t>(b)].life(setup.bearing, setup.lambda, kStanding);
}

CoupledStart Monolithic::state() const {
  CoupledStart all{inside_->gear_state(), {}};
  for (int b = 0; b < bearings(); ++b) all.bearings.push_back(inside_->bearing_state(b));
  return all;
}

void Monolithic::save(SavedState& state) const {
  state = inside_->saved();
}

void Monolithic::restore(const SavedState& state) {
  if (inside_->put(state)) return;
  std::ostringstream text;
  text << "monolithic solution: found a saved state of " << state.size()
       << " numbers; required: " << inside_->saved().size() << " numbers, of such a gear set with "
       << bearings() << " bearings";
  throw std::invalid_argument(text.str());
}

}  // namespace orbearing::cosim
