#include "coupling/cosim/planetary_coupling.hpp"

namespace orbearing::cosim {

namespace {

std::string bearing_name(int planet, int bearing) {
  return "planet_" + std::to_string(planet + 1) + ".bearing_" + std::to_string(bearing + 1);
}

}  // namespace

Participants PlanetaryCoupling::participants() const {
  Participants out{gears.get()};
  for (const std::unique_ptr<BearingParticipant>& bearing : bearings) out.push_back(bearing.get());
  return out;
}

PlanetaryCoupling planetary_coupling(const CoupledSetup& setup) {
  PlanetaryCoupling out;
  out.gears = std::make_unique<GearsParticipant>(setup.gears);
  for (int planet = 0; planet < setup.gears.set.planets; ++planet)
    for (int bearing = 0; bearing < setup.bearings_per_planet; ++bearing)
      out.bearings.push_back(std::make_unique<BearingParticipant>(
          bearing_of_planet(setup, planet, bearing),
          BearingPlace{bearing_name(planet, bearing), planet, setup.gears.operation}));
  return out;
}

}  // namespace orbearing::cosim
