// From the model of bearing/dynamics to the plain numbers of the vectorised one.
#pragma once

#include "bearing/dynamics/model.hpp"
#include "bearing/fast/constants.hpp"

namespace orbearing::bearing::fast {

/// Plain numbers of `model`.
Constants constants_of(const dynamics::BearingModel& model);

}  // namespace orbearing::bearing::fast
