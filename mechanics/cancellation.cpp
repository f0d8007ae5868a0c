#include "mechanics/cancellation.hpp"

namespace orbearing::detail {

std::atomic<bool> stop_wished = false;

}  // namespace orbearing::detail
