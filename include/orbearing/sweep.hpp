// Operating points of a case with numbers replaced, all in one call and without files.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "orbearing/case.hpp"

namespace orbearing {

/// The table of a sweep: its columns of numbers [the unit that ends a column's name].
struct Points {
  std::vector<std::string> columns;
  std::vector<double> numbers;      // (points, columns), the columns fastest; NaN where there is none
  std::vector<std::string> status;  // of each point: "ok", or why it has no result
};

/// The operating point of each row of `values` [SI] (points, paths), the paths fastest, with the bits of a
/// sweep's point whatever `jobs` (0: one for each core). `paths` are numbers of the case, input.speed as any
/// other; "PATH[i]" is an element of a list. A point that is no case or that fails keeps its reason as its
/// status. `done` receives how many are done, from any thread, one at a time. Throws BadInput where the case
/// itself, a path or the fidelity is of no use, or a path has no effect, and Cancelled.
Points evaluate(const Case& stated, const std::vector<std::string>& paths, const std::vector<double>& values,
                const std::string& fidelity = "quasi-static", int jobs = 0,
                const std::function<void(std::size_t)>& done = {});

}  // namespace orbearing
