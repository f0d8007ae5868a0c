// Matrix of the stages of a linearly implicit method and their solution. Included by the file of each
// instruction set only.
//
// A contact's wrench on its ball follows the motion of the other body relative to the ball at the ball's
// centre, t, by a matrix Z = g dw/dt + g^2 dw/d(position), the same whichever of both moves: with B the
// motion of the body at the ball's centre by its own unknowns,
//   ball:  [M + Z] k - Z B k_body,     body:  -B^T Z k + [M_body + B^T Z B] k_body
//
// All rows are forces and moments: the ball's masses are on its diagonal.
#pragma once

#include "bearing/motion/balls/pack_engine.hpp"

namespace orbearing::bearing::balls::ORBEARING_PACKS {

/// Z in the ball's axes: force (rows 0 to 2) and moment (3 to 5) by velocity and turning.
struct Impedance {
  Pack by[kBallUnknowns][kBallUnknowns];
};

inline Impedance impedance(const ContactSlopes<Pack>& s, double g,
                           const PocketFilmSlopes<Pack>* film = nullptr) {
  // In the axes (n, along, across) first, about the contact.
  Pack z[6][6]{};
  const Pack load = g * s.load_by_speed + (g * g) * s.load_by_approach;
  for (int i = 0; i < 6; ++i) z[i][0] = -(s.per_load[i] * load);
  constexpr int row[4] = {1, 2, 5, 3};  // along, across, rolling, spin
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) z[row[i]][row[k]] += g * s.friction.by[i][k];
  z[2][2] += (g * g) * s.rotating_stiffness;
  // About the ball's centre: turning about across moves the contact along, turning about along moves it back
  // across; forces there turn the ball likewise.
  for (int i = 0; i < 6; ++i) {
    z[i][5] += s.arm * z[i][1];
    z[i][4] -= s.arm * z[i][2];
  }
  for (int k = 0; k < 6; ++k) {
    z[5][k] += s.arm * z[1][k];
    z[4][k] -= s.arm * z[2][k];
  }
  if (film != nullptr) {
    z[0][0] += g * film->by_speed + (g * g) * film->by_approach;
    z[0][1] -= g * film->by_along;
    z[0][2] -= g * film->by_across;
    z[0][4] -= g * film->by_turning_along;
    z[0][5] -= g * film->by_turning_across;
    z[1][1] += g * film->along;
    z[2][2] += g * film->across;
    z[4][4] += g * film->rotating;
    z[5][5] += g * film->rotating;
  }
  const Pack r[3][3] = {{s.axes.normal.x, s.axes.along.x, s.axes.across.x},
                        {s.axes.normal.y, s.axes.along.y, s.axes.across.y},
                        {s.axes.normal.z, s.axes.along.z, s.axes.across.z}};
  Impedance result;
  for (int bi = 0; bi < 6; bi += 3)
    for (int bk = 0; bk < 6; bk += 3) {
      Pack half[3][3];
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          half[i][k] = r[i][0] * z[bi][bk + k] + r[i][1] * z[bi + 1][bk + k] + r[i][2] * z[bi + 2][bk + k];
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          result.by[bi + i][bk + k] = half[i][0] * r[k][0] + half[i][1] * r[k][1] + half[i][2] * r[k][2];
    }
  return result;
}

/// Puts the coupling of one body with the balls into `block` from its unknown `first` on, and adds B^T Z B,
/// summed over the balls, to the bodies' own block.
template <int kUnknowns>
void couple(const Impedance& z, const BodyColumns& b, const Mask& here, int first,
            ElementBlock<kBallUnknowns, kShared>& block, SharedBlock<kShared>& shared) {
  for (int k = 0; k < kUnknowns; ++k) {
    Pack column[6], row[6];
    for (int i = 0; i < 6; ++i) {
      Pack by = z.by[i][0] * b.by[0][k], of = b.by[0][k] * z.by[0][i];
      for (int m = 1; m < 6; ++m) {
        by = by + z.by[i][m] * b.by[m][k];
        of = of + b.by[m][k] * z.by[m][i];
      }
      column[i] = only(here, by);
      row[i] = only(here, of);
      block.by_shared[i][first + k] = -column[i];
      block.of_shared[first + k][i] = -row[i];
    }
    for (int i = 0; i < kUnknowns; ++i) {
      Pack own = b.by[0][i] * column[0];
      for (int m = 1; m < 6; ++m) own = own + b.by[m][i] * column[m];
      shared.a[first + i][first + k] += sum(own);
    }
  }
}

template <int kEnd>
void PackEngine::build_block(int p, double g) {
  const BallPack& at = linear_[p];
  const Mask here = present(p);
  auto& block = block_[p];
  const Impedance inner = impedance(at.inner, g), outer = impedance(at.outer, g);
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k) block.own[i][k] = only(here, inner.by[i][k] + outer.by[i][k]);
  couple<kRingUnknowns>(inner, columns_of(at.ball, at.from_inner), here, kInner, block, shared_);
  if constexpr (kEnd > kOuter)
    couple<kRingUnknowns>(outer, columns_of(at.ball, at.from_outer), here, kOuter, block, shared_);
  if (at.caged) {
    const Impedance pocket = impedance(at.pocket, g, c_.pocket.film.present() ? &at.film : nullptr);
    for (int i = 0; i < 6; ++i)
      for (int k = 0; k < 6; ++k) block.own[i][k] += only(here, pocket.by[i][k]);
    couple<kCageUnknowns>(pocket, columns_of(at.ball, at.from_cage), here, kCage, block, shared_);
  } else {
    for (int i = 0; i < 6; ++i)
      for (int k = 0; k < kCageUnknowns; ++k)
        block.by_shared[i][kCage + k] = block.of_shared[kCage + k][i] = Pack{};
  }
  for (int i = 0; i < 3; ++i) {
    block.own[i][i] += c_.mass;
    block.own[3 + i][3 + i] += c_.inertia;
  }
}

inline void PackEngine::add_lands(double g) {
  if (!c_.land.present) return;
  const int ring = c_.land.on_outer ? kOuter : kInner;
  // Unknowns of a body by the two components of the offset at a land: its centre, its axis times position.
  for (int side = 0; side < 2; ++side) {
    const double position = side == 0 ? -c_.land.offset : c_.land.offset;
    for (int i = 0; i < 3; ++i) {
      const RegisterDual& force = land_[side][i];
      const double by[2] = {g * (slope_by(force, 2) + g * slope_by(force, 0)),
                            g * (slope_by(force, 3) + g * slope_by(force, 1))};
      for (int k = 0; k < 2; ++k) {
        const auto put = [&](int row, double row_share, int column, double share) {
          shared_.a[row][column] -= row_share * share * by[k];
        };
        const auto into = [&](int row, double row_share) {
          put(row, row_share, kCage + k, 1.0);
          put(row, row_share, kCage + 3 + k, position);
          if (ring >= shared_end()) return;
          put(row, row_share, ring + k, -1.0);
          put(row, row_share, ring + 3 + k, -position);
        };
        if (i == 2) {
          into(kCage + 5, 1.0);
          continue;
        }
        into(kCage + i, 1.0);
        into(kCage + 3 + i, position);
        if (ring >= shared_end()) continue;
        into(ring + i, -1.0);
        into(ring + 3 + i, -position);
      }
    }
    shared_.a[kCage + 5][kCage + 5] -= g * slope_by(land_[side][2], 4);
  }
}

inline void PackEngine::add_bodies(double g) {
  const auto add = [&](int first, const BodyNumbers& body) {
    // A held body does not move: its rows are its own.
    const bool held = !(body.mass > 0.0);
    for (int i = 0; i < kRingUnknowns; ++i)
      shared_.a[first + i][first + i] += held ? 1e30 : i < 3 ? body.mass : body.across;
  };
  add(kCage, c_.cage);
  shared_.a[kCage + 5][kCage + 5] += c_.cage.polar;
  add(kInner, c_.inner_ring);
  if (shared_end() > kOuter) add(kOuter, c_.outer_ring);
  add_lands(g);
}

template <int kEnd>
bool PackEngine::assemble(double g) {
  g_ = g;
  shared_ = SharedBlock<kShared>{};
  for (int p = 0; p < packs_; ++p) {
    build_block<kEnd>(p, g);
    eliminate<kEnd>(block_[p]);
    add_schur<kEnd>(
        block_[p], [](int, int, Register&) {}, shared_.a);
  }
  add_bodies(g);
  return shared_.factor(kEnd, kEnd);
}

inline bool PackEngine::factor(double g) {
  return shared_end() > kOuter ? assemble<kShared>(g) : assemble<kOuter>(g);
}

/// Change of a contact's wrench on the ball when only positions move: the other body's point by `shift`
/// relative to the ball.
inline BallWrench<Pack> shifted(const ContactSlopes<Pack>& s, const Triple<Pack>& shift) {
  const Pack along_normal = dot(shift, s.axes.normal), across = dot(shift, s.axes.across);
  const Pack load = s.load_by_approach * along_normal;
  const Pack force[3] = {-(s.per_load[0] * load), -(s.per_load[1] * load),
                         s.rotating_stiffness * across - s.per_load[2] * load};
  const Pack moment[3] = {-(s.per_load[3] * load), -(s.per_load[4] * load) - s.arm * force[2],
                          -(s.per_load[5] * load) + s.arm * force[1]};
  return {
      scaled(force[0], s.axes.normal) + scaled(force[1], s.axes.along) + scaled(force[2], s.axes.across),
      scaled(moment[0], s.axes.normal) + scaled(moment[1], s.axes.along) + scaled(moment[2], s.axes.across)};
}

/// Motion at the ball's centre of a body whose unknowns change by `by`.
inline Triple<Pack> moved(const BodyColumns& b, const double* by, int unknowns) {
  Pack v[3]{};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < unknowns; ++k) v[i] += b.by[i][k] * by[k];
  return {v[0], v[1], v[2]};
}

/// Adds -B^T w to the rows of a body.
inline void react_on(const BodyColumns& b, const BallWrench<Pack>& w, const Mask& here, int unknowns,
                     double* rows) {
  const Pack part[6] = {w.force.x, w.force.y, w.force.z, w.moment.x, w.moment.y, w.moment.z};
  for (int k = 0; k < unknowns; ++k) {
    Pack total = b.by[0][k] * part[0];
    for (int i = 1; i < 6; ++i) total = total + b.by[i][k] * part[i];
    rows[k] -= sum(only(here, total));
  }
}

// The same for the film's load, by positions only.
inline void PackEngine::add_film(const BallPack& at, const BodyColumns& columns, const double* cage,
                                 const Triple<Pack>& own, const Mask& here, double* rows,
                                 BallWrench<Pack>& sum) const {
  const Triple<Pack>& normal = at.pocket.axes.normal;
  const Pack load = at.film.by_approach * dot(moved(columns, cage, kCageUnknowns) - own, normal);
  const BallWrench<Pack> change{scaled(g_ * load, normal), {}};
  react_on(columns, change, here, kCageUnknowns, rows);
  sum += change;
}

// k_place = b_place + g k_velocity, so that velocities see g (dw/dplace) b_place on their right-hand side.
inline void PackEngine::solve(const double* rhs, double* k) const {
  const double* cage = rhs + layout_.cage();
  const double* inner = rhs + layout_.inner();
  const double* outer = rhs + layout_.outer();
  const int end = shared_end();
  double b[kShared]{};
  for (int p = 0; p < packs_; ++p) {
    const BallPack& at = linear_[p];
    const Mask here = present(p);
    const auto& block = block_[p];
    const Triple<Pack> own{entry(rhs, 0, p), at.ball.radius * entry(rhs, 1, p), entry(rhs, 2, p)};
    BallWrench<Pack> sum{};
    const auto add = [&](const ContactSlopes<Pack>& slopes, const Triple<Pack>& d, const double* by,
                         int unknowns, double* rows) {
      const BodyColumns columns = columns_of(at.ball, d);
      BallWrench<Pack> change = shifted(slopes, moved(columns, by, unknowns) - own);
      change.force = scaled(g_, change.force);
      change.moment = scaled(g_, change.moment);
      react_on(columns, change, here, unknowns, rows);
      sum += change;
    };
    add(at.inner, at.from_inner, inner, kRingUnknowns, b + kInner);
    add(at.outer, at.from_outer, outer, kRingUnknowns, b + kOuter);
    if (at.caged) {
      add(at.pocket, at.from_cage, cage, kCageUnknowns, b + kCage);
      if (c_.pocket.film.present())
        add_film(at, columns_of(at.ball, at.from_cage), cage, own, here, b + kCage, sum);
    }
    const Pack r[6] = {c_.mass * entry(rhs, 3, p) + sum.force.x,
                       c_.mass * at.ball.radius * entry(rhs, 4, p) + sum.force.y,
                       c_.mass * entry(rhs, 5, p) + sum.force.z,
                       c_.inertia * entry(rhs, 6, p) + sum.moment.x,
                       c_.inertia * entry(rhs, 7, p) + sum.moment.y,
                       c_.inertia * entry(rhs, 8, p) + sum.moment.z};
    Pack y[6];
    for (int i = 0; i < 6; ++i) {
      y[i] = only(here, mechanics::ORBEARING_PACKS::detail::row_times_column(block.own[i], r, 1));
      put(y[i], k, 3 + i, p);
    }
    for (int i = 0; i < end; ++i) {
      Pack share = block.of_shared[i][0] * y[0];
      for (int m = 1; m < 6; ++m) share = share + block.of_shared[i][m] * y[m];
      b[i] -= mechanics::ORBEARING_PACKS::sum(share);
    }
  }
  const auto add_body = [&](int first, const BodyNumbers& body, const double* given, int unknowns) {
    const bool held = !(body.mass > 0.0);
    for (int i = 0; i < kRingUnknowns; ++i)
      b[first + i] += held ? 0.0 : (i < 3 ? body.mass : body.across) * given[unknowns + i];
  };
  add_body(kCage, c_.cage, cage, kCageUnknowns);
  b[kCage + 5] += c_.cage.polar * cage[2 * kCageUnknowns - 1];
  add_body(kInner, c_.inner_ring, inner, kRingUnknowns);
  if (end > kOuter) add_body(kOuter, c_.outer_ring, outer, kRingUnknowns);
  if (c_.land.present) {
    const int ring = c_.land.on_outer ? kOuter : kInner;
    const double* guide = c_.land.on_outer ? outer : inner;
    for (int side = 0; side < 2; ++side) {
      const double position = side == 0 ? -c_.land.offset : c_.land.offset;
      const double x = cage[0] - guide[0] + position * (cage[3] - guide[3]);
      const double y = cage[1] - guide[1] + position * (cage[4] - guide[4]);
      for (int i = 0; i < 3; ++i) {
        const double force = g_ * (slope_by(land_[side][i], 0) * x + slope_by(land_[side][i], 1) * y);
        if (i == 2) {
          b[kCage + 5] += force;
          continue;
        }
        b[kCage + i] += force;
        b[kCage + 3 + i] += position * force;
        b[ring + i] -= force;
        b[ring + 3 + i] -= position * force;
      }
    }
  }
  shared_.solve(b, end);
  for (int i = end; i < kShared; ++i) b[i] = 0.0;
  const auto put_body = [&](int at, int first, int unknowns) {
    for (int i = 0; i < unknowns; ++i) {
      k[at + i] = rhs[at + i] + g_ * b[first + i];
      k[at + unknowns + i] = b[first + i];
    }
  };
  put_body(layout_.cage(), kCage, kCageUnknowns);
  put_body(layout_.inner(), kInner, kRingUnknowns);
  put_body(layout_.outer(), kOuter, kRingUnknowns);
  for (int p = 0; p < packs_; ++p) {
    const BallPack& at = linear_[p];
    const auto& block = block_[p];
    Pack rate[6];
    for (int i = 0; i < 6; ++i) {
      Pack y = entry(k, 3 + i, p);
      for (int m = 0; m < end; ++m) y = y - block.by_shared[i][m] * b[m];
      rate[i] = y;
    }
    rate[1] = rate[1] / at.ball.radius;
    for (int i = 0; i < 6; ++i) put(rate[i], k, 3 + i, p);
    for (int i = 0; i < 3; ++i) put(entry(rhs, i, p) + g_ * rate[i], k, i, p);
  }
  for (int i = layout_.spot(0); i < layout_.end(); ++i) k[i] = rhs[i];  // the order does not ask for more
  for (int i = layout_.end(); i < layout_.size(); ++i) k[i] = 0.0;
  clear_rest(k);
}

}  // namespace orbearing::bearing::balls::ORBEARING_PACKS
