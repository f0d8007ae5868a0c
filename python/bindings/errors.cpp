// BadInput -> orbearing.CaseError, Interrupted and Cancelled -> KeyboardInterrupt, ComputationFailed ->
// orbearing.ComputationError.
#include <pybind11/stl.h>

#include "mechanics/cancellation.hpp"
#include "python/bindings/bindings.hpp"

namespace orbearing::python {

namespace py = pybind11;

namespace {

template <class... Arguments>
void raise(const char* name, const Arguments&... arguments) {
  const py::object type = py::module_::import("orbearing.errors").attr(name);
  PyErr_SetObject(type.ptr(), type(arguments...).ptr());
}

}  // namespace

void add_errors(py::module_&) {
  // The last one registered is asked first, and std::exception comes after all.
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const BadInput& error) {
      raise("CaseError", error.messages);
    } catch (const Interrupted& error) {
      PyErr_SetString(PyExc_KeyboardInterrupt, error.what());
    } catch (const Cancelled& wish) {
      PyErr_SetString(PyExc_KeyboardInterrupt, wish.what());
    } catch (const ComputationFailed& error) {
      raise("ComputationError", std::string(error.what()));
    }
  });
}

}  // namespace orbearing::python
