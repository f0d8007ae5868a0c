#include "bearing/motion/driven_start.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/equilibrium/roller_balance.hpp"
#include "bearing/motion/model_constants.hpp"
#include "mechanics/force_left.hpp"

namespace orbearing::bearing::motion {

namespace {

constexpr double kLeastForce = 1e-12;  // [N]  an unloaded bearing is in equilibrium

// Coordinates: the position of the pin ring, the waves of an elastic outer race, and the position of the bore
// if a load moves it. N = 2 where there are none but the first, else Eigen::Dynamic.
struct PinProblem {
  RaceEquilibrium races;
  Vector2 bore;
  Vector2 own_load;                       // [N]  inertial, on the pin ring
  double stiffness_support;               // [N/m]
  Eigen::VectorXd wave_stiffness;         // [N/m]  (waves)
  Eigen::VectorXd wave_at_rest;           // [m]
  std::optional<Vector2> bore_load = {};  // [N]  under which the bore moves; none: it is held

  Eigen::Index waves() const { return wave_stiffness.size(); }
  Eigen::Index size() const { return 2 + waves() + (bore_load ? 2 : 0); }

  template <class Position>
  Vector2 bore_at(const Position& position) const {
    if constexpr (Position::SizeAtCompileTime == Eigen::Dynamic)
      if (bore_load) return position.template tail<2>();
    return bore;
  }

  template <class Position>
  RollerBalance roller(Eigen::Index j, const Position& position) const {
    double approach = races.approach(j, bore_at(position) - position.template head<2>());
    if constexpr (Position::SizeAtCompileTime == Eigen::Dynamic)
      if (waves() > 0)
        approach -= position.segment(2, waves()).dot(wave_shapes(races.outer_race, races.angle[j]));
    return balance_roller(races.contacts.inner, races.contacts.outer, races.inertial_load[j], approach);
  }

  // Forces on the pin ring, on the waves and on a bore that is free.
  template <int N>
  mechanics::Imbalance<N> at(const Eigen::Vector<double, N>& position) const {
    const Vector2 pin = position.template head<2>();
    const Eigen::Index size = position.size();
    mechanics::Imbalance<N> sum;
    sum.force.setZero(size);
    sum.stiffness.setZero(size, size);
    sum.force.template head<2>() = own_load - stiffness_support * pin;
    sum.stiffness.diagonal().template head<2>().setConstant(stiffness_support);
    if constexpr (N == Eigen::Dynamic) {
      sum.force.segment(2, waves()) -=
          wave_stiffness.cwiseProduct(position.segment(2, waves()) - wave_at_rest);
      sum.stiffness.diagonal().segment(2, waves()) += wave_stiffness;
      if (bore_load) sum.force.template tail<2>() += *bore_load;
    }
    sum.scale = own_load.norm() + stiffness_support * pin.norm() + kLeastForce;
    if (bore_load) sum.scale += bore_load->norm();
    Eigen::Vector<double, N> closes(size);  // the approach by each coordinate
    for (Eigen::Index j = 0; j < races.angle.size(); ++j) {
      closes.template head<2>() = direction(races.angle[j]);
      const RollerBalance one = roller(j, position);
      sum.force.template head<2>() -= one.inner_load * closes.template head<2>();
      if constexpr (N == Eigen::Dynamic) {
        if (waves() > 0) closes.segment(2, waves()) = -wave_shapes(races.outer_race, races.angle[j]);
        if (bore_load) closes.template tail<2>() = -direction(races.angle[j]);
        sum.force.tail(size - 2) -= one.outer_load * closes.tail(size - 2);
      }
      sum.stiffness += one.stiffness * closes * closes.transpose();
      sum.scale += one.inner_load;
    }
    return sum;
  }

  // The pin may have to follow its bore and deflect by as much as its own load deflects the support.
  mechanics::SearchLimits limits() const {
    mechanics::SearchLimits limits = search_limits(races);
    limits.size += bore.norm();
    limits.reach += bore.norm() + own_load.norm() / stiffness_support;
    if (bore_load) limits.reach += bore_load->norm() / stiffness_support;
    return limits;
  }
};

PinProblem pin_problem(const Bearing& bearing, const BearingModel& model,
                       const DynamicsParameters& parameters, const BoreMotion& motion, double first_roller) {
  OperatingPoint point;
  point.carrier = {motion.carrier_speed, motion.carrier_acceleration, model.frame.orbit_radius};
  point.outer_speed = motion.speed;
  point.outer_race = model.point.outer_race;
  const Vector2 none = Vector2::Zero();
  Vector2 on_pin =
      model.pin_mass * inertial_acceleration(vectorised::surroundings_of(model, motion).frame, none, none);
  if (model.gravity.acts()) on_pin += model.pin_mass * gravity_at(model, motion.carrier_angle);
  const auto of_waves = [&](double vectorised::RimWave::*number) {
    Eigen::VectorXd all(model.layout.waves);
    std::transform(model.rim.begin(), model.rim.end(), all.begin(), std::mem_fn(number));
    return all;
  };
  return {quasi_static_problem(bearing, model.geometry, point, start_options(parameters), first_roller),
          motion.position,
          on_pin,
          model.support.stiffness,
          of_waves(&vectorised::RimWave::stiffness),
          of_waves(&vectorised::RimWave::at_rest)};
}

template <int N>
void solve_in(const PinProblem& problem, PinBalance& balance) {
  Eigen::Vector<double, N> position = Eigen::Vector<double, N>::Zero(problem.size());
  if constexpr (N == Eigen::Dynamic) position.segment(2, problem.waves()) = problem.wave_at_rest;
  mechanics::Imbalance<N> now;
  balance.rollers.report = {
      mechanics::find_balance<N>([&](const Eigen::Vector<double, N>& at) { return problem.at<N>(at); },
                                 problem.limits(), position, now)};
  balance.rollers.report.residual = mechanics::force_left(balance.rollers.report.residual);
  const Eigen::Index rollers = problem.races.angle.size();
  balance.pin = position.template head<2>();
  if constexpr (N == Eigen::Dynamic) balance.rollers.waves = position.segment(2, problem.waves());
  balance.rollers.angle = problem.races.angle;
  balance.bore = problem.bore_at(position);
  balance.rollers.displacement = balance.bore - balance.pin;
  balance.rollers.inner_load.resize(rollers);
  balance.rollers.outer_load.resize(rollers);
  for (Eigen::Index j = 0; j < rollers; ++j) {
    const RollerBalance one = problem.roller(j, position);
    balance.rollers.inner_load[j] = one.inner_load;
    balance.rollers.outer_load[j] = one.outer_load;
  }
}

}  // namespace

PinBalance balance_pin(const Bearing& bearing, const BearingModel& model,
                       const DynamicsParameters& parameters, const BoreMotion& motion, double first_roller) {
  const PinProblem problem = pin_problem(bearing, model, parameters, motion, first_roller);
  PinBalance balance;
  if (problem.waves() == 0)
    solve_in<2>(problem, balance);
  else
    solve_in<Eigen::Dynamic>(problem, balance);
  return balance;
}

PinBalance balance_pin_and_bore(const Bearing& bearing, const BearingModel& model,
                                const DynamicsParameters& parameters, const BoreMotion& motion,
                                double first_roller, const Vector2& load) {
  PinProblem problem = pin_problem(bearing, model, parameters, motion, first_roller);
  problem.bore.setZero();
  problem.bore_load = load;
  PinBalance balance;
  solve_in<Eigen::Dynamic>(problem, balance);
  return balance;
}

Eigen::VectorXd driven_start(const Bearing& bearing, const BearingModel& model,
                             const DynamicsParameters& parameters, const BoreMotion& motion,
                             double first_roller) {
  const PinBalance balance = balance_pin(bearing, model, parameters, motion, first_roller);
  if (!balance.rollers.report.converged) {
    std::ostringstream text;
    text << "the pin ring found no static equilibrium with its bore at (" << motion.position.transpose()
         << ") m: " << mechanics::force_left_text(balance.rollers.report.residual)
         << "; required: a displacement that rollers and support can carry";
    throw std::runtime_error(text.str());
  }
  const double spin = kinematic_roller_spin(model.geometry, 0.0, motion.speed);
  const double cage_speed = kinematic_cage_speed(model.geometry, 0.0, motion.speed);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(model.layout.size());
  const QuasiStaticOptions options = start_options(parameters);
  place_bodies(model, rolling_contacts(bearing, model.geometry, 0.0, motion.speed, options.film),
               balance.rollers, {balance.pin, motion.position, cage_speed, spin}, first_roller, x);
  x.segment<2>(model.layout.bore()) = motion.position;
  x.segment<2>(model.layout.bore() + 2) = motion.velocity;
  return x;
}

}  // namespace orbearing::bearing::motion
