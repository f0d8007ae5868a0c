// What goes wrong with FMUs that others made.
#pragma once

#include <stdexcept>

namespace orbearing::fmu {

/// The file cannot be used, or the FMU reports that it cannot go on; the text holds what it logged.
class ForeignFmuError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace orbearing::fmu
