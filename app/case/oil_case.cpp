#include "app/case/oil_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "app/case/field_table.hpp"
#include "app/case/objection.hpp"
#include "app/case/settings.hpp"
#include "bearing/film/oil_grade.hpp"

namespace orbearing::app {

namespace {

constexpr const char* kGrade = "lubricant.grade";
// The density, where a model asks for none [kg/m^3].
constexpr double kUsualDensity = bearing::OilGrade{}.density;
constexpr const char *kDensity = "lubricant.density", *kDrag = "drag.enabled";

bearing::OilGrade oil_of(const std::string& grade, const std::function<double(const char*)>& number) {
  constexpr std::size_t prefix = 7;  // "ISO VG "
  return {.viscosity_40 = 1e-6 * std::stod(grade.substr(prefix)),
          .viscosity_index = number("lubricant.viscosity_index"),
          .density = number(kDensity)};
}

bool same(double a, double b) {
  constexpr double digits = 1e-5;  // a resolved case holds six
  return std::abs(a - b) <= digits * std::abs(a);
}

}  // namespace

double oil_density(const ResolvedCase& in) {
  const bool counts = has_all(in, {kDensity, kDrag}) && in.flag(kDrag);
  return counts ? in.quantity(kDensity) : kUsualDensity;
}

std::vector<OilProperty> properties_of_grade(const std::string& grade,
                                             const std::function<double(const char*)>& number) {
  const bearing::OilGrade oil = oil_of(grade, number);
  const double temperature = number("lubricant.temperature");
  const bearing::Lubricant lubricant = bearing::lubricant_at(oil, temperature);
  const std::string reason = fmt::format("a mineral oil {} of viscosity index {:g} at {:g} degC", grade,
                                         oil.viscosity_index, temperature);
  return {{"lubricant.viscosity", fmt::format("{:.6g} Pa.s", lubricant.viscosity), reason},
          {"lubricant.pressure_viscosity", fmt::format("{:.6g} GPa-1", 1e9 * lubricant.pressure_viscosity),
           reason},
          {"lubricant.kinematic_viscosity",
           fmt::format("{:.6g} mm2/s", 1e6 * bearing::kinematic_viscosity(oil, temperature)), reason}};
}

void fill_from_grade(CaseData& data, Model model) {
  const auto grade = data.values.find(kGrade);
  if (grade == data.values.end()) return;
  const auto has = [&](const char* path) { return data.values.contains(path); };
  const auto number = [&](const char* path) {
    const bool counts =
        path != kDensity || (has(kDensity) && has(kDrag) && data.values.at(kDrag).value.number != 0.0);
    return counts ? data.values.at(path).value.number : kUsualDensity;
  };
  for (const char* needed : {"lubricant.temperature", "lubricant.viscosity_index"})
    if (!data.values.contains(needed)) return;  // said elsewhere
  std::vector<OilProperty> properties;
  try {
    properties = properties_of_grade(grade->second.value.given, number);
  } catch (const std::invalid_argument&) {
    return;  // check_grade() says it
  }
  for (OilProperty& property : properties) {
    const Field* field = find_field(property.path);
    if ((field->models & model) == 0) continue;
    FieldReading reading = read_field_text(*field, property.text);
    if (!reading.good) continue;
    StoredValue& stored = data.values[property.path];
    const bool stated = !stored.value.given.empty() && !stored.from_default;
    if (stated && !same(reading.value.number, stored.value.number)) {
      stored.replaced = stored.value.given;
      stored.value = std::move(reading.value);
    } else if (stored.replaced.empty()) {
      stored = {std::move(reading.value), {}, true};
    }
    data.assumed[property.path] = "default: " + property.reason;
  }
}

void check_grade(const ResolvedCase& in, std::vector<Mistake>& mistakes) {
  if (!has_all(in, {kGrade, "lubricant.temperature", "lubricant.viscosity_index"})) return;
  const auto number = [&](const char* path) {
    return path == kDensity ? oil_density(in) : in.value(path).number;
  };
  try {
    (void)properties_of_grade(in.choice(kGrade), number);
  } catch (const std::invalid_argument& error) {
    object_to(in, kGrade, in.choice(kGrade), error.what(), mistakes);
  }
}

}  // namespace orbearing::app
