// Many variants of a case as one table of numbers, and tables with errors in their place.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "app/results/progress.hpp"
#include "orbearing/sweep.hpp"
#include "orbearing/table.hpp"
#include "python/bindings/bindings.hpp"

namespace orbearing::python {

namespace py = pybind11;

namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

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

py::tuple evaluated(const Case& stated, const std::vector<std::string>& paths, const Numbers& values,
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
  Numbers table({found.status.size(), found.columns.size()});
  std::copy(found.numbers.begin(), found.numbers.end(), table.mutable_data());
  return py::make_tuple(found.columns, table, found.status);
}

py::tuple answered(const Table& table, const std::string& result, const Numbers& values,
                   std::optional<double> bound, bool compute, int jobs) {
  if (values.ndim() != 2 || static_cast<std::size_t>(values.shape(1)) != table.inputs().size())
    throw BadInput("values: found an array of another shape; required: (queries, inputs of the table)");
  const std::vector<double> numbers(values.data(), values.data() + values.size());
  const TableAnswers found = [&] {
    const py::gil_scoped_release released;
    const app::Interruption interruption;
    return table.answers(result, numbers, {bound, compute, jobs});
  }();
  const auto array = [](const auto& all) {
    return py::array(static_cast<py::ssize_t>(all.size()), all.data());
  };
  return py::make_tuple(array(found.values), array(found.errors), array(found.computed), found.failures);
}

void add_table(py::module_& module) {
  py::class_<Table>(module, "CoreTable", "Results of a case over some of its inputs, with errors.")
      .def(py::init(&Table::read), py::arg("file"), py::call_guard<py::gil_scoped_release>())
      .def("case", &Table::stated)
      .def("bound", &Table::bound)
      .def("results", &Table::results)
      .def("inputs",
           [](const Table& table) {
             py::list inputs;
             for (const TableInput& one : table.inputs())
               inputs.append(py::make_tuple(one.path, one.from, one.to));
             return inputs;
           })
      .def("answers", &answered, py::arg("result"), py::arg("values"), py::arg("bound") = py::none(),
           py::arg("compute") = true, py::arg("jobs") = 0);
}

}  // namespace

void add_variants(py::module_& module) {
  add_table(module);
  module.def("evaluate", &evaluated, py::arg("case"), py::arg("paths"), py::arg("values"),
             py::arg("fidelity") = "quasi-static", py::arg("jobs") = 0, py::arg("progress") = py::none(),
             "Operating points of the case with the numbers at `paths` replaced by rows of `values` "
             "(variants, paths) "
             "[SI]: the columns of a sweep's table, their numbers (variants, columns) and the status of each "
             "variant. "
             "`progress(done)` receives how many are done.");
}

}  // namespace orbearing::python
