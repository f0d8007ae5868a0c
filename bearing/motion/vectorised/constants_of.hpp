// From the model of bearing/motion to the plain numbers of the vectorised one.
#pragma once

#include "bearing/motion/model.hpp"
#include "bearing/motion/vectorised/constants.hpp"

namespace orbearing::bearing::vectorised {

/// Plain numbers of `model`.
Constants constants_of(const motion::BearingModel& model);

}  // namespace orbearing::bearing::vectorised
