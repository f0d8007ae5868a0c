// From what is fixed before a run to the model of a driven bearing.
#pragma once

#include "coupling/cosim/driven_bearing.hpp"

namespace orbearing::cosim {

/// The model of a bearing that others drive. Throws std::invalid_argument, with what was found and what is
/// required, where a number has no meaning or where something is asked for that follows from speeds or loads
/// before they are known: a run-up, a mesh ripple, the film as printed.
bearing::dynamics::BearingModel driven_model(const DrivenBearingSetup& setup);

/// Throw std::runtime_error with what was found where a number is not finite, or a window has no length.
void require_finite(const BoreCourse& inputs);
void require_finite(const bearing::dynamics::BoreMotion& motion);
void require_length(const Window& window);

}  // namespace orbearing::cosim
