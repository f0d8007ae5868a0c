#include "app/case/resolved_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "mechanics/problem.hpp"

namespace orbearing::app {

const StoredValue& ResolvedCase::stored(std::string_view path) const {
  const auto found = data_->values.find(path);
  if (found == data_->values.end())
    throw std::logic_error(fmt::format("the case has no value for '{}'", path));
  return found->second;
}

const StoredValue& ResolvedCase::stored(std::string_view path, [[maybe_unused]] Kind kind) const {
  assert(find_field(path) != nullptr && find_field(path)->kind == kind);
  return stored(path);
}

double ResolvedCase::quantity(std::string_view path) const {
  return stored(path, Kind::quantity).value.number;
}
double ResolvedCase::number(std::string_view path) const {
  return stored(path, Kind::number).value.number;
}
int ResolvedCase::integer(std::string_view path) const {
  return static_cast<int>(stored(path, Kind::integer).value.number);
}
bool ResolvedCase::flag(std::string_view path) const {
  return stored(path, Kind::flag).value.number != 0.0;
}
const std::string& ResolvedCase::choice(std::string_view path) const {
  return stored(path, Kind::choice).value.given;
}
const std::string& ResolvedCase::text(std::string_view path) const {
  return stored(path, Kind::text).value.given;
}
const std::vector<double>& ResolvedCase::list(std::string_view path) const {
  return stored(path, Kind::list).value.list;
}

const std::vector<std::string>& ResolvedCase::texts(std::string_view path) const {
  return stored(path, Kind::list).value.texts;
}

bool ResolvedCase::has(std::string_view path) const {
  return data_->values.find(path) != data_->values.end();
}
const std::string& ResolvedCase::given(std::string_view path) const {
  return stored(path).value.given;
}
Location ResolvedCase::location(std::string_view path) const {
  return stored(path).location;
}

Location ResolvedCase::item_location(std::string_view path, std::size_t item) const {
  const StoredValue& value = stored(path);
  return item < value.item_locations.size() ? value.item_locations[item] : value.location;
}

const std::string& ResolvedCase::written(std::string_view path) const {
  const StoredValue& value = stored(path);
  return value.replaced.empty() ? value.value.given : value.replaced;
}

std::string ResolvedCase::origin(std::string_view path) const {
  const StoredValue& value = stored(path);
  if (value.from_default) return "default";
  if (value.location.option) return "--set";
  return fmt::format("{}:{}:{}", data_->file, value.location.line, value.location.column);
}

Model ResolvedCase::model() const {
  if (!has("model")) return no_model;
  return specific_model(model_of(choice("model")), has("simulation.duration"), has(keys().rollers));
}

ResolvedCase ResolvedCase::assuming(const std::string& path, const std::string& reason) const {
  CaseData data = *data_;
  data.assumed[path] = reason;
  return ResolvedCase(std::move(data));
}

ResolvedCase ResolvedCase::without_sweep() const {
  if (axes().empty()) return *this;
  CaseData data = *data_;
  data.axes = CaseData{}.axes;
  ResolvedCase point(std::move(data));
  point.made_ = made_;  // nothing is made of the sweep
  return point;
}

bool ResolvedCase::operator==(const ResolvedCase& other) const {
  if (data_->values.size() != other.data_->values.size()) return false;
  for (const auto& [path, stored] : data_->values)
    if (!other.has(path) || !(other.stored(path).value == stored.value)) return false;
  return data_->shape == other.data_->shape && data_->assumed == other.data_->assumed &&
         axes() == other.axes() && uncertain() == other.uncertain();
}

bool is_stated(const ResolvedCase& resolved, std::string_view path) {
  return resolved.has(path) && resolved.origin(path) != "default";
}

bool has_all(const ResolvedCase& in, std::initializer_list<std::string_view> paths) {
  return std::ranges::all_of(paths, [&](std::string_view path) { return in.has(path); });
}

bool is_nonzero(const ResolvedCase& in, std::string_view path) {
  return in.has(path) && in.quantity(path) != 0.0;
}

bool is_on(const ResolvedCase& in, std::string_view path) {
  return in.has(path) && in.flag(path);
}

bool is_chosen(const ResolvedCase& in, std::string_view path, std::string_view choice) {
  return in.has(path) && in.choice(path) == choice;
}

namespace {

Location location_for(const ResolvedCase& in, const std::string& path) {
  if (in.has(path)) return in.location(path);
  for (const std::string& block : {path + ".", path.substr(0, path.rfind('.') + 1)})
    for (const Input& input : in.inputs())
      if (!block.empty() && input.path.starts_with(block) && is_stated(in, input.path))
        return in.location(input.path);
  return in.has("model") ? in.location("model") : Location{};
}

}  // namespace

void CheckedCase::add_error(const std::string& path, const std::string& text) {
  const auto written = [&](const std::string& key) { return given(key); };
  const auto [found, required] = mechanics::found_and_required(text);
  add_error_at(path, mechanics::with_inputs(found, written), mechanics::with_inputs(required, written));
}

void CheckedCase::add_error_at(const std::string& path, std::string found, std::string required) {
  mistakes.push_back({location_for(*this, path), path, {std::move(found), std::move(required)}});
}

std::vector<double> swept_speeds(const ResolvedCase& resolved) {
  for (const SweepAxis& axis : resolved.axes())
    if (axis.path == keys().speed) return axis.numbers;
  return {resolved.quantity(keys().speed)};
}

std::size_t sweep_size(const ResolvedCase& resolved) {
  std::size_t size = 1;
  for (const SweepAxis& axis : resolved.axes()) size *= axis.values.size();
  return size;
}

Setting input_speed(double rpm) {
  return {keys().speed, fmt::format("{} rpm", rpm),
          convert(rpm, "rpm", find_field(keys().speed)->dimension.si).value};
}

std::vector<Setting> sweep_point(const ResolvedCase& resolved, std::size_t index) {
  assert(index < sweep_size(resolved));
  std::vector<Setting> settings;
  std::size_t block = sweep_size(resolved);
  for (const SweepAxis& axis : resolved.axes()) {
    block /= axis.values.size();
    settings.push_back(axis.setting(index / block));
    index %= block;
  }
  return settings;
}

}  // namespace orbearing::app
