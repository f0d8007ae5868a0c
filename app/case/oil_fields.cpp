// Fields of an oil by its grade: what uses the viscosity uses them.
#include <fmt/format.h>

#include <algorithm>

#include "app/case/field_table.hpp"
#include "bearing/film/oil_grade.hpp"

namespace orbearing::app::table {

namespace {

// As the viscosity that follows, and for the life by film and cleanliness too.
Use use_of_grade(const Field& viscosity) {
  Use use = viscosity.use;
  // That no grade is given.
  use.conditions.clear();
  for (Way& way : use.ways)
    std::erase_if(way.conditions, [](const Condition& condition) { return condition.absent; });
  return use.used_too(use::crown | use::static_load, where_absent("life.viscosity_ratio"));
}

}  // namespace

void add_oil_fields(std::vector<Field>& fields) {
  const auto viscosity = std::find_if(fields.begin(), fields.end(),
                                      [](const Field& field) { return field.path == "lubricant.viscosity"; });
  const Use use = use_of_grade(*viscosity), beside = use.when(where_given({"lubricant.grade"}));
  const unsigned models = viscosity->models;
  std::vector<std::string> grades;
  for (const int grade : bearing::kOilGrades) grades.push_back(fmt::format("ISO VG {}", grade));
  fields.push_back({.path = "lubricant.grade",
                    .kind = Kind::choice,
                    .meaning = "viscosity grade of a mineral oil; with the temperature it replaces "
                               "lubricant.viscosity, pressure_viscosity and kinematic_viscosity",
                    .use = use,
                    .models = models,
                    .choices = grades});
  fields.push_back({.path = "lubricant.temperature",
                    .kind = Kind::quantity,
                    .meaning = "running temperature of the oil, stated with its grade",
                    .use = beside,
                    .models = models,
                    .dimension = described::dimension::temperature,
                    .range = {-20.0, 150.0},
                    .default_text = "70 degC",
                    .default_reason = "oil of a gearbox at full load"});
  fields.push_back({.path = "lubricant.viscosity_index",
                    .kind = Kind::number,
                    .meaning = "viscosity index, stated with the grade",
                    .use = beside,
                    .models = models,
                    .range = {0.0, 100.0},
                    .default_text = "95",
                    .default_reason = "an ordinary mineral oil"});
}

}  // namespace orbearing::app::table
