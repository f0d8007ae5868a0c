// One value of a model's setup: name, unit, meaning, what the user of an FMU may do with it, and access.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "coupling/fmu/number_table.hpp"

namespace orbearing::fmu {

/// What an FMU shows of a value.
enum class Use {
  parameter,  // settable before the run
  constant,   // shown; fixes the number of variables
  resource    // travels with the model, unseen
};

/// Which numbers make sense; all are finite.
enum class Allowed { any, not_negative, positive, share };

/// Facts about a value, whatever it belongs to.
struct FieldFacts {
  std::string name;     // as the key of a case, where it has one
  std::string unit;     // SI; "1" for ratios
  std::string meaning;  // one sentence
  Use use = Use::resource;
  Allowed allowed = Allowed::any;
};

/// Throws std::invalid_argument, with what was found and what is required, where `value` makes no sense.
void require_allowed(const FieldFacts& facts, double value);

template <class Setup>
struct SetupField {
  FieldFacts facts;
  std::function<std::vector<double>(const Setup&)> get;
  std::function<void(Setup&, const std::vector<double>&)> set;
  bool single = true;  // one number, not a list
};

/// Collects the fields of a setup.
template <class Setup>
class FieldList {
 public:
  /// A number; `member` gives a reference to it in a setup, const or not.
  template <class Member>
  FieldList& number(FieldFacts facts, Member member) {
    add(
        std::move(facts), [member](const Setup& s) { return std::vector{static_cast<double>(member(s))}; },
        [member](Setup& s, const std::vector<double>& values) { put(member(s), values.at(0)); });
    return *this;
  }
  /// A list of any length.
  FieldList& list(std::string name, std::function<std::vector<double>(const Setup&)> get,
                  std::function<void(Setup&, const std::vector<double>&)> set) {
    add({.name = std::move(name)}, std::move(get), std::move(set));
    fields_.back().single = false;
    return *this;
  }

  const std::vector<SetupField<Setup>>& fields() const { return fields_; }

 private:
  // Numbers, counts, flags and choices alike.
  template <class Value>
  static void put(Value& into, double value) {
    into = static_cast<Value>(value);
  }
  static void put(bool& into, double value) { into = value != 0.0; }

  template <class Get, class Set>
  void add(FieldFacts facts, Get get, Set set) {
    fields_.push_back({std::move(facts), std::move(get), std::move(set)});
  }

  std::vector<SetupField<Setup>> fields_;
};

template <class Setup>
NumberTable numbers_of_fields(std::string model, const std::vector<SetupField<Setup>>& fields,
                              const Setup& setup) {
  NumberTable numbers{std::move(model), {}};
  for (const SetupField<Setup>& field : fields) numbers.rows.push_back({field.facts.name, field.get(setup)});
  return numbers;
}

/// Throws std::invalid_argument where a number is missing or makes no sense.
template <class Setup>
Setup setup_from(const std::vector<SetupField<Setup>>& fields, const NumberTable& numbers) {
  Setup setup;
  for (const SetupField<Setup>& field : fields) {
    const std::vector<double>& values = numbers.at(field.facts.name);
    if (field.facts.use != Use::resource) require_allowed(field.facts, values.empty() ? 0.0 : values[0]);
    if (field.single && values.size() != 1)
      throw std::invalid_argument(field.facts.name + ": found " + std::to_string(values.size()) +
                                  " numbers; required: 1");
    field.set(setup, values);
  }
  return setup;
}

}  // namespace orbearing::fmu
