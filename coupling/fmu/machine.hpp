// A model behind the C interface: numbers in, numbers out. Knows neither FMI nor files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "coupling/cosim/participant.hpp"
#include "coupling/fmu/number_table.hpp"
#include "coupling/fmu/setup_numbers.hpp"
#include "coupling/system/course.hpp"

namespace orbearing::fmu {

struct InputFacts {
  std::string name;
  std::string unit;
  std::string meaning;
  double start = 0.0;  // [unit]
  int rate = -1;       // input with whose value this one goes on inside a step; -1: it stays
};

struct OutputFacts {
  std::string name;
  std::string unit;
  std::string meaning;
  std::vector<std::size_t> inputs;        // on which it depends at once, the state of the model held
  std::vector<std::size_t> start_inputs;  // on which its value at the start depends
  bool start_parameters = true;           // that value depends on parameters too
};

/// All that is known of a model before it runs.
struct ModelFacts {
  std::string model;    // "bearing" or "gearset"
  std::string meaning;  // one sentence
  std::vector<ShownField> parameters;
  std::vector<ShownField> constants;
  std::vector<InputFacts> inputs;
  std::vector<OutputFacts> outputs;
};

/// Throws std::invalid_argument where `numbers` are those of no model.
ModelFacts facts_of(const NumberTable& numbers);

/// One machine. On an error (std::exception) it is in the state before the call.
class Machine {
 public:
  virtual ~Machine() = default;

  virtual void initialize(double time, const std::vector<double>& inputs) = 0;
  /// Courses count from the beginning of the window.
  virtual void advance(const cosim::Window& window, const std::vector<cosim::Course>& inputs) = 0;
  /// Under the inputs of the present time.
  virtual std::vector<double> outputs(const std::vector<double>& inputs) const = 0;
  /// Slopes of all outputs by input `input`, the state held.
  virtual std::vector<double> slopes(const std::vector<double>& inputs, std::size_t input) const = 0;
  virtual void save(cosim::SavedState& state) const = 0;
  virtual void restore(const cosim::SavedState& state) = 0;
};

/// A machine with values of the parameters in the order of the facts. Throws std::invalid_argument where they
/// make no sense.
std::unique_ptr<Machine> make_machine(const NumberTable& numbers, const std::vector<double>& parameters);

/// The parts of the two above.
ModelFacts bearing_facts(const NumberTable& numbers);
ModelFacts gear_facts(const NumberTable& numbers);
std::unique_ptr<Machine> make_bearing(const NumberTable& numbers);
std::unique_ptr<Machine> make_gears(const NumberTable& numbers);

/// Parameters and constants among the rows of `setup`.
template <class Setup>
void show_fields(const Setup& setup, ModelFacts& facts) {
  ShownFields shown = shown_fields(setup);
  facts.parameters = std::move(shown.parameters);
  facts.constants = std::move(shown.constants);
}

}  // namespace orbearing::fmu
