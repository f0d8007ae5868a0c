// The constants of both races side by side, as the laws of race_contact read them: inner low, outer high.
#pragma once

#include "bearing/motion/vectorised/constants.hpp"
#include "mechanics/packs/pack.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

struct RacePair : RaceNumbers<NumberPair> {
  bool film = false;      // adds to the elastic approach
  bool squeezed = false;  // resists the approach
  FrictionLaws<NumberPair> friction;
  bool round = true;  // neither race has waves or scratches, no roller a scratch, and the outer one is rigid
  int rim_waves = 0;  // of the outer race
  const RaceConstants* inner = nullptr;
  const RaceConstants* outer = nullptr;
  LaminaConstants laminae;
  Listed<RollerScratch> roller_scratches;
};

/// The numbers of both races side by side. Constants hold nothing but numbers.
template <template <class> class Constants>
void put_side_by_side(const Constants<double>& inner, const Constants<double>& outer,
                      Constants<NumberPair>& both) {
  constexpr int kNumbers = sizeof(Constants<double>) / sizeof(double);
  static_assert(sizeof inner == kNumbers * sizeof(double) && sizeof both == kNumbers * sizeof(NumberPair));
  double low[kNumbers], high[kNumbers];
  NumberPair pair[kNumbers];
  __builtin_memcpy(low, &inner, sizeof low);
  __builtin_memcpy(high, &outer, sizeof high);
  for (int i = 0; i < kNumbers; ++i) pair[i] = {low[i], high[i]};
  __builtin_memcpy(&both, pair, sizeof pair);
}

/// Both races follow the same laws, with numbers of their own. Keeps pointers to the constants of both races
/// and to what those of laminae and scratches point to.
inline RacePair race_pair(const Constants& constants) {
  const RaceConstants &inner = constants.inner, &outer = constants.outer;
  RacePair both;
  put_side_by_side<RaceNumbers>(inner, outer, both);
  put_side_by_side<FrictionNumbers>(inner.friction, outer.friction, both.friction);
  static_cast<FrictionChoice&>(both.friction) = inner.friction;
  both.film = inner.film;
  both.squeezed = inner.squeezed;
  both.round = inner.form.empty() && outer.form.empty() && inner.scratches.empty() &&
               outer.scratches.empty() && constants.roller_scratches.empty() && constants.rim.empty();
  both.rim_waves = constants.rim.count;
  both.inner = &inner;
  both.outer = &outer;
  both.laminae = constants.laminae;
  both.roller_scratches = constants.roller_scratches;
  return both;
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
