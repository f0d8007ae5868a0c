// Inputs of a rating per contact.
#pragma once

#include "bearing/life/lundberg_palmgren.hpp"

namespace orbearing::bearing::rating {

/// Load [N] that one contact bears for a million revolutions, on either race.
struct ContactCapacities {
  double inner = 0.0;  // [N]
  double outer = 0.0;  // [N]
};

/// One race turns relative to the load, the other stands.
inline RaceMotions rotating(Race race) {
  if (race == Race::inner) return {};
  return {.inner = RaceMotion::stationary, .outer = RaceMotion::rotating};
}

}  // namespace orbearing::bearing::rating
