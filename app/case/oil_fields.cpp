// Fields of an oil by its grade.
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/machine_fields.hpp"
#include "bearing/film/graded_oil.hpp"
#include "mechanics/member_keys.hpp"

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
  const bearing::GradedOil oil;
  const mechanics::MemberKeys key(oil);
  models &= row_of(fields, keys().viscosity).models;
  for (const std::string& path : paths_of<bearing::GradedOil>())
    if (find_row(fields, path) == nullptr)
      fields.push_back(field_of_row<bearing::GradedOil>(path, models, use));
  const auto put = [&](const auto& member, const Use& of_member) {
    row_of(fields, key(member)).use = of_member;
  };
  const Condition graded = where_given({key(oil.grade)});
  put(oil.grade, use);
  put(oil.viscosity_40, use);
  put(oil.viscosity_100, use.when(where_given({key(oil.viscosity_40)})));
  row_of(fields, key(oil.temperature)).under(graded);
  put(oil.viscosity_index, use.when(graded).when(where_absent(key(oil.viscosity_100))));
  row_of(fields, key(oil.viscosity_index)).default_text = "95";  // as data sheets write it
}

// The analyses that use the viscosity use these fields.
void add_oil_fields(std::vector<Field>& fields, unsigned models) {
  add_grade_fields(fields, models, use_of_grade(row_of(fields, "lubricant.viscosity").use));
}

}  // namespace table

}  // namespace orbearing::app
