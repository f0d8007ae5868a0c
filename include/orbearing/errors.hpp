// The two errors of a request; a third, orbearing::Cancelled, is no std::exception.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace orbearing {

/// An error of the user: location, what was found, what is required, what to do. Exit code 2.
struct BadInput : std::runtime_error {
  explicit BadInput(std::vector<std::string> lines)
      : std::runtime_error(joined(lines)), messages(std::move(lines)) {}
  explicit BadInput(const std::string& line) : BadInput(std::vector<std::string>{line}) {}

  std::vector<std::string> messages;  // one line per mistake

 private:
  static std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
  }
};

/// The input was sound, yet the work could not be completed: no convergence, no room on the disk,
/// interrupted. Exit code 1.
struct ComputationFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Stopped on request; the message says what is kept and how to go on. Where nothing is kept, Cancelled comes
/// through as it is.
struct Interrupted : ComputationFailed {
  using ComputationFailed::ComputationFailed;
};

}  // namespace orbearing
