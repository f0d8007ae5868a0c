// Rows of the table of fields, by the part of a case that they state.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/case/field.hpp"

namespace orbearing::app {

namespace table {
/// Adds rows of fields without a described member to a table, all of the same models. Further properties of a
/// row are appended: `rows.number(...).by_default("1", "no run-up")`.
class Rows {
 public:
  Rows(std::vector<Field>& fields, unsigned models) : fields_(fields), models_(models) {}

  Field& quantity(std::string path, std::string meaning, const Use& use, const Dimension& dimension,
                  Range range);
  Field& number(std::string path, std::string meaning, const Use& use, Range range);
  Field& integer(std::string path, std::string meaning, const Use& use, Range range);
  Field& choice(std::string path, std::string meaning, const Use& use, std::vector<std::string> choices);
  Field& text(std::string path, std::string meaning, const Use& use);
  Field& list_of_rows(std::string path, std::string meaning, const Use& use, std::vector<ListColumn> columns);

 private:
  Field& add(Kind kind, std::string path, std::string meaning, const Use& use, Range range = {});

  std::vector<Field>& fields_;
  unsigned models_;
};

/// The row of that path in a table that is being made, which has one.
Field& row_of(std::vector<Field>& fields, std::string_view path);

/// The same in a table that may lack it: null then.
Field* find_row(std::vector<Field>& fields, std::string_view path);

// Rows by block, of models whose cases are no types.
void add_drivetrain_fields(std::vector<Field>& fields);
void add_bearing_fields(std::vector<Field>& fields);
void add_static_fields(std::vector<Field>& fields);
void add_oil_fields(std::vector<Field>& fields, unsigned models);

// Rows of inputs that are no members of structures, for those of `models` that have them: of a planetary
// drivetrain, or of one machine.

void add_case_fields(std::vector<Field>& fields, unsigned models, const Use& use);
void add_bearing_type(std::vector<Field>& fields, unsigned models, const Use& use);

/// Uses of the inputs of the rollers' profile.
struct ProfileUses {
  Use kind, shape, depth, table;
  AnalysisSet all;      // analyses with a profile
  AnalysisSet crown{};  // that vary its depth
};
/// For rows that are in the table.
void put_profile_uses(std::vector<Field>& fields, const ProfileUses& uses);

void add_grade_fields(std::vector<Field>& fields, unsigned models, const Use& use);

/// `crown`: analyses that optimize the life which a requirement selects.
void add_requirements(std::vector<Field>& fields, unsigned models, const Use& use, AnalysisSet crown = {});

/// After those that they put conditions on. `by_complement`: analyses that use the complement of a catalogue
/// bearing alone.
void add_catalogue_fields(std::vector<Field>& fields, unsigned models, AnalysisSet by_complement = {});
}  // namespace table

}  // namespace orbearing::app
