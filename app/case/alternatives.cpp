#include "app/case/alternatives.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/field_table.hpp"
#include "app/case/machine_fields.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

std::string value_of(const CaseData& data, const std::string& path) {
  const auto value = data.values.find(path);
  return value == data.values.end() ? find_field(path)->default_text : value->second.value.given;
}

bool states(const CaseData& data, const std::string& path) {
  const auto value = data.values.find(path);
  return value != data.values.end() && !value->second.from_default;
}

// The first of the alternatives of which the case states an input; the first of all where it states none.
std::size_t chosen_by_inputs(const CaseData& data, unsigned models, const std::string& by) {
  for (const Field& field : all_fields())
    if ((field.models & models) != 0 && states(data, field.path))
      for (const Field::Alternative& one : field.alternatives)
        if (one.by == by) return one.number;
  return 0;
}

bool is_chosen(const CaseData& data, const Field& field, const Field::Alternative& one) {
  return one.value.empty() ? chosen_by_inputs(data, field.models, one.by) == one.number
                           : value_of(data, one.by) == one.value;
}

}  // namespace

std::string inputs_of_others(const Field& field, const Field::Alternative& mine) {
  std::string text;
  for (const Field& other : all_fields())
    for (const Field::Alternative& one : other.alternatives)
      if ((other.models & field.models) != 0 && one.by == mine.by && one.number != mine.number)
        text += (text.empty() ? "" : " or ") + other.path;
  return text;
}

namespace {

void refuse(const CaseData& data, const Field& field, std::vector<Mistake>& mistakes) {
  const auto one = std::ranges::find_if(field.alternatives, [&](const Field::Alternative& alternative) {
    return !is_chosen(data, field, alternative);
  });
  const StoredValue& value = data.values.at(field.path);
  const auto message = [&]() -> ConsistencyMessage {
    if (one->value.empty())
      return {fmt::format("{} together with {}", quote(value.value.given), inputs_of_others(field, *one)),
              "one of both is required"};
    return {
        fmt::format("an input of {}: {}, and here it is {}", one->by, one->value, value_of(data, one->by)),
        fmt::format("a case without it, or {}: {}, is required", one->by, one->value)};
  };
  mistakes.push_back({value.location, field.path, message()});
}

}  // namespace

bool is_chosen(const CaseData& data, const Field& field) {
  return std::ranges::all_of(field.alternatives,
                             [&](const Field::Alternative& one) { return is_chosen(data, field, one); });
}

void settle_alternatives(CaseData& data, Model model, std::vector<Mistake>& mistakes) {
  for (const Field& field : fields_of_machine(model)) {
    if (field.alternatives.empty()) continue;
    const auto value = data.values.find(field.path);
    const bool there = value != data.values.end();
    if (is_chosen(data, field)) {
      if (there || field.default_text.empty()) continue;
      data.values[field.path] = {read_field_text(field, field.default_text).value, {}, true};
      data.assumed[field.path] = "default: " + field.default_reason;
    } else if (there && value->second.from_default) {
      data.assumed.erase(field.path);
      data.values.erase(value);
    } else if (there) {
      refuse(data, field, mistakes);
    }
  }
}

}  // namespace orbearing::app
