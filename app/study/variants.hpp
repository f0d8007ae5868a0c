// Many variants of a case in one call, without files: what studies, uncertainty and scripts are made of.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/result_row.hpp"

namespace orbearing::app {

/// Numbers in place of a case's own, all computed alike.
struct Variants {
  std::vector<std::string> paths;  // of numbers of the case, input.speed as any other; "PATH[i]": of a list
  std::vector<double> values;      // [SI]  (variants, paths), the paths fastest
  std::size_t count() const { return paths.empty() ? 1 : values.size() / paths.size(); }
};

/// Rows as those of a sweep's table; `head` is the same for all.
struct VariantRows {
  TableHead head;
  std::vector<ResultRow> rows;
};

/// Computes the operating point of each variant, with the bits of a sweep's point, on `jobs` threads (0: one
/// for each core). A variant that is no case or that fails keeps its reason as its row's status. `done`
/// receives how many are done, from any thread, one at a time. Throws BadInput where the case itself, a path
/// or the fidelity is of no use, and Cancelled after request_stop().
VariantRows evaluate_variants(const ResolvedCase& resolved, const Variants& variants,
                              const std::string& fidelity, int jobs,
                              const std::function<void(std::size_t)>& done = {});

}  // namespace orbearing::app
