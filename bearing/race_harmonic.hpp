// One wave of a race that is not round. No header of a library here, since files compiled for special
// instruction sets include it.
#pragma once

namespace orbearing::bearing {

/// One wave of a race that is not round: its radius grows by amplitude cos(order * angle + phase).
struct RaceHarmonic {
  int order = 2;           // [-]    waves around the race: 2 for an oval
  double amplitude = 0.0;  // [m]
  double phase = 0.0;      // [rad]
  bool rotating = false;   // true: angle from a mark on the race (waviness made into it); false: from the
                           // outward direction (a shape that loads hold while the race turns through it)

  bool operator==(const RaceHarmonic&) const = default;
};

}  // namespace orbearing::bearing
