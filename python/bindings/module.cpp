// orbearing._core: the program within Python.
#include "app/version.hpp"
#include "python/bindings/bindings.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "Compiled part of the package orbearing; use the package.";
  module.attr("version") = std::string(orbearing::app::program_version);
  module.attr("instruction_set") = std::string(orbearing::app::instruction_set);
  orbearing::python::add_errors(module);
  orbearing::python::add_case(module);
  orbearing::python::add_command(module);
  orbearing::python::add_variants(module);
  orbearing::python::add_machine(module);
}
