// The one table of all fields: checking, defaults, JSON Schema, resolved case and `check` all come from it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/case/field_rows.hpp"

namespace orbearing::app {

/// All fields, in the order in which cases are written.
const std::vector<Field>& all_fields();

/// The field of that path, or null. For "sets.NAME.gearset.module" it is "gearset.module", which names no
/// set.
const Field* find_field(std::string_view path);

/// Names of sets and shafts: letters, digits and _, beginning with a letter.
bool is_name(std::string_view name);
inline constexpr const char* name_rule =
    "a name of at most 40 letters, digits and _, beginning with a letter, is required";

/// Length of "sets.NAME." at the beginning of a path; 0 for a path without it.
std::size_t set_prefix_length(std::string_view path);

/// "sets.NAME." at the beginning of a path; empty for a path without it.
inline std::string set_of(std::string_view path) {
  return std::string(path.substr(0, set_prefix_length(path)));
}

/// Whether only a case of one set has this field: shafts take its place.
bool is_of_one_set(const Field& field);

/// Whether each of several sets has this field for itself.
bool in_each_set(const Field& field);

/// The field of `shafts.NAME`.
const Field& shaft_field();

/// Fields that any of the models uses, in table order.
std::vector<const Field*> fields_of(unsigned models);

/// Name of a model of this version, and back (`no_model` for another name).
std::string_view model_name(Model model);
Model model_of(std::string_view name);
/// Model of a case that names `named`: a ball bearing with a block `simulation`, and a scratched bearing with
/// rollers, are models of their own.
Model specific_model(Model named, bool simulation, bool rollers);
const std::vector<Model>& models();

/// The known word nearest to `word` by edit distance; empty where none is near.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace orbearing::app
