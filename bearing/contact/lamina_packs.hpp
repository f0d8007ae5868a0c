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

inline LaminaSums lamina_sums(const double* position, const double* drop, int count, double approach,
                              double end_displacement) {
  Pack load{}, end_load{}, by_approach{}, mixed{}, by_end_displacement{};
  for (int k = 0; k < count; k += kLanes) {
    const LaminaPack pack = lamina_pack(position + k, drop + k, approach, end_displacement);
    const Pack sloped = pack.root * pack.position;
    load += pack.load;
    end_load += pack.load * pack.position;
    by_approach += pack.root;
    mixed += sloped;
    by_end_displacement += sloped * pack.position;
  }
  return {sum(load), sum(end_load), sum(by_approach), sum(mixed), sum(by_end_displacement)};
}

inline void lamina_loads(const double* position, const double* drop, int count, double approach,
                         double end_displacement, double* load) {
  for (int k = 0; k < count; k += kLanes)
    store(lamina_pack(position + k, drop + k, approach, end_displacement).load, load + k);
}

inline constexpr LaminaKernel kLaminaKernel{lamina_sums, lamina_loads};

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
