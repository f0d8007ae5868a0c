#include "app/case/described_fields.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>

namespace orbearing::app {

Field field_of(const described::Facts& facts, unsigned models) {
  const described::Details& details = facts.details;
  return {.path = facts.path,
          .meaning = facts.meaning,
          .use = use_of(facts, models),
          .models = models,
          .required_by = details.required_without_teeth ? toothless_set : 0u,
          .dimension = details.dimension,
          .range = details.range,
          .default_reason = std::string(details.reason),
          .default_without_bearing = details.default_without_bearing,
          .numerical = details.numerical};
}

void DescribedFields::add(Field field) {
  const auto same = std::find_if(fields_.begin(), fields_.end(),
                                 [&](const Field& other) { return other.path == field.path; });
  if (same == fields_.end()) {
    fields_.push_back(std::move(field));
    return;
  }
  same->models |= field.models;
  same->required_by |= field.required_by;
  const bool states_none = field.default_text.empty();  // the other row has the default
  if (!states_none && same->default_text != field.default_text)
    throw std::logic_error(
        fmt::format("two structures share \"{}\" with defaults of their own: \"{}\" and \"{}\"", field.path,
                    same->default_text, field.default_text));
}

std::string default_text(double value, const described::Details& details) {
  const Dimension& dimension = details.dimension;
  const std::string_view unit = details.written.empty() ? dimension.customary : details.written;
  const Reading<double> converted =
      unit.empty() ? Reading<double>{value, {}} : convert(value, dimension.si, unit);
  assert(converted.value);
  std::string text =
      fmt::format("{:.15g}", *converted.value);  // the bits that conversion may touch are left out
  if (const std::size_t exponent = text.find("e-0"); exponent != std::string::npos)
    text.erase(exponent + 2, 1);
  if (const std::size_t digits = text.find_last_not_of('0') + 1; text.size() >= digits + 5)
    text = fmt::format("{}e{}", text.substr(0, digits), text.size() - digits);  // of 100000 and beyond
  const bool whole = text.find_first_of(".e") == std::string::npos;
  if (unit.empty() && whole) text += ".0";
  return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

}  // namespace orbearing::app
