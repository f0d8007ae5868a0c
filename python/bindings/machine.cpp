// A bearing that a script moves: what an FMU of it holds, in this process.
#include <pybind11/stl.h>

#include <memory>

#include "app/interface/case_values.hpp"
#include "orbearing/participant.hpp"
#include "python/bindings/bindings.hpp"

namespace orbearing::python {

namespace py = pybind11;

namespace {

py::list described(const std::vector<Port>& ports) {
  py::list rows;
  for (const Port& one : ports) rows.append(py::make_tuple(one.name, one.unit, one.meaning));
  return rows;
}

}  // namespace

void add_machine(py::module_& module) {
  using Released = py::call_guard<py::gil_scoped_release>;
  py::class_<Participant>(module, "Machine", "A participant of the co-simulation in this process.")
      .def(py::init([](const Case& stated, const std::string& model) {
             return std::make_unique<Participant>(model == "gearset" ? Participant::gearset(stated)
                                                                     : Participant::bearing(stated));
           }),
           py::arg("case"), py::arg("model") = "bearing")
      .def("set_input", &Participant::set_input, py::arg("name"), py::arg("value"),
           py::arg("slope") = py::none())
      .def("input", &Participant::input, py::arg("name"))
      .def("initialize", &Participant::initialize, py::arg("time") = 0.0, Released())
      .def("advance", &app::advance_until_stopped, py::arg("length"), Released())
      .def("output", &Participant::output, py::arg("name"))
      .def("outputs", &Participant::values)
      .def("slope", &Participant::slope, py::arg("output"), py::arg("input"))
      .def("save", &Participant::save)
      .def("restore", &Participant::restore, py::arg("state"))
      .def_property_readonly("time", &Participant::time)
      .def_property_readonly("inputs", [](const Participant& p) { return described(p.inputs()); })
      .def_property_readonly("output_list", [](const Participant& p) { return described(p.outputs()); });
}

}  // namespace orbearing::python
