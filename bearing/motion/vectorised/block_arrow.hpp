// The matrix 1 - g J of a bearing, reduced to velocities: one 3 x 3 block for each roller, its coupling with
// the seven velocities of the rings, and the rings' own 7 x 7 block. Rollers are eliminated first (Schur
// complement).
#pragma once

#include "mechanics/packs/sums.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

inline constexpr int kRollerUnknowns = 3;  // radial speed, orbital speed, spin
inline constexpr int kRingUnknowns = 7;    // pin x y, bore x y, cage x y, cage rotation
inline constexpr int kPin = 0, kBore = 2, kCage = 4;

/// Blocks of kLanes rollers. Ring rows: the pin's forces see the inner race only, and so on, so all columns
/// of the rings are kept but only the coupled ones are filled; `caged` says whether the cage's are in use.
struct RollerBlock {
  Pack own[kRollerUnknowns][kRollerUnknowns];
  Pack by_ring[kRollerUnknowns][kRingUnknowns];  // rows of the roller, columns of the rings
  Pack of_ring[kRingUnknowns][kRollerUnknowns];  // rows of the rings, columns of the roller
  Pack rings[kRingUnknowns][kRingUnknowns];      // what the rollers add to each body's own block, else unset
  bool caged = false;

  int ring_end() const { return caged ? kRingUnknowns : kCage; }
};

/// Replaces `own` by its inverse and `by_ring` by own^-1 by_ring, of the first kEnd ring unknowns.
template <int kEnd>
void eliminate(RollerBlock& block) {
  Pack(&a)[3][3] = block.own;
  const Pack c00 = a[1][1] * a[2][2] - a[1][2] * a[2][1];
  const Pack c01 = a[1][2] * a[2][0] - a[1][0] * a[2][2];
  const Pack c02 = a[1][0] * a[2][1] - a[1][1] * a[2][0];
  const Pack scale = 1.0 / (a[0][0] * c00 + a[0][1] * c01 + a[0][2] * c02);
  const Pack inverse[3][3] = {{scale * c00, scale * (a[0][2] * a[2][1] - a[0][1] * a[2][2]),
                               scale * (a[0][1] * a[1][2] - a[0][2] * a[1][1])},
                              {scale * c01, scale * (a[0][0] * a[2][2] - a[0][2] * a[2][0]),
                               scale * (a[0][2] * a[1][0] - a[0][0] * a[1][2])},
                              {scale * c02, scale * (a[0][1] * a[2][0] - a[0][0] * a[2][1]),
                               scale * (a[0][0] * a[1][1] - a[0][1] * a[1][0])}};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) a[i][k] = inverse[i][k];
#pragma GCC unroll 8
  for (int k = 0; k < kEnd; ++k) {
    const Pack b0 = block.by_ring[0][k], b1 = block.by_ring[1][k], b2 = block.by_ring[2][k];
    for (int i = 0; i < 3; ++i) block.by_ring[i][k] = a[i][0] * b0 + a[i][1] * b1 + a[i][2] * b2;
  }
}

/// Whether two unknowns of the rings belong to one body, pin, bore or cage.
constexpr bool same_body(int i, int k) {
  return (i < kCage ? i / 2 : 2) == (k < kCage ? k / 2 : 2);
}

/// Length of a row of the rings' block, so that it fills registers.
inline constexpr int kRingRow = 8;

/// Adds rings - of_ring own^-1 by_ring of an eliminated block, summed over its rollers.
template <int kEnd>
void add_schur(const RollerBlock& block, double (&into)[kRingUnknowns][kRingRow]) {
#pragma GCC unroll 8
  for (int i = 0; i < kEnd; ++i) {
#pragma GCC unroll 8
    for (int first = 0; first < kEnd; first += kRegisterLanes) {
      Register shares[kRegisterLanes];
#pragma GCC unroll 8
      for (int k = first; k < first + kRegisterLanes; ++k) {
        Register& share = shares[k - first];
        share = Register{};
        if (k >= kEnd) continue;
        const Pack product = block.of_ring[i][0] * block.by_ring[0][k] +
                             block.of_ring[i][1] * block.by_ring[1][k] +
                             block.of_ring[i][2] * block.by_ring[2][k];
        share = -(product.low + product.high);
        if (same_body(i, k)) share += block.rings[i][k].low + block.rings[i][k].high;
      }
      const Register all = sums(shares);
      for (int n = 0; n < kRegisterLanes; ++n) into[i][first + n] += all[n];
    }
  }
}

/// Small dense matrix with its factors; no pivoting, since 1 - g J is close to a positive matrix.
struct RingBlock {
  double a[kRingUnknowns][kRingRow] = {};

  /// Of the first kPivots unknowns; the block of the others is then what their elimination leaves.
  template <int kPivots = kRingUnknowns>
  bool factor() {
    for (int p = 0; p < kPivots; ++p) {
      const double inverse = 1.0 / a[p][p];
      if (!(__builtin_fabs(inverse) < 1e300)) return false;
      a[p][p] = inverse;
      for (int i = p + 1; i < kRingUnknowns; ++i) {
        const double share = a[i][p] * inverse;
        a[i][p] = share;
        for (int k = p + 1; k < kRingUnknowns; ++k) a[i][k] -= share * a[p][k];
      }
    }
    return true;
  }

  void solve(double (&b)[kRingUnknowns]) const {
    for (int i = 1; i < kRingUnknowns; ++i)
      for (int k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    for (int i = kRingUnknowns - 1; i >= 0; --i) {
      for (int k = i + 1; k < kRingUnknowns; ++k) b[i] -= a[i][k] * b[k];
      b[i] *= a[i][i];
    }
  }
};

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
