// Fields of an oil by its grade.
#include <fmt/format.h>

#include "app/case/field_table.hpp"
#include "app/case/machine_fields.hpp"
#include "app/case/oil_case.hpp"
#include "bearing/film/oil_grade.hpp"

namespace orbearing::app {

namespace {

// As the viscosity that follows, and for the life by film and cleanliness too.
Use use_of_grade(Use use) {
  // The condition that no grade is given.
  use.conditions.clear();
  for (Way& way : use.ways)
    std::erase_if(way.conditions, [](const Condition& condition) { return condition.absent; });
  return use.used_too(AnalysisId::crown, where_absent("life.viscosity_ratio"));
}

}  // namespace

namespace table {

void add_grade_fields(std::vector<Field>& fields, unsigned models, const Use& use) {
  const Condition graded = where_given({"lubricant.grade"});
  models &= row_of(fields, "lubricant.viscosity").models;
  Rows rows(fields, models);
  std::vector<std::string> grades;
  for (const int grade : bearing::kOilGrades) grades.push_back(fmt::format("ISO VG {}", grade));
  grades.emplace_back(kStatedGrade);
  rows.choice("lubricant.grade",
              "viscosity grade of a mineral oil; with the temperature it replaces lubricant.viscosity, "
              "pressure_viscosity and kinematic_viscosity. stated: lubricant.viscosity_40 says it",
              use, std::move(grades));
  rows.quantity("lubricant.viscosity_40",
                "kinematic viscosity at 40 degC as a data sheet states it, instead of a grade", use,
                dimension::kinematic_viscosity, positive(1e6));
  rows.quantity("lubricant.viscosity_100",
                "kinematic viscosity at 100 degC, stated with viscosity_40; by the viscosity index if absent",
                use.when(where_given({"lubricant.viscosity_40"})), dimension::kinematic_viscosity,
                {2.0, 1e6});
  if (find_row(fields, "lubricant.temperature") == nullptr)
    fields.push_back(field_of_row<analysis::BearingOil>("lubricant.temperature", models, use));
  row_of(fields, "lubricant.temperature").under(graded);
  rows.number("lubricant.viscosity_index", "viscosity index, stated with the grade",
              use.when(graded).when(where_absent("lubricant.viscosity_100")), {0.0, 100.0})
      .by_default("95", "an ordinary mineral oil");
}

// The analyses that use the viscosity use these fields.
void add_oil_fields(std::vector<Field>& fields, unsigned models) {
  add_grade_fields(fields, models, use_of_grade(row_of(fields, "lubricant.viscosity").use));
}

}  // namespace table

}  // namespace orbearing::app
