// Where cage and ring stand to each other at both ends of the cage's width, where the law of
// bearing/contact/land_law.hpp holds at each land: so that they also resist tilting.
#pragma once

#include "bearing/motion/balls/bodies.hpp"

namespace orbearing::bearing::balls {

/// Cage less land at `place` along the axes: offset x y, velocity x y, spin of the cage.
struct LandOffset {
  double by[5];
};
[[gnu::always_inline]] inline LandOffset land_offset(const Body& cage, const Body& ring, double position) {
  return {{cage.centre.x - ring.centre.x + position * (cage.axis.x - ring.axis.x),
           cage.centre.y - ring.centre.y + position * (cage.axis.y - ring.axis.y),
           cage.velocity.x - ring.velocity.x + position * (cage.axis_rate.x - ring.axis_rate.x),
           cage.velocity.y - ring.velocity.y + position * (cage.axis_rate.y - ring.axis_rate.y), cage.spin}};
}

}  // namespace orbearing::bearing::balls
