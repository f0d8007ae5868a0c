#include "app/options/option_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/errors.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

std::string key_of(const Option& option) {
  if (!option.details.key.empty()) return option.details.key;
  if (is_positional(option)) return "folders";
  std::string key = long_name(option).substr(2);
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

template <class Member>
Json json_value(const Member& member) {
  return member;
}
Json json_value(const std::optional<double>& member) {
  return member ? Json(*member) : Json();
}

std::string word_of(std::string key, const Json& value) {
  std::replace(key.begin(), key.end(), '_', '-');
  return fmt::format("--{}={}", key, value.is_string() ? value.get<std::string>() : value.dump());
}

std::vector<Json> values_of(const Json& value) {
  std::vector<Json> values = value.is_array() ? value.get<std::vector<Json>>() : std::vector{value};
  std::erase_if(values, [](const Json& one) { return one.is_null() || one == false; });
  return values;
}

void put_values(const Option& option, const std::vector<Json>& values, std::vector<std::string>& mistakes) {
  if (values.size() > 1 && !is_list(option)) {
    mistakes.push_back(fmt::format("{}: found {} values; required: one", long_name(option), values.size()));
    return;
  }
  for (const Json& value : values)
    if (const std::string fault = put_value(option, value); !fault.empty())
      mistakes.push_back(long_name(option) + ": " + fault);
}

void add_missing(const OptionList& options, const std::set<std::string>& given,
                 std::vector<std::string>& mistakes) {
  for (const Option& option : options) {
    const std::string name = long_name(option);
    if (option.details.required && !given.contains(name)) mistakes.push_back(name + " is required");
    if (!option.details.needs.empty() && given.contains(name) && !given.contains(option.details.needs))
      mistakes.push_back(name + " requires " + option.details.needs);
  }
}

}  // namespace

void put_json(const Json& object, const OptionList& options, std::set<std::string> given) {
  std::vector<std::string> mistakes;
  for (const auto& [key, value] : object.items()) {
    const std::vector<Json> values = values_of(value);
    const auto known =
        std::ranges::find_if(options, [&key = key](const Option& option) { return key_of(option) == key; });
    if (values.empty()) continue;
    if (known == options.end()) {
      const std::string word = word_of(key, values.front());
      mistakes.push_back("The following argument was not expected: " + word + proposal(word, options));
      continue;
    }
    put_values(*known, values, mistakes);
    given.insert(long_name(*known));
  }
  add_missing(options, given, mistakes);
  if (!mistakes.empty()) throw BadInput(mistakes);
}

Json json_of(const OptionList& options) {
  Json object = Json::object();
  for (const Option& option : options)
    object[key_of(option)] =
        std::visit([](const auto* member) { return json_value(*member); }, option.member);
  return object;
}

}  // namespace orbearing::app
