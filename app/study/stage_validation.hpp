// Rows of the table that need no case: numbers of stages known from the literature by a few parameters.
#pragma once

#include "app/study/validation_table.hpp"

namespace orbearing::app {

/// The low-speed planetary stage of the gearbox of [Oyague2011]: mean load of a planet bearing. The number it
/// is compared with is not printed there but follows from its parameters, by T/(N n a).
ValidationTable stage_validation();

}  // namespace orbearing::app
