// The one door to what the program computes: a request in, the result as --json prints it out. By the names
// of the commands: run, sweep, crown, modes, mesh, stiffness, signals, sensitivities, fmu, check, validate
// and more.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "orbearing/case.hpp"

namespace orbearing {

/// A command and its input. If the command takes a case, one of three ways of stating it.
struct Request {
  std::string command;                  // "run"
  std::string case_file{};              // or
  std::string case_text{};              // what a file would hold, or
  std::optional<Case> given{};          // one that is read already, which takes no settings
  std::vector<std::string> settings{};  // "path=value"
  /// A JSON object of the options of the command line by their names, with _ for -:
  /// {"fidelity": "dynamic", "jobs": 2}. Switches are true or false; what may be repeated is a list;
  /// "folders" are the words by their place, such as the folders that report and merge take.
  std::string options = "{}";
  /// Called from any thread, one call at a time, with the progress of the computation; return false to stop
  /// it.
  std::function<bool(std::size_t done, std::size_t all, const std::string& doing)> progress{};
  /// Called from any thread, one call at a time, with how far a motion in progress is, a JSON object:
  /// {"time_s", "expected_s", "most_s", "share", "seconds_left", "run", "most_runs", "rolling_cage_rpm",
  /// "cage_rpm", "cage_turned_deg", "cage_um", "angle_deg", "spin_rpm", "inner_load_N", "outer_load_N"}.
  /// `seconds_left` is null at first; `run` is 0 unless gears and bearing run in turn. Speeds are relative to
  /// the carrier; without a cage its speed and angle are means over the rollers.
  std::function<void(const std::string& motion)> motion{};
  /// Receives each point of a sweep as it ends, a JSON object with the keys of `points`; first those that a
  /// resumed folder holds. One call at a time.
  std::function<void(const std::string& row)> point{};
};

struct Answer {
  std::string result;                 // a JSON object; "null" where the command prints none
  std::vector<std::string> failures;  // lines about points that failed
  int code = 0;                       // 0 done, 1 failed at some points
};

/// Throws BadInput for an invalid request, ComputationFailed, and Interrupted or Cancelled where it was
/// stopped on request.
Answer answer(const Request& request);

}  // namespace orbearing
