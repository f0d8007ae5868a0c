// A matrix of block-arrow form: many like elements, each coupled with a few unknowns that all of them share
// and with nothing else. One block for each element, its coupling with the shared unknowns, and their own
// block. Elements are eliminated first (Schur complement). Blocks of any size; kLanes elements at once.
#pragma once

#include "mechanics/packs/sums.hpp"

namespace orbearing::mechanics::ORBEARING_PACKS {

/// kLanes elements of kOwn unknowns each, and kShared unknowns of all.
template <int kOwn, int kShared>
struct ElementBlock {
  Pack own[kOwn][kOwn];
  Pack by_shared[kOwn][kShared];  // rows of the element, columns of the shared unknowns
  Pack of_shared[kShared][kOwn];  // rows of the shared unknowns, columns of the element
};

namespace detail {
inline void invert(Pack (&a)[3][3]) {
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
}

// In its own memory, without pivoting: blocks of 1 - g J are close to positive matrices.
template <int n>
void invert(Pack (&a)[n][n]) {
  for (int p = 0; p < n; ++p) {
    const Pack pivot = 1.0 / a[p][p];
    a[p][p] = spread(1.0);
    for (int k = 0; k < n; ++k) a[p][k] = a[p][k] * pivot;
    for (int i = 0; i < n; ++i) {
      if (i == p) continue;
      const Pack share = a[i][p];
      a[i][p] = Pack{};
      for (int k = 0; k < n; ++k) a[i][k] -= share * a[p][k];
    }
  }
}

template <int n>
Pack row_times_column(const Pack (&row)[n], const Pack* column, int stride) {
  Pack sum = row[0] * column[0];
#pragma GCC unroll 8
  for (int m = 1; m < n; ++m) sum = sum + row[m] * column[m * stride];
  return sum;
}
}  // namespace detail

/// Replaces `own` by its inverse and `by_shared` by own^-1 by_shared, of the first kEnd shared unknowns.
template <int kEnd, int kOwn, int kShared>
void eliminate(ElementBlock<kOwn, kShared>& block) {
  detail::invert(block.own);
#pragma GCC unroll 16
  for (int k = 0; k < kEnd; ++k) {
    Pack b[kOwn];
    for (int i = 0; i < kOwn; ++i) b[i] = block.by_shared[i][k];
    for (int i = 0; i < kOwn; ++i) block.by_shared[i][k] = detail::row_times_column(block.own[i], b, 1);
  }
}

/// Length of a row of kShared unknowns, so that it fills registers.
template <int kShared>
inline constexpr int kSharedRow = (kShared + 7) / 8 * 8;

/// Adds direct - of_shared own^-1 by_shared of an eliminated block, summed over its elements. `direct(i, k,
/// sum)` adds the elements' own contribution to that entry to a register.
template <int kEnd, int kOwn, int kShared, class Direct>
void add_schur(const ElementBlock<kOwn, kShared>& block, const Direct& direct,
               double (&into)[kShared][kSharedRow<kShared>]) {
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
        const Pack product = detail::row_times_column(block.of_shared[i], &block.by_shared[0][k], kShared);
        share = -(product.low + product.high);
        direct(i, k, share);
      }
      const Register all = sums(shares);
      for (int n = 0; n < kRegisterLanes; ++n) into[i][first + n] += all[n];
    }
  }
}

/// The shared unknowns' own block with its factors; no pivoting, since 1 - g J is close to a positive matrix.
template <int kShared>
struct SharedBlock {
  double a[kShared][kSharedRow<kShared>] = {};

  /// Factors the first kPivots unknowns; the block of the others then is their Schur complement.
  template <int kPivots = kShared>
  bool factor() {
    return factor(kPivots, kShared);
  }
  /// Factors the first `pivots` unknowns out of `end`.
  bool factor(int pivots, int end) {
    for (int p = 0; p < pivots; ++p) {
      const double inverse = 1.0 / a[p][p];
      if (!(__builtin_fabs(inverse) < 1e300)) return false;
      a[p][p] = inverse;
      for (int i = p + 1; i < end; ++i) {
        const double share = a[i][p] * inverse;
        a[i][p] = share;
        for (int k = p + 1; k < end; ++k) a[i][k] -= share * a[p][k];
      }
    }
    return true;
  }

  void solve(double (&b)[kShared], int end = kShared) const {
    for (int i = 1; i < end; ++i)
      for (int k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    for (int i = end - 1; i >= 0; --i) {
      for (int k = i + 1; k < end; ++k) b[i] -= a[i][k] * b[k];
      b[i] *= a[i][i];
    }
  }
};

/// The inverse of the shared unknowns' own block: for several right-hand sides with few unknowns, whose
/// solution by factors waits for itself all the time.
template <int kShared>
class SharedInverse {
 public:
  /// Inverts `block`, without pivoting. False if it is singular.
  bool take(const SharedBlock<kShared>& block) {
    Row row[kShared];
    __builtin_memcpy(row, block.a, sizeof row);
    bool regular = true;
    eliminate<0>(row, regular);
    for (int i = 0; i < kShared; ++i)
      for (int k = 0; k < kShared; ++k) column_[k][i] = row[i][k];
    return regular;
  }

  /// Replaces `b` by its solution.
  void times(double (&b)[kShared]) const {
    Row even{}, odd{};
#pragma GCC unroll 8
    for (int k = 0; k < kShared; k += 2) {
      even += b[k] * column(k);
      if (k + 1 < kShared) odd += b[k + 1] * column(k + 1);
    }
    even += odd;
    __builtin_memcpy(b, &even, sizeof b);
  }

 private:
  static_assert(kShared <= 8, "a row is eight numbers");
  using Row = double __attribute__((vector_size(64)));
  using Positions = long long __attribute__((vector_size(64)));
  static constexpr Positions kPositions = {0, 1, 2, 3, 4, 5, 6, 7};

  // Unknown p and those after it, all rows of the others included (Gauss, Jordan).
  template <int p>
  static void eliminate(Row (&row)[kShared], bool& regular) {
    const Positions own = kPositions == static_cast<long long>(p);
    const auto spread_own = [](const Row& x) {
      return __builtin_shufflevector(x, x, p, p, p, p, p, p, p, p);
    };
    const double inverse = 1.0 / spread_own(row[p])[0];
    regular = regular && __builtin_fabs(inverse) < 1e300;
    row[p] = inverse * (own ? Row{} + 1.0 : row[p]);
#pragma GCC unroll 8
    for (int i = 0; i < kShared; ++i) {
      if (i == p) continue;
      const Row share = spread_own(row[i]);
      row[i] = (own ? Row{} : row[i]) - share * row[p];
    }
    if constexpr (p + 1 < kShared) eliminate<p + 1>(row, regular);
  }

  Row column(int k) const {
    Row column;
    __builtin_memcpy(&column, column_[k], sizeof column);
    return column;
  }

  alignas(64) double column_[kShared][8] = {};
};

}  // namespace orbearing::mechanics::ORBEARING_PACKS
