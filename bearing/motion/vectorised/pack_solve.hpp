// Solving the stages of a linearly implicit method. Included by the file of each instruction set only.
#pragma once

#include "bearing/motion/vectorised/stage_matrix.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Change of a contact force when only positions move: rollers by (dr, dtheta), the body by (dx, dy).
struct Shift {
  Pack d_r, d_t, w_r, w_t;
};

inline Shift shift_of(const RollerPack& at, const Pack& dr, const Pack& dtheta, double dx, double dy) {
  return {dr - (dx * at.cosine + dy * at.sine), at.r * dtheta + (dx * at.sine - dy * at.cosine),
          -at.r * at.orbital * dtheta, at.radial * dtheta + at.orbital * dr};
}

inline ContactForce<Pack> shifted(const ContactSlopes<Pack>& slopes, const Shift& shift) {
  ContactForce<Pack> change;
  Pack* into[3] = {&change.f_r, &change.f_t, &change.moment};
  for (int i = 0; i < 3; ++i)
    *into[i] = slopes.by_position[i][0] * shift.d_r + slopes.by_position[i][1] * shift.d_t +
               slopes.by_velocity[i][0] * shift.w_r + slopes.by_velocity[i][1] * shift.w_t;
  return change;
}

/// Adds the changes of the forces between neighbours by their shifts and the rollers' own.
inline void PackEngine::push_shifted(int p, const Pack& dr, const Pack& dtheta, Pack& f_r, Pack& f_t,
                                     Pack& moment) const {
  const RollerPack& at = linear_[p];
  const auto add = [&](const NeighbourSlopes& slopes, const Pack& other_dr, const Pack& other_dtheta) {
    const Pack r = other_dr, t = slopes.r * other_dtheta, w_r = -slopes.r * slopes.orbital * other_dtheta,
               w_t = slopes.radial * other_dtheta + slopes.orbital * other_dr;
    Shift shift = shift_of(at, dr, dtheta, 0.0, 0.0);
    shift.d_r -= r * slopes.cosine - t * slopes.sine;
    shift.d_t -= r * slopes.sine + t * slopes.cosine;
    shift.w_r -= w_r * slopes.cosine - w_t * slopes.sine;
    shift.w_t -= w_r * slopes.sine + w_t * slopes.cosine;
    const ContactForce<Pack> change = shifted(slopes.on_roller, shift);
    f_r += change.f_r;
    f_t += change.f_t;
    moment += change.moment;
  };
  add(neighbour_[p].ahead, neighbours_.ahead(0, p), neighbours_.ahead(1, p));
  add(neighbour_[p].behind, neighbours_.behind(0, p), neighbours_.behind(1, p));
}

/// Rollers: their share of `k`, and what they leave on the right-hand sides `b` of the rings. The rows of an
/// open bore hold only force and moment on it.
template <bool OpenBore, bool Caged>
void PackEngine::reduce_rollers(const double* rhs, double* k, double (&b)[kOpenUnknowns]) const {
  const double* cage = rhs + layout_.cage();
  const double* bore = rhs + layout_.bore();
  const double* pin = rhs + layout_.pin();
  const double g = g_, per_mass = 1.0 / c_.roller_mass;
  RingLoads loads;             // changes of force through the shifts of positions
  Pack bore_moment{};          // the same
  Pack sums[kOpenUnknowns]{};  // of_shared own^-1 b
  const bool chained = !Caged && touching_;
  if constexpr (!Caged)
    if (chained) neighbours_.take(rhs, 2, c_.rollers);
  for (int p = 0; p < packs_; ++p) {
    const RollerPack& at = linear_[p];
    const RollerBlock& block = block_[p];
    const Pack dr = load(entry(rhs, 0, p)), dtheta = load(entry(rhs, 1, p));
    const ContactForce<Pack> inner = shifted(at.inner, shift_of(at, dr, dtheta, pin[0], pin[1]));
    const Shift of_bore = shift_of(at, dr, dtheta, bore[0], bore[1]);
    const ContactForce<Pack> outer = shifted(at.outer, of_bore);
    react(inner.f_r, inner.f_t, at.cosine, at.sine, loads.pin);
    react(outer.f_r, outer.f_t, at.cosine, at.sine, loads.bore);
    if (OpenBore && rotating_) {
      bore_moment -= bore_arm(at).moment(outer.f_r, outer.f_t, outer.moment) + of_bore.d_r * at.outer_t -
                     of_bore.d_t * at.outer_r;
    }
    Pack f_r = inner.f_r + outer.f_r, f_t = inner.f_t + outer.f_t, moment = inner.moment + outer.moment;
    if (at.caged) {
      const Shift shift = shift_of(at, dr, dtheta, cage[0], cage[1]);
      ContactForce<Pack> pocket = shifted(at.pocket.on_roller, shift);
      pocket.f_r += at.pocket.by_angle[0] * cage[2];
      pocket.f_t += at.pocket.by_angle[1] * cage[2];
      pocket.moment += at.pocket.by_angle[2] * cage[2];
      react(pocket.f_r, pocket.f_t, at.cosine, at.sine, loads.cage);
      loads.cage_moment += at.pocket.cage_by_position[0] * shift.d_r +
                           at.pocket.cage_by_position[1] * shift.d_t +
                           at.pocket.cage_by_velocity[0] * shift.w_r +
                           at.pocket.cage_by_velocity[1] * shift.w_t + at.pocket.cage_by_angle * cage[2];
      f_r += pocket.f_r;
      f_t += pocket.f_t;
      moment += pocket.moment;
    }
    if constexpr (!Caged)
      if (chained) push_shifted(p, dr, dtheta, f_r, f_t, moment);
    const FreeSlopes& free = at.free;
    const Pack own[3] = {
        load(entry(rhs, 2, p)) + g * (f_r * per_mass + free.radial_by_r * dr + free.radial_by_theta * dtheta),
        load(entry(rhs, 3, p)) +
            g * (f_t * at.per_r * per_mass + free.orbital_by_r * dr + free.orbital_by_theta * dtheta),
        load(entry(rhs, 4, p)) + (g / c_.roller_inertia) * moment};
    if constexpr (!Caged) {
      if (chained) {  // all together, beneath
        for (int i = 0; i < 3; ++i) store(own[i], entry(k, 2 + i, p));
        continue;
      }
    }
    Pack y[3];
    for (int i = 0; i < 3; ++i) {
      y[i] = block.own[i][0] * own[0] + block.own[i][1] * own[1] + block.own[i][2] * own[2];
      store(y[i], entry(k, 2 + i, p));
    }
    for (int i = 0; i < block.ring_end; ++i)
      sums[i] += block.of_shared[i][0] * y[0] + block.of_shared[i][1] * y[1] + block.of_shared[i][2] * y[2];
  }

  if constexpr (!Caged) {
    if (chained) {
      chain_.solve<1>([&](int j, int i, int) -> double& { return entry(k, 2 + i, 0)[j]; });
      for (int p = 0; p < packs_; ++p)
        for (int i = 0; i < kCage; ++i)
          for (int m = 0; m < 3; ++m) sums[i] += block_[p].of_shared[i][m] * load(entry(k, 2 + m, p));
    }
  }

  // Both shares of the rollers, each force over the mass that it moves.
  const double on_pin_mass = g / c_.pin_mass, on_bore_mass = g / c_.bore_mass,
               on_cage_mass = g / c_.cage_mass;
  double of_rollers[kOpenUnknowns];
  sums_of({on_pin_mass * loads.pin.x - sums[0], on_pin_mass * loads.pin.y - sums[1],
           on_bore_mass * loads.bore.x - sums[2], on_bore_mass * loads.bore.y - sums[3],
           on_cage_mass * loads.cage.x - sums[4], on_cage_mass * loads.cage.y - sums[5],
           (g / c_.cage_inertia) * loads.cage_moment - sums[6], g * bore_moment - sums[7]},
          of_rollers);
  const double turn = c_.frame.centrifugal, late = c_.frame.euler;
  double land[3]{};
  const double* guide = c_.land.on_bore ? bore : pin;
  const RegisterDual* force[3] = {&land_x_, &land_y_, &land_moment_};
  for (int i = 0; i < 3 && c_.land.present; ++i)
    land[i] = slope_by(*force[i], 0) * (cage[0] - guide[0]) + slope_by(*force[i], 1) * (cage[1] - guide[1]);
  const double on_bore = c_.land.on_bore ? 1.0 : 0.0, on_pin = 1.0 - on_bore;
  b[0] = of_rollers[0] + pin[2] - on_pin_mass * (on_pin * land[0] + c_.support_stiffness * pin[0]) +
         g * (turn * pin[0] + late * pin[1]);
  b[1] = of_rollers[1] + pin[3] - on_pin_mass * (on_pin * land[1] + c_.support_stiffness * pin[1]) +
         g * (turn * pin[1] - late * pin[0]);
  b[2] = of_rollers[2] - on_bore_mass * on_bore * land[0];
  b[3] = of_rollers[3] - on_bore_mass * on_bore * land[1];
  b[kTurn] = of_rollers[kTurn];
  if constexpr (!OpenBore) {
    b[2] += bore[2] + g * (turn * bore[0] + late * bore[1]);
    b[3] += bore[3] + g * (turn * bore[1] - late * bore[0]);
  }
  if constexpr (!Caged) {
    b[4] = b[5] = b[6] = 0.0;
    return;
  }
  b[4] = of_rollers[4] + cage[3] + on_cage_mass * land[0] + g * (turn * cage[0] + late * cage[1]);
  b[5] = of_rollers[5] + cage[4] + on_cage_mass * land[1] + g * (turn * cage[1] - late * cage[0]);
  b[6] = of_rollers[6] + cage[5] + (g / c_.cage_inertia) * land[2];
}

/// Rates of the end displacements, once those of roller and rings are known; `shift` is that of the rollers'
/// radii. The change of the contacts' approaches is taken along the ray from the origin, which leaves that of
/// the rings out.
inline void PackEngine::tilt_rollers(int p, const double* rhs, const Pack& shift,
                                     const double (&b)[kOpenUnknowns], double* k) const {
  const RollerPack& at = linear_[p];
  const double *bore = rhs + layout_.bore(), *pin = rhs + layout_.pin();
  const auto along = [&](const double* ring, int first) {
    return (ring[0] + g_ * b[first]) * at.cosine + (ring[1] + g_ * b[first + 1]) * at.sine;
  };
  const Pack inner = along(pin, kPin) - shift, outer = shift - along(bore, kBore);
  store((load(entry(rhs, kEndDisplacement, p)) + g_ * (at.rate_by_inner * inner + at.rate_by_outer * outer)) /
            (1.0 - g_ * at.rate_by_end_displacement),
        entry(k, kEndDisplacement, p));
}

/// Rates of the waves of an elastic rim, each separately: the coupling of waves and rollers is left out of J,
/// since the rim deflects far less than the contacts; the order does not require it.
inline void PackEngine::complete_waves(const double* rhs, double* k) const {
  const double *position = rhs + layout_.wave(), *speed = rhs + layout_.wave_speed();
  for (int i = 0; i < layout_.waves; ++i) {
    const RimWave& wave = c_.rim[i];
    const double per_mass = g_ / wave.mass, stiffness = per_mass * wave.stiffness;
    const double rate =
        (speed[i] - stiffness * position[i]) / (1.0 + per_mass * wave.damping + g_ * stiffness);
    k[layout_.wave_speed() + i] = rate;
    k[layout_.wave() + i] = position[i] + g_ * rate;
  }
}

/// All rates, once those of the rings are known: `b`.
template <bool Caged>
void PackEngine::complete_rollers(const double* rhs, const double (&b)[kOpenUnknowns], double* k) const {
  const double* cage = rhs + layout_.cage();
  const double* bore = rhs + layout_.bore();
  const double* pin = rhs + layout_.pin();
  const double g = g_;
  double* k_cage = k + layout_.cage();
  double* k_bore = k + layout_.bore();
  double* k_pin = k + layout_.pin();
  for (int p = 0; p < packs_; ++p) {
    const RollerBlock& block = block_[p];
    Pack rate[3];
    for (int i = 0; i < 3; ++i) {
      rate[i] = load(entry(k, 2 + i, p));
      for (int m = 0; m < block.ring_end; ++m) rate[i] -= block.by_shared[i][m] * b[m];
      store(rate[i], entry(k, 2 + i, p));
    }
    const Pack shift = load(entry(rhs, 0, p)) + g * rate[0];
    store(shift, entry(k, 0, p));
    store(load(entry(rhs, 1, p)) + g * rate[1], entry(k, 1, p));
    if (layout_.tilting) tilt_rollers(p, rhs, shift, b, k);
  }
  // The turning of rollers is no part of J: the order does not require it.
  for (int i = layout_.turned(); i < layout_.end(); ++i) k[i] = rhs[i];
  complete_waves(rhs, k);
  for (int i = layout_.end(); i < layout_.size(); ++i) k[i] = 0.0;
  for (int i = 0; i < 2; ++i) {
    k_pin[i] = pin[i] + g * b[kPin + i];
    k_pin[2 + i] = b[kPin + i];
    k_bore[i] = bore[i] + g * b[kBore + i];
    k_bore[2 + i] = b[kBore + i];
  }
  for (int i = 0; Caged && i < 3; ++i) {
    k_cage[i] = cage[i] + g * b[kCage + i];
    k_cage[3 + i] = b[kCage + i];
  }
}

[[gnu::flatten]] inline void PackEngine::solve(const double* rhs, double* k) const {
  double b[kOpenUnknowns];
  auto& closed = reinterpret_cast<double(&)[kRingUnknowns]>(b);
  if (c_.caged) {
    reduce_rollers<false, true>(rhs, k, b);
    inverse_.times(closed);
    complete_rollers<true>(rhs, b, k);
  } else {
    reduce_without_cage<false>(rhs, k, b);
    inverse_.times(closed);
    complete_rollers<false>(rhs, b, k);
  }
}

// The linear algebra of a bearing whose bore is open: all else is eliminated, the bore's velocity last.
// Included by the file of each instruction set only.

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

/// The force on the roller changes with its position relative to the bore, and the opposite acts on the bore:
/// the slope by the bore's own position is that of the force on the roller by the roller's.
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
  const RegisterDual* land[2] = {&land_x_, &land_y_};
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k) {
      slopes.by_position[i][k] = sum(position[i][k]);
      slopes.by_velocity[i][k] = sum(velocity[i][k]);
      if (!c_.land.present || !c_.land.on_bore) continue;
      slopes.by_position[i][k] += slope_by(*land[i], k);
      slopes.by_velocity[i][k] += slope_by(*land[i], 2 + k);
    }
  return slopes;
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
