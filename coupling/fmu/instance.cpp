#include "coupling/fmu/instance.hpp"

#include <algorithm>
#include <cmath>

namespace orbearing::fmu {

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
  } catch (...) {  // no memory for the words: the status alone has to do
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
  participant().initialize(state_.time, state_.inputs);
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

void Instance::get_whole(References references, std::int64_t* values) {
  require_pointer(references.list, references.number, "value references");
  require_pointer(values, references.number, "values");
  for (std::size_t i = 0; i < references.number; ++i) {
    const Variable& one = variable(references.list[i]);
    if (!one.whole())
      throw Refused(one.name + ": found a call for integers; required: one for real variables");
    values[i] = static_cast<std::int64_t>(one.start);
  }
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

}  // namespace orbearing::fmu
