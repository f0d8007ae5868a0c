// The errors of the public interface by the names that the program uses.
#pragma once

#include "orbearing/errors.hpp"

namespace orbearing::app {

using orbearing::BadInput;
using orbearing::ComputationFailed;
using orbearing::Interrupted;

}  // namespace orbearing::app
