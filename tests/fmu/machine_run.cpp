// The model inside an FMU without any interface: reads the numbers of the model and, from standard input, one
// line of inputs for each step (step size first; a bearing's may end with the slopes of both velocities);
// prints the outputs after each. For comparison with FMPy.
//
//   machine_run RESOURCES_FOLDER
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "coupling/fmu/model.hpp"
#include "coupling/fmu/model_file.hpp"

namespace {

using namespace orbearing;
using system::InputPolynomial;

void print(const std::vector<double>& values) {
  for (const double value : values) std::printf("%.17g ", value);
  std::printf("\n");
}

// Step size, then the inputs; nothing at the end.
std::vector<double> next_line() {
  std::string line;
  std::vector<double> numbers;
  if (!std::getline(std::cin, line)) return numbers;
  std::istringstream words(line);
  for (std::string word; words >> word;) numbers.push_back(std::stod(word));
  return numbers;
}

bearing::motion::BoreMotion motion_of(const std::vector<double>& in) {
  bearing::motion::BoreMotion motion;
  motion.position = {in[1], in[2]};
  motion.velocity = {in[3], in[4]};
  motion.speed = in[5];
  motion.carrier_speed = in[6];
  motion.carrier_acceleration = in[7];
  return motion;
}

// Displacement and carrier speed continue with the rates beside them.
system::BoreInputs polynomial_of(const std::vector<double>& in) {
  const double slope_x = in.size() > 9 ? in[8] : 0.0, slope_y = in.size() > 9 ? in[9] : 0.0;
  return {{{in[1], in[3], 0.5 * slope_x, 0.0}}, {{in[2], in[4], 0.5 * slope_y, 0.0}},
          {{in[3], slope_x, 0.0, 0.0}},         {{in[4], slope_y, 0.0, 0.0}},
          InputPolynomial::constant(in[5]),     {{in[6], in[7], 0.0, 0.0}},
          InputPolynomial::constant(in[7])};
}

void run_bearing(const fmu::NumberTable& numbers) {
  system::DrivenBearing bearing(fmu::setup_from<system::DrivenBearingSetup>(numbers));
  double time = 0.0;
  bool begun = false;
  for (std::vector<double> in = next_line(); !in.empty(); in = next_line()) {
    if (!begun) bearing.initialize(motion_of(in));
    begun = true;
    const system::BoreInputs inputs = polynomial_of(in);
    const double size = in[0];
    bearing.advance({time, time + size}, inputs);
    time += size;
    const system::DrivenBearingOutput out = bearing.output(inputs.at(size));
    print({out.reaction.force.x(), out.reaction.force.y(), out.reaction.moment, out.life_used, out.cage_speed,
           out.inner_load[0], out.outer_load[0]});
  }
}

void run_gears(const fmu::NumberTable& numbers) {
  system::DrivenGears gears(fmu::setup_from<system::DrivenGearsSetup>(numbers));
  gears.initialize(0.0);
  double time = 0.0;
  for (std::vector<double> in = next_line(); !in.empty(); in = next_line()) {
    std::vector<InputPolynomial> forces;
    for (std::size_t i = 1; i < in.size(); ++i) forces.push_back(InputPolynomial::constant(in[i]));
    gears.advance({time, time + in[0]}, forces);
    time += in[0];
    const system::PlanetMotion planet = gears.output().planets[0];
    print({planet.displacement.x(), planet.displacement.y(), planet.velocity.x(), planet.velocity.y(),
           planet.speed, planet.sun_mesh_force, planet.ring_mesh_force});
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::invalid_argument("required: a folder with resources");
    const fmu::NumberTable numbers = fmu::table_from(fmu::read_model(argv[1]));
    (numbers.model == "bearing" ? run_bearing : run_gears)(numbers);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "machine_run: %s\n", error.what());
    return 1;
  }
}
