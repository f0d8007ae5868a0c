// The matrix 1 - g J of a roller bearing, reduced to velocities: three unknowns for each roller and the seven
// velocities of the rings, with an open bore also that of its rotation, in the block-arrow form of
// mechanics/packs/block_arrow.hpp.
#pragma once

#include "mechanics/packs/block_arrow.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

inline constexpr int kRollerUnknowns = 3;  // radial speed, orbital speed, spin
inline constexpr int kRingUnknowns = 7;    // pin x y, bore x y, cage x y, cage rotation
inline constexpr int kOpenUnknowns = 8;    // and rotation of the bore
inline constexpr int kPin = 0, kBore = 2, kCage = 4, kTurn = 7;
inline constexpr int kRingRow = kSharedRow<kOpenUnknowns>;

/// Blocks of kLanes rollers. Ring rows: the pin's forces see the inner race only, and so on, so all columns
/// of the rings are kept but only the coupled ones are filled, up to `ring_end`.
struct RollerBlock : ElementBlock<kRollerUnknowns, kOpenUnknowns> {
  Pack rings[kOpenUnknowns][kOpenUnknowns];  // what the rollers add to each body's own block, else unset
  int ring_end = kCage;
};

using RingBlock = SharedBlock<kOpenUnknowns>;

/// Whether two unknowns of the rings belong to one body, pin, bore or cage.
constexpr bool same_body(int i, int k) {
  const auto body = [](int unknown) {
    return unknown == kTurn ? kBore / 2 : unknown < kCage ? unknown / 2 : 2;
  };
  return body(i) == body(k);
}

/// Adds what is left of the rollers of `block` once they are eliminated.
template <int kEnd>
void add_rollers(const RollerBlock& block, double (&into)[kOpenUnknowns][kRingRow]) {
  add_schur<kEnd>(
      block,
      [&](int i, int k, Register& share) {
        if (same_body(i, k)) share += block.rings[i][k].low + block.rings[i][k].high;
      },
      into);
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
