#include "app/case/oil_case.hpp"

#include <fmt/format.h>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/mistake.hpp"
#include "app/case/part_of_data.hpp"
#include "app/case/settings.hpp"
#include "bearing/film/graded_oil.hpp"
#include "bearing/motion/parameters.hpp"

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

// A field that follows from the grade: its path, its value as it would be written in a case, and why.
struct OilProperty {
  std::string path;
  std::string text;
  std::string reason;
};

std::string words_for(bearing::ViscosityGrade grade, const bearing::OilGrade& oil) {
  const std::string name = grade == bearing::ViscosityGrade::stated
                               ? fmt::format("of {:g} mm2/s at 40 degC", 1e6 * oil.viscosity_40)
                               : std::string(described::text_of(grade));
  return oil.viscosity_100
             ? fmt::format("an oil {}, {:g} mm2/s at 100 degC", name, 1e6 * *oil.viscosity_100)
             : fmt::format("a mineral oil {} of viscosity index {:g}", name, oil.viscosity_index);
}

// Throws std::invalid_argument for an oil of which nothing is known.
std::vector<OilProperty> properties_of(bearing::ViscosityGrade grade, const bearing::OilGrade& oil,
                                       double temperature) {
  const bearing::Lubricant lubricant = bearing::lubricant_at(oil, temperature);
  const std::string reason = fmt::format("default: {} at {:g} degC", words_for(grade, oil), temperature);
  return {{keys().viscosity, fmt::format("{} Pa.s", lubricant.viscosity), reason},
          {keys().pressure_viscosity, fmt::format("{} GPa-1", 1e9 * lubricant.pressure_viscosity), reason},
          {keys().kinematic_viscosity,
           fmt::format("{} mm2/s", 1e6 * bearing::kinematic_viscosity(oil, temperature)), reason}};
}

// An oil by its grade, and the density that counts.
struct OilOfCase {
  struct Part {
    bearing::GradedOil oil;
    bearing::motion::OilDragParameters drag;
  };
  template <class Visitor>
  static void inputs(Visitor& visit, Part& part) {
    describe(visit, part.oil);
    describe(visit, part.drag);
  }
};

}  // namespace

void fill_from_grade(CaseData& data, Model model) {
  if (data.values.contains(keys().oil_viscosity_40))
    put_where_absent(data, keys().oil_grade, std::string(described::text_of(bearing::ViscosityGrade::stated)),
                     "default: " + keys().oil_viscosity_40 + " states the oil");
  if (!data.values.contains(keys().oil_grade) || !data.values.contains(keys().oil_temperature)) return;
  const OilOfCase::Part in = PartOfData<OilOfCase>::read(data, "");
  const std::optional<bearing::OilGrade> oil = oil_of(in.oil, density_of_oil(in.drag));
  if (!oil) return;  // reported by check_grade()
  std::vector<OilProperty> properties;
  try {
    properties = properties_of(*in.oil.grade, *oil, in.oil.temperature);
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
  return path == keys().oil_grade && in.has(keys().oil_viscosity_40) ? keys().oil_viscosity_40 : path;
}

void check_grade(CheckedCase& in) {
  const std::string &grade = keys().oil_grade, &at_40 = keys().oil_viscosity_40,
                    &at_100 = keys().oil_viscosity_100;
  const bearing::GradedOil oil = PartOfData<OilOfCase>::read(in.data(), "").oil;
  if (oil.viscosity_100 && !oil.viscosity_40)
    return in.add_error_at(at_100, "a viscosity at 100 degC without that at 40 degC",
                           at_40 + " is required with it");
  if (!oil.grade) return;
  const bool stated = oil.grade == bearing::ViscosityGrade::stated;
  if (stated != oil.viscosity_40.has_value())
    return in.add_error_at(grade, in.choice(grade) + (stated ? " without " : " together with ") + at_40,
                           stated ? at_40 + " is required with it" : "one of the two is required");
  if (stated && oil.viscosity_100) {
    if (*oil.viscosity_100 >= *oil.viscosity_40)
      in.add_error_at(at_100, in.given(at_100) + " with " + in.given(at_40) + " at 40 degC",
                      "less at 100 degC than at 40 degC is required");
    return;
  }
  try {
    const bearing::OilGrade found = oil_of(oil).value();
    (void)bearing::viscosity_at_100(found.viscosity_40, found.viscosity_index);
  } catch (const std::invalid_argument& error) {
    const std::string& path = stated ? at_40 : grade;
    in.add_error_at(path, in.given(path), error.what());
  }
}

}  // namespace orbearing::app
