// orbearing_own_drive FMU...
//
// Planet bearings that the program exported, of either version of FMI, come back through the import and carry
// the planet of planet_body.hpp; beside each the machine that is inside, without any FMU between. Prints one
// JSON object a line.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

#include "coupling/cosim/bearing_participant.hpp"
#include "coupling/cosim/coupled_run.hpp"
#include "coupling/fmu/bearing_fields.hpp"
#include "coupling/fmu/import/foreign_participant.hpp"
#include "coupling/fmu/import/unpacked_fmu.hpp"
#include "coupling/fmu/model_file.hpp"
#include "tests/foreign/planet_body.hpp"

namespace {

using namespace orbearing;
using cosim::Gives;
using cosim::PortKind;

constexpr double kEnd = 2e-4;                             // [s]
constexpr double kCarrierSpeed = 200.0, kSpeed = -720.0;  // [rad/s]

tests::PlanetBodyParameters planet(const cosim::DrivenBearingSetup& bearing) {
  tests::PlanetBodyParameters p;
  p.mass = 0.1858;
  p.orbit_radius = bearing.orbit_radius;
  p.carrier_speed = kCarrierSpeed;
  p.load_y = 532.0;
  p.turning_stiffness = 5e4;
  p.turning_damping = 5.0;
  p.start_x = 3.3e-6;
  p.start_y = 2.7e-6;
  return p;
}

// Inside a step the FMU lets the displacement go on with the velocity. That of 2.0 has the velocity's slopes
// too; that of 3.0 gets the velocity as it is in the mean.
fmu::ForeignSetup imported(const char* file) {
  fmu::ForeignSetup setup;
  setup.file = file;
  const auto port = [](const char* name, PortKind kind) { return cosim::Port{name, kind, Gives::force}; };
  const fmu::Held begin = fmu::Held::at_begin, mean = fmu::Held::mean;
  setup.ports = {
      {port("planet_1.x", PortKind::translation),
       {"planet.displacement.x", 1.0, 0.0, begin, true},
       {"planet.velocity.x", 1.0, 0.0, mean},
       {"force.x"}},
      {port("planet_1.y", PortKind::translation),
       {"planet.displacement.y", 1.0, 0.0, begin, true},
       {"planet.velocity.y", 1.0, 0.0, mean},
       {"force.y"}},
      {port("planet_1.rotation", PortKind::rotation), {}, {"planet.speed", 1.0, -kSpeed, mean}, {"moment"}}};
  setup.values = {{"carrier.speed", kCarrierSpeed}, {"carrier.acceleration", 0.0}};
  setup.slopes = 2;
  setup.answers_between_steps = true;
  return setup;
}

// Places of the planet [m] at the ends of all windows.
std::vector<double> run(cosim::Participant& bearing, const tests::PlanetBodyParameters& parameters,
                        double window) {
  tests::PlanetBody body{parameters, false};
  const cosim::Participants participants = {&body, &bearing};
  cosim::CoupledOptions options;
  options.window.longest = window;
  options.iteration.most_passes = 2;
  options.balance_rounds = 1;
  cosim::CoupledRun coupled{participants, cosim::connect_by_name(participants), options};
  coupled.initialize(0.0);
  std::vector<double> places;
  const cosim::CoupledReport report =
      coupled.advance(std::lround(kEnd / window), [&](const cosim::WindowRecord&) {
        std::vector<cosim::PortOutput> outputs;
        body.output(outputs);
        places.insert(places.end(), {outputs[0].displacement, outputs[1].displacement});
      });
  if (!report.completed) throw std::runtime_error(report.message);
  return places;
}

void compare(const char* file, double window) {
  const fmu::UnpackedFmu unpacked{file};
  const cosim::DrivenBearingSetup setup =
      fmu::bearing_from(fmu::table_from(fmu::read_model((unpacked.folder() / "resources").string()))).setup;
  cosim::BearingPlace place;
  place.operation.speeds.carrier = kCarrierSpeed;
  place.operation.speeds.planet_relative = kSpeed;
  cosim::BearingParticipant machine{setup, place};
  const auto foreign = fmu::import_fmu(imported(file));
  const std::vector<double> expected = run(machine, planet(setup), window);
  const std::vector<double> found = run(*foreign, planet(setup), window);
  double way = 0.0, distance = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    way = std::max(way, std::abs(expected[i] - expected[i % 2]));
    distance = std::max(distance, std::abs(found[i] - expected[i]));
  }
  std::printf("{\"fmi\": %d, \"window_s\": %g, \"way_m\": %.6g, \"distance_m\": %.6g}\n",
              fmu::describe_fmu(file).version, window, way, distance);
}

}  // namespace

int main(int count, char** arguments) try {
  for (int i = 1; i < count; ++i) {
    for (const double window : {4e-6, 2e-6, 1e-6}) compare(arguments[i], window);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
