#include "orbearing/participant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "app/study/fmu_model.hpp"
#include "coupling/fmu/model.hpp"

namespace orbearing {

/// A participant of the co-simulation with its inputs and its time.
struct Participant::Content {
  fmu::ModelFacts facts;
  std::unique_ptr<system::Participant> participant;
  std::vector<double> inputs;
  std::vector<double> slopes;
  std::vector<bool> has_slope;
  std::vector<bool> given;  // by the caller, at any time
  double time = 0.0;
  bool begun = false;

  explicit Content(const fmu::NumberTable& numbers) : facts(fmu::facts_of(numbers)) {
    std::vector<double> parameters;
    for (const auto& parameter : facts.shown.parameters) parameters.push_back(parameter.start);
    participant = fmu::make_participant(numbers, parameters);
    for (const system::Input& input : facts.inputs) inputs.push_back(input.start);
    slopes.assign(inputs.size(), 0.0);
    has_slope.assign(inputs.size(), false);
    given.assign(inputs.size(), false);
  }

  void begin() {
    participant->complete(inputs, given);
    participant->initialize(time, inputs);
    begun = true;
  }

  void require_begun() {
    if (!begun) begin();
  }

  // Values of the first `number` outputs.
  std::vector<double> values(std::size_t number) {
    require_begun();
    return participant->values(inputs, number);
  }

  std::vector<system::InputPolynomial> polynomials() const {
    std::vector<system::InputPolynomial> over;
    for (std::size_t i = 0; i < inputs.size(); ++i) over.push_back({{inputs[i], slopes[i], 0.0, 0.0}});
    for (std::size_t i = 0; i < over.size(); ++i) {
      const std::size_t rate = facts.inputs[i].rate;
      if (rate != system::kNone && !has_slope[i]) over[i] = system::integral(inputs[i], over[rate]);
    }
    return over;
  }
};

namespace {

template <class Described>
std::vector<Port> ports_of(const std::vector<Described>& all) {
  std::vector<Port> ports;
  for (const Described& one : all) ports.push_back({one.name, one.unit, one.meaning});
  return ports;
}

template <class Described>
std::size_t index_of(const std::vector<Described>& all, const std::string& name, const char* what) {
  const std::size_t index = system::index_of(all, name);
  if (index != system::kNone) return index;
  std::string known;
  for (const Described& one : all) known += (known.empty() ? "" : ", ") + one.name;
  throw BadInput(name + ": found no " + what + " of that name; required: one of " + known);
}

void require_finite(const std::string& what, double value) {
  if (!std::isfinite(value))
    throw BadInput(fmt::format("{}: found {}; required: a finite number", what, value));
}

}  // namespace

Participant::Participant(std::unique_ptr<Content> content) : content_(std::move(content)) {}
Participant::~Participant() = default;
Participant::Participant(Participant&&) noexcept = default;
Participant& Participant::operator=(Participant&&) noexcept = default;

Participant Participant::bearing(const Case& stated) {
  return Participant(std::make_unique<Content>(app::bearing_numbers(stated.content())));
}

Participant Participant::gearset(const Case& stated) {
  return Participant(std::make_unique<Content>(app::gear_numbers(stated.content())));
}

std::vector<Port> Participant::inputs() const {
  return ports_of(content_->facts.inputs);
}

std::vector<Port> Participant::outputs() const {
  return ports_of(content_->facts.outputs);
}

double Participant::time() const {
  return content_->time;
}

void Participant::set_input(const std::string& name, double value, std::optional<double> slope) {
  Content& c = *content_;
  const std::size_t index = index_of(c.facts.inputs, name, "input");
  require_finite(name, value);
  if (slope) require_finite(name + ", slope", *slope);
  c.inputs[index] = value;
  c.slopes[index] = slope.value_or(0.0);
  c.has_slope[index] = slope.has_value();
  c.given[index] = true;
}

double Participant::input(const std::string& name) const {
  return content_->inputs[index_of(content_->facts.inputs, name, "input")];
}

void Participant::initialize(double time) {
  require_finite("initialize: time [s]", time);
  content_->time = time;
  content_->begin();
}

void Participant::advance(double length) {
  if (!(length > 0.0)) throw BadInput("advance: found " + std::to_string(length) + " s; required: above 0");
  require_finite("advance: step [s]", length);
  Content& c = *content_;
  c.require_begun();
  const std::vector<system::InputPolynomial> over = c.polynomials();
  c.participant->advance({c.time, c.time + length}, over);
  for (std::size_t i = 0; i < c.inputs.size(); ++i) c.inputs[i] = over[i].at(length);
  c.time += length;
}

double Participant::output(const std::string& name) {
  const std::size_t index = index_of(content_->facts.outputs, name, "output");
  return content_->values(index + 1)[index];
}

std::vector<double> Participant::values() {
  return content_->values(content_->facts.outputs.size());
}

double Participant::slope(const std::string& output, const std::string& input) {
  Content& c = *content_;
  c.require_begun();
  return c.participant->slopes(
      c.inputs, index_of(c.facts.inputs, input, "input"))[index_of(c.facts.outputs, output, "output")];
}

std::vector<double> Participant::save() {
  Content& c = *content_;
  c.require_begun();
  std::vector<double> state{c.time};
  state.insert(state.end(), c.inputs.begin(), c.inputs.end());
  state.insert(state.end(), c.slopes.begin(), c.slopes.end());
  for (const bool has : c.has_slope) state.push_back(has ? 1.0 : 0.0);
  system::SavedState inner;
  c.participant->save(inner);
  state.insert(state.end(), inner.begin(), inner.end());
  return state;
}

void Participant::restore(const std::vector<double>& state) {
  Content& c = *content_;
  const std::size_t count = c.inputs.size(), head = 1 + 3 * count;
  if (state.size() < head) throw BadInput("restore: found a state of another bearing");
  c.participant->restore({state.begin() + static_cast<std::ptrdiff_t>(head), state.end()});
  c.time = state[0];
  for (std::size_t i = 0; i < count; ++i) {
    c.inputs[i] = state[1 + i];
    c.slopes[i] = state[1 + count + i];
    c.has_slope[i] = state[1 + 2 * count + i] != 0.0;
  }
  c.begun = true;
}

}  // namespace orbearing
