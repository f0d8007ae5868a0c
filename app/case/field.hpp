// One row of the table of fields: all that is known about an input before a case is read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/case/field_use.hpp"
#include "app/case/mistake.hpp"
#include "app/case/model.hpp"
#include "app/case/units.hpp"
#include "app/case/yaml_tree.hpp"

namespace orbearing::app {

enum class Kind { quantity, integer, number, flag, choice, text, list };

using described::positive;
using described::Range;

/// One column of a list of rows. A row is a list of all columns, or a block with their names as keys.
struct ListColumn {
  std::string name{};
  Dimension dimension{};  // none: a plain number
  Range range{};
  int one_of = 0;  // of the columns with this number, if above 0, a row has one; the others read 0
  std::string_view unit_of_number{};  // unit of a number without one, if the name has it; none: refused
  bool text = false;      // holds texts: a row's number is that of its text in FieldValue::texts, from 1
  bool optional = false;  // a row may be without it and reads 0 then
};

struct Field {
  std::string path{};  // "bearing.radial_clearance"
  Kind kind = Kind::text;
  std::string meaning{};                 // one sentence, shown by the schema
  Use use;                               // who uses it; without it a row does not compile
  unsigned models = with_rollers;        // models that use the field
  unsigned required_by = no_model;       // models that require it
  Dimension dimension{};                 // quantity, and list of quantities
  Range range{};                         // quantity, number, integer and the elements of a list
  std::vector<std::string> choices{};    // choice
  std::string default_text{};            // as it would be written in a case; empty: none
  std::string default_reason{};          // why this value may replace a missing one
  Kind element = Kind::number;           // list: kind of its elements
  bool default_without_bearing = false;  // the default applies only where a set has no bearing
  std::vector<ListColumn> columns{};     // list of rows: quantities of each of these
  bool from_file = false;                // list of rows, or of a matrix: or {file: NAME.csv} instead
  std::size_t group =
      0;  // list: of so many elements; or a list of such lists, whose elements follow each other
  bool numerical = false;  // Details::numerical
  std::size_t count = 0;   // list: of so many, if above 0

  /// Alternative structure that a case selects: by the value of the input `by`, or without a value by which
  /// of its inputs the case states.
  struct Alternative {
    std::string by;
    std::string value;
    std::size_t number = 0;
  };
  std::vector<Alternative> alternatives{};  // the outer ones first
  bool required_if_chosen = false;
  std::vector<std::pair<Model, Use>> of_machines{};  // uses by analyses of machines whose cases are types

  /// Uses in a case of that model.
  const Use& use_in(Model model) const;

  /// Further properties of a row; each function returns the row itself.
  Field& by_default(std::string text, std::string reason);
  Field& required();                  // by all models that use it
  Field& listed();                    // a list of such values
  Field& under(Condition condition);  // where it has an effect
  Field& of_numerics();               // a numerical setting
};

/// How a case writes the values of an enumeration, and the one that it writes so, if any.
template <class E>
std::vector<std::string> choices_of() {
  std::vector<std::string> choices;
  for (const auto& name : names_of(E{})) choices.emplace_back(name.text);
  return choices;
}
template <class E>
std::optional<E> value_named(std::string_view text) {
  for (const auto& name : names_of(E{}))
    if (name.text == text) return name.value;
  return std::nullopt;
}

/// A checked value of a field.
struct FieldValue {
  std::string given;                 // as written, in the form that the resolved case repeats
  double number = 0.0;               // [SI] quantity; plain for number and integer; 1 or 0 for flag
  std::vector<double> list;          // [SI] list; of rows one after the other
  std::vector<std::string> texts{};  // list of texts; of a column of texts, each text once

  bool operator==(const FieldValue&) const = default;
};

/// The text of a column of texts that has this number in a row; empty for 0.
inline std::string text_numbered(const std::vector<std::string>& texts, double number) {
  return number > 0.0 ? texts[static_cast<std::size_t>(number) - 1] : std::string();
}

/// Whether its values are numbers, with or without unit.
inline bool is_numeric(const Field& field) {
  return field.kind == Kind::quantity || field.kind == Kind::number || field.kind == Kind::integer;
}

/// A limit that results are judged by, which changes none of them.
inline bool is_limit(const Field& field) {
  return field.path.starts_with("requirements.") && is_numeric(field);
}

/// Whether a sweep can go through its values.
inline bool can_be_swept(const Field& field) {
  return is_numeric(field) && !is_limit(field);
}

/// Either a value, or what was found and what is required.
struct FieldReading {
  bool good = false;
  FieldValue value;
  ConsistencyMessage message;
  std::optional<Location> location{};  // of a part of the entry that is to blame
};

/// Checks one entry of the case against its field: kind, unit, finiteness, range.
FieldReading read_field(const Field& field, const Entry& entry);

/// The same for a number of the program [SI], written as `text`; none: as a case states it in SI. Numeric
/// fields only.
FieldReading read_field_number(const Field& field, double value, std::string text = "");

/// Whether some columns of its rows are left out, so that rows are blocks.
bool has_choices(const Field& field);

/// The key of a column in a row that is a block: "rolling_speed" of "rolling speed".
std::string column_key(const ListColumn& column);

/// Requirement of the field, as in "a length like '3 mm', greater than 0 mm".
std::string requirement(const Field& field);

}  // namespace orbearing::app
