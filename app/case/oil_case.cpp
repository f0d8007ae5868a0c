#include "app/case/oil_case.hpp"

#include <fmt/format.h>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/case/field_table.hpp"
#include "app/case/mistake.hpp"
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

namespace {

constexpr const char *kGrade = "lubricant.grade", *kIndex = "lubricant.viscosity_index",
                     *kTemperature = "lubricant.temperature", *kDynamic = "lubricant.viscosity",
                     *kKinematic = "lubricant.kinematic_viscosity";

// A field that follows from the grade: its path, its value as it would be written in a case, and why.
struct OilProperty {
  const char* path;
  std::string text;
  std::string reason;
};

double viscosity_40_of(const std::string& grade) {
  constexpr std::size_t prefix = 7;  // "ISO VG "
  return 1e-6 * *read_number(std::string_view(grade).substr(prefix)).value;
}

// `number` gives the value of a field, and null where there is none: that of the density counts for drag.
template <class Number>
double density_that_counts(const Number& number) {
  const double *density = number("lubricant.density"), *drag = number("drag.enabled");
  return density != nullptr && drag != nullptr && *drag != 0.0 ? *density : bearing::OilGrade{}.density;
}

// Throws std::invalid_argument for an oil of which nothing is known.
std::vector<OilProperty> properties_of(const std::string& grade, const bearing::OilGrade& oil,
                                       double temperature) {
  const bearing::Lubricant lubricant = bearing::lubricant_at(oil, temperature);
  const std::string reason = fmt::format("default: a mineral oil {} of viscosity index {:g} at {:g} degC",
                                         grade, oil.viscosity_index, temperature);
  return {
      {kDynamic, fmt::format("{} Pa.s", lubricant.viscosity), reason},
      {"lubricant.pressure_viscosity", fmt::format("{} GPa-1", 1e9 * lubricant.pressure_viscosity), reason},
      {kKinematic, fmt::format("{} mm2/s", 1e6 * bearing::kinematic_viscosity(oil, temperature)), reason}};
}

}  // namespace

double oil_density(const ResolvedCase& in) {
  return density_that_counts(
      [&](const char* path) { return in.has(path) ? &in.value(path).number : nullptr; });
}

bearing::Lubricant graded_lubricant(const ResolvedCase& in) {
  return {.viscosity = in.quantity("lubricant.viscosity"),
          .pressure_viscosity = in.quantity("lubricant.pressure_viscosity")};
}

bearing::OilGrade graded_oil(const ResolvedCase& in) {
  return {viscosity_40_of(in.choice(kGrade)), in.number(kIndex), oil_density(in)};
}

double graded_viscosity_slope(const ResolvedCase& in) {
  return bearing::viscosity_slope(graded_oil(in), in.quantity(kTemperature));
}

void fill_from_grade(CaseData& data, Model model) {
  const auto grade = data.values.find(kGrade);
  const auto number = [&](const char* path) -> const double* {
    const auto found = data.values.find(path);
    return found == data.values.end() ? nullptr : &found->second.value.number;
  };
  const double *index = number(kIndex), *temperature = number(kTemperature);
  if (grade == data.values.end() || index == nullptr || temperature == nullptr) return;
  const std::string name = grade->second.value.given;
  std::vector<OilProperty> properties;
  try {
    properties =
        properties_of(name, {viscosity_40_of(name), *index, density_that_counts(number)}, *temperature);
  } catch (const std::invalid_argument&) {
    return;  // check_grade() says it
  }
  for (const OilProperty& property : properties) {
    const Field* field = find_field(property.path);
    if ((field->models & model) == 0) continue;
    substitute(data, property.path, property.text, property.reason);
  }
}

void check_grade(CheckedCase& in) {
  if (!has_all(in, {kGrade, kIndex})) return;
  try {
    (void)bearing::viscosity_at_100(viscosity_40_of(in.choice(kGrade)), in.number(kIndex));
  } catch (const std::invalid_argument& error) {
    in.add_error_at(kGrade, in.choice(kGrade), error.what());
  }
}

}  // namespace orbearing::app
