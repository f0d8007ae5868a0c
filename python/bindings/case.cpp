// A case: read, changed, asked for its values.
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/interface/case_values.hpp"
#include "python/bindings/bindings.hpp"

namespace orbearing::python {

namespace py = pybind11;

namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

std::vector<std::string> as_options(const Settings& settings) {
  std::vector<std::string> texts;
  for (const auto& [path, text] : settings) texts.push_back(path + "=" + text);
  return texts;
}

py::object as_python(const nlohmann::ordered_json& found) {
  return py::module_::import("json").attr("loads")(found.dump());
}

}  // namespace

void add_case(py::module_& module) {
  py::class_<Case>(module, "CoreCase", "A case with every value checked; it never changes.")
      .def(
          "with_settings",
          [](const Case& core, const Settings& settings) {
            std::vector<app::Setting> all;
            for (const auto& [path, text] : settings) all.push_back({path, text});
            return Case{core.content().with(all)};
          },
          py::arg("settings"), py::call_guard<py::gil_scoped_release>(),
          "A copy with values replaced, by (path, text as in a case file); what follows from them is derived "
          "anew.")
      .def(
          "with_numbers",
          [](const Case& core, const std::vector<std::pair<std::string, double>>& settings) {
            std::vector<app::Setting> all;
            for (const auto& [path, number] : settings) all.push_back({path, "", number});
            return Case{core.content().with(all)};
          },
          py::arg("settings"), "The same by (path, number in SI).")
      .def(
          "without_sweep", [](const Case& core) { return Case{core.content().without_sweep()}; },
          "The one operating point that the values state.")
      .def(
          "si",
          [](const Case& core, const std::string& path, const std::string& text) {
            return app::number_in_si(core.content(), path, text);
          },
          py::arg("path"), py::arg("text"), "What the case's reader makes of a text for that input, in SI.")
      .def(
          "si",
          [](const Case& core, const std::string& path, const std::vector<std::string>& texts) {
            std::vector<double> values;
            for (const std::string& text : texts)
              values.push_back(app::number_in_si(core.content(), path, text));
            return values;
          },
          py::arg("path"), py::arg("texts"), "The same of many texts.")
      .def(
          "value",
          [](const Case& core, const std::string& path) {
            return as_python(app::value_of(core.content(), path));
          },
          py::arg("path"), "The present value, in SI; None where there is none.")
      .def(
          "given",
          [](const Case& core, const std::string& path) {
            return as_python(app::given_of(core.content(), path));
          },
          py::arg("path"), "The present value as written, with its unit; None where there is none.")
      .def(
          "inputs", [](const Case& core) { return as_python(app::inputs_of(core.content())); },
          "All that may stand in this case: dicts of path, kind, unit (customary), si_unit, meaning, given, "
          "source "
          "(given, assumed, default or absent) and reason.")
      .def(
          "axes", [](const Case& core) { return as_python(app::axes_of(core.content())); },
          "Swept inputs and their values as written.")
      .def(
          "resolved", [](const Case& core) { return app::write_resolved(core.content()); },
          "The resolved case as YAML, from which the same numbers follow.")
      .def("hash", [](const Case& core) { return app::case_hash(core.content()); })
      .def("file", [](const Case& core) { return core.content().file(); })
      .def("name", [](const Case& core) { return core.content().text("name"); })
      .def("model", [](const Case& core) { return core.content().choice("model"); });
  module.def(
      "si_units", [](const std::string& path) { return as_python(app::si_units(path)); }, py::arg("path"),
      "(unit, [(column, unit), ...]) of the numbers at a path, in SI, empty where they have none; "
      "None where no "
      "input has that path.");
  module.def(
      "load",
      [](const std::string& file, const Settings& settings) {
        return Case{app::read_case(file, as_options(settings))};
      },
      py::arg("file"), py::arg("settings") = Settings{}, py::call_guard<py::gil_scoped_release>(),
      "Reads and checks a case file.");
  module.def(
      "parse",
      [](const std::string& text, const std::string& name, const Settings& settings) {
        return Case{app::parse_case(text, name, as_options(settings))};
      },
      py::arg("text"), py::arg("name") = "case", py::arg("settings") = Settings{},
      py::call_guard<py::gil_scoped_release>(),
      "The same of a text; `name` stands for the file in messages.");
}

}  // namespace orbearing::python
