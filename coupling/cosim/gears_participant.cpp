#include "coupling/cosim/gears_participant.hpp"

namespace orbearing::cosim {

namespace {

constexpr std::size_t kPortsOfPlanet = 3;

}  // namespace

std::vector<Port> planet_ports(int planet, Gives gives) {
  const std::string name = "planet_" + std::to_string(planet + 1);
  return {{name + ".x", PortKind::translation, gives},
          {name + ".y", PortKind::translation, gives},
          {name + ".rotation", PortKind::rotation, gives}};
}

GearsParticipant::GearsParticipant(const DrivenGearsSetup& setup, std::string name)
    : gears_(setup), on_springs_(!setup.set.planet.coupled_bearing), name_(std::move(name)) {
  for (int planet = 0; planet < gears_.planets(); ++planet)
    for (Port& port : planet_ports(planet, Gives::motion)) ports_.push_back(std::move(port));
  forces_.resize(static_cast<std::size_t>(gears_.planets()));
}

// The first call has no forces yet that belong to a displacement.
void GearsParticipant::initialize(double time, const std::vector<PortInput>& inputs) {
  set_input(inputs);
  if (begun_ && !on_springs_) {
    gears_.balance(forces_);
  } else {
    gears_.initialize(time);
  }
  begun_ = true;
}

void GearsParticipant::set_input(const std::vector<PortInput>& inputs) {
  for (std::size_t i = 0; i < forces_.size(); ++i)
    forces_[i] = {inputs[kPortsOfPlanet * i].force, inputs[kPortsOfPlanet * i + 1].force,
                  inputs[kPortsOfPlanet * i + 2].force};
}

void GearsParticipant::advance(const Window& window) {
  gears_.advance(window, forces_);
  begun_ = false;
}

void GearsParticipant::output(std::vector<PortOutput>& outputs) const {
  const DrivenGearsOutput now = gears_.output();
  outputs.assign(ports_.size(), {});
  for (std::size_t i = 0; i < now.planets.size(); ++i) {
    const PlanetMotion& planet = now.planets[i];
    PortOutput* out = &outputs[kPortsOfPlanet * i];
    out[0] = {planet.displacement.x(), planet.velocity.x(), 0.0};
    out[1] = {planet.displacement.y(), planet.velocity.y(), 0.0};
    out[2] = {planet.angle, planet.speed - now.planet_speed, 0.0};
  }
}

}  // namespace orbearing::cosim
