// The linear algebra of a bearing whose bore is open: all else is eliminated, the bore's velocity last.
// Included by the file of each instruction set only.
#pragma once

#include "bearing/motion/vectorised/pack_solve.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Unknowns of the rings in the order of their elimination.
inline constexpr int kBoreLast[kOpenUnknowns] = {kPin,      kPin + 1, kCage,     kCage + 1,
                                                 kCage + 2, kBore,    kBore + 1, kTurn};
inline constexpr int kInner = kOpenUnknowns - 3;  // all but the bore

[[gnu::flatten]] inline bool PackEngine::factor_open(double g, bool rotating, PortMatrix& port) {
  rotating_ = rotating && c_.caged;
  if (c_.caged)
    assemble<true, true>(g);
  else
    assemble_without_cage<true>(g);
  const RingBlock given = rings_;
  for (int i = 0; i < kOpenUnknowns; ++i)
    for (int k = 0; k < kOpenUnknowns; ++k) rings_.a[i][k] = given.a[kBoreLast[i]][kBoreLast[k]];
  if (!rings_.factor<kInner>()) return false;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) port.a[i][k] = bore_scale(i) * rings_.a[kInner + i][kInner + k];
  return true;
}

[[gnu::flatten]] inline void PackEngine::reduce(const double* rhs, double* k, double (&force)[3]) {
  if (c_.caged)
    reduce_open<true>(rhs, k, force);
  else
    reduce_open<false>(rhs, k, force);
}

template <bool Caged>
void PackEngine::reduce_open(const double* rhs, double* k, double (&force)[3]) {
  double b[kOpenUnknowns];
  if constexpr (Caged)
    reduce_rollers<true, true>(rhs, k, b);
  else
    reduce_without_cage<true>(rhs, k, b);
  for (int i = 0; i < kOpenUnknowns; ++i) {
    double sum = b[kBoreLast[i]];
    for (int m = 0; m < i && m < kInner; ++m) sum -= rings_.a[i][m] * reduced_[m];
    reduced_[i] = sum;
  }
  for (int i = 0; i < 3; ++i) force[i] = bore_scale(i) * reduced_[kInner + i];
}

[[gnu::flatten]] inline void PackEngine::complete(const double* rhs, const double (&rate)[3],
                                                  double* k) const {
  if (c_.caged)
    complete_open<true>(rhs, rate, k);
  else
    complete_open<false>(rhs, rate, k);
}

template <bool Caged>
void PackEngine::complete_open(const double* rhs, const double (&rate)[3], double* k) const {
  double y[kOpenUnknowns];
  for (int i = 0; i < kInner; ++i) y[i] = reduced_[i];
  for (int i = 0; i < 3; ++i) y[kInner + i] = rate[i];
  for (int i = kInner - 1; i >= 0; --i) {
    for (int m = i + 1; m < kOpenUnknowns; ++m) y[i] -= rings_.a[i][m] * y[m];
    y[i] *= rings_.a[i][i];
  }
  double b[kOpenUnknowns];
  for (int i = 0; i < kOpenUnknowns; ++i) b[kBoreLast[i]] = y[i];
  complete_rollers<Caged>(rhs, b, k);
}

/// The force on the roller changes with its place relative to the bore, and the bore feels the opposite: the
/// slope by the bore's own place is that of the force on the roller by the roller's.
inline BoreSlopes PackEngine::bore_slopes() const {
  Pack position[2][2]{}, velocity[2][2]{};
  for (int p = 0; p < packs_; ++p) {
    const RollerPack& at = linear_[p];
    const auto add = [&](const Pack(&slopes)[3][2], Pack(&into)[2][2]) {
      // R K R^T with R = [cosine -sine; sine cosine].
      const Pair r = to_plane(at, slopes[0][0], slopes[1][0]), t = to_plane(at, slopes[0][1], slopes[1][1]);
      const Pair x = to_plane(at, r.x, t.x), y = to_plane(at, r.y, t.y);
      into[0][0] += x.x;
      into[0][1] += x.y;
      into[1][0] += y.x;
      into[1][1] += y.y;
    };
    add(at.outer.by_position, position);
    add(at.outer.by_velocity, velocity);
  }
  BoreSlopes slopes;
  const GuidanceDual* land[2] = {&land_x_, &land_y_};
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k) {
      slopes.by_position[i][k] = sum(position[i][k]);
      slopes.by_velocity[i][k] = sum(velocity[i][k]);
      if (!c_.land.present || !c_.land.on_bore) continue;
      slopes.by_position[i][k] += land[i]->by(k);
      slopes.by_velocity[i][k] += land[i]->by(2 + k);
    }
  return slopes;
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
