// Copies of a case with other values: what is derived is derived anew, what must fit is checked again.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>

#include "app/case/alternatives.hpp"
#include "app/case/catalogue_fields.hpp"
#include "app/case/catalogue_file.hpp"
#include "app/case/consistency.hpp"
#include "app/case/derived_defaults.hpp"
#include "app/case/field_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/case/settings.hpp"
#include "app/case/spectrum_case.hpp"
#include "app/case/sweep_axes.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing::app {

namespace {

// The field at a path that may be set; else null, and why.
const Field* settable_field(const CaseData& data, unsigned model, const std::string& path, Location location,
                            std::vector<Mistake>& mistakes) {
  const Field* field = find_field(path);
  if (field != nullptr && (field->models & model) != 0 && path != "model" && belongs(data.shape, path))
    return field;
  mistakes.push_back(
      {location, path, {"a path that cannot be set here", "the path of a value of this case is required"}});
  return nullptr;
}

void put(CaseData& data, const std::string& path, FieldReading reading, Location location,
         std::vector<Mistake>& mistakes) {
  if (!reading.good) {
    mistakes.push_back({location, path, reading.message});
    return;
  }
  if (path.ends_with(catalogue_keys::kCatalogue) &&
      !take_catalogue(reading.value, location, path, data.file, mistakes))
    return;
  data.values[path] = {std::move(reading.value), location, false};
  data.assumed.erase(path);
  replace_other_duty(data, path);
}

// "gearset.pin_errors[2]" as path and element; nothing where it has no such end.
std::optional<std::pair<std::string, std::size_t>> element_of(const std::string& path) {
  const std::size_t bracket = path.find('[');
  if (bracket == std::string::npos || !path.ends_with(']')) return std::nullopt;
  std::size_t element = 0;
  const char* const last = path.data() + path.size() - 1;
  const auto [end, error] = std::from_chars(path.data() + bracket + 1, last, element);
  if (end != last || error != std::errc{}) return std::nullopt;
  return std::pair{path.substr(0, bracket), element};
}

// One number of a list, which is checked anew as a whole.
void replace_element(CaseData& data, const Field& field, const std::string& path, std::size_t element,
                     double value, Location location, std::vector<Mistake>& mistakes) {
  const auto stored = data.values.find(path);
  const std::size_t count = stored == data.values.end() ? 0 : stored->second.value.list.size();
  if (field.kind != Kind::list || !field.columns.empty() || element >= count) {
    mistakes.push_back(
        {location,
         path,
         {fmt::format("element {} of {}", element, count),
          "an element of a list of numbers that the case states, counted from 0, is required"}});
    return;
  }
  std::vector<double> list = stored->second.value.list;
  list[element] = value;
  Entry entry = make_entry(Entry::Shape::list, location);
  for (const double one : list)
    entry.items.push_back(make_scalar(fmt::format("{} {}", one, field.dimension.si)));
  put(data, path, read_field(field, entry), location, mistakes);
}

void replace(CaseData& data, unsigned model, const Setting& setting, Location location,
             std::vector<Mistake>& mistakes) {
  const auto element = setting.number ? element_of(setting.path) : std::nullopt;
  const std::string& path = element ? element->first : setting.path;
  const Field* field = settable_field(data, model, path, location, mistakes);
  if (field == nullptr) return;
  if (element)
    replace_element(data, *field, path, element->second, *setting.number, location, mistakes);
  else if (!setting.number)
    put(data, path, read_field_text(*field, setting.text), location, mistakes);
  else if (is_numeric(*field))
    put(data, path, read_field_number(*field, *setting.number, setting.text), location, mistakes);
  else
    mistakes.push_back({location, path, {"a number", requirement(*field) + " is required"}});
}

}  // namespace

ResolvedCase ResolvedCase::with(const std::vector<Setting>& settings) const {
  std::vector<Mistake> mistakes;
  ResolvedCase result = with(settings, mistakes);
  if (!mistakes.empty()) throw_mistakes(result.file(), std::move(mistakes));
  return result;
}

ResolvedCase ResolvedCase::with(const std::vector<Setting>& settings, std::vector<Mistake>& mistakes) const {
  throw_if_stopped();  // a sweep may have tens of thousands of points
  if (settings.empty()) return *this;
  CaseData data = *data_;
  int number = 0;
  for (const Setting& setting : settings) replace(data, model(), setting, {true, ++number, 1}, mistakes);
  settle_alternatives(data, model(), mistakes);
  fill_derived_defaults(data);
  ResolvedCase result(std::move(data));
  check_consistency(result, mistakes);
  return result;
}

ResolvedCase ResolvedCase::with(const std::string& path, const std::string& text) const {
  return with(std::vector<Setting>{{path, text}});
}

ResolvedCase ResolvedCase::with(const std::string& path, double number) const {
  return with(std::vector<Setting>{{path, "", number}});
}

ResolvedCase ResolvedCase::sweeping(const std::string& path, const std::vector<double>& numbers) const {
  const Location location{true, 1, 1};
  const Field* field = find_field(path);
  const std::string unit = field == nullptr ? "" : std::string(field->dimension.si);
  Entry list = make_entry(Entry::Shape::list, location), sweep = make_entry(Entry::Shape::block, location);
  for (const double number : numbers)
    list.items.push_back(make_scalar(fmt::format("{} {}", number, unit), false, location));
  sweep.members.push_back({path, location, std::move(list)});
  std::vector<Mistake> mistakes;
  CaseData data = *data_;
  data.axes = std::make_shared<const std::vector<SweepAxis>>(read_axes(sweep, model(), shape(), mistakes));
  const ResolvedCase result(std::move(data));
  check_sweep_consistency(result, mistakes);
  if (!mistakes.empty()) throw_mistakes(file(), std::move(mistakes));
  return result;
}

ResolvedCase ResolvedCase::of_set(std::string_view set) const {
  const std::string prefix = set_prefix(set);
  CaseData data{.file = data_->file, .shape = {.defect = false}};
  const auto take = [&](const auto& from, auto& into) {
    for (const auto& [path, value] : from)
      if (path.starts_with(prefix))
        into.emplace(path.substr(prefix.size()), value);
      else if (!path.starts_with("sets.") && !path.starts_with("shafts."))
        into.emplace(path, value);
  };
  take(data_->values, data.values);
  take(data_->assumed, data.assumed);
  fill_derived_defaults(data);
  return ResolvedCase(std::move(data));
}

}  // namespace orbearing::app
