// The commands of the command line, their results as JSON; and the command line itself.
#include <pybind11/stl.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "app/commands/command_line.hpp"
#include "app/errors.hpp"
#include "app/results/interruption.hpp"
#include "app/results/progress.hpp"
#include "app/study/fidelity.hpp"
#include "python/bindings/bindings.hpp"

namespace orbearing::python {

namespace py = pybind11;

namespace {

using Command = int (*)(const app::Options&);

const std::map<std::string, Command> kCommands{
    {"check", app::check_command},   {"run", app::run_command},         {"sweep", app::sweep_command},
    {"crown", app::crown_command},   {"fmu", app::fmu_command},         {"mesh", app::mesh_command},
    {"modes", app::modes_command},   {"signals", app::signals_command}, {"stiffness", app::stiffness_command},
    {"report", app::report_command},   {"sensitivities", app::sensitivities_command}, {"merge", app::merge_command}};

// What an option of the command line is called here, and where it goes.
using Take = void (*)(app::Options&, const py::handle&);
template <auto member>
void take(app::Options& options, const py::handle& value) {
  using Member = std::remove_reference_t<decltype(options.*member)>;
  options.*member = py::cast<Member>(value);
}
template <auto member>
void take_crown(app::Options& options, const py::handle& value) {
  using Member = std::remove_reference_t<decltype(options.crown.*member)>;
  options.crown.*member = py::cast<Member>(value);
}

void take_fidelity(app::Options& options, const py::handle& value) {
  take<&app::Options::fidelity>(options, value);
  options.fidelity_given = true;
}

using app::CrownOptions;
using app::Options;
const std::map<std::string, Take> kTaken{{"output", take<&Options::output>},
                                         {"fidelity", take_fidelity},
                                         {"speed", take<&Options::speed>},
                                         {"shard", take<&Options::shard>},
                                         {"direction", take<&Options::direction>},
                                         {"folders", take<&Options::folders>},
                                         {"grid_only", take<&Options::grid_only>},
                                         {"jobs", take<&Options::jobs>},
                                         {"gears", take<&Options::gears>},
                                         {"fmi", take<&Options::fmi>},
                                         {"model", take<&Options::model>},
                                         {"vary", take<&Options::varied>},
                                         {"result", take<&Options::result>},
                                         {"by", take<&Options::by>},
                                         {"noise", take<&Options::noise>},
                                         {"seed", take<&Options::seed>},
                                         {"resume", take<&Options::resume>},
                                         {"data_only", take<&Options::data_only>},
                                         {"every_effect", take<&Options::every_effect>},
                                         {"profile", take_crown<&CrownOptions::profiles>},
                                         {"tilts", take_crown<&CrownOptions::tilts>},
                                         {"drops", take_crown<&CrownOptions::drops>},
                                         {"spectrum", take_crown<&CrownOptions::spectrum>},
                                         {"shares", take_crown<&CrownOptions::shares>},
                                         {"tolerance", take_crown<&CrownOptions::tolerance>},
                                         {"tilt_tolerance", take_crown<&CrownOptions::tilt_tolerance>},
                                         {"distribution", take_crown<&CrownOptions::distribution>},
                                         {"life", take_crown<&CrownOptions::life>},
                                         {"of", take_crown<&CrownOptions::of_set>},
                                         {"starts", take_crown<&CrownOptions::starts>}};

Options options_from(const py::dict& given) {
  Options options;
  options.json = options.quiet = true;
  for (const auto& [key, value] : given) {
    const std::string name = py::cast<std::string>(key);
    const auto found = kTaken.find(name);
    if (found == kTaken.end()) throw app::BadInput(name + ": found an option that no command knows");
    found->second(options, value);
  }
  const std::vector<std::string>& rungs = app::fidelity_names();
  if (std::find(rungs.begin(), rungs.end(), options.fidelity) == rungs.end())
    throw app::BadInput(
        fmt::format("fidelity: found {}; required: one of {}", options.fidelity, fmt::join(rungs, ", ")));
  return options;
}

// Python's own handler runs only when the interpreter does: this one is heard while the program computes.
py::tuple compute(const CoreCase* core, const std::string& command, const py::dict& given,
                  const py::object& progress) {
  const auto found = kCommands.find(command);
  if (found == kCommands.end()) throw app::BadInput(command + ": found a command that is not known");
  Options options = options_from(given);
  if (core != nullptr) options.given = core->resolved;
  std::string result;
  std::vector<std::string> failures;
  options.take_result = [&](const nlohmann::ordered_json& object) { result = object.dump(); };
  options.take_failures = [&](const std::string& line) { failures.push_back(line); };
  const app::ProgressObserver observer = [&](std::size_t done, std::size_t all, const std::string& doing) {
    const py::gil_scoped_acquire held;
    progress(done, all, doing);
  };
  {
    const py::gil_scoped_release released;
    const app::Interruption interruption;
    const app::ObservedProgress observed(progress.is_none() ? app::ProgressObserver{} : observer);
    found->second(options);
  }
  return py::make_tuple(result, failures);
}

int command_line(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"orbearing"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return app::run_command_line(static_cast<int>(words.size()), pointers.data());
}

}  // namespace

void add_command(py::module_& module) {
  module.def(
      "compute", &compute, py::arg("case").none(true), py::arg("command"), py::arg("options") = py::dict(),
      py::arg("progress") = py::none(),
      "The result of a command as JSON text, and lines about points that failed. `options` are those of the "
      "command line with _ for -; `progress(done, all, doing)` receives how far it is.");
  module.def("command_line", &command_line, py::arg("arguments"), py::call_guard<py::gil_scoped_release>(),
             "The command line in this process; returns its exit code.");
}

}  // namespace orbearing::python
