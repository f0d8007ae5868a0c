// Options of commands: one row for each member of a structure of options, next to the structure. The words
// of the command line, its help, requests in JSON and the checks of values all come from these rows.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "mechanics/described.hpp"

namespace orbearing::app {

/// Optional data of an option, besides its name and meaning.
struct OptionDetails {
  std::string type{};                       // of its value in the help: "DIR"; none: by the member
  std::vector<std::string> choices{};       // the permitted values; none: all
  std::optional<described::Range> range{};  // of a number, both ends allowed
  bool required = false;
  std::string needs{};  // another option, without which this one cannot be given
  std::string key{};    // in JSON; none: the name with _ for -, of a word by its place "folders"
  bool hidden = false;  // not in the help: the program gives it to itself
};

/// The member that an option fills: a list has several values, a switch none.
using OptionMember = std::variant<bool*, int*, std::uint64_t*, double*, std::optional<double>*, std::string*,
                                  std::vector<std::string>*>;

/// An option as the command line and requests in JSON see it.
struct Option {
  std::string name;  // "--jobs", "-o,--output"; "CASE": a word by its place
  std::string meaning;
  OptionDetails details;
  OptionMember member;
};
using OptionList = std::vector<Option>;

template <class Member>
Option option(Member& member, std::string name, std::string meaning, OptionDetails details = {}) {
  return {std::move(name), std::move(meaning), std::move(details), &member};
}

inline void visit_row(OptionList& list, const Option& row) {
  list.push_back(row);
}

/// Options of a structure, in the order of its rows.
template <class Struct>
OptionList option_list(Struct& of) {
  OptionList list;
  describe(list, of);
  return list;
}

/// "--output" of "-o,--output".
std::string long_name(const Option& option);
bool is_positional(const Option& option);
inline bool is_switch(const Option& option) {
  return std::holds_alternative<bool*>(option.member);
}
inline bool is_list(const Option& option) {
  return std::holds_alternative<std::vector<std::string>*>(option.member);
}
/// Type and permitted values in the help: "INT:INT in [1 - 4096]".
std::string type_text(const Option& option);

/// Puts a value into the member, or behind those of a list: a text as typed, or a number or switch of JSON.
/// Returns why it is refused; empty: it is not.
std::string put_value(const Option& option, const nlohmann::ordered_json& value);

/// A line that names the option that an unknown one resembles: "\nDid you mean --fidelity?"; else empty.
std::string proposal(const std::string& unknown, const OptionList& options);

}  // namespace orbearing::app
