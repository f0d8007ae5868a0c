// Setups as tables of numbers and back, by the rows of their structures (mechanics/described.hpp).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "bearing/parameters.hpp"
#include "bearing/profile/profile.hpp"
#include "coupling/fmu/number_table.hpp"
#include "coupling/fmu/shown_members.hpp"
#include "gearset/mesh/loaded/loaded_teeth.hpp"
#include "gearset/mesh/periodic_curve.hpp"
#include "mechanics/described.hpp"

namespace orbearing::fmu {

/// Facts of a variable of an FMU of any kind.
struct FieldFacts {
  std::string name;          // as the key of a case, where it has one
  std::string unit;          // SI; "1" for ratios
  std::string meaning;       // one sentence
  described::Range range{};  // [unit]  as of a case
  double none = 0.0;         // [unit]  allowed too: the value of a member that is not stated
};

FieldFacts field_facts(const described::Facts& facts, double none);

/// Throws std::invalid_argument, with what was found and what is required, where `value` makes no sense.
void require_allowed(const FieldFacts& facts, double value);

std::vector<double> to_numbers(const std::vector<double>& list);
std::vector<double> to_numbers(const std::vector<bearing::RaceHarmonic>& form);
/// Index of the kind in the variant, then its members; a table as scale, positions, drops.
std::vector<double> to_numbers(const bearing::profile::Profile& profile);
std::vector<double> to_numbers(const gearset::PeriodicCurve& curve);
std::vector<double> to_numbers(const std::shared_ptr<const gearset::LoadedTeeth>& teeth);  // none: no numbers
std::vector<double> to_numbers(const Eigen::Matrix2Xd& matrix);
void from_numbers(const std::vector<double>& numbers, std::vector<double>& list);
void from_numbers(const std::vector<double>& numbers, std::vector<bearing::RaceHarmonic>& form);
/// Throws std::invalid_argument where `numbers` are those of no profile.
void from_numbers(const std::vector<double>& numbers, bearing::profile::Profile& profile);
void from_numbers(const std::vector<double>& numbers, gearset::PeriodicCurve& curve);
void from_numbers(const std::vector<double>& numbers, std::shared_ptr<const gearset::LoadedTeeth>& teeth);
void from_numbers(const std::vector<double>& numbers, Eigen::Matrix2Xd& matrix);

/// Numbers, counts, flags and choices.
template <class Member>
inline constexpr bool is_single = std::is_arithmetic_v<Member> || std::is_enum_v<Member>;

/// A visitor of rows: appends the numbers of each member to a table.
class NumberWriter {
 public:
  explicit NumberWriter(NumberTable& numbers) : numbers_(numbers) {}

  template <class Member>
  void operator()(const Member& member, const described::Facts& facts) {
    NumberRow row{facts.path, {}};
    if constexpr (is_single<Member>)
      row.values = {static_cast<double>(member)};
    else
      row.values = to_numbers(member);
    numbers_.rows.push_back(std::move(row));
  }

 private:
  NumberTable& numbers_;
};

/// A visitor of rows: gives each member its numbers from a table. Throws std::invalid_argument where they are
/// missing or make no sense.
class NumberReader {
 public:
  NumberReader(const NumberTable& numbers, const ShownMembers& shown) : numbers_(numbers), shown_(shown) {}

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    const std::vector<double>& values = numbers_.at(facts.path);
    if constexpr (is_single<Member>)
      put(member, single(facts, values, static_cast<double>(member),
                         shown_.parameters.hold(&member) || shown_.constants.hold(&member)));
    else
      from_numbers(values, member);
  }

 private:
  /// @param shown then it has to be allowed
  static double single(const described::Facts& facts, const std::vector<double>& values, double none,
                       bool shown);
  template <class Value>
  static void put(Value& into, double value) {
    into = static_cast<Value>(value);
  }
  static void put(bool& into, double value) { into = value != 0.0; }

  const NumberTable& numbers_;
  const ShownMembers& shown_;
};

/// A value that the user may set before the run, or a constant.
struct ShownField {
  FieldFacts facts;
  double start = 0.0;  // [unit of the facts]
};

/// Parameters and constants among the rows.
struct ShownFields {
  std::vector<ShownField> parameters;
  std::vector<ShownField> constants;
};

/// A visitor of rows that finds them.
struct ShownFinder {
  template <class Member>
  void operator()(const Member& member, const described::Facts& facts) {
    if constexpr (is_single<Member>) {
      const ShownField field{field_facts(facts, static_cast<double>(member)), static_cast<double>(member)};
      if (shown.parameters.hold(&member)) fields.parameters.push_back(field);
      if (shown.constants.hold(&member)) fields.constants.push_back(field);
    }
  }

  const ShownMembers& shown;
  ShownFields fields{};
};

template <class Setup>
NumberTable numbers_of_setup(std::string model, Setup setup) {
  NumberTable numbers{std::move(model), {}};
  NumberWriter visit(numbers);
  describe(visit, setup);
  return numbers;
}

/// Throws std::invalid_argument where a number is missing or makes no sense.
template <class Setup>
Setup setup_from(const NumberTable& numbers) {
  Setup setup;
  const ShownMembers shown = shown_members(setup);
  NumberReader visit(numbers, shown);
  describe(visit, setup);
  return setup;
}

template <class Setup>
ShownFields shown_fields(Setup setup) {
  const ShownMembers members = shown_members(setup);
  ShownFinder shown{members}, none{members};
  describe(shown, setup);
  describe(none, setup = {});
  for (std::size_t i = 0; i < shown.fields.parameters.size(); ++i)
    shown.fields.parameters[i].facts.none = none.fields.parameters[i].start;
  return std::move(shown.fields);
}

}  // namespace orbearing::fmu
