// Many variants of a case as one table of numbers.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "app/results/progress.hpp"
#include "orbearing/sweep.hpp"
#include "python/bindings/bindings.hpp"

namespace orbearing::python {

namespace py = pybind11;

namespace {

using Table = py::array_t<double, py::array::c_style | py::array::forcecast>;

// Called now and then: asking for the interpreter after each point would cost more than a point.
class Progress {
 public:
  explicit Progress(const py::object& progress) : progress_(progress) {}

  void operator()(std::size_t done) {
    const auto now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(50)) return;
    last_ = now;
    const py::gil_scoped_acquire held;
    progress_(done);
  }

 private:
  using Clock = std::chrono::steady_clock;
  const py::object& progress_;
  Clock::time_point last_ = Clock::now();
};

py::tuple evaluated(const Case& stated, const std::vector<std::string>& paths, const Table& values,
                    const std::string& fidelity, int jobs, const py::object& progress) {
  if (values.ndim() != 2 || static_cast<std::size_t>(values.shape(1)) != paths.size() || paths.empty())
    throw BadInput("values: found an array of another shape; required: (variants, paths), at least one path");
  const std::vector<double> numbers(values.data(), values.data() + values.size());
  Progress report(progress);
  const Points found = [&] {
    const py::gil_scoped_release released;
    const app::Interruption interruption;
    return evaluate(stated, paths, numbers, fidelity, jobs,
                    progress.is_none() ? std::function<void(std::size_t)>{} : std::ref(report));
  }();
  Table table({found.status.size(), found.columns.size()});
  std::copy(found.numbers.begin(), found.numbers.end(), table.mutable_data());
  return py::make_tuple(found.columns, table, found.status);
}

}  // namespace

void add_variants(py::module_& module) {
  module.def("evaluate", &evaluated, py::arg("case"), py::arg("paths"), py::arg("values"),
             py::arg("fidelity") = "quasi-static", py::arg("jobs") = 0, py::arg("progress") = py::none(),
             "Operating points of the case with the numbers at `paths` replaced by rows of `values` "
             "(variants, paths) "
             "[SI]: the columns of a sweep's table, their numbers (variants, columns) and the status of each "
             "variant. "
             "`progress(done)` receives how many are done.");
}

}  // namespace orbearing::python
