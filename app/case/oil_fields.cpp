// Fields of an oil by its grade.
#include <fmt/format.h>

#include "app/case/described_fields.hpp"
#include "app/case/field_table.hpp"
#include "app/case/oil_case.hpp"
#include "bearing/film/oil_grade.hpp"

namespace orbearing::app::table {

namespace {

// As the viscosity that follows, and for the life by film and cleanliness too.
Use use_of_grade(const Field& viscosity) {
  Use use = viscosity.use;
  // The condition that no grade is given.
  use.conditions.clear();
  for (Way& way : use.ways)
    std::erase_if(way.conditions, [](const Condition& condition) { return condition.absent; });
  return use.used_too(use::crown | use::static_load, where_absent("life.viscosity_ratio"));
}

}  // namespace

// The analyses that use the viscosity use these fields.
void add_oil_fields(std::vector<Field>& fields) {
  const Field viscosity = row_of(fields, "lubricant.viscosity");
  const Use use = use_of_grade(viscosity), beside = use.when(where_given({"lubricant.grade"}));
  Rows rows(fields, viscosity.models);
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
  rows.quantity("lubricant.temperature", "running temperature of the oil, stated with its grade", beside,
                dimension::temperature, {-20.0, 150.0})
      .by_default("70 degC", "oil of a gearbox at full load");
  rows.number("lubricant.viscosity_index", "viscosity index, stated with the grade",
              beside.when(where_absent("lubricant.viscosity_100")), {0.0, 100.0})
      .by_default("95", "an ordinary mineral oil");
}

}  // namespace orbearing::app::table
