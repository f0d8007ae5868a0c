// Contacts of rollers on laminae that stay level, one operating point a lane, for PackEquilibrium.
//
// Lanes do not meet, and nothing here or there depends on how many of them there are: without fused
// operations all instruction sets give the same bits.
#pragma once

#include "bearing/equilibrium/equilibrium_packs.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

/// Load of one contact [N] and its slope over 10/9 [N^0.1].
struct CutContact {
  Pack load{}, root{};
};

class LevelContacts {
 public:
  static constexpr double kBend =
      1.0;  // of the law of a contact without laminae that come to bear, from above
  static constexpr double kOnset = 0.01;  // share of a step's load that these bear, as a rule

  explicit LevelContacts(const EquilibriumConstants& constants)
      : c_(constants), load_at_drop_(constants.laminae) {
    for (int k = 0; k < c_.laminae; ++k) load_at_drop_[k] = contact(spread(c_.drop[k])).load.low[0];
  }

  ContactPair loads(const Pack& x, const Pack& y) const {
    const CutContact p = contact(x), q = contact(y);
    return {p.load, q.load, p.root, q.root};
  }

  /// Loads of all laminae at the balance.
  void put(const AlignedArray<RollerUnknown>& rollers, int count, const PlaneVector& u, double half_clearance,
           int first, const EquilibriumOutput& output) const {
    if (output.lamina_loads == nullptr) return;
    for (int j = 0; j < count; ++j) {
      const RollerUnknown& roller = rollers[j];
      const Pack approach = -half_clearance - (u.x * roller.e_x + u.y * roller.e_y);
      const Mask squeezed = roller.squeeze > 0.0;
      const Pack x = only(squeezed, roller.x + roller.step);
      const Pack y = select(squeezed, approach - x, approach_under(absolute(roller.inertial), squeezed));
      const Mask inner_alone = roller.inertial > 0.0;  // feels the squeeze alone
      put_laminae(select(inner_alone, x, y), output.lamina_loads + j * kBlock + first, count);
      put_laminae(select(inner_alone, y, x), output.lamina_loads + (c_.laminae * count + j) * kBlock + first,
                  count);
    }
  }

 private:
  static constexpr int kMostSteps = 60;

  CutContact contact(const Pack& approach) const {
    CutContact sum;
    for (int k = 0; k < c_.laminae; ++k) {
      const Pack depth = larger(approach - c_.drop[k], Pack{});
      if (!any(depth > 0.0)) break;
      const Pack root = c_.share[k] * ninth_root(depth);
      sum.load += depth * root;
      sum.root += root;
    }
    return sum;
  }

  /// The approach under `load`, by Newton's method from above, where the load is convex: it falls towards it,
  /// from the first drop at which the load is larger. Not sought where `known`.
  Pack approach_under(const Pack& load, const Mask& known) const {
    const Mask sought = (load > 0.0) & ~known;
    if (!any(sought)) return Pack{};
    Pack approach = larger(load, spread(1.0)) + c_.drop[c_.laminae - 1];  // x <= x^(10/9) from 1 on
    for (int k = c_.laminae - 1; k > 0; --k)
      approach = select(spread(load_at_drop_[k]) > load, spread(c_.drop[k]), approach);
    approach = only(sought, approach);
    Mask moving = sought;
    for (int i = 0; i < kMostSteps && any(moving); ++i) {
      const CutContact now = contact(approach);
      const Pack step = kLineApproachExponent * (now.load - load) / larger(now.root, spread(1e-200));
      moving = moving & (step > 1e-14 * approach);
      approach -= only(moving, step);
    }
    return approach;
  }

  void put_laminae(const Pack& approach, double* to, int count) const {
    for (int k = 0; k < c_.laminae; ++k) {
      const Pack depth = larger(approach - c_.drop[k], Pack{});
      store(any(depth > 0.0) ? only(depth > 0.0, depth * ninth_root(depth)) : Pack{},
            to + k * count * kBlock);
    }
  }

  EquilibriumConstants c_;
  AlignedArray<double> load_at_drop_;  // [N]  (laminae)
};

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
