// Copies of a case with other values: what is derived is derived anew, what must fit is checked again.
#include "app/case/consistency.hpp"
#include "app/case/derived_defaults.hpp"
#include "app/case/field_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/case/settings.hpp"

namespace orbearing::app {

namespace {

void replace(CaseData& data, unsigned model, const Setting& setting, Place place,
             std::vector<Mistake>& mistakes) {
  const auto& [path, text] = setting;
  const Field* field = find_field(path);
  if (field == nullptr || (field->models & model) == 0 || path == "model" || !belongs(data.shape, path)) {
    mistakes.push_back(
        {place, path, {"a path that cannot be set here", "the path of a value of this case is required"}});
    return;
  }
  FieldReading reading = read_field_text(*field, text);
  if (!reading.good) {
    mistakes.push_back({place, path, reading.complaint});
    return;
  }
  data.values[path] = {std::move(reading.value), place, false};
  data.assumed.erase(path);
}

}  // namespace

ResolvedCase ResolvedCase::with(const std::vector<Setting>& settings) const {
  std::vector<Mistake> mistakes;
  ResolvedCase changed = with(settings, mistakes);
  if (!mistakes.empty()) throw_mistakes(changed.file(), std::move(mistakes));
  return changed;
}

ResolvedCase ResolvedCase::with(const std::vector<Setting>& settings, std::vector<Mistake>& mistakes) const {
  CaseData data = data_;
  int number = 0;
  for (const Setting& setting : settings) replace(data, model(), setting, {true, ++number, 1}, mistakes);
  fill_derived_defaults(data);
  ResolvedCase changed(std::move(data));
  check_consistency(changed, mistakes);
  return changed;
}

ResolvedCase ResolvedCase::with(const std::string& path, const std::string& text) const {
  return with(std::vector<Setting>{{path, text}});
}

ResolvedCase ResolvedCase::of_set(std::string_view set) const {
  const std::string prefix = set_prefix(set);
  CaseData data{.file = data_.file, .shape = {.defect = false}};
  const auto take = [&](const auto& from, auto& into) {
    for (const auto& [path, value] : from)
      if (path.starts_with(prefix))
        into.emplace(path.substr(prefix.size()), value);
      else if (!path.starts_with("sets.") && !path.starts_with("shafts."))
        into.emplace(path, value);
  };
  take(data_.values, data.values);
  take(data_.assumed, data.assumed);
  fill_derived_defaults(data);
  return ResolvedCase(std::move(data));
}

}  // namespace orbearing::app
