#include "coupling/system/ball_run.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "bearing/friction/oil_supply.hpp"
#include "bearing/geometry.hpp"
#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/damage.hpp"
#include "bearing/life/reference_life.hpp"
#include "bearing/motion/balls/published_form.hpp"
#include "coupling/integration/run.hpp"
#include "coupling/system/balls_in_time.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::system {

namespace {

using bearing::balls::BallBearing;
using bearing::balls::BallNumbers;
using bearing::balls::BallPowerLoss;
using bearing::balls::BallSnapshot;
using bearing::balls::StateLayout;

void add_loss(BallPowerLoss& sum, const BallPowerLoss& other, double weight) {
  sum.sliding += weight * other.sliding;
  sum.differential += weight * other.differential;
  sum.spin += weight * other.spin;
  sum.rolling += weight * other.rolling;
  sum.damping += weight * other.damping;
  sum.cage += weight * other.cage;
  sum.churning += weight * other.churning;
}

// Sums over the steps while observed.
struct ObservedSteps {
  double weight = 0.0;  // [s]
  double turned = 0.0;  // [rad]  of one ring against the other
  double inner_square = 0.0, outer_square = 0.0;
  double inner_max = 0.0, outer_max = 0.0;
  bearing::motion::DamageSums damage;
};

// Integrals over time of the states at the beginnings of steps, by the trapezoidal rule.
struct ObservedStates {
  double weight = 0.0;                                            // [s]
  double inner_load = 0.0, outer_load = 0.0;                      // [N s]
  double inner_angle = 0.0, outer_angle = 0.0;                    // [N rad s]
  double inner_film = 0.0, outer_film = 0.0;                      // [m s]
  double inner_loaded = 0.0, outer_loaded = 0.0;                  // [s]
  BallPowerLoss loss;                                             // [J]
  std::array<double, kPartsObserved> part_weight{}, part_loss{};  // [s], [J]

  /// `share` of the observed time that has passed [-].
  void add(double step, double share, const BallSnapshot& s) {
    const double length = 0.5 * (step + std::exchange(before, step));
    weight += length;
    add_loss(loss, s.loss, length);
    const auto part = std::min(kPartsObserved - 1, static_cast<std::size_t>(share * kPartsObserved));
    part_weight[part] += length;
    part_loss[part] += length * s.loss.total();
    add(length, s.inner, inner_load, inner_angle, inner_film, inner_loaded);
    add(length, s.outer, outer_load, outer_angle, outer_film, outer_loaded);
  }

 private:
  double before = 0.0;  // [s]  length of the step before

  template <class Contacts>
  static void add(double length, const Contacts& contacts, double& load, double& angle, double& film,
                  double& loaded) {
    for (const auto& contact : contacts) {
      load += length * contact.load;
      angle += length * contact.load * contact.contact_angle;
      if (!(contact.load > 0.0)) continue;
      film += length * contact.central_film;
      loaded += length;
    }
  }
};

double rolling_cage_speed(const bearing::BearingGeometry& geometry, const bearing::balls::BallDuty& duty,
                          double time) {
  return kinematic_cage_speed(geometry, duty.inner.speed_at(time), duty.outer.speed_at(time));
}

// Sums what passes in each step.
class WatchedBalls : public BallEquations {
 public:
  /// Observed in the interval [s].
  WatchedBalls(BallBearing& bearing, const bearing::BearingGeometry& geometry, double observe_from,
               double until, long bins)
      : BallEquations(bearing),
        geometry_(geometry),
        observe_from_(observe_from),
        until_(until),
        sums_{.damage = bearing::motion::DamageSums(bins, 0, bearing::motion::DamagePower::of_points)} {}

  // The loads of the linearisation are those of the step's beginning; they count until its end.
  void begun(const std::vector<double>& x) {
    const StateLayout& layout = bearing_.layout();
    const bearing::balls::ContactLoads loads = bearing_.loads();
    const auto count = static_cast<std::size_t>(layout.balls);
    inner_.assign(loads.inner, loads.inner + count);
    outer_.assign(loads.outer, loads.outer + count);
    for (std::size_t j = 0; j < count; ++j) pocket_ = std::max(pocket_, loads.pocket[j]);
    const double* angle = x.data() + layout.lanes();
    angle_.assign(angle, angle + count);
    orbital_.assign(x.data() + 4 * layout.lanes(), x.data() + 4 * layout.lanes() + count);
    cage_speed_ = x[static_cast<std::size_t>(layout.inner() - 1)];
    state_ = x;
  }
  void stepped(double time, double length) {
    const double rolling = rolling_cage_speed(geometry_, bearing_.duty(), time);
    if (rolling != 0.0) {
      history_.time.push_back(time);
      history_.slip.push_back(1.0 - cage_speed_ / rolling);
    }
    if (time < observe_from_) return;
    rolled_ += length * rolling_cage_speed(geometry_, bearing_.duty(), time + 0.5 * length);
    sums_.weight += length;
    const double middle = time + 0.5 * length;
    sums_.turned +=
        length * std::abs(bearing_.duty().inner.speed_at(middle) - bearing_.duty().outer.speed_at(middle));
    states_.add(length, (time - observe_from_) / (until_ - observe_from_),
                bearing_.snapshot(time, state_.data()));
    for (std::size_t j = 0; j < inner_.size(); ++j) {
      sums_.inner_square += length * inner_[j] * inner_[j];
      sums_.outer_square += length * outer_[j] * outer_[j];
      sums_.inner_max = std::max(sums_.inner_max, inner_[j]);
      sums_.outer_max = std::max(sums_.outer_max, outer_[j]);
    }
    const bearing::balls::BallDuty& duty = bearing_.duty();
    sums_.damage.add(length, bearing_.layout().balls,
                     {.angle = angle_.data(),
                      .orbital_speed = orbital_.data(),
                      .inner = inner_.data(),
                      .outer = outer_.data(),
                      .races = bearing::motion::race_speeds(geometry_, duty.inner.speed_at(time),
                                                            duty.outer.speed_at(time))});
  }
  const ObservedSteps& sums() const { return sums_; }
  const ObservedStates& states() const { return states_; }
  /// Largest load of a pocket since the last call [N].
  double take_pocket_load() { return std::exchange(pocket_, 0.0); }
  /// Angle of a cage that rolls without slip while observed [rad].
  double rolled() const { return rolled_; }
  /// Slip of every step.
  SlipHistory take_history() { return std::move(history_); }

 private:
  const bearing::BearingGeometry& geometry_;
  double observe_from_, until_;
  ObservedSteps sums_;
  ObservedStates states_;
  std::vector<double> inner_, outer_, angle_, orbital_;
  std::vector<double> state_;  // at the beginning of the step
  double pocket_ = 0.0;        // [N]
  double cage_speed_ = 0.0;    // [rad/s]
  double rolled_ = 0.0;        // [rad]
  SlipHistory history_;
};

// The classic Runge-Kutta method for the printed form.
class PublishedSteps {
 public:
  /// Steps of `longest` [s] at most.
  PublishedSteps(BallBearing& bearing, const std::vector<double>& start, double longest)
      : form_(bearing), longest_(longest), y_(form_.reduced(start)), then_(y_), sum_(y_), rate_(y_) {
    mechanics::require(longest > 0.0, "step [s]", longest, "more than 0");
  }

  /// To `end` [s], as BallsInTime::advance().
  void advance(WatchedBalls& system, double end, integration::Run& budget,
               const integration::IntegrationReport& report) {
    const double from = time_, steps = std::ceil((end - from) / longest_), length = (end - from) / steps;
    for (double i = 0.0; i < steps; ++i) {
      step(system, from + i * length, length);
      time_ = i + 1.0 < steps ? from + (i + 1.0) * length : end;
      if (!budget.accept(time_, length)) throw std::runtime_error(report.message);
    }
  }
  double time() const { return time_; }  // [s]
  const std::vector<double>& state() { return form_.complete(time_, y_.data()); }

 private:
  void step(WatchedBalls& system, double time, double length) {
    constexpr double position[] = {0.0, 0.5, 0.5, 1.0},
                     weight[] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    sum_ = y_;
    for (int stage = 0; stage < 4; ++stage) {
      for (std::size_t i = 0; i < y_.size(); ++i)
        then_[i] = y_[i] + (stage > 0 ? position[stage] * length * rate_[i] : 0.0);
      form_.derivative(time + position[stage] * length, then_.data(), rate_.data());
      if (stage == 0) system.begun(form_.complete());
      for (std::size_t i = 0; i < y_.size(); ++i) sum_[i] += weight[stage] * length * rate_[i];
    }
    y_.swap(sum_);
    system.stepped(time, length);
  }

  bearing::balls::PublishedForm form_;
  double longest_, time_ = 0.0;
  std::vector<double> y_, then_, sum_, rate_;
};

double mean_of(double sum, double count) {
  return count > 0.0 ? sum / count : 0.0;
}

// Sums of parts over their counts; not a number where a part is empty.
std::array<double, kPartsObserved> means_of_parts(const std::array<double, kPartsObserved>& sums,
                                                  const std::array<double, kPartsObserved>& counts) {
  std::array<double, kPartsObserved> means{};
  for (std::size_t i = 0; i < kPartsObserved; ++i) means[i] = sums[i] / counts[i];
  return means;
}

// Of the samples from `first` on.
double error_of_samples(const std::vector<double>& samples, std::size_t first) {
  std::array<double, kPartsObserved> sums{}, counts{};
  for (std::size_t i = first; i < samples.size(); ++i) {
    const std::size_t part = kPartsObserved * (i - first) / (samples.size() - first);
    sums[part] += samples[i];
    counts[part] += 1.0;
  }
  return error_of_mean(means_of_parts(sums, counts));
}

BallMeans means_of_balls(const ObservedSteps& steps, const ObservedStates& states, int balls) {
  BallMeans m;
  const double contacts = steps.weight * balls;
  m.inner_load_rms = std::sqrt(mean_of(steps.inner_square, contacts));
  m.outer_load_rms = std::sqrt(mean_of(steps.outer_square, contacts));
  m.inner_load_max = steps.inner_max;
  m.outer_load_max = steps.outer_max;
  m.friction_torque = mean_of(states.loss.total(), steps.turned);
  m.inner_angle = mean_of(states.inner_angle, states.inner_load);
  m.outer_angle = mean_of(states.outer_angle, states.outer_load);
  m.inner_film = mean_of(states.inner_film, states.inner_loaded);
  m.outer_film = mean_of(states.outer_film, states.outer_loaded);
  add_loss(m.loss, states.loss, mean_of(1.0, states.weight));
  m.heat_error = error_of_mean(means_of_parts(states.part_loss, states.part_weight));
  return m;
}

void sample_series(const BallBearing& model, const bearing::BearingGeometry& geometry, double time,
                   const double* x, const BallSnapshot& s, double pocket_load, BallSeries& series) {
  const StateLayout& layout = model.layout();
  const double rolling = rolling_cage_speed(geometry, model.duty(), time);
  const double* inner = x + layout.inner();
  series.time.push_back(time);
  series.cage_speed.push_back(s.cage_speed);
  series.cage_slip.push_back(rolling != 0.0 ? 1.0 - s.cage_speed / rolling : 0.0);
  series.inner_speed.push_back(model.duty().inner.speed_at(time));
  series.cage_x.push_back(s.cage_position.x());
  series.cage_y.push_back(s.cage_position.y());
  series.pocket_load.push_back(pocket_load);
  series.torque.push_back(s.inner_torque);
  series.inner_x.push_back(inner[0]);
  series.inner_y.push_back(inner[1]);
  series.inner_z.push_back(inner[2]);
  series.first_angle.push_back(x[layout.lanes()]);
  series.first_inner.push_back(s.inner.front().load);
  series.first_outer.push_back(s.outer.front().load);
  series.loss.push_back(s.loss);
}

// Whether no load has a direction across the axis.
bool is_symmetric(const bearing::balls::BallDuty& duty) {
  const auto is_axial = [](const bearing::balls::RingLoad& load) {
    return load.by[0] == 0.0 && load.by[1] == 0.0 && load.by[3] == 0.0 && load.by[4] == 0.0;
  };
  return is_axial(duty.on_inner) && is_axial(duty.on_outer);
}

}  // namespace

double error_of_mean(const std::array<double, kPartsObserved>& parts) {
  const boost::math::students_t spread(kPartsObserved - 1);
  const auto of = Eigen::Map<const Eigen::ArrayXd>(parts.data(), kPartsObserved);
  const double squares = (of - of.mean()).square().sum();
  return quantile(spread, 0.975) * std::sqrt(squares / (kPartsObserved * (kPartsObserved - 1)));
}

std::optional<double> settling_time(const SlipHistory& h, double end, double band) {
  const double last_third = 2.0 / 3.0 * end;
  const auto first =
      static_cast<std::size_t>(std::lower_bound(h.time.begin(), h.time.end(), last_third) - h.time.begin());
  if (first + 1 >= h.time.size()) return std::nullopt;
  double sum = 0.0;
  for (std::size_t i = first; i + 1 < h.time.size(); ++i)
    sum += 0.5 * (h.slip[i] + h.slip[i + 1]) * (h.time[i + 1] - h.time[i]);
  const double mean = sum / (h.time.back() - h.time[first]);
  std::size_t inside = h.time.size();
  while (inside > 0 && std::abs(h.slip[inside - 1] - mean) <= band) --inside;
  if (inside == 0) return 0.0;
  if (inside > first) return std::nullopt;
  const double outside = h.slip[inside - 1];
  const double edge = outside > mean ? mean + band : mean - band;
  const double share = (edge - outside) / (h.slip[inside] - outside);
  return h.time[inside - 1] + share * (h.time[inside] - h.time[inside - 1]);
}

BallRunResult run_balls(const bearing::Bearing& bearing, const bearing::balls::MotionParameters& parameters,
                        const bearing::balls::BallDuty& duty,
                        const bearing::rating::ContactCapacities& capacities, const BallRunOptions& options,
                        const std::function<void(double)>& progress) {
  mechanics::require(options.duration > 0.0, "duration of the run [s]", options.duration, "more than 0");
  mechanics::require(options.observed > 0.0 && options.observed <= 1.0, "observed share of the run [-]",
                     options.observed, "more than 0 and at most 1");
  mechanics::require(options.samples >= 2, "samples", options.samples, "at least 2");
  const double speed = duty.inner.speed_at(options.duration) - duty.outer.speed_at(options.duration);
  const BallNumbers numbers =
      bearing::balls::ball_numbers(bearing, bearing::friction::supplied(bearing, parameters, speed));
  const bearing::BearingGeometry geometry = geometry_of(bearing);
  BallBearing model(numbers, duty);
  std::vector<double> x = options.from.empty() ? start_state(bearing, model, options.first_ball,
                                                             options.start == Start::rest ? 0.0 : 1.0)
                                               : options.from;
  if (options.from.empty() && is_symmetric(duty))
    x[static_cast<std::size_t>(model.layout().cage())] = kOffCentre;
  mechanics::require(static_cast<int>(x.size()) == model.layout().size(),
                     "variables of the state to continue from", static_cast<int>(x.size()),
                     "those of the bearing");
  // Observed from a sample on.
  const long first_observed =
      std::min<long>(options.samples - 1, std::lround(options.samples * (1.0 - options.observed)));
  const auto sample_time = [&](long i) {
    return options.duration * static_cast<double>(i) / options.samples;
  };
  const double observe_from = sample_time(first_observed);
  WatchedBalls system(model, geometry, observe_from, options.duration, options.bins);
  BallsInTime balls(x, ball_stepper(numbers, options.length_error));
  std::optional<PublishedSteps> published;
  if (options.form == BallForm::published) published.emplace(model, x, options.published_step);
  BallRunResult result;
  result.report.smallest_step = std::numeric_limits<double>::infinity();
  integration::IntegrationOptions limits;
  limits.most_seconds = options.most_seconds;
  integration::Run budget(limits, result.report);
  const int cage_turn = model.layout().cage() + 5;
  double time = 0.0, observed_since = 0.0, angle_then = 0.0;
  bool observing = false;
  const auto sample = [&] {
    const BallSnapshot s = model.snapshot(time, x.data());
    const double pocket = system.take_pocket_load();
    result.pocket_load_max = std::max(result.pocket_load_max, pocket);
    sample_series(model, geometry, time, x.data(), s, pocket, result.series);
    if (time < observe_from) return;
    if (std::exchange(observing, true)) return;
    observed_since = time;
    angle_then = x[static_cast<std::size_t>(cage_turn)];
  };
  try {
    sample();
    for (long i = 1; i <= options.samples; ++i) {
      if (published) {
        published->advance(system, sample_time(i), budget, result.report);
        x = published->state();
      } else {
        balls.advance(system, sample_time(i), budget, result.report);
        x = balls.state();
      }
      time = sample_time(i);
      require_containment(numbers, x.data());
      sample();
      if (progress) progress(time);
    }
    result.completed = true;
  } catch (const std::runtime_error& error) {
    result.message = error.what();
  }
  result.report.completed = result.completed;
  result.report.wall_seconds = budget.seconds();
  result.means = means_of_balls(system.sums(), system.states(), numbers.balls);
  const double span = time - observed_since;
  if (observing && span > 0.0) {
    const double turned = x[static_cast<std::size_t>(cage_turn)] - angle_then;
    result.means.cage_speed = turned / span;
    result.means.cage_slip = system.rolled() != 0.0 ? 1.0 - turned / system.rolled() : 0.0;
    result.means.cage_slip_error =
        error_of_samples(result.series.cage_slip, static_cast<std::size_t>(first_observed));
  }
  const bearing::motion::DamageSums& damage = system.sums().damage;
  const Eigen::ArrayXd inner = damage.inner.damage().pow(1.0 / 3.0),
                       outer = damage.outer.damage().pow(1.0 / 3.0);
  result.means.equivalent = {bearing::rating::equivalent_ball_load(inner, bearing.motions.inner),
                             bearing::rating::equivalent_ball_load(outer, bearing.motions.outer)};
  result.means.life = bearing::rating::ball_reference_life(capacities, result.means.equivalent.inner,
                                                           result.means.equivalent.outer);
  result.means.balls_life = bearing::rating::life_of_balls(
      bearing, capacities,
      {.inner = std::cbrt(damage.inner.damage().mean()), .outer = std::cbrt(damage.outer.damage().mean())});
  if (result.completed)
    result.slip_settling = settling_time(system.take_history(), options.duration, options.settling_band);
  result.final_state = std::move(x);
  return result;
}

}  // namespace orbearing::system
