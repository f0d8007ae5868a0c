#include "app/case/key_hints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/case/field_table.hpp"

namespace orbearing::app {

std::vector<std::string> keys_under(const std::string& prefix, const CaseShape& shape) {
  std::vector<std::string> names;
  const std::size_t of_set = set_prefix_length(prefix);
  const std::string inner = prefix.substr(of_set);
  for (const Field& field : all_fields()) {
    const bool fits = of_set > 0 ? in_each_set(field) : belongs(shape, field.path);
    if (!fits || !field.path.starts_with(inner)) continue;
    const std::string rest = field.path.substr(inner.size());
    std::string name = rest.substr(0, rest.find('.'));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  if (prefix.empty() && shape.several) names.insert(names.end(), {"sets", "shafts"});
  if (prefix.empty()) names.insert(names.end(), {"sweep", "uncertain", "assumed"});
  return names;
}

std::string key_hint(const std::string& key, const std::string& prefix, const CaseShape& shape) {
  const std::string set = prefix.substr(0, set_prefix_length(prefix));
  if (!set.empty() && key == "fixed")
    return "a member stands by being on a shaft with 'ground'; a known key is required";
  // The right name in the wrong block is likelier than a slip of the keyboard.
  for (const Field& field : all_fields()) {
    if (!set.empty() && !in_each_set(field)) continue;
    if (field.path == key || field.path.ends_with("." + key))
      return fmt::format("a known key is required; '{}{}' nested by its blocks is one",
                         belongs(shape, field.path) ? "" : set, field.path);
  }
  const std::vector<std::string> siblings = keys_under(prefix, shape);
  const std::string near = nearest_word(key, siblings);
  if (!near.empty()) return fmt::format("a known key is required; did you mean '{}{}'?", prefix, near);
  return fmt::format("one of {} is required", fmt::join(siblings, ", "));
}

}  // namespace orbearing::app
