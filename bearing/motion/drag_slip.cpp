#include "bearing/motion/drag_slip.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mechanics/constants.hpp"

namespace orbearing::bearing::motion {

namespace {

using constants::two_pi;

constexpr Eigen::Index kPositions = 48;  // [-]  of the orbit that are enough
constexpr double kSpinError = 1e-7;      // [-]  of a roller's surface speed
constexpr double kSpeedError = 1e-7;     // [-]  of the orbit at pure rolling
constexpr double kPlaceError = 1e-3;     // [-]  of the land's clearance, from one lap to the next
constexpr double kTractionShare = 0.01;  // [-]  that counts compared with drag
constexpr double kMomentError = 1e-5;    // [-]  of scale(), likewise
constexpr double kMomentLeft = 1e-2;     // [-]  of scale(), where the slip was found
constexpr int kMostLaps = 60;
constexpr int kMostTrials = 200;
constexpr double kLongestStep = 0.2;  // [-]  of the land's clearance

double pitch_of(const BearingModel& model) {
  return 0.5 * (model.geometry.inner_radius + model.geometry.outer_radius);
}

double pure_rolling(const BearingModel& model) {
  return kinematic_cage_speed(model.geometry, model.point.inner_speed, model.point.outer_speed);
}

// 1 or -1: that of pure rolling, also for a stationary cage.
double sense_of_orbit(const BearingModel& model) {
  return pure_rolling(model) < 0.0 ? -1.0 : 1.0;
}

double land_speed(const BearingModel& model) {
  return model.land.on_bore ? model.point.outer_speed : model.point.inner_speed;
}

// Zero of the falling function `f` within [least, most]; beyond them the nearer bound. From `guess` outwards
// by steps that double, then by regula falsi with halved values.
template <class Function>
double falling_root(const Function& f, double guess, double step, double least, double most, double error) {
  double low = guess, high = guess, at_low = f(guess), at_high = at_low;
  if (at_low == 0.0) return guess;
  const double towards = at_low > 0.0 ? 1.0 : -1.0;
  while (at_low * at_high > 0.0) {
    const double next = std::clamp((towards > 0.0 ? high : low) + towards * step, least, most);
    if (towards > 0.0) {
      if (next == high) return high;
      low = high, at_low = at_high;
      high = next, at_high = f(next);
    } else {
      if (next == low) return low;
      high = low, at_high = at_low;
      low = next, at_low = f(next);
    }
    step *= 4.0;
  }
  for (int last = 0, trial = 0; high - low > error && trial < kMostTrials; ++trial) {
    const double middle = (high * at_low - low * at_high) / (at_low - at_high);
    const double value = f(middle);
    if (value == 0.0) return middle;
    const int side = value > 0.0 ? 1 : -1;
    if (side > 0) {
      low = middle, at_low = value;
      if (last == side) at_high *= 0.5;
    } else {
      high = middle, at_high = value;
      if (last == side) at_low *= 0.5;
    }
    last = side;
  }
  return at_low - at_high > 0.0 ? (high * at_low - low * at_high) / (at_low - at_high) : low;
}

// Means over so many neighbours that kPositions are left, or more.
Eigen::ArrayXd thinned(const Eigen::ArrayXd& all) {
  Eigen::Index group = std::max<Eigen::Index>(1, all.size() / kPositions);
  while (all.size() % group != 0) --group;
  Eigen::ArrayXd means(all.size() / group);
  for (Eigen::Index i = 0; i < means.size(); ++i) means[i] = all.segment(i * group, group).mean();
  return means;
}

struct OnRoller {
  double along = 0.0;   // [N]    in the sense of growing angles
  double moment = 0.0;  // [N m]
};

OnRoller& operator+=(OnRoller& sum, const OnRoller& one) {
  sum.along += one.along;
  sum.moment += one.moment;
  return sum;
}

// A roller at one position.
struct Passing {
  double inner = 0.0, outer = 0.0;  // [N]
  double orbit = 0.0;               // [rad/s]
  double others = 0.0;              // [N]  along the orbit, of all but the races and the bar
};

OnRoller of_race(const BearingModel& model, const RaceModel& race, double race_speed, double load,
                 double orbit, double spin) {
  if (load <= 0.0) return {};
  const double pitch = pitch_of(model), roller_arm = race.side * pitch * model.geometry.slenderness;
  const double race_arm = pitch + roller_arm;
  const double race_surface = (race_speed - orbit) * race_arm, roller_surface = (spin - orbit) * roller_arm;
  const double rolling = 0.5 * (race_surface + roller_surface);
  const double log_speed = std::log(entrainment_speed(rolling, race.entrainment_scale));
  const double friction = race.friction.friction(load, race_surface - roller_surface, log_speed);
  const double inlet = race.friction.rolling_resistance ? race.friction.inlet(load, rolling, log_speed) : 0.0;
  return {friction + inlet * (race_arm + roller_arm) / pitch, (friction - inlet) * roller_arm};
}

OnRoller on_roller(const BearingModel& model, const Passing& at, double spin) {
  const double radius = pitch_of(model) * model.geometry.slenderness;
  OnRoller sum{0.0, model.spin_drag.force(spin)};
  sum += of_race(model, model.inner, model.point.inner_speed, at.inner, at.orbit, spin);
  sum += of_race(model, model.outer, model.point.outer_speed, at.outer, at.orbit, spin);
  const double bar = std::abs(sum.along + at.others);
  sum.moment -= radius * model.pocket.friction.force(bar, radius * (spin - at.orbit));
  return sum;
}

// A cage in its land.
struct Guided {
  Vector2 centre = Vector2::Zero();  // [m]
  double moment = 0.0;               // [N m]  of the land about the cage's axis
};

// Position of the cage at which film and touch-down hold `load` [N].
Guided guided(const BearingModel& model, const Vector2& load, double speed) {
  if (!model.land.present) return {};
  const LandLaw& law = model.land.law;
  const auto at = [&](double offset) {
    return law.force(LandMotion<double>{offset, 0.0, 0.0, 0.0, speed}, land_speed(model));
  };
  const double size = load.norm(), most = law.clearance + 2.0 * size / law.stiffness;
  const auto left = [&](double offset) {
    const LandForce<double> force = at(offset);
    return size - std::hypot(force.x, force.y);
  };
  const double offset = falling_root(left, law.largest_eccentricity * law.clearance, 1e-3 * law.clearance,
                                     0.0, most, 1e-6 * most);
  const LandForce<double> force = at(offset);
  const Vector2 by_land(force.x, force.y);
  const double scale = by_land.norm() * size;
  if (!(scale > 0.0)) return {Vector2::Zero(), force.on_cage};
  // Turned so that the land holds the load.
  return {-offset / scale * Vector2(by_land.dot(load), cross(by_land, load)), force.on_cage};
}

// Rollers and cage on their orbit; it goes on from where the last speed left it.
class Orbit {
 public:
  Orbit(const BearingModel& model, const LoadsOfOrbit& loads)
      : model_(model),
        inner_(thinned(loads.inner)),
        outer_(thinned(loads.outer)),
        pitch_(pitch_of(model)),
        rolling_(pure_rolling(model)),
        field_(model.frame.centrifugal * model.frame.orbit_radius),
        first_angle_(0.5 * two_pi / static_cast<double>(inner_.size()) -
                     0.5 * two_pi / static_cast<double>(loads.inner.size())),
        small_(kMomentError * scale_of(model)),
        spin_(kinematic_roller_spin(model.geometry, model.point.inner_speed, model.point.outer_speed)) {}

  /// Mean moment [N m] on the cage at `speed` [rad/s]; `settled()`: whether its position was found.
  double moment(double speed) {
    double before = 0.0;
    Vector2 step = Vector2::Zero(), last = Vector2::Zero();  // [m]  and what was left before it
    settled_ = false;
    for (int lap = 0; lap < kMostLaps; ++lap) {
      const double spin = spin_, of_rollers = once_around(speed);
      const Guided next = guided(model_, load_, speed);
      const double sum = of_rollers + next.moment + model_.cage_drag.force(speed);
      const Vector2 left = next.centre - centre_;
      const double clearance = model_.land.law.clearance;
      if (lap > 0 && std::abs(sum - before) <= small_ && left.norm() <= kPlaceError * clearance &&
          std::abs(spin_ - spin) <= kMomentError * std::abs(spin)) {
        settled_ = true;
        return sum;
      }
      if (lap > 0 && step.squaredNorm() > 0.0) {  // Broyden: derivative of the residual by the position
        const Vector2 missed = left - last - slope_ * step;
        slope_ += missed * step.transpose() / step.squaredNorm();
      }
      step = -slope_.inverse() * left;
      const double most = kLongestStep * clearance;
      if (!step.allFinite()) step = 0.5 * left;
      if (step.norm() > most) step *= most / step.norm();
      if ((centre_ + step).norm() > 1.05 * clearance) step = 0.5 * left;
      centre_ += step;
      last = left;
      before = sum;
    }
    return before;
  }
  bool settled() const { return settled_; }
  double scale() const { return small_ / kMomentError; }  // [N m]  of moments about the pin

 private:
  // Drag at pure rolling and some of the traction that there is.
  double scale_of(const BearingModel& model) const {
    const double traction = 0.5 * model.inner.friction.coulomb.friction * (inner_ + outer_).mean();
    return std::abs(model.cage_drag.force(rolling_)) +
           pitch_ * static_cast<double>(model.layout.rollers) *
               (std::abs(model.orbit_drag.force(pitch_ * rolling_)) + kTractionShare * traction);
  }

  Passing passing(Eigen::Index k, const Vector2& outward, double speed) const {
    const double orbit = speed * (1.0 - centre_.dot(outward) / pitch_);
    const double lighter = model_.roller.mass * pitch_ *
                           (model_.frame.own_orbit * (rolling_ * rolling_ - orbit * orbit) +
                            2.0 * model_.frame.coriolis_speed * (rolling_ - orbit));
    const double outer = outer_[k] - lighter;
    const double weight = -field_ * outward.y(), speeding = -speed * orbit * centre_.dot(across(outward));
    return {inner_[k] - std::min(outer, 0.0), std::max(outer, 0.0), orbit,
            model_.orbit_drag.force(pitch_ * orbit) + model_.roller.mass * (weight - speeding)};
  }

  double next_spin(const Passing& at, double time) const {
    const double gamma = model_.geometry.slenderness;
    const double limit = 2.0 / gamma *
                             std::max(std::abs(model_.point.inner_speed - at.orbit) * (1.0 - gamma),
                                      std::abs(model_.point.outer_speed - at.orbit) * (1.0 + gamma)) +
                         std::abs(at.orbit);
    return falling_root(
        [&](double spin) {
          return on_roller(model_, at, spin).moment - model_.roller.inertia * (spin - spin_) / time;
        },
        spin_, 1e-3 * limit, at.orbit - limit, at.orbit + limit, kSpinError * limit);
  }

  // Moment of all bars about the cage's axis [N m].
  double once_around(double speed) {
    const Eigen::Index n = inner_.size();
    const double each = static_cast<double>(model_.layout.rollers) / static_cast<double>(n);
    const double longest = 1e6;  // [s]  of a stationary cage: rollers in equilibrium
    const double angle = two_pi / static_cast<double>(n);
    double moment = 0.0;
    load_ = {model_.cage.mass * field_, 0.0};
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Index k = speed < 0.0 ? n - 1 - i : i;
      const Vector2 outward = direction(first_angle_ + angle * static_cast<double>(k));
      const Passing at = passing(k, outward, speed);
      spin_ = next_spin(at, std::min(longest, angle / std::max(std::abs(at.orbit), 1e-300)));
      const double bar = on_roller(model_, at, spin_).along + at.others;
      load_ += each * bar * across(outward);
      moment += each * bar * (pitch_ - centre_.dot(outward));
    }
    return moment;
  }

  const BearingModel& model_;
  Eigen::ArrayXd inner_, outer_;  // [N]  (positions)
  double pitch_, rolling_, field_, first_angle_, small_;
  Vector2 centre_ = Vector2::Zero();                            // [m]  of the cage
  Vector2 load_ = Vector2::Zero();                              // [N]  on it
  Eigen::Matrix2d slope_ = -2.0 * Eigen::Matrix2d::Identity();  // [-]  of the residual by the position
  bool settled_ = false;
  double spin_;  // [rad/s]  of the roller at the position last passed
};

}  // namespace

double resistance_to_orbit(const BearingModel& model, double speed) {
  const double pitch = pitch_of(model), along = sense_of_orbit(model);
  double resistance =
      -along * static_cast<double>(model.layout.rollers) * model.orbit_drag.force(pitch * speed) -
      along * model.cage_drag.force(speed) / pitch;
  if (!model.land.present) return resistance;
  const LandMotion<double> centred{0.0, 0.0, 0.0, 0.0, speed};
  return resistance - along * model.land.law.force(centred, land_speed(model)).on_cage / pitch;
}

double drag_over_traction(const BearingModel& model, const LoadsOfOrbit& loads) {
  const double resistance = resistance_to_orbit(model, pure_rolling(model));
  if (resistance <= 0.0) return 0.0;
  return resistance / (2.0 * model.inner.friction.coulomb.friction *
                       static_cast<double>(model.layout.rollers) * loads.inner.min(loads.outer).mean());
}

std::optional<double> drag_slip(const BearingModel& model, const LoadsOfOrbit& loads) {
  const double along = sense_of_orbit(model), rolling = std::abs(pure_rolling(model));
  const double most = std::max(along * model.point.inner_speed, along * model.point.outer_speed);
  Orbit orbit(model, loads);
  const double speed = falling_root([&](double w) { return along * orbit.moment(along * w); }, rolling,
                                    0.01 * rolling, 0.0, most, kSpeedError * rolling);
  const double left = std::abs(orbit.moment(along * speed));
  if (speed > 0.0 && !(orbit.settled() && left <= kMomentLeft * orbit.scale())) return std::nullopt;
  return 1.0 - speed / rolling;
}

}  // namespace orbearing::bearing::motion
