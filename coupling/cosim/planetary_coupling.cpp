#include "coupling/cosim/planetary_coupling.hpp"

#include <cmath>
#include <stdexcept>

namespace orbearing::cosim {

namespace {

std::string bearing_name(int planet, int bearing) {
  return "planet_" + std::to_string(planet + 1) + ".bearing_" + std::to_string(bearing + 1);
}

CoupledOptions with_window(CoupledOptions options, double window) {
  options.window.longest = window;
  return options;
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

CoSimulatedMotion::CoSimulatedMotion(const CoupledSetup& setup, const CoupledOptions& options,
                                     double interval)
    : parts_(planetary_coupling(setup)),
      window_(interval / std::ceil(interval / options.window.longest)),
      run_(parts_.participants(), connect_by_name(parts_.participants()), with_window(options, window_)) {
  run_.initialize(0.0);
}

void CoSimulatedMotion::observe_steps(const system::StepObservers& observers) {
  for (std::size_t b = 0; b < observers.loads.size(); ++b)
    parts_.bearings[b]->collect_loads(observers.loads[b]);
}

void CoSimulatedMotion::advance(const integration::OutputTimes& times,
                                const std::function<void(double time)>& observe) {
  for (long sample = 1; sample <= times.samples; ++sample) {
    const long until = std::lround(times.time(sample) / window_);
    const CoupledReport part = run_.advance(until - done_);
    done_ = until;
    exchange_.reached = part.reached;
    exchange_.windows += part.windows;
    exchange_.rejected += part.rejected;
    exchange_.passes += part.passes;
    exchange_.absolute_residual += part.absolute_residual;
    exchange_.passed += part.passed;
    exchange_.wall_seconds += part.wall_seconds;
    if (!part.completed) throw std::runtime_error(part.message);
    observe(times.time(sample));
  }
}

void CoSimulatedMotion::take_snapshot(int b, bearing::dynamics::Snapshot& into) const {
  parts_.bearings[static_cast<std::size_t>(b)]->take_snapshot(into);
}

integration::IntegrationReport CoSimulatedMotion::report() const {
  return {.completed = true,
          .reached = exchange_.reached,
          .steps = exchange_.windows,
          .rejected = exchange_.rejected,
          .wall_seconds = exchange_.wall_seconds};
}

}  // namespace orbearing::cosim
