// The shape of a drivetrain's case: one set, whose fields are at the top level, or several under `sets`, each
// with the same fields, and the `shafts` that join them.
//
//     one set                 several sets
//     gearset: {...}          sets:   {reduction: {gearset: {...}, bearing: {...}}, ...}
//     bearing: {...}          shafts: {input: [motor, reduction.sun], ...}
//
// One set may have no bearing: its planets are supported by springs, and it has no life. Without a bearing it
// may also have no teeth: gearset.dynamics then states its masses and stiffnesses.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/case/field_table.hpp"
#include "coupling/analysis/set_keys.hpp"

namespace orbearing::app {

/// Names of sets and shafts in the order written.
struct CaseShape {
  std::vector<std::string> sets;
  std::vector<std::string> shafts;
  bool several = false;  // whether the case has sets and shafts, well or badly given
  bool bearing = true;   // one set: whether it has a bearing
  bool teeth = true;     // one set: whether it has teeth
  bool defect = true;    // a drivetrain: whether one of its bearings is scratched

  bool operator==(const CaseShape&) const = default;
};

/// A place in a case that a field describes: "sets.reduction.gearset.module" for the field "gearset.module".
struct Input {
  std::string path;
  const Field* field = nullptr;
};

inline constexpr std::size_t most_sets = 16;

/// Which parts one set has: a bearing, teeth. `root` is the whole case.
void find_parts(const Entry& root, CaseShape& shape);

/// Message on a field that a case of that shape cannot have: what was found, what is required.
ConsistencyMessage unused_field(const CaseShape& shape, std::string_view path);

using analysis::set_prefix;
/// "shafts.NAME"
std::string shaft_path(std::string_view shaft);
/// Prefixes of the paths of the sets: one empty prefix in a case of one set.
std::vector<std::string> set_prefixes(const CaseShape& shape);

/// Path of the name of the set with the scratched bearing, in a case of several sets.
inline constexpr std::string_view kScratchedSet = "defect.set";

/// Whether a case of that shape can have an input at the path.
bool belongs(const CaseShape& shape, std::string_view path);

/// All inputs of a case of that shape that one of `models` uses, in the order in which cases are written.
std::vector<Input> inputs_of(unsigned models, const CaseShape& shape);

}  // namespace orbearing::app
