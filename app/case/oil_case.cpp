#include "app/case/oil_case.hpp"

#include <fmt/format.h>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
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

constexpr const char *kIndex = "lubricant.viscosity_index", *kAt40 = "lubricant.viscosity_40",
                     *kAt100 = "lubricant.viscosity_100";

// A field that follows from the grade: its path, its value as it would be written in a case, and why.
struct OilProperty {
  std::string path;
  std::string text;
  std::string reason;
};

double viscosity_40_of(const std::string& grade) {
  constexpr std::size_t prefix = 7;  // "ISO VG "
  return 1e-6 * *read_number(std::string_view(grade).substr(prefix)).value;
}

// `number` gives the value of a field, and null where there is none: that of the density is used for drag.
template <class Number>
double density_that_counts(const Number& number) {
  const double *density = number(keys().oil_density), *drag = number(keys().drag);
  return density != nullptr && drag != nullptr && *drag != 0.0 ? *density : bearing::OilGrade{}.density;
}

// By the inputs that state it, of which `number` gives the value, and null where there is none.
template <class Number>
bearing::OilGrade oil_by_inputs(const std::string& grade, const Number& number) {
  bearing::OilGrade oil{.density = density_that_counts(number)};
  if (const double* index = number(kIndex)) oil.viscosity_index = *index;
  const double *at_40 = number(kAt40), *at_100 = number(kAt100);
  oil.viscosity_40 = grade == kStatedGrade && at_40 != nullptr ? *at_40 : viscosity_40_of(grade);
  if (grade == kStatedGrade && at_100 != nullptr) oil.viscosity_100 = *at_100;
  return oil;
}

std::string words_for(const std::string& grade, const bearing::OilGrade& oil) {
  const std::string name =
      grade == kStatedGrade ? fmt::format("of {:g} mm2/s at 40 degC", 1e6 * oil.viscosity_40) : grade;
  return oil.viscosity_100
             ? fmt::format("an oil {}, {:g} mm2/s at 100 degC", name, 1e6 * *oil.viscosity_100)
             : fmt::format("a mineral oil {} of viscosity index {:g}", name, oil.viscosity_index);
}

// Throws std::invalid_argument for an oil of which nothing is known.
std::vector<OilProperty> properties_of(const std::string& grade, const bearing::OilGrade& oil,
                                       double temperature) {
  const bearing::Lubricant lubricant = bearing::lubricant_at(oil, temperature);
  const std::string reason = fmt::format("default: {} at {:g} degC", words_for(grade, oil), temperature);
  return {{keys().viscosity, fmt::format("{} Pa.s", lubricant.viscosity), reason},
          {keys().pressure_viscosity, fmt::format("{} GPa-1", 1e9 * lubricant.pressure_viscosity), reason},
          {keys().kinematic_viscosity,
           fmt::format("{} mm2/s", 1e6 * bearing::kinematic_viscosity(oil, temperature)), reason}};
}

}  // namespace

double oil_density(const ResolvedCase& in) {
  return density_that_counts(
      [&](const std::string& path) { return in.has(path) ? &in.value(path).number : nullptr; });
}

bearing::Lubricant graded_lubricant(const ResolvedCase& in) {
  return {.viscosity = in.quantity(keys().viscosity),
          .pressure_viscosity = in.quantity(keys().pressure_viscosity)};
}

bearing::OilGrade graded_oil(const ResolvedCase& in) {
  return oil_by_inputs(in.choice(keys().oil_grade), [&](const std::string& path) {
    return in.has(path) ? &in.value(path).number : nullptr;
  });
}

bool is_known_oil(const ResolvedCase& in) {
  return in.choice(keys().oil_grade) != kStatedGrade || in.has(kAt40);
}

double graded_viscosity_slope(const ResolvedCase& in) {
  return bearing::viscosity_slope(graded_oil(in), in.quantity(keys().oil_temperature));
}

void fill_from_grade(CaseData& data, Model model) {
  if (data.values.contains(kAt40))
    put_where_absent(data, keys().oil_grade, kStatedGrade, "default: lubricant.viscosity_40 states the oil");
  const auto grade = data.values.find(keys().oil_grade);
  const auto number = [&](const std::string& path) -> const double* {
    const auto found = data.values.find(path);
    return found == data.values.end() ? nullptr : &found->second.value.number;
  };
  const double* temperature = number(keys().oil_temperature);
  if (grade == data.values.end() || temperature == nullptr) return;
  const std::string name = grade->second.value.given;
  if (name == kStatedGrade && !data.values.contains(kAt40)) return;  // reported by check_grade()
  std::vector<OilProperty> properties;
  try {
    properties = properties_of(name, oil_by_inputs(name, number), *temperature);
  } catch (const std::invalid_argument&) {
    return;  // reported by check_grade()
  }
  for (const OilProperty& property : properties) {
    const Field* field = find_field(property.path);
    if ((field->models & model) == 0) continue;
    substitute(data, property.path, property.text, property.reason);
  }
}

std::string stated_path(const ResolvedCase& in, const std::string& path) {
  return path == keys().oil_grade && in.has(kAt40) ? kAt40 : path;
}

void check_grade(CheckedCase& in) {
  if (in.has(kAt100) && !in.has(kAt40))
    return in.add_error_at(kAt100, "a viscosity at 100 degC without that at 40 degC",
                           std::string(kAt40) + " is required with it");
  if (!in.has(keys().oil_grade)) return;
  const bool stated = in.choice(keys().oil_grade) == kStatedGrade;
  if (stated != in.has(kAt40))
    return in.add_error_at(
        keys().oil_grade, in.choice(keys().oil_grade) + (stated ? " without " : " together with ") + kAt40,
        stated ? "lubricant.viscosity_40 is required with it" : "one of the two is required");
  if (stated && in.has(kAt100)) {
    if (in.quantity(kAt100) >= in.quantity(kAt40))
      in.add_error_at(kAt100, in.given(kAt100) + " with " + in.given(kAt40) + " at 40 degC",
                      "less at 100 degC than at 40 degC is required");
    return;
  }
  try {
    const bearing::OilGrade oil = graded_oil(in);
    (void)bearing::viscosity_at_100(oil.viscosity_40, oil.viscosity_index);
  } catch (const std::invalid_argument& error) {
    const std::string path = stated ? kAt40 : keys().oil_grade;
    in.add_error_at(path, in.given(path), error.what());
  }
}

}  // namespace orbearing::app
