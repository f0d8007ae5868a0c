#include "coupling/system/coupled_model.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "bearing/defect/scratched_elements.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::system {

namespace {

using bearing::motion::BoreMotion;
using constants::two_pi;
using gearset::dynamics::PlanetBearing;

PlanetPort port_of(const PlanetBearing& bearing, double planet_angle) {
  PlanetPort port;
  port.planet_angle = planet_angle;
  port.planet_index = bearing.planet_index;
  port.of_carrier << -bearing.radial.central.transpose(), -bearing.tangential.central.transpose(),
      bearing.rotation.central.transpose();
  port.of_planet << -bearing.radial.planet.transpose(), -bearing.tangential.planet.transpose(),
      bearing.rotation.planet.transpose();
  port.pin_error = bearing.pin_error;
  return port;
}

constexpr int kMostRounds = 30;
constexpr double kBalancedChange = 1e-9;  // [-]  of the largest force: good enough

void put_seats(const CoupledSetup& setup, CoupledModel& model) {
  if (setup.seats.empty()) return;
  mechanics::require(static_cast<int>(setup.seats.size()) == model.bearings(), "seats of bearings",
                     static_cast<double>(setup.seats.size()), "one for each bearing of all planets");
  for (int b = 0; b < model.bearings(); ++b) {
    DrivenBearingSetup own = bearing_of_planet(setup, b / model.per_planet, b % model.per_planet);
    own.dynamics.gravity.angle = setup.bearing.dynamics.gravity.angle;  // its port adds that of the planet
    model.seated.push_back(driven_model(own));
    model.pin_offset.push_back(setup.seats[static_cast<std::size_t>(b)].pin_offset);
  }
}

void put_scratched(const CoupledSetup& setup, CoupledModel& model) {
  for (const ScratchedPlanet& one : setup.scratched) {
    mechanics::require(one.planet >= 0 && one.planet < static_cast<int>(model.ports.size()),
                       "scratched planet", one.planet + 1, "one of the set's, counted from 1");
    mechanics::require(one.bearing >= 0 && one.bearing < model.per_planet, "scratched bearing of a planet",
                       one.bearing + 1, "one of the planet's, counted from 1");
    const int b = one.planet * model.per_planet + one.bearing;
    bearing::motion::BearingModel own = model.bearing_of(b);
    bearing::defect::put_scratches(one.scratches, own);
    model.scratched.push_back(std::move(own));
    model.scratched_bearing.push_back(b);
  }
}

// Bearings under the motion of the gears at rest; what they do to each planet.
std::vector<double> forces_under(const CoupledModel& model, const DrivenGearsOutput& gears,
                                 std::vector<DrivenBearing>& bearings) {
  std::vector<double> forces(3 * model.ports.size(), 0.0);  // x, y, moment of each planet
  for (std::size_t b = 0; b < bearings.size(); ++b) {
    const std::size_t planet = b / static_cast<std::size_t>(model.per_planet);
    BoreMotion motion;
    motion.position = gears.planets[planet].displacement;
    motion.speed = gears.planets[planet].speed;
    motion.carrier_speed = gears.carrier_speed;
    motion.carrier_acceleration = gears.carrier_acceleration;
    motion = at_seat(model, static_cast<int>(b), motion);
    bearings[b].initialize(motion);
    const bearing::motion::BoreReaction reaction = bearings[b].reaction(motion);
    forces[3 * planet] += reaction.force.x();
    forces[3 * planet + 1] += reaction.force.y();
  }
  return forces;
}

// Largest change of a force over the largest force.
double change(const std::vector<double>& before, const std::vector<double>& now) {
  double change = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    change = std::max(change, std::abs(now[i] - before[i]));
    largest = std::max(largest, std::abs(now[i]));
  }
  return change / largest;
}

}  // namespace

DrivenBearingSetup bearing_of_planet(const CoupledSetup& setup, int planet, int bearing) {
  DrivenBearingSetup own = setup.bearing;
  if (!setup.seats.empty()) {
    const BearingSeat& seat =
        setup.seats[static_cast<std::size_t>(planet * setup.bearings_per_planet + bearing)];
    own.bearing.radial_clearance += seat.clearance_difference;
    own.bore_tilt = seat.bore_tilt;
    own.outer_race = seat.outer_race;
  }
  const double pitch = two_pi / own.bearing.rollers().count;
  own.first_roller += pitch * bearing / setup.bearings_per_planet;
  const std::vector<double>& angles = setup.gears.set.planet_angles;
  own.dynamics.gravity.angle +=
      angles.empty() ? two_pi * planet / setup.gears.set.planets : angles[static_cast<std::size_t>(planet)];
  return own;
}

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
  for (std::size_t i = 0; i < model.gears.bearings.size(); ++i)
    model.ports.push_back(port_of(model.gears.bearings[i], model.gears.planet_angles[i]));
  put_seats(setup, model);
  put_scratched(setup, model);
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
  motion.carrier_angle = carrier_angle(operation, time) + port.planet_angle;
  motion.carrier_speed = operation.speeds.carrier * speed.factor;
  motion.carrier_acceleration = operation.speeds.carrier * speed.rate;
  return motion;
}

CoupledStart coupled_start(const CoupledSetup& setup, const CoupledModel& model, double time) {
  DrivenGears gears(setup.gears);
  std::vector<DrivenBearing> bearings;
  for (int b = 0; b < model.bearings(); ++b)
    bearings.emplace_back(bearing_of_planet(setup, b / model.per_planet, b % model.per_planet));
  gears.initialize(time);
  std::vector<double> forces = forces_under(model, gears.output(), bearings);
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<double> before = forces;
    gears.balance(time, forces);
    forces = forces_under(model, gears.output(), bearings);
    if (change(before, forces) <= kBalancedChange) break;
  }
  CoupledStart start{gears.state(), {}};
  for (const DrivenBearing& bearing : bearings) {
    // Scratches count from here on: rollers that are followed have turned by nothing.
    const Eigen::Index size = model.bearing_of(static_cast<int>(start.bearings.size())).layout.size();
    Eigen::VectorXd state = Eigen::VectorXd::Zero(size);
    state.head(bearing.state().size()) = bearing.state();
    start.bearings.push_back(std::move(state));
  }
  return start;
}

}  // namespace orbearing::system
