// The `sweep:` block: which fields take which values.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Most operating points of one sweep.
inline constexpr double most_points = 100000;

/// Calls `read` for each member of a block at `path`, whose keys must differ.
void read_each_once(const Entry& block, const std::string& path, std::vector<Mistake>& mistakes,
                    const std::function<void(const Member&)>& read);

/// Fields that the keys of a block name by their paths.
struct FieldsByPath {
  std::string_view block;       // "sweep"
  bool (*takes)(const Field&);  // those of the right kind
  std::string_view kind;        // "a numeric field"
  std::string_view example{};   // of which an example is ", as in 'input.speed',"
  std::string_view wrong_kind;  // "a field that is no number"
};
/// The field of such a key; null, with a mistake, where there is none.
const Field* field_by_path(const FieldsByPath& fields, const Member& member, unsigned model,
                           const CaseShape& shape, std::vector<Mistake>& mistakes);

/// Reads the axes in the order written; `model` holds the bits of the models whose fields may be swept,
/// `shape` which sets there are.
std::vector<SweepAxis> read_axes(const Entry& sweep, unsigned model, const CaseShape& shape,
                                 std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
