// Rollers that touch their neighbours: linear equations of three unknowns each, in which a roller meets the
// one ahead, the one behind and no other, the last one being the neighbour of the first.
//
//     | A_1  U_1            D_1 |      Rollers but the last are eliminated in turn, D_1 and U_Z as a border;
//     their | D_2  A_2  U_2           |      number alone, not its square, sets what it costs. |      ... ...
//     ...      | | U_Z            D_Z  A_Z |
//
#pragma once

#include "mechanics/packs/aligned_array.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// One number of `pack`.
inline double& lane_of(Pack& pack, int lane) {
  return reinterpret_cast<double*>(&pack)[lane];
}

class RollerChain {
 public:
  /// A block for each of `rollers` >= 3 of them, `packs` packs in all.
  RollerChain(int rollers, int packs)
      : rollers_(rollers), own_(packs), ahead_(packs), behind_(packs), link_(rollers) {}

  /// Blocks kLanes rollers at once: the roller's own, by the neighbour ahead, by the one behind.
  using Blocks = Pack[3][3];
  Blocks& own(int pack) { return own_[pack].rows; }
  Blocks& ahead(int pack) { return ahead_[pack].rows; }
  Blocks& behind(int pack) { return behind_[pack].rows; }

  /// Prepares solve(). Without pivoting: blocks of 1 - g J are close to positive matrices.
  [[gnu::noinline]] void factor() {
    const int last = rollers_ - 1;
    Block final = block(own_, last), row = block(ahead_, last);  // of the last roller, by the one in turn
    for (int j = 0; j < last; ++j) {
      Link& link = link_[j];
      Block pivot = block(own_, j);
      link.by_last = j == 0 ? block(behind_, 0) : Block{};
      if (j == last - 1) {
        link.by_last += block(ahead_, j);
        row += block(behind_, last);
      }
      if (j > 0) {
        const Link& before = link_[j - 1];
        link.from_before = block(behind_, j) * before.inverse;
        pivot -= link.from_before * before.ahead;
        link.by_last -= link.from_before * before.by_last;
      }
      link.inverse = inverted(pivot);
      link.ahead = j == last - 1 ? Block{} : block(ahead_, j);
      link.into_last = row * link.inverse;
      final -= link.into_last * link.by_last;
      row = Block{};
      row -= link.into_last * link.ahead;
    }
    link_[last].inverse = inverted(final);
  }

  /// Replaces kColumns right-hand sides by their solutions: at(roller, row, column) is a number of them.
  template <int kColumns, class At>
  [[gnu::noinline]] void solve(const At& at) const {
    const int last = rollers_ - 1;
    using Columns = double[3][kColumns];
    const auto read = [&](int j, Columns& b) {
      for (int i = 0; i < 3; ++i)
        for (int c = 0; c < kColumns; ++c) b[i][c] = at(j, i, c);
    };
    const auto write = [&](int j, const Columns& b) {
      for (int i = 0; i < 3; ++i)
        for (int c = 0; c < kColumns; ++c) at(j, i, c) = b[i][c];
    };
    const auto take = [&](const Block& a, const Columns& x, Columns& from) {
      for (int i = 0; i < 3; ++i)
        for (int m = 0; m < 3; ++m)
          for (int c = 0; c < kColumns; ++c) from[i][c] -= a.a[i][m] * x[m][c];
    };
    const auto through = [&](const Block& a, const Columns& x, Columns& into) {
      for (int i = 0; i < 3; ++i)
        for (int c = 0; c < kColumns; ++c)
          into[i][c] = a.a[i][0] * x[0][c] + a.a[i][1] * x[1][c] + a.a[i][2] * x[2][c];
    };
    Columns before{}, now, end;
    read(last, end);
    for (int j = 0; j < last; ++j) {
      read(j, now);
      if (j > 0) take(link_[j].from_before, before, now);
      take(link_[j].into_last, now, end);
      write(j, now);
      __builtin_memcpy(before, now, sizeof before);
    }
    Columns of_last, next{};
    through(link_[last].inverse, end, of_last);
    write(last, of_last);
    for (int j = last - 1; j >= 0; --j) {
      read(j, now);
      take(link_[j].by_last, of_last, now);
      if (j < last - 1) take(link_[j].ahead, next, now);
      through(link_[j].inverse, now, next);
      write(j, next);
    }
  }

 private:
  struct Block {
    double a[3][3] = {};
    Block& operator+=(const Block& b) {
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) a[i][k] += b.a[i][k];
      return *this;
    }
    Block& operator-=(const Block& b) {
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) a[i][k] -= b.a[i][k];
      return *this;
    }
    friend Block operator*(const Block& x, const Block& y) {
      Block z;
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          z.a[i][k] = x.a[i][0] * y.a[0][k] + x.a[i][1] * y.a[1][k] + x.a[i][2] * y.a[2][k];
      return z;
    }
  };
  struct PackBlocks {
    Pack rows[3][3];
  };
  struct Link {
    Block inverse;      // of what is left of the roller's own block
    Block from_before;  // share of the row before it
    Block ahead;        // U
    Block by_last;      // column of the last roller
    Block into_last;    // share in the row of the last roller
  };

  static Block inverted(const Block& block) {
    const auto& a = block.a;
    const double c0 = a[1][1] * a[2][2] - a[1][2] * a[2][1], c1 = a[1][2] * a[2][0] - a[1][0] * a[2][2],
                 c2 = a[1][0] * a[2][1] - a[1][1] * a[2][0];
    const double s = 1.0 / (a[0][0] * c0 + a[0][1] * c1 + a[0][2] * c2);
    return {
        {{s * c0, s * (a[0][2] * a[2][1] - a[0][1] * a[2][2]), s * (a[0][1] * a[1][2] - a[0][2] * a[1][1])},
         {s * c1, s * (a[0][0] * a[2][2] - a[0][2] * a[2][0]), s * (a[0][2] * a[1][0] - a[0][0] * a[1][2])},
         {s * c2, s * (a[0][1] * a[2][0] - a[0][0] * a[2][1]), s * (a[0][0] * a[1][1] - a[0][1] * a[1][0])}}};
  }
  static Block block(AlignedArray<PackBlocks>& blocks, int roller) {
    Block one;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) one.a[i][k] = lane_of(blocks[roller / kLanes].rows[i][k], roller % kLanes);
    return one;
  }

  int rollers_;
  AlignedArray<PackBlocks> own_, ahead_, behind_;
  AlignedArray<Link> link_;
};

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
