#include "app/case/substitute.hpp"

#include <cmath>
#include <utility>

#include "app/case/field_table.hpp"
#include "app/case/settings.hpp"

namespace orbearing::app {

namespace {

bool same(const Field& field, const FieldValue& a, const FieldValue& b) {
  constexpr double digits = 1e-5;  // a resolved case holds six
  if (!is_numeric(field)) return a.given == b.given;
  return std::abs(a.number - b.number) <= digits * std::abs(a.number);
}

}  // namespace

void substitute(CaseData& data, const std::string& path, const std::string& text, const std::string& reason) {
  const Field& field = *find_field(path);
  FieldReading reading = read_field_text(field, text);
  if (!reading.good) return;
  StoredValue& stored = data.values[path];
  const bool stated = !stored.value.given.empty() && !stored.from_default;
  if (!stored.replaced.empty()) {
    stored.value = std::move(reading.value);
  } else if (stated && !same(field, reading.value, stored.value)) {
    stored.replaced = stored.value.given;
    stored.value = std::move(reading.value);
  } else {
    stored = {std::move(reading.value), {}, true};
  }
  data.assumed[path] = reason;
}

void put_where_absent(CaseData& data, const std::string& path, const std::string& text,
                      const std::string& reason) {
  const auto stored = data.values.find(path);
  if (stored == data.values.end() || stored->second.from_default) substitute(data, path, text, reason);
}

}  // namespace orbearing::app
