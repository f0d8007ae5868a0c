// Scratches of the bearing as a motion meets them. No header of a library here, since files compiled for special
// instruction sets include it.
#pragma once

#include "bearing/contact/scratch_law.hpp"

namespace orbearing::bearing {

/// A scratch across a race, which turns with it.
struct RaceScratch {
  double radius = 0.0;  // [m]    of the race
  double angle = 0.0;   // [rad]  of its middle when the race has turned by nothing
  ScratchLaw law;
};

/// A scratch along a roller, which turns with it and meets both races. One roller may have several.
struct RollerScratch {
  int roller = 0;
  int followed = 0;     // which of the rollers that are followed in their turning
  double radius = 0.0;  // [m]    of the roller
  double angle = 0.0;   // [rad]  of its middle when the roller has turned by nothing
  ScratchLaw on_inner;
  ScratchLaw on_outer;
};

/// What lies on a contact whose normal stands at the angle with `cosine` and `sine`: a scratch at the angle
/// `scratch` [rad].
template <class Number>
TrackDepth<Number> depth_at(const ScratchLaw& law, double radius, double scratch, const Number& cosine,
                            const Number& sine) {
  const auto at = mechanics::sine_cosine(scratch);
  return track_depth(law, radius, Number(sine * at.cosine - cosine * at.sine),
                     Number(cosine * at.cosine + sine * at.sine));
}

}  // namespace orbearing::bearing
