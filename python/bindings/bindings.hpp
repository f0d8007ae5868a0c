// The parts of the extension module orbearing._core; each adds its functions and classes.
#pragma once

#include <pybind11/pybind11.h>

#include <utility>
#include <vector>

#include "orbearing/case.hpp"

namespace orbearing::python {

void add_errors(pybind11::module_& module);
void add_case(pybind11::module_& module);
void add_command(pybind11::module_& module);
void add_variants(pybind11::module_& module);
void add_machine(pybind11::module_& module);

}  // namespace orbearing::python
