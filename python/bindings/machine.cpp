// A bearing that a script moves: what an FMU of it holds, in this process.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>

#include "app/errors.hpp"
#include "app/results/interruption.hpp"
#include "app/study/fmu_model.hpp"
#include "coupling/fmu/model.hpp"
#include "python/bindings/bindings.hpp"

namespace orbearing::python {

namespace py = pybind11;

namespace {

/// A participant of the co-simulation with its inputs and its time.
class Machine {
 public:
  explicit Machine(const fmu::NumberTable& numbers) : facts_(fmu::facts_of(numbers)) {
    std::vector<double> parameters;
    for (const auto& parameter : facts_.shown.parameters) parameters.push_back(parameter.start);
    participant_ = fmu::make_participant(numbers, parameters);
    for (const system::Input& input : facts_.inputs) inputs_.push_back(input.start);
    slopes_.assign(inputs_.size(), 0.0);
    has_slope_.assign(inputs_.size(), false);
    given_.assign(inputs_.size(), false);
  }

  /// A slope by time that is given stands for the rate that otherwise goes with the input.
  void set_input(const std::string& name, double value, std::optional<double> slope) {
    const std::size_t index = index_of(facts_.inputs, name, "input");
    inputs_[index] = value;
    slopes_[index] = slope.value_or(0.0);
    has_slope_[index] = slope.has_value();
    given_[index] = true;
  }

  double input(const std::string& name) const { return inputs_[index_of(facts_.inputs, name, "input")]; }

  /// What nobody set fits the rest: the displacement is that under the start load.
  void initialize(double time) {
    participant_->complete(inputs_, given_);
    participant_->initialize(time, inputs_);
    time_ = time;
    begun_ = true;
  }

  void advance(double length) {
    if (!(length > 0.0))
      throw app::BadInput("advance: found " + std::to_string(length) + " s; required: above 0");
    if (!begun_) initialize(time_);
    constexpr double long_step = 1e-3;  // [s]  may take longer than anyone waits for Ctrl-C
    std::optional<app::Interruption> interruption;
    if (length > long_step) interruption.emplace();
    const std::vector<system::InputPolynomial> over = polynomials();
    participant_->advance({time_, time_ + length}, over);
    for (std::size_t i = 0; i < inputs_.size(); ++i) inputs_[i] = over[i].at(length);
    time_ += length;
  }

  double output(const std::string& name) {
    const std::size_t index = index_of(facts_.outputs, name, "output");
    return values(index + 1)[index];
  }

  std::vector<double> outputs() { return values(facts_.outputs.size()); }

  /// [unit of output / unit of input], the inner state held.
  double slope(const std::string& output, const std::string& input) {
    if (!begun_) initialize(time_);
    return participant_->slopes(
        inputs_, index_of(facts_.inputs, input, "input"))[index_of(facts_.outputs, output, "output")];
  }

  /// Everything the future depends on: time, inputs, their slopes, the inner state.
  std::vector<double> save() {
    if (!begun_) initialize(time_);
    std::vector<double> state{time_};
    state.insert(state.end(), inputs_.begin(), inputs_.end());
    state.insert(state.end(), slopes_.begin(), slopes_.end());
    for (const bool has : has_slope_) state.push_back(has ? 1.0 : 0.0);
    system::SavedState inner;
    participant_->save(inner);
    state.insert(state.end(), inner.begin(), inner.end());
    return state;
  }

  void restore(const std::vector<double>& state) {
    const std::size_t count = inputs_.size(), head = 1 + 3 * count;
    if (state.size() < head) throw app::BadInput("restore: found a state of another bearing");
    participant_->restore({state.begin() + static_cast<std::ptrdiff_t>(head), state.end()});
    time_ = state[0];
    for (std::size_t i = 0; i < count; ++i) {
      inputs_[i] = state[1 + i];
      slopes_[i] = state[1 + count + i];
      has_slope_[i] = state[1 + 2 * count + i] != 0.0;
    }
    begun_ = true;
  }

  double time() const { return time_; }
  const fmu::ModelFacts& facts() const { return facts_; }

 private:
  template <class Described>
  static std::size_t index_of(const std::vector<Described>& all, const std::string& name, const char* what) {
    const std::size_t index = system::index_of(all, name);
    if (index != system::kNone) return index;
    std::string known;
    for (const Described& one : all) known += (known.empty() ? "" : ", ") + one.name;
    throw app::BadInput(name + ": found no " + what + " of that name; required: one of " + known);
  }

  std::vector<double> values(std::size_t number) {
    if (!begun_) initialize(time_);
    return participant_->values(inputs_, number);
  }

  std::vector<system::InputPolynomial> polynomials() const {
    std::vector<system::InputPolynomial> over;
    for (std::size_t i = 0; i < inputs_.size(); ++i) over.push_back({{inputs_[i], slopes_[i], 0.0, 0.0}});
    for (std::size_t i = 0; i < over.size(); ++i) {
      const std::size_t rate = facts_.inputs[i].rate;
      if (rate != system::kNone && !has_slope_[i]) over[i] = system::integral(inputs_[i], over[rate]);
    }
    return over;
  }

  fmu::ModelFacts facts_;
  std::unique_ptr<system::Participant> participant_;
  std::vector<double> inputs_;
  std::vector<double> slopes_;
  std::vector<bool> has_slope_;
  std::vector<bool> given_;  // by the caller, at any time
  double time_ = 0.0;
  bool begun_ = false;
};

template <class Described>
py::list described(const std::vector<Described>& all) {
  py::list rows;
  for (const Described& one : all) rows.append(py::make_tuple(one.name, one.unit, one.meaning));
  return rows;
}

}  // namespace

void add_machine(py::module_& module) {
  using Released = py::call_guard<py::gil_scoped_release>;
  py::class_<Machine>(module, "Machine", "A participant of the co-simulation in this process.")
      .def(py::init([](const CoreCase& core, const std::string& model) {
             return std::make_unique<Machine>(model == "gearset" ? app::gear_numbers(core.resolved)
                                                                 : app::bearing_numbers(core.resolved));
           }),
           py::arg("case"), py::arg("model") = "bearing")
      .def("set_input", &Machine::set_input, py::arg("name"), py::arg("value"), py::arg("slope") = py::none())
      .def("input", &Machine::input, py::arg("name"))
      .def("initialize", &Machine::initialize, py::arg("time") = 0.0, Released())
      .def("advance", &Machine::advance, py::arg("length"), Released())
      .def("output", &Machine::output, py::arg("name"))
      .def("outputs", &Machine::outputs)
      .def("slope", &Machine::slope, py::arg("output"), py::arg("input"))
      .def("save", &Machine::save)
      .def("restore", &Machine::restore, py::arg("state"))
      .def_property_readonly("time", &Machine::time)
      .def_property_readonly("inputs", [](const Machine& m) { return described(m.facts().inputs); })
      .def_property_readonly("output_list", [](const Machine& m) { return described(m.facts().outputs); });
}

}  // namespace orbearing::python
