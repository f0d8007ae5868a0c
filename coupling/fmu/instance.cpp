#include "coupling/fmu/instance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

#include "coupling/fmu/model_file.hpp"
#include "coupling/fmu/number_table.hpp"

namespace orbearing::fmu {

namespace {

struct Header {
  std::array<char, 8> magic{'O', 'R', 'B', 'F', 'M', 'U', 'S', 'T'};
  std::uint64_t format = 3;
  std::uint64_t model = 0;     // hash
  std::uint64_t numbers = 0;   // doubles that follow
  std::uint64_t checksum = 0;  // of their bytes
};

std::vector<double> numbers_of(const InstanceState& s) {
  std::vector<double> numbers{static_cast<double>(s.phase),
                              static_cast<double>(s.experiment_set),
                              static_cast<double>(s.has_stop),
                              static_cast<double>(s.computed),
                              s.time,
                              s.stop,
                              s.elapsed};
  const auto add = [&](const auto& list) { numbers.insert(numbers.end(), list.begin(), list.end()); };
  add(s.parameters);
  add(s.inputs);
  add(s.first);
  add(s.second);
  for (const bool has : s.has_first) numbers.push_back(has ? 1.0 : 0.0);
  for (const bool was : s.given) numbers.push_back(was ? 1.0 : 0.0);
  add(s.participant);
  return numbers;
}

constexpr std::size_t kFixed = 7;  // numbers before the lists

std::size_t count_of(const StateSizes& sizes) {
  return kFixed + sizes.parameters + 5 * sizes.inputs;
}

// The numbers of the participant are its own business; all before must be finite.
InstanceState state_of(const std::vector<double>& numbers, const StateSizes& sizes) {
  for (std::size_t i = 0; i < count_of(sizes); ++i)
    if (!std::isfinite(numbers[i])) throw Refused("serialised state: found a number that is not finite");
  InstanceState s;
  const int phase = static_cast<int>(std::fmin(std::fmax(numbers[0], -1.0), 9.0));
  if (phase < 0 || phase > static_cast<int>(Phase::terminated))
    throw Refused("serialised state: found phase " + std::to_string(phase) + "; required: 0 to 3");
  s.phase = static_cast<Phase>(phase);
  s.experiment_set = numbers[1] != 0.0;
  s.has_stop = numbers[2] != 0.0;
  s.computed = numbers[3] != 0.0;
  s.time = numbers[4];
  s.stop = numbers[5];
  s.elapsed = numbers[6];
  auto from = numbers.begin() + kFixed;
  const auto take = [&](std::size_t count) {
    const auto begin = from;
    from += static_cast<std::ptrdiff_t>(count);
    return std::vector<double>(begin, from);
  };
  s.parameters = take(sizes.parameters);
  s.inputs = take(sizes.inputs);
  s.first = take(sizes.inputs);
  s.second = take(sizes.inputs);
  for (const double has : take(sizes.inputs)) s.has_first.push_back(has != 0.0);
  for (const double was : take(sizes.inputs)) s.given.push_back(was != 0.0);
  s.participant.assign(from, numbers.end());
  return s;
}

Refused no_state(const std::string& found, const std::string& required) {
  return Refused("serialised state: found " + found + "; required: " + required);
}

}  // namespace

std::string bytes_of(const InstanceState& state, std::uint64_t model) {
  const std::vector<double> numbers = numbers_of(state);
  std::string body(numbers.size() * sizeof(double), '\0');
  std::memcpy(body.data(), numbers.data(), body.size());
  const Header header{.model = model, .numbers = numbers.size(), .checksum = hash_of(body)};
  std::string bytes(sizeof(Header), '\0');
  std::memcpy(bytes.data(), &header, sizeof(Header));
  return bytes + body;
}

InstanceState state_from(const char* bytes, std::size_t size, std::uint64_t model, const StateSizes& sizes) {
  if (size < sizeof(Header))
    throw no_state(std::to_string(size) + " bytes", "at least " + std::to_string(sizeof(Header)));
  Header header;
  std::memcpy(&header, bytes, sizeof(Header));
  if (header.magic != Header{}.magic) throw no_state("other bytes", "a state of an FMU of Orbearing");
  if (header.format != Header{}.format)
    throw no_state("format " + std::to_string(header.format), std::to_string(Header{}.format));
  if (header.model != model)
    throw no_state("that of another model or version of Orbearing", "one of this very model");
  const std::string_view body(bytes + sizeof(Header), size - sizeof(Header));
  if (header.numbers != body.size() / sizeof(double) || body.size() % sizeof(double) != 0)
    throw no_state(std::to_string(size) + " bytes", "a complete state");
  if (header.checksum != hash_of(body)) throw no_state("changed bytes", "an unchanged state");
  std::vector<double> numbers(body.size() / sizeof(double));
  if (numbers.size() < count_of(sizes))
    throw no_state(std::to_string(numbers.size()) + " numbers",
                   "at least " + std::to_string(count_of(sizes)));
  std::memcpy(numbers.data(), body.data(), body.size());
  return state_of(numbers, sizes);
}

namespace {

void require_pointer(const void* pointer, std::size_t number, const char* what) {
  if (pointer == nullptr && number > 0)
    throw Refused(std::string(what) + ": found NULL; required: a list of " + std::to_string(number));
}

const char* name_of(Phase phase) {
  constexpr const char* names[] = {"instantiated", "in initialization mode", "in step mode", "terminated"};
  return names[static_cast<std::size_t>(phase)];
}

constexpr const char* kEvents = "logEvents";

const char* category_of(Status status) {
  constexpr const char* names[] = {kEvents, "logStatusWarning", "logStatusDiscard", "logStatusError",
                                   "logStatusFatal"};
  return names[static_cast<std::size_t>(status)];
}

std::vector<double> starts(const ModelFacts& facts) {
  std::vector<double> values;
  for (const system::Input& input : facts.inputs) values.push_back(input.start);
  return values;
}

}  // namespace

Instance::Instance(NumberTable numbers, const std::string& token, Log log, bool logging)
    : numbers_(std::move(numbers)),
      facts_(facts_of(numbers_)),
      variables_(variables_of(facts_)),
      log_(std::move(log)),
      logging_(logging) {
  const std::string own = token_of(numbers_);
  if (token != own)
    throw Refused("GUID or instantiation token: found '" + token + "'; required: that of the resources, " +
                  own);
  hash_ = hash_of(own);
  reset();
}

void Instance::set_logging(bool on, std::vector<std::string> categories) {
  for (const std::string& category : categories) {
    const auto known = [&](Status status) { return category == category_of(status); };
    if (!known(Status::ok) && !known(Status::warning) && !known(Status::discard) && !known(Status::error) &&
        !known(Status::fatal))
      throw Refused("log category: found '" + category + "'; required: one of the model description");
  }
  logging_ = on;
  categories_ = std::move(categories);
}

void Instance::log(Status status, const char* function, const char* text) const noexcept {
  if (!log_ || (status == Status::ok && !logging_)) return;
  try {
    const char* category = category_of(status);
    if (!categories_.empty() &&
        std::find(categories_.begin(), categories_.end(), category) == categories_.end())
      return;
    log_(status, category, (std::string(function) + ": " + text).c_str());
  } catch (...) {  // no memory for the text: only the status is returned
  }
}

void Instance::require_phase(std::initializer_list<Phase> allowed, const char* what) const {
  if (std::find(allowed.begin(), allowed.end(), state_.phase) != allowed.end()) return;
  std::string required;
  for (const Phase phase : allowed)
    required += (required.empty() ? "" : " or ") + std::string(name_of(phase));
  throw Refused(std::string(what) + ": found an instance that is " + name_of(state_.phase) +
                "; required: one " + required);
}

void Instance::setup_experiment(const Experiment& experiment) {
  require_phase({Phase::instantiated}, "set-up of the experiment");
  if (!std::isfinite(experiment.start))
    throw Refused("start time: found " + seconds(experiment.start) + "; required: a finite number");
  if (experiment.stop && !(*experiment.stop >= experiment.start))
    throw Refused("stop time: found " + seconds(*experiment.stop) + "; required: not before the start at " +
                  seconds(experiment.start));
  state_.experiment_set = true;
  state_.time = experiment.start;
  state_.has_stop = experiment.stop.has_value();
  state_.stop = experiment.stop.value_or(0.0);
}

void Instance::enter_initialization() {
  require_phase({Phase::instantiated}, "entering initialization");
  if (!state_.experiment_set)
    throw Refused("entering initialization: found no set-up of the experiment before");
  state_.phase = Phase::initializing;
}

void Instance::exit_initialization() {
  require_phase({Phase::initializing}, "leaving initialization");
  compute_start();
  state_.phase = Phase::stepping;
}

void Instance::terminate() {
  require_phase({Phase::stepping}, "terminating");
  state_.phase = Phase::terminated;
}

void Instance::reset() {
  InstanceState fresh;
  for (const ShownField& field : facts_.shown.parameters) fresh.parameters.push_back(field.start);
  fresh.inputs = starts(facts_);
  fresh.given.assign(fresh.inputs.size(), false);
  state_ = std::move(fresh);
  clear_derivatives();
  participant_.reset();
  outputs_.reset();
}

system::Participant& Instance::participant() {
  if (!participant_) participant_ = make_participant(numbers_, state_.parameters);
  return *participant_;
}

void Instance::compute_start() {
  if (state_.computed) return;
  participant().complete(state_.inputs, state_.given);
  participant().initialize(state_.elapsed, state_.inputs);
  state_.computed = true;
}

const std::vector<double>& Instance::outputs() {
  if (outputs_) return *outputs_;
  if (state_.phase == Phase::initializing) compute_start();
  std::vector<double> values = participant().values(state_.inputs, facts_.outputs.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw Refused(Status::discard, facts_.outputs[i].name + ": found no finite value under these inputs");
  return outputs_.emplace(std::move(values));
}

const Variable& Instance::variable(std::uint32_t reference) const {
  if (reference < variables_.size()) return variables_[reference];
  throw Refused("value reference: found " + std::to_string(reference) + "; required: less than " +
                std::to_string(variables_.size()));
}

double Instance::value_of(const Variable& variable) {
  switch (variable.role) {
    case Role::time:
      return state_.time;
    case Role::parameter:
      return state_.parameters[variable.index];
    case Role::input:
      return state_.inputs[variable.index];
    case Role::output:
      require_phase({Phase::initializing, Phase::stepping, Phase::terminated}, variable.name.c_str());
      return outputs()[variable.index];
    case Role::constant:
      break;
  }
  return variable.start;
}

void Instance::get(References references, double* values) {
  require_pointer(references.list, references.number, "value references");
  require_pointer(values, references.number, "values");
  std::vector<double> found;
  for (std::size_t i = 0; i < references.number; ++i) {
    const Variable& one = variable(references.list[i]);
    if (one.whole())
      throw Refused(one.name + ": found a call for real variables; required: one for integers");
    found.push_back(value_of(one));
  }
  std::copy(found.begin(), found.end(), values);
}

void Instance::get_whole(References references, std::int32_t* values) {
  require_pointer(references.list, references.number, "value references");
  require_pointer(values, references.number, "values");
  std::vector<std::int32_t> found;
  for (std::size_t i = 0; i < references.number; ++i) {
    const Variable& one = variable(references.list[i]);
    if (!one.whole())
      throw Refused(one.name + ": found a call for integers; required: one for real variables");
    found.push_back(static_cast<std::int32_t>(one.start));
  }
  std::copy(found.begin(), found.end(), values);
}

void Instance::require_settable(const Variable& one, double value) const {
  if (one.role != Role::input && one.role != Role::parameter)
    throw Refused(one.name + ": found a value to set; required: an input or a parameter");
  if (!std::isfinite(value))
    throw Refused(one.name + ": found " + std::to_string(value) + "; required: a finite number");
  if (one.role == Role::parameter) {
    require_phase({Phase::instantiated, Phase::initializing}, one.name.c_str());
    require_allowed(facts_.shown.parameters[one.index].facts, value);
  }
}

void Instance::set(References references, const double* values) {
  require_pointer(references.list, references.number, "value references");
  require_pointer(values, references.number, "values");
  require_phase({Phase::instantiated, Phase::initializing, Phase::stepping}, "setting variables");
  for (std::size_t i = 0; i < references.number; ++i)
    require_settable(variable(references.list[i]), values[i]);
  for (std::size_t i = 0; i < references.number; ++i) {
    const Variable& one = variables_[references.list[i]];
    if (one.role == Role::parameter) participant_.reset();
    if (one.role == Role::input) state_.given[one.index] = true;
    (one.role == Role::parameter ? state_.parameters : state_.inputs)[one.index] = values[i];
  }
  if (references.number == 0) return;
  outputs_.reset();
  if (state_.phase != Phase::stepping) state_.computed = false;
}

// Steps: inputs over a step, derivatives of inputs and of outputs.

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

// Tries half of the length, half of that and so on; the cost of a trial is halved too. None accepted: 0.
double Instance::accepted_length(double length, const std::vector<system::InputPolynomial>& inputs) {
  constexpr int kHalvings = 20;
  system::SavedState before;
  participant().save(before);
  for (int i = 0; i < kHalvings; ++i) {
    length *= 0.5;
    if (!(state_.elapsed + length > state_.elapsed)) break;
    try {
      participant().advance({state_.elapsed, state_.elapsed + length}, inputs);
      const std::vector<double> values =
          participant().values(input_values(inputs, length), facts_.outputs.size());
      participant().restore(before);
      if (std::all_of(values.begin(), values.end(), [](double one) { return std::isfinite(one); }))
        return length;
    } catch (const std::exception&) {  // its state is `before` then
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
  // By the participant's own clock: a late start changes no phase, and no length by round-off.
  const system::Window window{state_.elapsed, state_.elapsed + size};
  const std::vector<system::InputPolynomial> inputs = polynomials();
  std::vector<double> ends;
  try {
    ends = input_values(inputs, window.length());
    participant().advance(window, inputs);
  } catch (const std::exception& failure) {
    refuse_step(window.length(), inputs, failure.what());
  }
  state_.time = point + size;
  state_.elapsed = window.end;
  state_.inputs = std::move(ends);
  clear_derivatives();
  outputs_.reset();
}

// Calls `function` for the slope of each unknown i by each known k.
template <class Function>
void Instance::for_each_slope(References unknowns, References knowns, const Function& function) {
  for (std::size_t k = 0; k < knowns.number; ++k) {
    const Variable& known = variable(knowns.list[k]);
    require_phase({Phase::stepping, Phase::terminated}, "derivatives of outputs");
    if (known.role != Role::input) throw Refused(known.name + ": found as a known; required: an input");
    const std::vector<double> by = participant().slopes(state_.inputs, known.index);
    for (std::size_t i = 0; i < unknowns.number; ++i) function(i, k, by[variables_[unknowns.list[i]].index]);
  }
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
  for_each_slope(unknowns, knowns,
                 [&](std::size_t i, std::size_t k, double slope) { sum[i] += slope * seed[k]; });
  std::copy(sum.begin(), sum.end(), sensitivity);
}

void Instance::adjoint(References unknowns, References knowns, const double* seed, double* sensitivity) {
  require_lists(unknowns, knowns, seed, sensitivity, *this);
  std::vector<double> sum(knowns.number, 0.0);
  for_each_slope(unknowns, knowns,
                 [&](std::size_t i, std::size_t k, double slope) { sum[k] += slope * seed[i]; });
  std::copy(sum.begin(), sum.end(), sensitivity);
}

// States: kept, gone back to, written as bytes.

namespace {

auto is_at(const InstanceState* state) {
  return [state](const InstanceState& kept) { return &kept == state; };
}

}  // namespace

void Instance::require_known(const InstanceState* state) const {
  if (state == nullptr || std::none_of(kept_.begin(), kept_.end(), is_at(state)))
    throw Refused("state: found none of this instance; required: one that it gave and that was not freed");
}

InstanceState Instance::present() const {
  InstanceState state = state_;
  if (state.computed) participant_->save(state.participant);
  return state;
}

InstanceState* Instance::place_state(InstanceState state, InstanceState* again) {
  if (again == nullptr) return &kept_.emplace_back(std::move(state));
  require_known(again);
  *again = std::move(state);
  return again;
}

InstanceState* Instance::keep_state(InstanceState* again) {
  return place_state(present(), again);
}

void Instance::go_to_state(const InstanceState* state) {
  require_known(state);
  if (participant_ && state->parameters != state_.parameters) participant_.reset();
  state_ = *state;
  state_.participant.clear();
  outputs_.reset();
  if (state->computed) participant().restore(state->participant);  // it fits: it was saved or tried before
}

void Instance::free_state(const InstanceState* state) {
  if (state == nullptr) return;
  require_known(state);
  kept_.remove_if(is_at(state));
}

std::size_t Instance::state_size(const InstanceState* state) const {
  require_known(state);
  return bytes_of(*state, hash_).size();
}

void Instance::serialize(const InstanceState* state, char* bytes, std::size_t size) const {
  require_known(state);
  const std::string all = bytes_of(*state, hash_);
  if (bytes == nullptr || size < all.size())
    throw Refused("serialised state: found room for " + std::to_string(bytes == nullptr ? 0 : size) +
                  " bytes; required: " + std::to_string(all.size()));
  std::copy(all.begin(), all.end(), bytes);
}

InstanceState* Instance::deserialize(const char* bytes, std::size_t size, InstanceState* again) {
  if (bytes == nullptr) throw Refused("serialised state: found NULL; required: bytes");
  InstanceState state =
      state_from(bytes, size, hash_, {facts_.shown.parameters.size(), facts_.inputs.size()});
  if (state.computed)
    make_participant(numbers_, state.parameters)->restore(state.participant);  // a state that fits
  return place_state(std::move(state), again);
}

}  // namespace orbearing::fmu
