// Frequencies at which a planet, its bearing and its teeth repeat.
#pragma once

#include "bearing/defect/scratched_bearing.hpp"

namespace orbearing::diagnosis {

/// Frequencies of pure rolling and of the teeth. Frequencies of the bearing are relative to the carrier.
struct PlanetFrequencies {
  double carrier = 0.0;                         // [Hz]  turns of the carrier in the housing
  double planet = 0.0;                          // [Hz]  turns of the planet relative to the carrier
  double mesh = 0.0;                            // [Hz]
  int planets = 0;                              // each passes the instrument once a turn of the carrier
  bearing::defect::PassingFrequencies bearing;  // of which `shaft` is `planet`
};

}  // namespace orbearing::diagnosis
