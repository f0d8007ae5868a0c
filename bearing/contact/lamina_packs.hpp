// Laminae of one contact, as many at once as the registers hold: d^(10/9) without logarithm and exponential.
#pragma once

#include "bearing/contact/lamina_kernel.hpp"
#include "mechanics/packs/powers.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

struct LaminaPack {
  Pack position, load, root;
};

inline LaminaPack lamina_pack(const double* position, const double* drop, double approach,
                              double end_displacement) {
  LaminaPack pack;
  pack.position = mechanics::ORBEARING_PACKS::load(position);
  const Pack depth = (approach + pack.position * end_displacement) - mechanics::ORBEARING_PACKS::load(drop);
  const Mask touching = depth > 0.0;
  pack.root = only(touching, ninth_root(only(touching, depth)));
  pack.load = only(touching, depth) * pack.root;
  return pack;
}

// Contribution of each lamina to the sums.
struct LaminaTerms {
  Pack load{}, end_load{}, by_approach{}, mixed{}, by_end_displacement{};
};

inline LaminaTerms operator+(const LaminaTerms& x, const LaminaTerms& y) {
  return {x.load + y.load, x.end_load + y.end_load, x.by_approach + y.by_approach, x.mixed + y.mixed,
          x.by_end_displacement + y.by_end_displacement};
}

inline LaminaTerms lamina_terms(const double* position, const double* drop, double approach,
                                double end_displacement) {
  const LaminaPack pack = lamina_pack(position, drop, approach, end_displacement);
  const Pack sloped = pack.root * pack.position;
  return {pack.load, pack.load * pack.position, pack.root, sloped, sloped * pack.position};
}

// Sums have one order in all instruction sets, so that they have the same bits: of sixteen laminae the first
// eight and the last eight are added, these eight to those of the sixteen before, in the end they are halved
// three times.
inline constexpr int kPacks = kLaminaPadding / kLanes, kHalf = kPacks > 1 ? kPacks / 2 : 1;

inline LaminaTerms sixteen_folded(const LaminaTerms& x) {
  const auto folded = [](const Pack& one) { return Pack{one.low + one.high, Register{}}; };
  return {folded(x.load), folded(x.end_load), folded(x.by_approach), folded(x.mixed),
          folded(x.by_end_displacement)};
}

inline LaminaSums lamina_sums(const double* position, const double* drop, int count, double approach,
                              double end_displacement) {
  LaminaTerms all[kHalf]{};
  for (int k = 0; k < count; k += kLaminaPadding)
    for (int i = 0; i < kHalf; ++i) {
      const auto terms = [&](int at) {
        return lamina_terms(position + at, drop + at, approach, end_displacement);
      };
      if constexpr (kPacks > 1)
        all[i] = all[i] + (terms(k + i * kLanes) + terms(k + (i + kHalf) * kLanes));
      else
        all[i] = all[i] + sixteen_folded(terms(k));
    }
  for (int i = 1; i < kHalf; ++i) all[0] = all[0] + all[i];
  return {sum(all[0].load), sum(all[0].end_load), sum(all[0].by_approach), sum(all[0].mixed),
          sum(all[0].by_end_displacement)};
}

inline void lamina_loads(const double* position, const double* drop, int count, double approach,
                         double end_displacement, double* load) {
  for (int k = 0; k < count; k += kLanes)
    store(lamina_pack(position + k, drop + k, approach, end_displacement).load, load + k);
}

inline constexpr LaminaKernel kLaminaKernel{lamina_sums, lamina_loads};

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
