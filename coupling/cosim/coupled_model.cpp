#include "coupling/cosim/coupled_model.hpp"

#include <boost/math/constants/constants.hpp>
#include <sstream>
#include <stdexcept>

#include "bearing/dynamics/driven_start.hpp"
#include "bearing/quasi_static.hpp"
#include "coupling/cosim/driven_setup.hpp"
#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/static_state.hpp"

namespace orbearing::cosim {

namespace {

using bearing::dynamics::BoreMotion;
using boost::math::double_constants::two_pi;
using gearset::dynamics::PlanetBearing;
using gearset::dynamics::SetModel;

PlanetPort port_of(const PlanetBearing& bearing) {
  PlanetPort port;
  port.place = bearing.place;
  port.of_carrier << -bearing.radial.central.transpose(), -bearing.tangential.central.transpose();
  port.of_planet << -bearing.radial.planet.transpose(), -bearing.tangential.planet.transpose();
  port.turn_of_carrier = bearing.rotation.central.transpose();
  port.turn_of_planet = bearing.rotation.planet.transpose();
  port.pin_error = bearing.pin_error;
  return port;
}

SetModel on_springs(const CoupledSetup& setup) {
  gearset::dynamics::SetParameters set = setup.gears.set;
  set.planet.coupled_bearing = false;
  return gearset::dynamics::set_model(set, setup.gears.operation);
}

// Displacement of a planet's bore [m] under the force `on_planet` [N] of all its bearings.
Eigen::Vector2d displacement_under(const CoupledSetup& setup, const CoupledModel& model,
                                   const BoreMotion& motion, const Eigen::Vector2d& on_planet) {
  bearing::OperatingPoint point;
  point.carrier = {motion.carrier_speed, motion.carrier_acceleration, model.bearing.frame.orbit_radius};
  point.outer_speed = motion.speed;
  point.bore_load = -on_planet / model.per_planet;
  const bearing::QuasiStaticState balance = quasi_static_state(
      setup.bearing.bearing, point, bearing::dynamics::start_options(setup.bearing.dynamics),
      setup.bearing.first_roller);
  if (!balance.report.converged) throw std::runtime_error(balance.report.message);
  const Eigen::Vector2d none = Eigen::Vector2d::Zero();
  const Eigen::Vector2d pin =
      (model.bearing.pin_mass * inertial_acceleration(model.bearing.frame, none, none) + point.bore_load) /
      model.bearing.support.stiffness;
  return pin + balance.displacement;
}

}  // namespace

CoupledModel coupled_model(const CoupledSetup& setup) {
  const bool coupled = setup.gears.set.planet.coupled_bearing;
  if (!coupled || setup.bearings_per_planet < 1) {
    std::ostringstream text;
    text << "coupled gears and bearings: found " << setup.bearings_per_planet << " bearings of a planet"
         << (coupled ? "" : ", on springs") << "; required: at least 1, coupled";
    throw std::invalid_argument(text.str());
  }
  CoupledModel model{gearset::dynamics::set_model(setup.gears.set, setup.gears.operation),
                     driven_model(setup.bearing),
                     {},
                     setup.bearings_per_planet};
  for (const PlanetBearing& bearing : model.gears.bearings) model.ports.push_back(port_of(bearing));
  return model;
}

BoreMotion bore_motion(const CoupledModel& model, const PlanetPort& port, double time,
                       const Eigen::Ref<const Eigen::VectorXd>& q,
                       const Eigen::Ref<const Eigen::VectorXd>& v) {
  const gearset::dynamics::Operation& operation = model.gears.operation;
  const gearset::dynamics::SpeedState speed = speed_at(operation, time);
  const double passed = operation.mesh_frequency > 0.0
                            ? mesh_periods(operation, time) / operation.mesh_frequency
                            : time;  // [s]  at nominal speed
  BoreMotion motion;
  motion.position = port.along(q) - port.pin_error;
  motion.velocity = port.along(v);
  motion.speed = operation.speeds.planet_relative * speed.factor + port.turn(v);
  motion.angle = operation.speeds.planet_relative * passed + port.turn(q);
  motion.carrier_speed = operation.speeds.carrier * speed.factor;
  motion.carrier_acceleration = operation.speeds.carrier * speed.rate;
  return motion;
}

CoupledStart coupled_start(const CoupledSetup& setup, const CoupledModel& model, double time) {
  SetModel springs = on_springs(setup);
  const Eigen::Index n = springs.layout.freedoms();
  CoupledStart start;
  start.gears = static_state(springs);
  const double stiffness = springs.parameters.planet.bearing_stiffness;
  for (PlanetBearing& bearing : springs.bearings) {
    const auto q = start.gears.head(n);
    const Eigen::Vector2d force = bearing_force(springs.parameters.planet, bearing, q, start.gears.tail(n));
    const PlanetPort port = port_of(bearing);
    const BoreMotion motion = bore_motion(model, port, time, q, start.gears.tail(n));
    // A spring that gives the force F at the displacement d has the deflection F / k there.
    bearing.pin_error += displacement_under(setup, model, motion, force) + force / stiffness;
  }
  start.gears = static_state(springs);
  const double pitch = two_pi / setup.bearing.bearing.rollers;
  for (int b = 0; b < model.bearings(); ++b) {
    const BoreMotion motion =
        bore_motion(model, model.port_of(b), time, start.gears.head(n), start.gears.tail(n));
    const double first = setup.bearing.first_roller + pitch * (b % model.per_planet) / model.per_planet;
    start.bearings.push_back(
        driven_start(setup.bearing.bearing, model.bearing, setup.bearing.dynamics, motion, first));
  }
  return start;
}

}  // namespace orbearing::cosim
