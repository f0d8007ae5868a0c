// The one door to what the program computes: a request in, the result as --json prints it out.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// What is asked. Of the case one way of saying which is needed, where the command takes a case.
struct Request {
  std::string command;                   // "run"
  std::string case_file{};               // or
  std::string case_text{};               // what a file would hold, or
  std::optional<ResolvedCase> given{};   // a case that is read already, which takes no settings
  std::vector<std::string> settings{};   // path=value
  /// Those of the command line by their names, with _ for -: {"fidelity": "dynamic", "jobs": 2}; switches are true or
  /// false, what may be repeated is a list; "folders" are the folders that report and merge take. Null: none.
  nlohmann::ordered_json options{};
  /// Called from any thread, one call at a time, with how far the computation is; false asks it to stop.
  std::function<bool(std::size_t done, std::size_t all, const std::string& doing)> progress{};
};

struct Answer {
  nlohmann::ordered_json result;      // null where the command prints none
  std::vector<std::string> failures;  // lines about points that failed
  int code = 0;                       // 0 done, 1 failed at some points
};

/// Throws BadInput for what cannot be asked, ComputationFailed, and Cancelled where it was asked to stop.
Answer answer(const Request& request);

}  // namespace orbearing::app
