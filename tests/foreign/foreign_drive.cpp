// orbearing_foreign_drive FMU [HOST_LIBRARY]
//
// A planet that another tool exported drives the bearing of the reducer through the import and a staggered
// exchange, and beside it the same planet of our own: with forces held over a window as the FMU holds them,
// and with forces that follow their course. Prints one JSON object a line, for each length of the window.
#include <cstdio>
#include <exception>

#include "coupling/cosim/bearing_participant.hpp"
#include "coupling/cosim/coupled_run.hpp"
#include "coupling/fmu/import/foreign_participant.hpp"
#include "tests/foreign/planet_body.hpp"
#include "tests/unit/cosim/driven_reducer.hpp"

namespace {

using namespace orbearing;
using cosim::Gives;
using cosim::PortKind;

constexpr double kEnd = 3e-4;  // [s]  short: motions with loose rollers are chaotic

tests::PlanetBodyParameters planet() {
  const bearing::dynamics::BoreMotion motion = test::pressed_motion();
  tests::PlanetBodyParameters p;
  p.orbit_radius = test::driven_reducer().orbit_radius;
  p.carrier_speed = motion.carrier_speed;
  p.load_y = 9000.0;
  p.mesh_stiffness = 2e8;
  p.mesh_damping = 2e3;
  p.turning_stiffness = 5e4;
  p.turning_damping = 5.0;
  p.start_x = motion.position.x();
  p.start_y = motion.position.y();
  return p;
}

fmu::ForeignSetup foreign_planet(const char* file, const char* host_library) {
  const tests::PlanetBodyParameters p = planet();
  fmu::ForeignSetup setup;
  setup.file = file;
  setup.ports = {{{"planet_1.x", PortKind::translation, Gives::motion}, {"x"}, {"v_x"}, {"force_x"}},
                 {{"planet_1.y", PortKind::translation, Gives::motion}, {"y"}, {"v_y"}, {"force_y"}},
                 {{"planet_1.rotation", PortKind::rotation, Gives::motion}, {"angle"}, {"spin"}, {"moment"}}};
  setup.values = {{"mass", p.mass},
                  {"inertia", p.inertia},
                  {"orbit_radius", p.orbit_radius},
                  {"carrier_speed", p.carrier_speed},
                  {"load_y", p.load_y},
                  {"mesh_stiffness", p.mesh_stiffness},
                  {"mesh_damping", p.mesh_damping},
                  {"turning_stiffness", p.turning_stiffness},
                  {"turning_damping", p.turning_damping},
                  {"start_x", p.start_x},
                  {"start_y", p.start_y}};
  if (host_library != nullptr) setup.host_libraries = {host_library};
  return setup;
}

cosim::BearingParticipant bearing_participant() {
  const bearing::dynamics::BoreMotion motion = test::pressed_motion();
  cosim::BearingPlace place;
  place.name = "bearing";
  place.operation.speeds.carrier = motion.carrier_speed;
  place.operation.speeds.planet_relative = motion.speed;
  return {test::driven_reducer(), place};
}

// Displacements x and y [m] of the planet at the end.
std::array<double, 2> run(cosim::Participant& body, double window, int passes) {
  cosim::BearingParticipant bearing = bearing_participant();
  const cosim::Participants participants = {&body, &bearing};
  cosim::CoupledOptions options;
  options.window.longest = window;
  options.iteration.most_passes = passes;
  options.balance_rounds = 1;
  cosim::CoupledRun coupled{participants, cosim::connect_by_name(participants), options};
  coupled.initialize(0.0);
  const cosim::CoupledReport report = coupled.advance(std::lround(kEnd / window));
  if (!report.completed) throw std::runtime_error(report.message);
  std::vector<cosim::PortOutput> outputs;
  body.output(outputs);
  return {outputs[0].displacement, outputs[1].displacement};
}

void print(const char* name, const std::array<double, 2>& place) {
  std::printf(", \"%s\": [%.17g, %.17g]", name, place[0], place[1]);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 2 || count > 3) return 2;
  const auto foreign = fmu::import_fmu(foreign_planet(arguments[1], count == 3 ? arguments[2] : nullptr));
  tests::PlanetBody held{planet(), true}, following{planet(), false};
  for (const int passes : {1, 3}) {
    for (const double window : {1e-5, 5e-6, 2.5e-6}) {
      std::printf("{\"passes\": %d, \"window_s\": %g", passes, window);
      print("foreign", run(*foreign, window, passes));
      print("held", run(held, window, passes));
      print("following", run(following, window, passes));
      std::puts("}");
    }
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
