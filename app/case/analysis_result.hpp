// What an analysis gives to whoever shows or keeps it.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/case/machine_rows.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// What an analysis found. A record, from which whoever shows or keeps it makes what he needs.
struct AnalysisResult {
  described::Record record;
  std::vector<std::string> warnings{};
  std::string heading{};                              // of its text
  std::vector<std::pair<std::string, double>> row{};  // of the table of a sweep; none: the record's numbers
  std::vector<std::pair<std::string, std::string>> files{};  // of the folder besides: name, content
  std::string status = "ok";                                 // that the netCDF file gives
  bool failed = false;                                       // in parts
};

/// What a caller wants besides the result.
struct Wanted {
  std::function<void(double)> progress{};  // gets the share done
  bool files = false;                      // those of the folder
};

}  // namespace orbearing::app
