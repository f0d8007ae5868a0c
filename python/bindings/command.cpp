// The commands of the command line, their results as JSON; and the command line itself.
#include <pybind11/stl.h>

#include "app/commands/command_line.hpp"
#include "app/results/progress.hpp"
#include "orbearing/request.hpp"
#include "python/bindings/bindings.hpp"

namespace orbearing::python {

namespace py = pybind11;

namespace {

// Python's own handler runs only when the interpreter does: this one is heard while the program computes.
py::tuple compute(const Case* stated, const std::string& command, const py::dict& options,
                  const py::object& progress) {
  Request request{.command = command};
  if (stated != nullptr) request.given = *stated;
  request.options = py::cast<std::string>(py::module_::import("json").attr("dumps")(options));
  if (!progress.is_none())
    request.progress = [&](std::size_t done, std::size_t all, const std::string& doing) {
      const py::gil_scoped_acquire held;
      progress(done, all, doing);
      return true;  // an exception of its own ends the computation
    };
  Answer found;
  {
    const py::gil_scoped_release released;
    const app::Interruption interruption;
    found = answer(request);
  }
  return py::make_tuple(found.result, found.failures);
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
