// The matrix 1 - g J of a roller bearing, reduced to velocities: three unknowns for each roller and the seven
// velocities of the rings, in the block-arrow form of mechanics/packs/block_arrow.hpp.
#pragma once

#include "mechanics/packs/block_arrow.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

inline constexpr int kRollerUnknowns = 3;  // radial speed, orbital speed, spin
inline constexpr int kRingUnknowns = 7;    // pin x y, bore x y, cage x y, cage rotation
inline constexpr int kPin = 0, kBore = 2, kCage = 4;
inline constexpr int kRingRow = kSharedRow<kRingUnknowns>;

/// Blocks of kLanes rollers. Ring rows: the pin's forces see the inner race only, and so on, so all columns
/// of the rings are kept but only the coupled ones are filled; `caged` says whether the cage's are in use.
struct RollerBlock : ElementBlock<kRollerUnknowns, kRingUnknowns> {
  Pack rings[kRingUnknowns][kRingUnknowns];  // what the rollers add to each body's own block, else unset
  bool caged = false;

  int ring_end() const { return caged ? kRingUnknowns : kCage; }
};

using RingBlock = SharedBlock<kRingUnknowns>;

/// Whether two unknowns of the rings belong to one body, pin, bore or cage.
constexpr bool same_body(int i, int k) {
  return (i < kCage ? i / 2 : 2) == (k < kCage ? k / 2 : 2);
}

/// Adds what is left of the rollers of `block` once they are eliminated.
template <int kEnd>
void add_rollers(const RollerBlock& block, double (&into)[kRingUnknowns][kRingRow]) {
  add_schur<kEnd>(
      block,
      [&](int i, int k, Register& share) {
        if (same_body(i, k)) share += block.rings[i][k].low + block.rings[i][k].high;
      },
      into);
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
