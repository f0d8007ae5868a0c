#include "app/options/option.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "app/case/field_table.hpp"
#include "app/case/text_parts.hpp"
#include "app/case/units.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostDigits = 18;  // every type of a count holds them

template <class Member>
struct ValueOf {
  using Type = Member;
};
template <class Member>
struct ValueOf<std::optional<Member>> {
  using Type = Member;
};

template <class Number>
constexpr const char* type_name() {
  return std::is_same_v<Number, int> ? "INT" : std::is_same_v<Number, std::uint64_t> ? "UINT" : "FLOAT";
}

template <class Number>
std::string limit_text(double limit) {
  return std::is_integral_v<Number> ? fmt::format("{:.0f}", limit) : fmt::format("{:g}", limit);
}

template <class Number>
std::string number_type(const Option& option) {
  std::string type = option.details.type.empty() ? type_name<Number>() : option.details.type;
  if (const auto& range = option.details.range)
    type += fmt::format(":{} in [{} - {}]", type_name<Number>(), limit_text<Number>(range->least),
                        limit_text<Number>(range->most));
  return type;
}

std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

template <class Number>
const char* required_number() {
  if (std::is_same_v<Number, std::uint64_t>) return "a whole number from 0, of at most 18 digits";
  return std::is_integral_v<Number> ? "a whole number of at most 18 digits" : "a finite number";
}

// Digits alone: "0x10" is no number of a user.
template <class Whole>
std::optional<Whole> whole_number(std::string_view text) {
  const bool minus = std::is_signed_v<Whole> && text.starts_with('-');
  if (minus || text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || text.size() > kMostDigits || text.find_first_not_of("0123456789") != text.npos)
    return std::nullopt;
  Whole number = 0;
  for (const char digit : text) number = 10 * number + static_cast<Whole>(digit - '0');
  return minus ? -number : number;
}

template <class Number>
auto number_in(const Json& value) {
  if constexpr (std::is_integral_v<Number>) {
    using Whole = std::conditional_t<std::is_signed_v<Number>, std::int64_t, std::uint64_t>;
    return value.is_string() || value.is_number_integer() ? whole_number<Whole>(trimmed(text_of(value)))
                                                          : std::nullopt;
  } else {
    if (value.is_number()) return std::optional(value.get<double>());
    return value.is_string() ? read_number(trimmed(value.get<std::string>())).value : std::nullopt;
  }
}

template <class Member>
std::string put(const Option& option, const Json& value, Member& member) {
  using Number = typename ValueOf<Member>::Type;
  const std::string found = text_of(value);
  if (trimmed(found).empty()) return "found an empty text; required: a number";
  const auto number = number_in<Number>(value);
  if (!number) return fmt::format("found {}; required: {}", quote(found), required_number<Number>());
  const auto& range = option.details.range;
  const auto real = static_cast<double>(*number);
  if (range && !(real >= range->least && real <= range->most))
    return fmt::format("Value {} not in range {} to {}", found, limit_text<Number>(range->least),
                       limit_text<Number>(range->most));
  member = static_cast<Number>(*number);
  return {};
}

// An empty text, as a shell makes it of a variable that is not set, would select a default.
std::string fault_of(const Option& option, const std::string& text) {
  if (trimmed(text).empty()) return "found an empty text; required: a value";
  const std::vector<std::string>& choices = option.details.choices;
  if (choices.empty() || std::ranges::find(choices, text) != choices.end()) return {};
  return fmt::format("{} not in {{{}}}", text, fmt::join(choices, ","));
}

std::string put(const Option& option, const Json& value, std::string& member) {
  const std::string text = text_of(value);
  std::string fault = fault_of(option, text);
  if (fault.empty()) member = text;
  return fault;
}

std::string put(const Option& option, const Json& value, std::vector<std::string>& member) {
  return put(option, value, member.emplace_back());
}

std::string put(const Option&, const Json& value, bool& member) {
  if (!value.is_boolean()) return fmt::format("found {}; required: true or false", quote(text_of(value)));
  member = value.get<bool>();
  return {};
}

}  // namespace

std::string long_name(const Option& option) {
  return option.name.substr(option.name.find(',') + 1);  // from 0 where there is no comma
}

bool is_positional(const Option& option) {
  return !option.name.starts_with('-');
}

std::string type_text(const Option& option) {
  return std::visit(
      [&](const auto* member) -> std::string {
        using Value = typename ValueOf<std::remove_cvref_t<decltype(*member)>>::Type;
        if constexpr (std::is_arithmetic_v<Value>) return number_type<Value>(option);
        const std::string type = option.details.type.empty() ? "TEXT" : option.details.type;
        const std::vector<std::string>& choices = option.details.choices;
        return choices.empty() ? type : fmt::format("{}:{{{}}}", type, fmt::join(choices, ","));
      },
      option.member);
}

std::string put_value(const Option& option, const Json& value) {
  return std::visit([&](auto* member) { return put(option, value, *member); }, option.member);
}

std::string proposal(const std::string& unknown, const OptionList& options) {
  if (!unknown.starts_with("--")) return {};
  std::vector<std::string> known;
  for (const Option& option : options)
    if (!option.details.hidden) known.push_back(long_name(option));
  const std::string near = nearest_word(unknown.substr(0, unknown.find('=')), known);
  return near.empty() ? near : fmt::format("\nDid you mean {}?", near);
}

}  // namespace orbearing::app
