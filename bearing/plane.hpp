// The plane of the bearing, in the carrier frame: short names for the types of mechanics/plane.hpp.
#pragma once

#include "mechanics/plane.hpp"

namespace orbearing::bearing {

using mechanics::across;
using mechanics::BodyMotion;
using mechanics::cross;
using mechanics::direction;
using mechanics::force_at;
using mechanics::Vector2;
using mechanics::Wrench;

}  // namespace orbearing::bearing
