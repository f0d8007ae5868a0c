#include "coupling/cosim/monolithic.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "bearing/dynamics/driven_bore.hpp"
#include "coupling/cosim/coupled_steps.hpp"
#include "coupling/cosim/driven_setup.hpp"
#include "coupling/integration/gear_steps.hpp"
#include "coupling/integration/in_place.hpp"
#include "coupling/integration/integrate_bearing.hpp"
#include "coupling/integration/window.hpp"
#include "gearset/dynamics/snapshot.hpp"

namespace orbearing::cosim {

namespace {

using bearing::dynamics::BoreMotion;
using bearing::dynamics::Snapshot;
using boost::math::double_constants::two_pi;

constexpr double kSavedKind = 30001.0;
constexpr double kLeastSpeed = 1e-9;  // [rad/s]  below it nothing turns
// Errors that linearly implicit steps may make in the gears, over those of dopri5.
constexpr double kGearErrorFactor = 100.0;

CoupledModel checked_model(const CoupledSetup& setup) {
  CoupledModel model = coupled_model(setup);
  if (!bearing::fast::supports(model.bearing))
    throw std::invalid_argument(
        "monolithic solution: found oil in the pockets; required: pockets without film, as the vectorised "
        "bearing knows them");
  return model;
}

CoupledStepOptions step_options(const CoupledSetup& setup, const CoupledModel& model,
                                const CoupledSystem& system) {
  const Eigen::VectorXd gears =
      kGearErrorFactor * integration::gear_allowed_errors(model.gears, setup.gears.allowed_share);
  return {.gears = {gears.begin(), gears.end()},
          .bearing = integration::linearly_implicit_errors(
              system.bearing(0),
              integration::bearing_allowed_errors(model.bearing.layout, setup.bearing.allowed_length_error,
                                                  model.bearing.geometry.pitch_radius,
                                                  integration::roller_frequency(model.bearing))),
          .longest_step = integration::longest_step(model.bearing),
          .most_refined = setup.most_refined,
          .most_steps = setup.bearing.most_steps};
}

}  // namespace

struct Monolithic::Inside {
  CoupledSetup setup;
  CoupledModel model;
  CoupledSystem system;
  CoupledSteps stepper;
  gearset::dynamics::PlanetarySetEquations gears;
  std::vector<double> x;
  double time = 0.0;           // [s]
  double step = 1e-6;          // [s]  to try next
  std::vector<double> turned;  // [rad]  (bearings)  there and back
  mutable std::vector<double> rate;

  explicit Inside(const CoupledSetup& given)
      : setup(given),
        model(checked_model(given)),
        system(model, given.bearing.places),
        stepper(system, step_options(given, model, system)),
        gears(model.gears),
        x(system.size(), 0.0),
        turned(static_cast<std::size_t>(system.bearings()), 0.0),
        rate(system.size()) {}

  Eigen::Index freedoms() const { return model.gears.layout.freedoms(); }
  Eigen::VectorXd gear_state() const { return Eigen::Map<const Eigen::VectorXd>(x.data(), 2 * freedoms()); }
  Eigen::VectorXd bearing_state(int b) const {
    Eigen::VectorXd flat(model.bearing.layout.size());
    system.bearing(b).flatten(system.of_bearing(x.data(), b), flat);
    return flat;
  }
  BoreMotion motion(int b) const {
    const Eigen::VectorXd q = gear_state();
    return bore_motion(model, model.port_of(b), time, q.head(freedoms()), q.tail(freedoms()));
  }

  // Piece by piece between the jumps of the mesh stiffness.
  void run(const Window& window) {
    const integration::Jumps jumps = integration::jumps_of(model.gears, window.begin);
    const double close = 4e-16 * std::abs(window.end) + 1e-15;  // [s]  round-off of the times
    const std::vector<double> before = angles();
    double begin = window.begin;
    for (long jump = 0; begin < window.end;) {
      double next = jumps.time ? jumps.time(jump) : std::numeric_limits<double>::infinity();
      if (next <= begin + close) {
        ++jump;
        continue;
      }
      if (next >= window.end - close) next = window.end;
      run_piece(begin, next, jumps.margin);
      begin = next;
    }
    time = window.end;
    const std::vector<double> after = angles();
    for (std::size_t b = 0; b < turned.size(); ++b) turned[b] += std::abs(after[b] - before[b]);
    require_in_place();
  }

  void run_piece(double begin, double end, double margin) {
    const double inner = std::min(margin, 0.25 * (end - begin));
    system.set_piece(begin, begin + inner, end - inner);
    integration::through_window(stepper, system, x, end - begin, {.most_steps = setup.bearing.most_steps},
                                step);
  }

  std::vector<double> angles() const {
    std::vector<double> all;
    for (int b = 0; b < system.bearings(); ++b) all.push_back(motion(b).angle);
    return all;
  }

  void require_in_place() const {
    for (int b = 0; b < system.bearings(); ++b) {
      const std::string reason = integration::out_of_place(model.bearing, bearing_state(b));
      if (reason.empty()) continue;
      std::ostringstream text;
      text << "bearing " << b + 1 << " at t = " << time << " s: " << reason;
      throw std::runtime_error(text.str());
    }
  }

  /// Every number of the state in turn, for `visit(double* first, size)`.
  template <class Visit>
  void each(Visit visit) {
    visit(&time, 1);
    visit(&step, 1);
    visit(x.data(), static_cast<long>(x.size()));
    visit(turned.data(), static_cast<long>(turned.size()));
    for (std::size_t b = 0; b < turned.size(); ++b) {
      visit(&system.loads[b].step_before, 1);
      for (Eigen::ArrayXd* sums : {&system.sums[b].passages, &system.sums[b].inner, &system.sums[b].outer})
        visit(sums->data(), static_cast<long>(sums->size()));
    }
  }
  SavedState saved() {
    SavedState all{kSavedKind, static_cast<double>(model.bearing.layout.rollers),
                   static_cast<double>(system.bearings()), static_cast<double>(freedoms())};
    each([&](const double* first, long size) { all.insert(all.end(), first, first + size); });
    return all;
  }
  void put(const SavedState& all) {
    auto from = all.begin() + 4;
    each([&](double* first, long size) {
      std::copy_n(from, size, first);
      from += size;
    });
  }
};

Monolithic::Monolithic(const CoupledSetup& setup) : inside_(std::make_unique<Inside>(setup)) {}
Monolithic::~Monolithic() = default;
Monolithic::Monolithic(Monolithic&&) noexcept = default;
Monolithic& Monolithic::operator=(Monolithic&&) noexcept = default;

void Monolithic::initialize(double time) {
  initialize(time, coupled_start(inside_->setup, inside_->model, time));
}

void Monolithic::initialize(double time, const CoupledStart& start) {
  Inside& in = *inside_;
  in.time = time;
  in.step = 1e-6;
  std::fill(in.x.begin(), in.x.end(), 0.0);
  std::copy(start.gears.begin(), start.gears.end(), in.x.begin());
  for (int b = 0; b < bearings(); ++b) {
    const std::vector<double> padded =
        in.system.bearing(b).padded(start.bearings[static_cast<std::size_t>(b)]);
    std::copy(padded.begin(), padded.end(), in.system.of_bearing(in.x.data(), b));
  }
  in.system.settle(0.0, in.x);
  forget();
}

void Monolithic::forget() {
  Inside& in = *inside_;
  for (std::size_t b = 0; b < in.turned.size(); ++b) {
    in.turned[b] = 0.0;
    in.system.loads[b].step_before = 0.0;
    in.system.sums[b] = LoadSums(in.setup.bearing.places);
  }
}

void Monolithic::advance(const Window& window) {
  require_length(window);
  const SavedState before = inside_->saved();
  try {
    inside_->run(window);
  } catch (...) {
    inside_->put(before);
    throw;
  }
}

int Monolithic::planets() const {
  return static_cast<int>(inside_->model.ports.size());
}
int Monolithic::bearings() const {
  return inside_->system.bearings();
}
double Monolithic::time() const {
  return inside_->time;
}
long Monolithic::steps() const {
  return inside_->system.steps;
}
long Monolithic::rejected() const {
  return inside_->stepper.rejected();
}
long Monolithic::refined() const {
  return inside_->stepper.refined();
}

DrivenGearsOutput Monolithic::gears() const {
  const Inside& in = *inside_;
  Eigen::VectorXd workspace;
  gearset::dynamics::SetSnapshot snapshot;
  gearset::dynamics::take_snapshot(in.gears, in.time, in.gear_state(), workspace, snapshot);
  DrivenGearsOutput out;
  for (int i = 0; i < planets(); ++i) {
    const BoreMotion motion = in.motion(i * in.model.per_planet);
    out.planets.push_back(
        {.displacement = motion.position,
         .velocity = motion.velocity,
         .angle = in.model.ports[static_cast<std::size_t>(i)].turn(in.gear_state().head(in.freedoms())),
         .speed = motion.speed,
         .sun_mesh_force = snapshot.sun_mesh_force[i],
         .ring_mesh_force = snapshot.ring_mesh_force[i]});
    out.carrier_speed = motion.carrier_speed;
    out.carrier_acceleration = motion.carrier_acceleration;
  }
  return out;
}

bearing::dynamics::BoreReaction Monolithic::reaction(int b) const {
  return bearing::dynamics::reaction(inside_->model.bearing, inside_->motion(b), inside_->bearing_state(b));
}

DrivenBearingOutput Monolithic::bearing(int b) const {
  const Inside& in = *inside_;
  const BoreMotion motion = in.motion(b);
  const Snapshot now = driven_snapshot(in.model.bearing, motion, in.bearing_state(b));
  const double kinematic = kinematic_cage_speed(in.model.bearing.geometry, 0.0, motion.speed);
  DrivenBearingOutput output;
  output.reaction = reaction(b);
  output.cage_speed = now.cage_speed;
  output.cage_slip = std::abs(kinematic) > kLeastSpeed ? 1.0 - now.cage_speed / kinematic : 0.0;
  output.revolutions = in.turned[static_cast<std::size_t>(b)] / two_pi;
  output.life_used = output.revolutions / life(b).bearing;
  output.friction_loss = now.loss.total();
  output.inner_load.assign(now.inner.load.begin(), now.inner.load.end());
  output.outer_load.assign(now.outer.load.begin(), now.outer.load.end());
  output.roller_angle.assign(now.angle.begin(), now.angle.end());
  return output;
}

void Monolithic::take_snapshot(int b, Snapshot& into) const {
  into = driven_snapshot(inside_->model.bearing, inside_->motion(b), inside_->bearing_state(b));
}

void Monolithic::collect_loads(int b, bearing::dynamics::StatisticsCollector* collector) {
  inside_->system.loads[static_cast<std::size_t>(b)].collector = collector;
}

bearing::BearingLife Monolithic::life(int b) const {
  return inside_->system.sums[static_cast<std::size_t>(b)].life(inside_->setup.bearing.bearing,
                                                                inside_->setup.bearing.lambda);
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
  const SavedState own = inside_->saved();
  if (state.size() != own.size() || !std::equal(own.begin(), own.begin() + 4, state.begin())) {
    std::ostringstream text;
    text << "monolithic solution: found a saved state of " << state.size()
         << " numbers; required: " << own.size() << " numbers, of such a gear set with " << bearings()
         << " bearings";
    throw std::invalid_argument(text.str());
  }
  inside_->put(state);
}

}  // namespace orbearing::cosim
