// The motion in time as named arrays of a point's file: dimensions time, roller and direction.
#pragma once

#include "app/results/point_file.hpp"

namespace orbearing::app {

/// Appends one cage revolution of the dynamic bearing to `content`.
void add_series(const integration::BearingSeries& series, PointContent& content);

}  // namespace orbearing::app
