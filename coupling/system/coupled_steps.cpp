#include "coupling/system/coupled_steps.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "coupling/integration/window.hpp"

namespace orbearing::system {

namespace {

using bearing::motion::BoreMotion;
using bearing::vectorised::VectorBearing;
using gearset::dynamics::SetLayout;

constexpr Eigen::Index kEight = 8;  // the stepper works on as many numbers at once

}  // namespace

CoupledSystem::CoupledSystem(const CoupledModel& model, bool rotating)
    : loads(static_cast<std::size_t>(model.bearings()),
            system::LoadsAtStep(static_cast<int>(model.bearing.layout.rollers))),
      counted(static_cast<std::size_t>(model.bearings()), false),
      model_(model),
      rotating_(rotating),
      equations_(model.gears),
      begin_reactions_(static_cast<std::size_t>(model.bearings())),
      stages_(begin_reactions_.size()),
      port_matrices_(begin_reactions_.size()),
      reduced_(begin_reactions_.size()) {
  for (int b = 0; b < model.bearings(); ++b) bearings_.emplace_back(model.bearing_of(b));
  gear_size_ = (model.gears.layout.size() + kEight - 1) / kEight * kEight;
  bearing_size_ = bearings_.front().layout().size();
  port_loads_.force.setZero(2, model.gears.layout.planets);
  port_loads_.moment.setZero(model.gears.layout.planets);
  stage_loads_ = port_loads_;
  right_.resize(freedoms());
  rate_.resize(freedoms());
  gear_rate_.resize(2 * freedoms());
  gear_rate_after_.resize(2 * freedoms());
}

void CoupledSystem::set_piece(double begin, double first, double last) {
  begin_ = begin;
  first_ = first;
  last_ = last;
}

double CoupledSystem::true_time(double time) const {
  return std::clamp(begin_ + time, first_, last_);
}

template <bool WithSlopes>
void CoupledSystem::evaluate(double time, const double* x, double* dx) {
  const double now = true_time(time);
  const Eigen::Index n = freedoms();
  port_loads_.force.setZero();
  port_loads_.moment.setZero();
  BoreMotion motion;
  for (int b = 0; b < bearings(); ++b) {
    const PlanetPort& port = model_.port_of(b);
    if (b % model_.per_planet == 0) motion = bore_motion(model_, port, now, part(x, 0), part(x, n));
    VectorBearing& bearing = bearings_[static_cast<std::size_t>(b)];
    const BoreMotion own = at_seat(model_, b, motion);
    if constexpr (WithSlopes)
      bearing.linearise(own, of_bearing(x, b), of_bearing(dx, b));
    else
      bearing.derivative(own, of_bearing(x, b), of_bearing(dx, b));
    const auto reaction = bearing.reaction();
    port_loads_.force.col(b / model_.per_planet) += reaction.force;
    port_loads_.moment[b / model_.per_planet] += reaction.moment;
    if constexpr (WithSlopes)
      begin_reactions_[static_cast<std::size_t>(b)] = reaction;
    else
      stages_[static_cast<std::size_t>(b)].evaluated(reaction);
  }
  Eigen::Map<Eigen::VectorXd> gears(dx, 2 * n);
  equations_.derivative(now, Vector(x, 2 * n), port_loads_, gears);
  std::fill(dx + 2 * n, dx + gear_size_, 0.0);
  for (int b = 0; b < bearings(); ++b) put_acceleration(b, gears.tail(n), of_bearing(dx, b));
}

void CoupledSystem::derivative(double time, const double* x, double* dx) {
  evaluate<false>(time, x, dx);
}

void CoupledSystem::linearise(double time, const double* x, double* dx) {
  evaluate<true>(time, x, dx);
  linear_gears_ = Vector(x, 2 * freedoms());
  if (model_.bearing.gravity.acts()) linear_.assign(x, x + size());
  force_slopes(model_.gears, true_time(time), linear_gears_, slopes_);
}

// By a difference, the same loads of the bearings on both sides, whatever they are: they drop out.
void CoupledSystem::mesh_slope(double time, double* dx) {
  constexpr double kShare = 1e-4;  // of a mesh period, within which the stiffness runs straight
  const Eigen::Index n = freedoms();
  const double period = 1.0 / model_.gears.operation.mesh_frequency;  // infinite for gears at rest
  const double span = std::min(kShare * period, 0.5 * (last_ - first_));
  const double now = std::clamp(true_time(time), first_, last_ - span);
  equations_.derivative(now, linear_gears_, port_loads_, gear_rate_);
  equations_.derivative(now + span, linear_gears_, port_loads_, gear_rate_after_);
  Eigen::Map<Eigen::VectorXd> gears(dx, 2 * n);
  gears = (gear_rate_after_ - gear_rate_) / span;
  std::fill(dx + 2 * n, dx + size(), 0.0);
  for (int b = 0; b < bearings(); ++b) put_acceleration(b, gears.tail(n), of_bearing(dx, b));
  if (!model_.bearing.gravity.acts()) return;
  const gearset::dynamics::Operation& operation = model_.gears.operation;
  for (int b = 0; b < bearings(); ++b)
    bearing(b).add_weight_slope(carrier_angle(operation, now) + model_.port_of(b).planet_angle,
                                operation.speeds.carrier * speed_at(operation, now).factor,
                                of_bearing(linear_.data(), b), of_bearing(dx, b));
}

// Acceleration of the bore of bearing `b`, from the `rate` of the gears' velocities, into its part of the
// rate.
void CoupledSystem::put_acceleration(int b, const Eigen::Ref<const Eigen::VectorXd>& rate, double* dx) const {
  const Eigen::Vector2d acceleration = model_.port_of(b).along(rate);
  std::copy_n(acceleration.data(), 2, dx + bearings_.front().layout().bore() + 2);
}

bool CoupledSystem::factor(double g) {
  g_ = g;
  matrix_.assemble(model_.gears, slopes_, g);
  for (int b = 0; b < bearings(); ++b) {
    const auto position = static_cast<std::size_t>(b);
    bearing::vectorised::PortMatrix& port = port_matrices_[position];
    if (!bearings_[position].factor_open(g, rotating_, port)) return false;
    stages_[position].begin(begin_reactions_[position]);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> matrix(&port.a[0][0]);
    const PlanetPort& planet = model_.port_of(b);
    matrix_.add_port(model_.gears, b / model_.per_planet, planet.of_carrier, planet.of_planet, matrix);
  }
  return matrix_.factor(model_.gears);
}

void CoupledSystem::solve(const double* rhs, double* k) {
  const Eigen::Index n = freedoms();
  right_ = model_.gears.mass.cwiseProduct(part(rhs, n)) + g_ * (slopes_.by_position * part(rhs, 0));
  stage_loads_.force.setZero();
  stage_loads_.moment.setZero();
  for (int b = 0; b < bearings(); ++b) {
    double(&force)[3] = reduced_[static_cast<std::size_t>(b)].force;
    bearings_[static_cast<std::size_t>(b)].reduce(of_bearing(rhs, b), of_bearing(k, b), force);
    const int planet = b / model_.per_planet;
    stage_loads_.force.col(planet) += Eigen::Vector2d(force[0], force[1]);
    stage_loads_.moment[planet] += force[2];
  }
  add_port_loads(model_.gears, stage_loads_, right_);
  rate_ = (model_.gears.mobility.array() != 0.0).select(right_, 0.0);
  matrix_.solve(rate_);
  Eigen::Map<Eigen::VectorXd>(k + n, n) = rate_;
  Eigen::Map<Eigen::VectorXd>(k, n) = part(rhs, 0) + g_ * rate_;
  std::fill(k + 2 * n, k + gear_size_, 0.0);
  for (int b = 0; b < bearings(); ++b) {
    const Eigen::Vector3d bore = model_.port_of(b).of(rate_);
    const double rate[3] = {bore.x(), bore.y(), bore.z()};
    const auto position = static_cast<std::size_t>(b);
    bearings_[position].complete(of_bearing(rhs, b), rate, of_bearing(k, b));
    stages_[position].solved(reduced_[position].force, rate, port_matrices_[position]);
  }
}

void CoupledSystem::begun(const std::vector<double>& x) {
  for (int b = 0; b < bearings(); ++b)
    loads[static_cast<std::size_t>(b)].take(bearing(b), of_bearing(x.data(), b));
}

void CoupledSystem::stepped(double, double length) {
  ++steps;
  for (std::size_t b = 0; b < loads.size(); ++b) {
    if (!counted[b]) loads[b].count(length);
    counted[b] = false;
  }
}

void CoupledSystem::push(const gearset::dynamics::PortLoads& impulses, double* x) {
  right_.setZero();
  add_port_loads(model_.gears, impulses, right_);
  rate_ = model_.gears.mobility.cwiseProduct(right_);
  Eigen::Map<Eigen::VectorXd>(x + freedoms(), freedoms()) += rate_;
}

// The bores are where the gear set has them but for round-off, which shall not gather.
void CoupledSystem::settle(double, std::vector<double>& x) const {
  const Eigen::Index n = freedoms();
  for (int b = 0; b < bearings(); ++b) {
    const PlanetPort& port = model_.port_of(b);
    Eigen::Vector2d position = port.along(part(x.data(), 0)) - port.pin_error;
    if (!model_.pin_offset.empty()) position -= model_.pin_offset[static_cast<std::size_t>(b)];
    const Eigen::Vector2d velocity = port.along(part(x.data(), n));
    double* bore = of_bearing(x.data(), b) + bearing(b).layout().bore();
    std::copy_n(position.data(), 2, bore);
    std::copy_n(velocity.data(), 2, bore + 2);
  }
}

namespace {

using bearing::motion::BoreMotion;

// Error of a step, over what is allowed, up to which a bearing is substepped: beyond it the
// bearing's force in the step of all is not to be trusted.
constexpr double kLargestSubstepped = 30.0;
// Cost of the start of substepping a bearing, in steps of one bearing.
constexpr double kSubsteppingBegins = 1.5;

std::vector<double> gears_alone(const CoupledSystem& system, const std::vector<double>& gears) {
  std::vector<double> allowed(system.size(), 0.0);
  std::copy(gears.begin(), gears.end(), allowed.begin());
  return allowed;
}

InputPolynomial straight(double h, double from, double to) {
  return {{from, (to - from) / h, 0.0, 0.0}};
}

BoreInputs polynomial_between(const BoreMotion& from, const BoreMotion& to, double h) {
  BoreInputs polynomial;
  polynomial.x = hermite(from.position.x(), from.velocity.x(), to.position.x(), to.velocity.x(), h);
  polynomial.y = hermite(from.position.y(), from.velocity.y(), to.position.y(), to.velocity.y(), h);
  polynomial.v_x = slope_of(polynomial.x);
  polynomial.v_y = slope_of(polynomial.y);
  polynomial.speed = straight(h, from.speed, to.speed);
  polynomial.carrier_speed = straight(h, from.carrier_speed, to.carrier_speed);
  polynomial.carrier_acceleration = straight(h, from.carrier_acceleration, to.carrier_acceleration);
  return polynomial;
}

}  // namespace

CoupledSteps::CoupledSteps(const CoupledSystem& system, const CoupledStepOptions& options)
    : options_(options),
      all_(gears_alone(system, options.gears), options.longest_step),
      within_(options.bearing, options.longest_step),
      control_(options.longest_step),
      weight_(options.bearing.size()),
      errors_(static_cast<std::size_t>(system.bearings())),
      sorted_(errors_),
      bearing_(options.bearing.size()) {
  std::transform(options.bearing.begin(), options.bearing.end(), weight_.begin(),
                 [](double allowed) { return allowed > 0.0 ? 1.0 / allowed : 0.0; });
}

void CoupledSteps::take_errors(const CoupledSystem& system, double h) {
  for (int b = 0; b < system.bearings(); ++b) {
    const auto first = static_cast<std::size_t>(system.offset(b));
    errors_[static_cast<std::size_t>(b)] = all_.share(h, first, weight_.data(), weight_.size());
  }
  sorted_ = errors_;
  std::sort(sorted_.begin(), sorted_.end(), std::greater<>());
}

bool CoupledSteps::is_kept(double gears) const {
  if (!(gears <= 1.0 && sorted_.front() <= kLargestSubstepped)) return false;
  const auto substepped =
      std::count_if(sorted_.begin(), sorted_.end(), [](double error) { return error > 1.0; });
  return substepped <= options_.most_substepped;
}

// The error that decides on the next step. With the k worst bearings substepped and errors that grow as the
// square of the step, a step costs all bearings once and these again; the k is taken that costs least over
// the time passed.
double CoupledSteps::cheapest_error(double gears) const {
  using integration::StepControl;
  const double all = static_cast<double>(sorted_.size());
  const double least = std::max(gears, sorted_.front() / kLargestSubstepped);
  double cheapest = std::max(least, sorted_.front());
  double cost = all / StepControl::share(cheapest);
  const std::size_t most = std::min(sorted_.size(), static_cast<std::size_t>(options_.most_substepped));
  for (std::size_t k = 1; k <= most; ++k) {
    const double error = k < sorted_.size() ? std::max(least, sorted_[k]) : least;
    const double share = StepControl::share(error);
    double work = all;
    for (std::size_t i = 0; i < k; ++i)
      work += kSubsteppingBegins + 1.0 / StepControl::share(sorted_[i] * share * share);
    if (work / share >= cost) continue;
    cost = work / share;
    cheapest = error;
  }
  return cheapest;
}

integration::StepResult CoupledSteps::try_step(CoupledSystem& system, std::vector<double>& x, double& t,
                                               double& dt) {
  const double h = dt;
  const double gears = all_.attempt(system, x, t, h);
  if (std::isfinite(gears)) take_errors(system, h);
  if (!std::isfinite(gears) || !is_kept(gears)) {
    dt = control_.after_refusal(h, std::isfinite(gears) ? std::max(1.0, cheapest_error(gears)) : gears);
    return integration::kRefused;
  }
  all_.accept(x);
  substep_all(system, all_.replaced_state(), t, h, x);
  t += h;
  dt = control_.after_acceptance(h, cheapest_error(gears));
  return integration::kAccepted;
}

// Substepped bearings have forces on the gears that the step of all did not include: the gears take up the
// difference of the impulses at the end of the step, so that momentum is conserved.
void CoupledSteps::substep_all(CoupledSystem& system, const std::vector<double>& before, double t, double h,
                               std::vector<double>& x) {
  bool any = false;
  for (int b = 0; b < system.bearings(); ++b) {
    if (!(errors_[static_cast<std::size_t>(b)] > 1.0)) continue;
    if (!any) {
      missed_.force.setZero(2, system.model().gears.layout.planets);
      missed_.moment.setZero(system.model().gears.layout.planets);
      any = true;
    }
    const bearing::motion::BoreReaction mean = system.mean_reaction(b);
    const bearing::motion::BoreReaction impulse = substep(system, b, before, t, h, x);
    const Eigen::Index planet = b / system.model().per_planet;
    missed_.force.col(planet) += impulse.force - h * mean.force;
    missed_.moment[planet] += impulse.moment - h * mean.moment;
  }
  if (any) system.push(missed_, x.data());
}

// Returns what it did to the bore over the step [N s], [N m s].
bearing::motion::BoreReaction CoupledSteps::substep(CoupledSystem& system, int b,
                                                    const std::vector<double>& before, double t, double h,
                                                    std::vector<double>& x) {
  const CoupledModel& model = system.model();
  const auto motion_at = [&](const std::vector<double>& state, double time) {
    return at_seat(model, b,
                   bore_motion(model, model.port_of(b), system.true_time(time), system.part(state.data(), 0),
                               system.part(state.data(), system.freedoms())));
  };
  const BoreMotion from = motion_at(before, t);
  const BoreInputs polynomial = polynomial_between(from, motion_at(x, t + h), h);
  const auto position = static_cast<std::size_t>(b);
  DrivenSystem driven(system.bearing(b), polynomial, {from.angle, from.carrier_angle},
                      system.loads[position]);
  std::copy_n(system.of_bearing(before.data(), b), bearing_.size(), bearing_.begin());
  driven.resume(all_.slope().data() + system.offset(b), system.begin_reaction(b));
  double step = h * integration::StepControl::share(errors_[position]);
  integration::through_window(within_, driven, bearing_, h, {.most_steps = options_.most_steps}, step);
  std::copy(bearing_.begin(), bearing_.end(), system.of_bearing(x.data(), b));
  system.counted[position] = true;
  ++substepped_;
  return driven.impulse();
}

}  // namespace orbearing::system
