// Form of a race at the contacts: bearing/contact/race_form.hpp for packs of contacts, with one derivative
// more.
#pragma once

#include "bearing/motion/vectorised/both_races.hpp"
#include "mechanics/packs/elementary.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Height and slopes by the angle of the normal; `turning` is the share of what turns with the race.
template <class Number>
struct FormSlopes {
  Number height;  // [m]
  Number slope;   // [m/rad]
  Number bend;    // [m/rad^2]  second derivative
  Number turning_slope;
  Number turning_bend;
};

/// `cosine`, `sine` of the normal's angle in the carrier frame.
inline FormSlopes<Pack> form_slopes(const RaceConstants& race, const Pack& cosine, const Pack& sine) {
  FormSlopes<Pack> sum{};
  for (int i = 0; i < race.waves; ++i) {
    const WaveConstants& wave = race.wave[i];
    // (cosine + i sine)^order, by squaring.
    Pack c = spread(1.0), s{}, base_c = cosine, base_s = sine;
    for (int n = wave.order; n > 0; n /= 2) {
      if (n % 2 == 1) {
        const Pack next = c * base_c - s * base_s;
        s = c * base_s + s * base_c;
        c = next;
      }
      const Pack square = base_c * base_c - base_s * base_s;
      base_s = 2.0 * base_c * base_s;
      base_c = square;
    }
    const double turn_c = wave.amplitude * __builtin_cos(wave.phase);
    const double turn_s = wave.amplitude * __builtin_sin(wave.phase);
    const double order = wave.order;
    const Pack height = turn_c * c - turn_s * s;
    const Pack slope = -order * (turn_c * s + turn_s * c);
    sum.height += height;
    sum.slope += slope;
    sum.bend -= order * order * height;
    if (wave.turning) {
      sum.turning_slope += slope;
      sum.turning_bend -= order * order * height;
    }
  }
  return sum;
}

inline FormSlopes<PackPair> form_slopes(const BothRaces& race, const PackPair& cosine, const PackPair& sine) {
  const FormSlopes<Pack> inner = form_slopes(*race.inner, cosine.low, sine.low);
  const FormSlopes<Pack> outer = form_slopes(*race.outer, cosine.high, sine.high);
  return {{inner.height, outer.height},
          {inner.slope, outer.slope},
          {inner.bend, outer.bend},
          {inner.turning_slope, outer.turning_slope},
          {inner.turning_bend, outer.turning_bend}};
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
