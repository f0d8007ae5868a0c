// Replacements for parts that the engine does not have: threads, netCDF files, FMUs, Python, records of
// measurements. Points are computed one after the other; the page requests no command that needs the other
// parts.
#include <filesystem>
#include <stdexcept>

#include "app/commands/commands.hpp"
#include "app/commands/python_part.hpp"
#include "app/results/point_file.hpp"
#include "coupling/analysis/parallel.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing::analysis {

std::size_t threads_for(std::size_t, int) {
  return 1;
}

void in_parallel(std::size_t count, int, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) {
    throw_if_stopped();
    work(i);
  }
}

void compute_points(const std::vector<std::size_t>& indices, int, const Evaluate& evaluate,
                    const Deliver& deliver) {
  for (const std::size_t index : indices) {
    throw_if_stopped();
    PointResult result;
    try {
      result = evaluate(index);
    } catch (const std::exception& error) {
      result.status = error.what();
    }
    std::vector<ComputedPoint> points;
    points.push_back({index, std::move(result)});
    deliver(std::move(points));
  }
}

}  // namespace orbearing::analysis

namespace orbearing::app {

std::vector<std::pair<std::string, std::string>> result_attributes(const ManifestHeader&, const std::string&,
                                                                   const std::string&) {
  return {};
}
PointContent point_content(const ManifestHeader&, std::size_t, const std::vector<double>&,
                           const analysis::PointResult&) {
  return {};
}
void add_location_in_sweep(bool, const std::optional<Resonance>&, PointContent&) {}

// A sweep that was stopped goes on with --resume, for which each point has its file.
std::string netcdf_bytes(const PointContent&) {
  return "no arrays in a browser\n";
}
std::vector<double> read_final_state(const std::filesystem::path&) {
  return {};
}

const std::vector<PythonCommand>& python_commands() {
  static const std::vector<PythonCommand> none;
  return none;
}
void hand_over(int, char**) {}

// Commands that a page never requests.
#define ORBEARING_NO_COMMAND(Options)                                                     \
  int execute(const Options&) {                                                           \
    throw std::logic_error(std::string(Options::command) + ": no command of the engine"); \
  }                                                                                       \
  std::vector<std::string> problems(const Options&) {                                     \
    return {};                                                                            \
  }
ORBEARING_NO_COMMAND(DemoOptions)
ORBEARING_NO_COMMAND(FmuOptions)
ORBEARING_NO_COMMAND(MergeOptions)
ORBEARING_NO_COMMAND(NewOptions)
ORBEARING_NO_COMMAND(OpenOptions)
ORBEARING_NO_COMMAND(ReportOptions)
ORBEARING_NO_COMMAND(SpectrumOptions)
ORBEARING_NO_COMMAND(ValidateOptions)

}  // namespace orbearing::app
