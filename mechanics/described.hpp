// Descriptions of parameters: one row for each member of a structure of parameters, next to the structure.
// Case files, their schema, the list of assumptions and the variables of FMUs all come from these rows.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>

namespace orbearing::described {

/// A physical quantity: its coherent SI unit, the customary unit in files, and an example for messages.
struct Dimension {
  std::string_view name;       // "length"
  std::string_view si;         // "m"        unit of every number inside the program
  std::string_view customary;  // "mm"       unit of ranges and messages
  std::string_view example;    // "3 mm"
  double factor = 1.0;         // [si / customary]
};

namespace dimension {
inline constexpr double kRadian = 0.017453292519943295;  // [rad / deg]
inline constexpr double kTurn = 0.10471975511965977;     // [rad/s / rpm]
inline constexpr Dimension length{"length", "m", "mm", "3 mm", 1e-3};
inline constexpr Dimension small_length{"length", "m", "um", "37 um", 1e-6};
inline constexpr Dimension angle{"angle", "rad", "deg", "20 deg", kRadian};
inline constexpr Dimension angular_speed{"angular speed", "rad/s", "rpm", "6000 rpm", kTurn};
inline constexpr Dimension spin{"angular speed", "rad/s", "rad/s", "200 rad/s"};
inline constexpr Dimension angular_acceleration{"angular acceleration", "rad/s2", "rpm/s", "5000 rpm/s",
                                                kTurn};
inline constexpr Dimension power{"power", "W", "kW", "150 kW", 1e3};
inline constexpr Dimension force{"force", "N", "N", "4450 N"};
inline constexpr Dimension torque{"torque", "N.m", "N.m", "240 N.m"};
inline constexpr Dimension mass{"mass", "kg", "kg", "2 kg"};
inline constexpr Dimension inertia{"moment of inertia", "kg.m2", "kg.m2", "1e-4 kg.m2"};
inline constexpr Dimension time{"time", "s", "s", "0.5 s"};
inline constexpr Dimension density{"density", "kg/m3", "kg/m3", "7850 kg/m3"};
inline constexpr Dimension stress{"stress", "Pa", "GPa", "206 GPa", 1e9};
inline constexpr Dimension viscosity{"dynamic viscosity", "Pa.s", "Pa.s", "0.01 Pa.s"};
inline constexpr Dimension kinematic_viscosity{"kinematic viscosity", "m2/s", "mm2/s", "20 mm2/s", 1e-6};
inline constexpr Dimension pressure_viscosity{"pressure-viscosity coefficient", "Pa-1", "GPa-1", "15 GPa-1",
                                              1e-9};
inline constexpr Dimension stiffness{"stiffness", "N/m", "N/m", "1e8 N/m"};
inline constexpr Dimension rotating_stiffness{"stiffness against rotation", "N.m/rad", "N.m/rad",
                                              "1e6 N.m/rad"};
inline constexpr Dimension speed{"speed", "m/s", "m/s", "0.1 m/s"};
inline constexpr Dimension inverse_speed{"inverse speed", "s/m", "s/m", "0.1 s/m"};
inline constexpr Dimension damping{"damping", "N.s/m", "N.s/m", "200 N.s/m"};
// Temperatures are counted in degrees Celsius all through.
inline constexpr Dimension temperature{"temperature", "degC", "degC", "70 degC"};
inline constexpr Dimension conductance{"thermal conductance", "W/K", "W/K", "3 W/K"};
inline constexpr Dimension per_kelvin{"share per temperature difference", "K-1", "K-1", "0.03 K-1"};
inline constexpr Dimension flow{"volume flow", "m3/s", "L/min", "0.5 L/min", 1e-3 / 60.0};
inline constexpr Dimension frequency{"frequency", "Hz", "kHz", "51.2 kHz", 1e3};
}  // namespace dimension

/// Interval of allowed values, in the customary unit of the dimension.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool least_allowed = true;  // false: greater than `least`
  bool most_allowed = true;   // false: less than `most`
};

/// Greater than 0.
constexpr Range positive(double most = std::numeric_limits<double>::infinity()) {
  return {.least = 0.0, .most = most, .least_allowed = false};
}

/// A parameter counts only where that of `path` is `value`, or one of several with | between; without a
/// value, where it is given and not zero. Several paths, with | between: one must meet it.
struct Where {
  std::string_view path{};
  std::string_view value{};
};

/// Optional data of a row, besides the parameter's name and meaning. Texts are literals.
struct Details {
  Dimension dimension{};  // none: a plain number
  Range range{};
  std::string_view reason{};   // why the member's initial value is the default of a case; none: it is not
  std::string_view written{};  // unit in which the default is written; none: the customary one
  Where where{};
  /// A case may leave the parameter out though it has no default: it follows from others, or is not needed.
  bool may_be_absent = false;
  bool required_without_teeth = false;   // where masses and stiffnesses take the place of a set's teeth
  bool default_without_bearing = false;  // the default counts only where a set has no bearing
  /// Setting of the numerical method, not of the machine: no printed digit depends on it, or its error is
  /// printed with the result (tests/interface/numerical_settings.py).
  bool numerical = false;
};

/// All that is known of a member besides its type and initial value.
struct Facts {
  std::string path;
  std::string meaning{};
  Details details{};
  bool internal = false;  // no case states it
};

/// One value of an enumeration as a case writes it. Next to each enumeration that a case can choose from is
/// `names_of(E)`, which returns a `Names`.
template <class E>
struct Name {
  E value;
  std::string_view text;
};
template <class E, std::size_t n>
using Names = std::array<Name<E>, n>;

/// Name by which a case writes a value of an enumeration.
template <class E>
constexpr std::string_view text_of(E value) {
  for (const auto& name : names_of(value))
    if (name.value == value) return name.text;
  return {};
}

template <class Member>
struct Row {
  Member& member;
  Facts facts;
};
template <class Part>
struct PartRow {
  Part& part;
};
template <class Part>
struct BlockRow {
  Part& part;
  std::string key;
};
template <class Variant>
struct ChoiceRow {
  Variant& member;
  Facts facts;
};
template <class Variant>
struct EitherRow {
  Variant& member;
};
template <class Call>
struct CallRow {
  Call describe;
};
template <class Member>
struct ApartRow {
  Member& member;
};
template <class... Rows>
struct RowsOfOne {
  std::tuple<Rows...> rows;
};

/// A member that no case states, but that travels with an FMU's model under this name.
template <class Member>
Row<Member> internal(Member& member, std::string path, std::string meaning = {},
                     const Details& details = {}) {
  return {member, {std::move(path), std::move(meaning), details, true}};
}
/// An input of a machine, by its key in the case or in the block of the structure. Without a reason for its
/// default it is required, unless the member is optional or the row says that it may be absent.
template <class Member>
Row<Member> input(Member& member, std::string key, std::string meaning, const Details& details = {}) {
  return {member, {std::move(key), std::move(meaning), details}};
}
/// A structure with rows of its own.
template <class Part>
PartRow<Part> part(Part& member) {
  return {member};
}
/// The same for rows in a block of the case.
template <class Part>
BlockRow<Part> block(Part& member, std::string key) {
  return {member, std::move(key)};
}
/// One of several structures, each with a `name` by which the input `key` chooses it. The inputs of the
/// others cannot be stated. The alternative that the member holds is the default, for `details.reason`.
template <class... Choices>
ChoiceRow<std::variant<Choices...>> choice(std::variant<Choices...>& member, std::string key,
                                           std::string meaning, const Details& details = {}) {
  return {member, {std::move(key), std::move(meaning), details}};
}
/// One of several structures: the one whose inputs the case states.
template <class... Choices>
EitherRow<std::variant<Choices...>> either(std::variant<Choices...>& member) {
  return {member};
}
/// A structure whose rows `describe()` gives, since they depend on where it is.
template <class Part, class Call>
CallRow<Call> part(Part&, Call describe) {
  return {describe};
}
/// Several rows for one member.
template <class... Rows>
RowsOfOne<Rows...> together(const Rows&... rows) {
  return {{rows...}};
}
/// A member that is no parameter of a case or FMU. Visitors with a function `apart` see it.
template <class Member>
ApartRow<Member> apart(Member& member) {
  return {member};
}

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// Stands for a member of any type; an optional one makes itself of its value.
struct AnyMember {
  template <class T>
  requires(!is_optional<T>) operator T() const;
};

/// Number of members of an aggregate.
template <class T, class... Any>
constexpr std::size_t member_count() {
  if constexpr (requires { T{Any{}..., AnyMember{}}; })
    return member_count<T, Any..., AnyMember>();
  else
    return sizeof...(Any);
}

template <class Visitor, class Member>
void visit_row(Visitor& visit, const Row<Member>& row) {
  visit(row.member, row.facts);
}
template <class Visitor, class Part>
void visit_row(Visitor& visit, const PartRow<Part>& row) {
  describe(visit, row.part);
}
/// A visitor of the rows of a block, whose paths begin with its key.
template <class Visitor>
class Within {
 public:
  Within(Visitor& visit, std::string key) : visit_(visit), key_(std::move(key)) {}

  template <class Member>
  void operator()(Member& member, Facts facts) {
    facts.path = key_ + "." + facts.path;
    visit_(member, facts);
  }
  template <class Self, class Variant>
  void choose(Self& self, Variant& member, Facts facts) {
    facts.path = key_ + "." + facts.path;
    visit_.choose(self, member, facts);
  }
  template <class Self, class Variant>
  void choose_by_inputs(Self& self, Variant& member) {
    visit_.choose_by_inputs(self, member);
  }
  template <class Member>
  void apart(Member& member) {
    visit_row(visit_, ApartRow<Member>{member});
  }

 private:
  Visitor& visit_;
  std::string key_;
};
template <class Visitor, class Part>
void visit_row(Visitor& visit, const BlockRow<Part>& row) {
  Within<Visitor> inside(visit, row.key);
  describe(inside, row.part);
}
// How alternatives are distinguished is up to the visitor: `self` is the one that describes them.
template <class Visitor, class Variant>
void visit_row(Visitor& visit, const ChoiceRow<Variant>& row) {
  visit.choose(visit, row.member, row.facts);
}
template <class Visitor, class Variant>
void visit_row(Visitor& visit, const EitherRow<Variant>& row) {
  visit.choose_by_inputs(visit, row.member);
}
template <class Visitor, class Call>
void visit_row(Visitor&, const CallRow<Call>& row) {
  row.describe();
}
template <class Visitor, class Member>
void visit_row(Visitor& visit, const ApartRow<Member>& row) {
  if constexpr (requires { visit.apart(row.member); }) visit.apart(row.member);
}
template <class Visitor, class... Rows>
void visit_row(Visitor& visit, const RowsOfOne<Rows...>& all) {
  std::apply([&](const Rows&... row) { (visit_row(visit, row), ...); }, all.rows);
}

/// Calls `visit(member, facts)` for rows in turn.
template <class Visitor, class... Rows>
void rows(Visitor& visit, const Rows&... all) {
  (visit_row(visit, all), ...);
}

/// The same for all rows of a structure: one for each of its members.
template <class Visitor, class Struct, class... Rows>
void members(Visitor& visit, const Struct&, const Rows&... all) {
  static_assert(sizeof...(Rows) == member_count<Struct>(), "each member of a structure has one row");
  rows(visit, all...);
}

}  // namespace orbearing::described
