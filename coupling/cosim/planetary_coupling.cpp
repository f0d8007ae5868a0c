#include "coupling/cosim/planetary_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace orbearing::cosim {

namespace {

// Inputs and outputs of a participant for a planet; their names differ only in the prefixes.
struct PlanetNames {
  std::string joint;   // "planet_1."
  std::string motion;  // before displacement, velocity, angle and speed
  std::string force;   // before force and moment
};

std::vector<Port> planet_ports(const Participant& of, PortOutput output, const PlanetNames& names) {
  const auto motion = [&](const std::string& name) {
    return output == PortOutput::motion ? index_of(of.outputs(), names.motion + name)
                                        : index_of(of.inputs(), names.motion + name);
  };
  const auto force = [&](const std::string& name) {
    return output == PortOutput::force ? index_of(of.outputs(), names.force + name)
                                       : index_of(of.inputs(), names.force + name);
  };
  std::vector<Port> ports;
  for (const char* axis : {"x", "y"})
    ports.push_back({names.joint + axis, PortKind::translation, output,
                     motion(std::string("displacement.") + axis), motion(std::string("velocity.") + axis),
                     force(std::string("force.") + axis)});
  ports.push_back({names.joint + "rotation", PortKind::rotation, output, motion("angle"), motion("speed"),
                   force("moment")});
  return ports;
}

// `speed` [rad/s] times what the run-up leaves of it, along a straight line from its value and rate.
Nominal nominal(std::size_t position, const gearset::dynamics::Operation& operation, double speed) {
  return {position, [operation, speed](double time) -> InputPolynomial {
            const gearset::dynamics::SpeedState now = speed_at(operation, time);
            return {{speed * now.factor, speed * now.rate, 0.0, 0.0}};
          }};
}

Side side_of(system::DrivenGears& gears, const gearset::dynamics::Operation& operation) {
  Side side{&gears, {}};
  for (int planet = 1; planet <= gears.planets(); ++planet) {
    const std::string number = std::to_string(planet), own = "planet[" + number + "].";
    for (Port& port : planet_ports(gears, PortOutput::motion, {"planet_" + number + ".", own, own}))
      side.ports.push_back(std::move(port));
    side.outputs.push_back(
        nominal(index_of(gears.outputs(), own + "speed"), operation, operation.speeds.planet_relative));
  }
  return side;
}

Side side_of(system::DrivenBearing& bearing, int planet, const gearset::dynamics::Operation& operation) {
  const auto input = [&](const char* name) { return index_of(bearing.inputs(), name); };
  const double carrier = operation.speeds.carrier;
  const auto acceleration = [operation, carrier](double time) {
    return InputPolynomial::constant(carrier * speed_at(operation, time).rate);
  };
  return {
      &bearing,
      planet_ports(bearing, PortOutput::force, {"planet_" + std::to_string(planet + 1) + ".", "planet.", ""}),
      {nominal(input("planet.speed"), operation, operation.speeds.planet_relative),
       nominal(input("carrier.speed"), operation, carrier),
       {input("carrier.acceleration"), acceleration}}};
}

CoupledOptions with_window(CoupledOptions options, double window) {
  options.window = window;
  return options;
}

}  // namespace

PlanetaryCoupling planetary_coupling(const system::CoupledSetup& setup) {
  const bool offset = std::ranges::any_of(
      setup.seats, [](const system::BearingSeat& seat) { return !seat.pin_offset.isZero(0.0); });
  if (!setup.scratched.empty() || offset)
    throw std::invalid_argument(
        "co-simulation: found scratched planet bearings, or planets whose tilt is computed; required: one "
        "system "
        "(monolithic), which includes both");
  PlanetaryCoupling out;
  const gearset::dynamics::Operation& operation = setup.gears.operation;
  out.gears = std::make_unique<system::DrivenGears>(setup.gears);
  out.sides.push_back(side_of(*out.gears, operation));
  const int count = setup.gears.set.planets * setup.bearings_per_planet;
  out.bearings.reserve(static_cast<std::size_t>(count));  // they stay where they are from here on
  for (int b = 0; b < count; ++b) {
    const int planet = b / setup.bearings_per_planet;
    out.bearings.emplace_back(system::bearing_of_planet(setup, planet, b % setup.bearings_per_planet));
    out.sides.push_back(side_of(out.bearings.back(), planet, operation));
  }
  return out;
}

CoSimulatedMotion::CoSimulatedMotion(const system::CoupledSetup& setup, const CoupledOptions& options,
                                     double interval)
    : parts_(planetary_coupling(setup)),
      window_(interval / std::ceil(interval / options.window)),
      run_(parts_.sides, with_window(options, window_)) {
  run_.initialize(0.0);
}

void CoSimulatedMotion::observe_steps(const system::StepObservers& observers) {
  for (std::size_t b = 0; b < observers.loads.size(); ++b)
    parts_.bearings[b].collect_loads(observers.loads[b]);
}

void CoSimulatedMotion::advance(const integration::OutputTimes& times,
                                const std::function<void(double time)>& observe) {
  for (long sample = 1; sample <= times.samples; ++sample) {
    const long until = std::lround(times.time(sample) / window_);
    const CoupledReport part = run_.advance(until - done_);
    done_ = until;
    exchange_ += part;
    if (!part.completed) throw std::runtime_error(part.message);
    observe(times.time(sample));
  }
}

void CoSimulatedMotion::take_snapshot(int b, bearing::motion::Snapshot& into) const {
  const std::size_t bearing = static_cast<std::size_t>(b);
  parts_.bearings[bearing].take_snapshot(system::DrivenBearing::motion_of(run_.inputs(1 + bearing)), into);
}

integration::IntegrationReport CoSimulatedMotion::report() const {
  return {.completed = true,
          .reached = exchange_.reached,
          .steps = exchange_.windows,
          .wall_seconds = exchange_.wall_seconds};
}

}  // namespace orbearing::cosim
