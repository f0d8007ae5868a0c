// A computation that came to no result, with its inputs right.
#pragma once

#include <stdexcept>

namespace orbearing::mechanics {

/// For example a load without static equilibrium. The text says why, and what to change.
struct NoResult : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace orbearing::mechanics
