// Structures of parameters from a case, by the rows beside them (mechanics/described.hpp).
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "app/case/bearing_type.hpp"
#include "app/case/catalogue_case.hpp"
#include "app/case/derived_defaults.hpp"
#include "app/case/field_table.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Whether inputs of a cage's motion may be missing: rollers without a cage, or balls of planets, which are
/// at rest and whose cage has but a mass.
inline bool goes_without_cage(const ResolvedCase& in) {
  return is_full_complement(in) || bearing_type_of(in) == bearing::PlanetBearingType::deep_groove_ball;
}

/// A visitor of rows: gives each member the value of its field. One without a value keeps what it has.
class DescribedCase {
 public:
  explicit DescribedCase(const ResolvedCase& in) : in_(in) {}

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    if (facts.internal) return;
    // Values that always follow from others must be there.
    if (in_.has(facts.path) ||
        (follows_always(facts.path) && belongs_to_model(facts.path) && !is_of_missing_cage(facts.path)))
      read(member, facts);
  }

  /// The value at a path that has one.
  template <class Member>
  void read_value(Member& member, const described::Facts& facts) {
    read(member, facts);
  }

 private:
  using Facts = described::Facts;

  bool belongs_to_model(std::string_view path) const { return (find_field(path)->models & in_.model()) != 0; }
  bool is_of_missing_cage(std::string_view path) const {
    return path.starts_with("bearing.cage.") && goes_without_cage(in_);
  }

  void read(bool& member, const Facts& facts) { member = in_.flag(facts.path); }
  template <std::integral Count>
  void read(Count& member, const Facts& facts) {
    member = in_.integer(facts.path);
  }
  template <class Value>
  void read(std::optional<Value>& member, const Facts& facts) {
    read(member.emplace(), facts);
  }
  void read(double& member, const Facts& facts) {
    const bool plain = facts.details.dimension.name.empty();
    member = plain ? in_.number(facts.path) : in_.quantity(facts.path);
  }
  void read(std::string& member, const Facts& facts) { member = in_.text(facts.path); }
  void read(std::vector<double>& member, const Facts& facts) { member = in_.list(facts.path); }
  template <class Number, std::size_t n>
  void read(std::array<Number, n>& member, const Facts& facts) {
    read_group(0, member, facts);
  }
  template <class Number, std::size_t n>
  void read(std::vector<std::array<Number, n>>& member, const Facts& facts) {
    member.resize(in_.list(facts.path).size() / n);
    for (std::size_t i = 0; i < member.size(); ++i) read_group(n * i, member[i], facts);
  }
  template <class Number, std::size_t n>
  void read_group(std::size_t first, std::array<Number, n>& group, const Facts& facts) {
    for (std::size_t i = 0; i < n; ++i) {
      const double value = in_.list(facts.path).at(first + i);
      group[i] = static_cast<Number>(std::is_integral_v<Number> ? std::round(value) : value);
    }
  }
  template <class Choice>
  requires std::is_enum_v<Choice>
  void read(Choice& member, const Facts& facts) {
    const auto stated = value_named<Choice>(in_.choice(facts.path));
    if (!stated) throw std::logic_error(facts.path + " has no choice '" + in_.choice(facts.path) + "'");
    member = *stated;
  }
  // Members of types that no case states.
  template <class Other>
  requires(!std::is_arithmetic_v<Other> && !std::is_enum_v<Other>) void read(Other&, const Facts&) {}

  const ResolvedCase& in_;
};

/// `parameters` with the values of the case.
template <class Struct>
Struct from_case(const ResolvedCase& in, Struct parameters = {}) {
  DescribedCase visit(in);
  describe(visit, parameters);
  return parameters;
}

}  // namespace orbearing::app
