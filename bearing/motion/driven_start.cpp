#include "bearing/motion/driven_start.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "bearing/equilibrium/roller_balance.hpp"
#include "bearing/motion/driven_bore.hpp"

namespace orbearing::bearing::motion {

namespace {

constexpr double kLeastForce = 1e-12;  // [N]  a bearing that nothing loads is in balance

struct PinProblem {
  RaceEquilibrium races;
  Vector2 bore;
  Vector2 own_load;          // [N]  inertial, on the pin ring
  double stiffness_support;  // [N/m]

  RollerBalance roller(Eigen::Index j, const Vector2& pin) const {
    return balance_roller(races.contacts.inner, races.contacts.outer, races.inertial_load[j],
                          races.approach(j, bore - pin));
  }

  // Forces on the pin ring.
  mechanics::Imbalance<2> at(const Vector2& pin) const {
    mechanics::Imbalance<2> sum;
    sum.force = own_load - stiffness_support * pin;
    sum.stiffness = stiffness_support * Eigen::Matrix2d::Identity();
    sum.scale = own_load.norm() + stiffness_support * pin.norm() + kLeastForce;
    for (Eigen::Index j = 0; j < races.angle.size(); ++j) {
      const Vector2 outward = direction(races.angle[j]);
      const RollerBalance one = roller(j, pin);
      sum.force -= one.inner_load * outward;
      sum.stiffness += one.stiffness * outward * outward.transpose();
      sum.scale += one.inner_load;
    }
    return sum;
  }

  // The pin may have to follow its bore and give way by as much as its own load asks of the support.
  mechanics::SearchLimits limits() const {
    mechanics::SearchLimits limits = search_limits(races);
    limits.size += bore.norm();
    limits.reach += bore.norm() + own_load.norm() / stiffness_support;
    return limits;
  }
};

PinProblem pin_problem(const Bearing& bearing, const BearingModel& model,
                       const DynamicsParameters& parameters, const BoreMotion& motion, double first_roller) {
  OperatingPoint point;
  point.carrier = {motion.carrier_speed, motion.carrier_acceleration, model.frame.orbit_radius};
  point.outer_speed = motion.speed;
  const Vector2 none = Vector2::Zero();
  return {quasi_static_problem(bearing, model.geometry, point, start_options(parameters), first_roller),
          motion.position, model.pin_mass * inertial_acceleration(frame_of(model, motion), none, none),
          model.support.stiffness};
}

void fill_loads(const PinProblem& problem, PinBalance& balance) {
  const Eigen::Index rollers = problem.races.angle.size();
  balance.rollers.angle = problem.races.angle;
  balance.rollers.displacement = problem.bore - balance.pin;
  balance.rollers.inner_load.resize(rollers);
  balance.rollers.outer_load.resize(rollers);
  for (Eigen::Index j = 0; j < rollers; ++j) {
    const RollerBalance one = problem.roller(j, balance.pin);
    balance.rollers.inner_load[j] = one.inner_load;
    balance.rollers.outer_load[j] = one.outer_load;
  }
}

}  // namespace

PinBalance balance_pin(const Bearing& bearing, const BearingModel& model,
                       const DynamicsParameters& parameters, const BoreMotion& motion, double first_roller) {
  const PinProblem problem = pin_problem(bearing, model, parameters, motion, first_roller);
  PinBalance balance;
  mechanics::Imbalance<2> now;
  balance.rollers.report = {mechanics::find_balance<2>([&](const Vector2& pin) { return problem.at(pin); },
                                                       problem.limits(), balance.pin, now)};
  fill_loads(problem, balance);
  return balance;
}

Eigen::VectorXd driven_start(const Bearing& bearing, const BearingModel& model,
                             const DynamicsParameters& parameters, const BoreMotion& motion,
                             double first_roller) {
  const PinBalance balance = balance_pin(bearing, model, parameters, motion, first_roller);
  if (!balance.rollers.report.converged) {
    std::ostringstream text;
    text << "the pin ring found no balance with its bore at (" << motion.position.transpose()
         << ") m: " << balance.rollers.report.residual
         << " N remain; required: a displacement that rollers and support stand";
    throw std::runtime_error(text.str());
  }
  const double spin = kinematic_roller_spin(model.geometry, 0.0, motion.speed);
  const double cage_speed = kinematic_cage_speed(model.geometry, 0.0, motion.speed);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(model.layout.size());
  const QuasiStaticOptions options = start_options(parameters);
  place_bodies(model, rolling_contacts(bearing, model.geometry, 0.0, motion.speed, added_film(options)),
               balance.rollers, {balance.pin, motion.position, cage_speed, spin}, first_roller, x);
  return state_at(model, motion, x);
}

}  // namespace orbearing::bearing::motion
