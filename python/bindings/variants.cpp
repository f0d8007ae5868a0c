// Many variants of a case as one table of numbers.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <chrono>

#include "app/errors.hpp"
#include "app/results/interruption.hpp"
#include "app/study/variants.hpp"
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

// Columns that hold text are left out.
std::vector<std::size_t> number_columns(const app::TableHead& head) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < head.names.size(); ++i)
    if (i != head.status_place && head.set_place != i && head.refined_place != i) places.push_back(i);
  return places;
}

py::tuple evaluate(const CoreCase& core, const std::vector<std::string>& paths, const Table& values,
                   const std::string& fidelity, int jobs, const py::object& progress) {
  if (values.ndim() != 2 || static_cast<std::size_t>(values.shape(1)) != paths.size() || paths.empty())
    throw app::BadInput(
        "values: found an array of another shape; required: (variants, paths), at least one path");
  const app::Variants variants{paths, {values.data(), values.data() + values.size()}};
  Progress report(progress);
  const app::VariantRows found = [&] {
    const py::gil_scoped_release released;
    const app::Interruption interruption;
    return app::evaluate_variants(core.resolved, variants, fidelity, jobs,
                                  progress.is_none() ? std::function<void(std::size_t)>{} : std::ref(report));
  }();
  const std::vector<std::size_t> places = number_columns(found.head);
  std::vector<std::string> columns;
  for (const std::size_t place : places) columns.push_back(found.head.names[place]);
  Table table({found.rows.size(), places.size()});
  std::vector<std::string> status;
  double* out = table.mutable_data();
  for (const app::ResultRow& row : found.rows) {
    for (const std::size_t place : places) *out++ = row.values[place];
    status.push_back(row.status);
  }
  return py::make_tuple(columns, table, status);
}

}  // namespace

void add_variants(py::module_& module) {
  module.def("evaluate", &evaluate, py::arg("case"), py::arg("paths"), py::arg("values"),
             py::arg("fidelity") = "quasi-static", py::arg("jobs") = 0, py::arg("progress") = py::none(),
             "Operating points of the case with the numbers at `paths` replaced by rows of `values` "
             "(variants, paths) "
             "[SI]: the columns of a sweep's table, their numbers (variants, columns) and the status of each "
             "variant. "
             "`progress(done)` receives how many are done.");
}

}  // namespace orbearing::python
