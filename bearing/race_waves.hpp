// Waves of a race as a case states them: lists of orders with amplitudes and phases.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "bearing/race_harmonic.hpp"
#include "mechanics/described.hpp"

namespace orbearing::bearing {

/// One block of waves. Without phases all are 0.
struct RaceWaves {
  std::vector<double> orders;      // [-]
  std::vector<double> amplitudes;  // [m]    (orders)
  std::vector<double> phases;      // [rad]  (orders)
};
template <class Visitor>
void describe_waves(Visitor& visit, RaceWaves& m, const std::string& block) {
  using namespace described;
  members(visit, m, internal(m.orders, block + ".order"), internal(m.amplitudes, block + ".amplitude"),
          internal(m.phases, block + ".phase"));
}

/// Form of one race: waves that are stationary in the carrier, and those that rotate with the race.
struct RaceForm {
  RaceWaves out_of_roundness;
  RaceWaves waviness;
};

inline void add_waves(const RaceWaves& waves, bool rotating, std::vector<RaceHarmonic>& form) {
  for (std::size_t i = 0; i < waves.orders.size(); ++i)
    form.push_back({.order = static_cast<int>(std::lround(waves.orders[i])),
                    .amplitude = waves.amplitudes[i],
                    .phase = waves.phases.empty() ? 0.0 : waves.phases[i],
                    .rotating = rotating});
}
inline std::vector<RaceHarmonic> harmonics_of(const RaceForm& form) {
  std::vector<RaceHarmonic> harmonics;
  add_waves(form.out_of_roundness, false, harmonics);
  add_waves(form.waviness, true, harmonics);
  return harmonics;
}

/// Forms of both races.
struct RaceForms {
  RaceForm inner, outer;
};
template <class Visitor>
void describe(Visitor& visit, RaceForms& m) {
  const auto race = [&](RaceForm& form, const std::string& name) {
    const std::string block = "bearing." + name + "_race.";
    describe_waves(visit, form.out_of_roundness, block + "out_of_roundness");
    describe_waves(visit, form.waviness, block + "waviness");
  };
  race(m.inner, "inner");
  race(m.outer, "outer");
}

}  // namespace orbearing::bearing
