// Result of an analysis, for callers that show or store it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/case/machine_rows.hpp"
#include "coupling/analysis/life_table.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// Result of an analysis: a record, from which each caller makes its own output.
struct AnalysisResult {
  described::Record record;
  std::vector<std::string> warnings{};
  std::string heading{};                              // of its text
  std::vector<std::pair<std::string, double>> row{};  // of the table of a sweep; none: the record's numbers
  std::vector<std::pair<std::string, std::string>> files{};  // of the folder besides: name, content
  std::string status = "ok";                                 // that the netCDF file gives
  bool failed = false;                                       // in parts
  std::optional<analysis::LifeTable> lives{};                // that requirements limit
};

/// Columns are of lives: a vibration has none but the largest load [N].
inline void put_largest_load(double largest, AnalysisResult& result) {
  result.row = {{"inner_load_max_N", largest}, {"outer_load_max_N", largest}};
}

/// Options of a caller besides the result.
struct AnalysisOptions {
  std::function<void(double)> progress{};  // gets the share done
  bool files = false;                      // those of the folder
};

}  // namespace orbearing::app
