// Steps of an instance: inputs over a step, derivatives of inputs and of outputs.
#include <algorithm>
#include <cmath>

#include "coupling/fmu/instance.hpp"

namespace orbearing::fmu {

namespace {

// Importers add step sizes up or multiply them: both differ by round-off.
constexpr double kStepShare = 1e-6, kTimeShare = 1e-12;
// An instance takes ten million steps of its own in one step at most, and none of a millisecond.
constexpr double kLongestStep = 1e4;  // [s]
constexpr const char* kTooManySteps = "largest number of steps";

double slack(double time, double size) {
  return kStepShare * size + kTimeShare * std::fabs(time);
}

}  // namespace

void Instance::clear_derivatives() {
  state_.first.assign(facts_.inputs.size(), 0.0);
  state_.second.assign(facts_.inputs.size(), 0.0);
  state_.has_first.assign(facts_.inputs.size(), false);
}

void Instance::set_derivatives(References references, const int* orders, const double* values) {
  require_phase({Phase::initializing, Phase::stepping}, "derivatives of inputs");
  if (references.number > 0 && (references.list == nullptr || orders == nullptr || values == nullptr))
    throw Refused("derivatives of inputs: found NULL; required: lists of references, orders and values");
  for (std::size_t i = 0; i < references.number; ++i) {
    const Variable& one = variable(references.list[i]);
    if (one.role != Role::input) throw Refused(one.name + ": found a derivative to set; required: an input");
    if (orders[i] < 1 || orders[i] > 2)
      throw Refused(one.name + ": found a derivative of order " + std::to_string(orders[i]) +
                    "; required: 1 or 2");
    if (!std::isfinite(values[i])) throw Refused(one.name + ": found a derivative that is not finite");
  }
  for (std::size_t i = 0; i < references.number; ++i) {
    const std::size_t input = variables_[references.list[i]].index;
    (orders[i] == 1 ? state_.first : state_.second)[input] = values[i];
    state_.has_first[input] = true;
  }
}

std::vector<system::InputPolynomial> Instance::polynomials() const {
  std::vector<system::InputPolynomial> polynomials;
  for (std::size_t i = 0; i < state_.inputs.size(); ++i)
    polynomials.push_back({{state_.inputs[i], state_.first[i], 0.5 * state_.second[i], 0.0}});
  for (std::size_t i = 0; i < polynomials.size(); ++i) {
    const std::size_t rate = facts_.inputs[i].rate;
    if (rate != system::kNone && !state_.has_first[i])
      polynomials[i] = system::integral(state_.inputs[i], polynomials[rate]);
  }
  return polynomials;
}

std::vector<double> Instance::input_values(const std::vector<system::InputPolynomial>& polynomials,
                                           double since) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < polynomials.size(); ++i) {
    values.push_back(polynomials[i].at(since));
    if (!std::isfinite(values.back()))
      throw Refused(Status::discard,
                    facts_.inputs[i].name + ": found no finite value at the end of the step");
  }
  return values;
}

void Instance::require_step(double point, double size) const {
  require_phase({Phase::stepping}, "step");
  if (!std::isfinite(size) || !(size > 0.0))
    throw Refused("step size: found " + seconds(size) + "; required: a finite number greater than 0");
  if (size > kLongestStep)
    throw Refused("step size: found " + seconds(size) + "; required: at most " + seconds(kLongestStep) +
                  ", which ten million steps of an instance's own do not exceed");
  if (!std::isfinite(point) || std::fabs(point - state_.time) > slack(state_.time, size))
    throw Refused("communication point: found " + seconds(point) + "; required: the time of the instance, " +
                  seconds(state_.time));
  if (!(point + size > state_.time) || !std::isfinite(point + size))
    throw Refused("step size: found " + seconds(size) + ", which does not move the time " + seconds(point));
  if (state_.has_stop && point + size > state_.stop + slack(state_.stop, size))
    throw Refused("step: found an end at " + seconds(point + size) +
                  "; required: not beyond the stop time, " + seconds(state_.stop));
}

// Of half the length, half of that and so on; what a trial costs halves too. None: 0.
double Instance::accepted_length(double length, const std::vector<system::InputPolynomial>& inputs) {
  constexpr int kHalvings = 20;
  system::SavedState before;
  participant().save(before);
  for (int i = 0; i < kHalvings; ++i) {
    length *= 0.5;
    if (!(state_.time + length > state_.time)) break;
    try {
      participant().advance({state_.time, state_.time + length}, inputs);
      const std::vector<double> values =
          participant().values(input_values(inputs, length), facts_.outputs.size());
      participant().restore(before);
      if (std::all_of(values.begin(), values.end(), [](double one) { return std::isfinite(one); }))
        return length;
    } catch (const std::exception&) {  // it stands at `before` then
    }
  }
  return 0.0;
}

void Instance::refuse_step(double length, const std::vector<system::InputPolynomial>& inputs,
                           const std::string& reason) {
  // A trial of half the length would take as many steps again before it gives up.
  if (reason.find(kTooManySteps) != std::string::npos)
    throw Refused(Status::discard, "step too long: found " + seconds(length) + ", in which " + reason +
                                       "; required: shorter steps");
  const double accepted = accepted_length(length, inputs);
  if (accepted > 0.0)
    throw Refused(Status::discard, "step too long: found " + seconds(length) + ", in which " + reason +
                                       "; required under these inputs: at most about " +
                                       seconds(accepted, 4));
  throw Refused(Status::discard, "step: found " + seconds(length) + ", in which " + reason +
                                     ". No shorter step was accepted under these inputs either");
}

void Instance::step(double point, double size) {
  require_step(point, size);
  const system::Window window{state_.time, point + size};
  const std::vector<system::InputPolynomial> inputs = polynomials();
  std::vector<double> ends;
  try {
    ends = input_values(inputs, window.length());
    participant().advance(window, inputs);
  } catch (const std::exception& failure) {
    refuse_step(window.length(), inputs, failure.what());
  }
  state_.time = window.end;
  state_.inputs = std::move(ends);
  clear_derivatives();
  outputs_.reset();
}

std::vector<double> Instance::slopes(const Variable& known) {
  require_phase({Phase::stepping, Phase::terminated}, "derivatives of outputs");
  if (known.role != Role::input) throw Refused(known.name + ": found as a known; required: an input");
  return participant().slopes(state_.inputs, known.index);
}

namespace {

void require_lists(References unknowns, References knowns, const double* seed, double* sensitivity,
                   const Instance& instance) {
  const bool empty = unknowns.number == 0 && knowns.number == 0;
  if (!empty &&
      (unknowns.list == nullptr || knowns.list == nullptr || seed == nullptr || sensitivity == nullptr))
    throw Refused(
        "derivatives of outputs: found NULL; required: lists of unknowns, knowns, seed, sensitivity");
  for (std::size_t i = 0; i < unknowns.number; ++i)
    if (const Variable& one = instance.variable(unknowns.list[i]); one.role != Role::output)
      throw Refused(one.name + ": found as an unknown; required: an output");
}

}  // namespace

void Instance::directional(References unknowns, References knowns, const double* seed, double* sensitivity) {
  require_lists(unknowns, knowns, seed, sensitivity, *this);
  std::vector<double> sum(unknowns.number, 0.0);
  for (std::size_t k = 0; k < knowns.number; ++k) {
    const std::vector<double> by = slopes(variable(knowns.list[k]));
    for (std::size_t i = 0; i < unknowns.number; ++i)
      sum[i] += by[variables_[unknowns.list[i]].index] * seed[k];
  }
  std::copy(sum.begin(), sum.end(), sensitivity);
}

void Instance::adjoint(References unknowns, References knowns, const double* seed, double* sensitivity) {
  require_lists(unknowns, knowns, seed, sensitivity, *this);
  std::vector<double> sum(knowns.number, 0.0);
  for (std::size_t k = 0; k < knowns.number; ++k) {
    const std::vector<double> by = slopes(variable(knowns.list[k]));
    for (std::size_t i = 0; i < unknowns.number; ++i)
      sum[k] += by[variables_[unknowns.list[i]].index] * seed[i];
  }
  std::copy(sum.begin(), sum.end(), sensitivity);
}

}  // namespace orbearing::fmu
