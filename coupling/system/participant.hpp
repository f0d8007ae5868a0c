// A driven model in time: a bearing or a set of gears behind described inputs and outputs. The master of a
// co-simulation and the C interfaces of FMUs both use it in this form.
#pragma once

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/system/input_polynomial.hpp"

namespace orbearing::system {

/// Index of an input or output that does not exist.
inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);

struct Input {
  std::string name;
  std::string unit;
  std::string meaning;
  double start = 0.0;  // [unit]
  std::size_t rate =
      kNone;  // input with whose value this one goes on where no polynomial is given; none: it stays
};

struct Output {
  std::string name;
  std::string unit;
  std::string meaning;
  std::vector<std::size_t> inputs;        // on which it depends at once, the state held
  std::vector<std::size_t> start_inputs;  // on which its value at the start depends
  bool start_parameters = true;           // that value depends on parameters too
};

/// On an error (std::exception) it is in the state before the call.
class Participant {
 public:
  virtual ~Participant() = default;

  const std::vector<Input>& inputs() const { return inputs_; }
  const std::vector<Output>& outputs() const { return outputs_; }

  /// To the state at `time` [s] under the inputs of that instant.
  virtual void initialize(double time, const std::vector<double>& inputs) = 0;
  /// Before that: replaces values that nobody gave by values that fit the parameters and the other inputs.
  virtual void complete(std::vector<double>& inputs, const std::vector<bool>& given) const {
    (void)inputs, (void)given;
  }
  /// Then, before the first window, with the others' output: nearer to the state in which all are in
  /// equilibrium.
  virtual void balance(double time, const std::vector<double>& inputs) { initialize(time, inputs); }
  /// From `window.begin`, its present time, to its end; polynomials count from the beginning.
  virtual void advance(const Window& window, const std::vector<InputPolynomial>& inputs) = 0;
  /// The first `number` outputs under the inputs of the present time; those that cost little come first.
  virtual std::vector<double> values(const std::vector<double>& inputs, std::size_t number) const = 0;
  /// Slopes of all outputs by input `input`, the state held.
  virtual std::vector<double> slopes(const std::vector<double>& inputs, std::size_t input) const = 0;
  /// Complete and exact: save, advance, restore, advance gives the same bits, in another process too.
  virtual void save(SavedState& state) const = 0;
  virtual void restore(const SavedState& state) = 0;

 protected:
  Participant(std::vector<Input> inputs, std::vector<Output> outputs)
      : inputs_(std::move(inputs)), outputs_(std::move(outputs)) {}
  Participant(Participant&&) noexcept = default;
  Participant& operator=(Participant&&) noexcept = default;

 private:
  std::vector<Input> inputs_;
  std::vector<Output> outputs_;
};

/// Index of the one called `name` among inputs or outputs; kNone where there is no such one.
template <class Described>
std::size_t index_of(const std::vector<Described>& all, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Described& one) { return one.name == name; });
  return found == all.end() ? kNone : static_cast<std::size_t>(found - all.begin());
}

/// All numbers of `state`, which it shows by each(visit(double* first, size)), behind `head`: version, kind
/// and all else that two states must agree in.
template <class State>
SavedState saved_state(std::vector<double> head, State& state) {
  state.each([&](const double* first, long size) { head.insert(head.end(), first, first + size); });
  return head;
}

/// The inverse. Throws std::invalid_argument, with nothing changed, where `from` is of another head or
/// length.
template <class State>
void restore_state(const SavedState& from, const char* whose, const std::vector<double>& head, State& state) {
  const std::size_t required = saved_state(head, state).size();
  if (from.size() != required || !std::equal(head.begin(), head.end(), from.begin())) {
    std::ostringstream text;
    text << whose << ": found a saved state of " << from.size() << " numbers that begin with";
    for (std::size_t i = 0; i < std::min(from.size(), head.size()); ++i) text << ' ' << from[i];
    text << "; required: " << required << " that begin with";
    for (const double number : head) text << ' ' << number;
    throw std::invalid_argument(text.str());
  }
  auto at = from.begin() + static_cast<std::ptrdiff_t>(head.size());
  state.each([&](double* first, long size) {
    std::copy_n(at, size, first);
    at += size;
  });
}

}  // namespace orbearing::system
