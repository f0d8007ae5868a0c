// The matrix 1 - g J of the stages of a linearly implicit method, from the slopes of the last linearisation.
// Positions are eliminated, since their rate is the velocity, and rollers after them. Included by
// lane_solve.hpp only.
#pragma once

#include "bearing/motion/vectorised/pack_rings.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Slopes of one contact by the velocities of a stage, whose positions move by g times the velocity.
/// Rows: force along e_r, along e_theta, moment on the roller.
struct StageSlopes {
  Pack roller[3][3];  // by radial speed, orbital speed, spin
  Pack body[3][2];    // by the velocity of the other body, along e_r and e_theta
};

template <class At>
void by_roller(double g, const At& at, const Pack& position_r, const Pack& position_t, const Pack& velocity_r,
               const Pack& velocity_t, Pack& radial, Pack& orbital) {
  radial = g * position_r + velocity_r + g * at.orbital * velocity_t;
  orbital =
      at.r * (g * position_t + velocity_t) + g * (at.radial * velocity_t - at.r * at.orbital * velocity_r);
}

inline StageSlopes stage_slopes(double g, const RollerPack& at, const ContactSlopes<Pack>& slopes) {
  StageSlopes stage;
  for (int i = 0; i < 3; ++i) {
    const Pack(&position)[2] = slopes.by_position[i];
    const Pack(&velocity)[2] = slopes.by_velocity[i];
    by_roller(g, at, position[0], position[1], velocity[0], velocity[1], stage.roller[i][0],
              stage.roller[i][1]);
    stage.roller[i][2] = slopes.by_spin[i];
    for (int k = 0; k < 2; ++k) stage.body[i][k] = -(g * position[k] + velocity[k]);
  }
  return stage;
}

/// Components in x and y of a vector or of a pair of columns in polar axes.
inline Pair to_plane(const RollerPack& at, const Pack& along_r, const Pack& along_t) {
  return {along_r * at.cosine - along_t * at.sine, along_r * at.sine + along_t * at.cosine};
}

/// Puts one contact into the block of its rollers, whose rows have the factors `roller_scale`; the ring's
/// rows begin at `first`.
inline void add_contact(double g, const Pack (&roller_scale)[3], double body_mass, int first,
                        const RollerPack& at, const StageSlopes& stage, RollerBlock& block) {
  const double body_scale = g / body_mass;  // the opposite force acts on the body
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) block.own[i][k] += roller_scale[i] * stage.roller[i][k];
    const Pair row = to_plane(at, stage.roller[0][k], stage.roller[1][k]);
    block.of_shared[first][k] = body_scale * row.x;
    block.of_shared[first + 1][k] = body_scale * row.y;
  }
  Pair columns[3];
  for (int i = 0; i < 3; ++i) {
    columns[i] = to_plane(at, stage.body[i][0], stage.body[i][1]);
    block.by_shared[i][first] = roller_scale[i] * columns[i].x;
    block.by_shared[i][first + 1] = roller_scale[i] * columns[i].y;
  }
  const Pair by_x = to_plane(at, columns[0].x, columns[1].x);
  const Pair by_y = to_plane(at, columns[0].y, columns[1].y);
  block.rings[first][first] = body_scale * by_x.x;
  block.rings[first + 1][first] = body_scale * by_x.y;
  block.rings[first][first + 1] = body_scale * by_y.x;
  block.rings[first + 1][first + 1] = body_scale * by_y.y;
}

/// The cage's rotation and its moment, which the races do not have.
inline void add_cage_rotation(double g, const Pack (&roller_scale)[3], const Constants& c,
                              const RollerPack& at, RollerBlock& block) {
  constexpr int kCageTurn = kCage + 2;
  const PocketSlopes& slopes = at.pocket;
  Pack by_turn[3];
  for (int i = 0; i < 3; ++i) by_turn[i] = g * slopes.by_angle[i] + slopes.by_speed[i];
  for (int i = 0; i < 3; ++i) block.by_shared[i][kCageTurn] = roller_scale[i] * by_turn[i];
  const Pair force = to_plane(at, by_turn[0], by_turn[1]);
  block.rings[kCage][kCageTurn] = (g / c.cage_mass) * force.x;
  block.rings[kCage + 1][kCageTurn] = (g / c.cage_mass) * force.y;

  const double scale = -g / c.cage_inertia;
  Pack radial, orbital;
  by_roller(g, at, slopes.cage_by_position[0], slopes.cage_by_position[1], slopes.cage_by_velocity[0],
            slopes.cage_by_velocity[1], radial, orbital);
  block.of_shared[kCageTurn][0] = scale * radial;
  block.of_shared[kCageTurn][1] = scale * orbital;
  block.of_shared[kCageTurn][2] = scale * slopes.cage_by_spin;
  const Pair shift = to_plane(at, g * slopes.cage_by_position[0] + slopes.cage_by_velocity[0],
                              g * slopes.cage_by_position[1] + slopes.cage_by_velocity[1]);
  block.rings[kCageTurn][kCage] = -scale * shift.x;
  block.rings[kCageTurn][kCage + 1] = -scale * shift.y;
  block.rings[kCageTurn][kCageTurn] = scale * (g * slopes.cage_by_angle + slopes.cage_by_speed);
}

/// Both neighbours of each roller, in its own block and in those that couple it with them.
inline void PackEngine::add_neighbours(int p, double g) {
  const RollerPack& at = linear_[p];
  const Pack roller_scale[3] = {spread(-g / c_.roller_mass), (-g / c_.roller_mass) * at.per_r,
                                spread(-g / c_.roller_inertia)};
  RollerBlock& block = block_[p];
  const auto add = [&](const NeighbourSlopes& slopes, RollerChain::Blocks& coupled) {
    const StageSlopes stage = stage_slopes(g, at, slopes.on_roller);
    for (int i = 0; i < 3; ++i) {
      Pack position[2], velocity[2], radial, orbital;
      slopes.to_neighbour(slopes.on_roller.by_position[i], position[0], position[1]);
      slopes.to_neighbour(slopes.on_roller.by_velocity[i], velocity[0], velocity[1]);
      by_roller(g, slopes, position[0], position[1], velocity[0], velocity[1], radial, orbital);
      for (int k = 0; k < 3; ++k) block.own[i][k] += roller_scale[i] * stage.roller[i][k];
      coupled[i][0] = -roller_scale[i] * radial;
      coupled[i][1] = -roller_scale[i] * orbital;
      coupled[i][2] = roller_scale[i] * slopes.by_neighbour_spin[i];
    }
  };
  add(neighbour_[p].ahead, chain_.ahead(p));
  add(neighbour_[p].behind, chain_.behind(p));
}

/// The rollers of all blocks eliminated together, since they touch one another.
inline void PackEngine::chain_rollers() {
  for (int p = 0; p < packs_; ++p)
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) chain_.own(p)[i][k] = block_[p].own[i][k];
  chain_.factor();
  chain_.solve<kCage>([&](int j, int i, int column) -> double& {
    return lane_of(block_[j / kLanes].by_shared[i][column], j % kLanes);
  });
}

/// The bore's rotation. Contact forces do not change where race, roller and their line of centres turn at one
/// speed more about the race's centre, so the slope by the race's speed is the opposite of that by the
/// roller's orbit and spin.
inline void add_bore_rotation(double g, const Pack (&roller_scale)[3], const Constants& c,
                              const RollerPack& at, const BoreArm& arm, const StageSlopes& stage,
                              RollerBlock& block) {
  Pack by_turn[3];
  for (int i = 0; i < 3; ++i) {
    by_turn[i] =
        -(arm.r * at.outer.by_velocity[i][1] - arm.t * at.outer.by_velocity[i][0] + at.outer.by_spin[i]);
    block.by_shared[i][kTurn] = roller_scale[i] * by_turn[i];
  }
  const Pair force = to_plane(at, by_turn[0], by_turn[1]);
  block.rings[kBore][kTurn] = (g / c.bore_mass) * force.x;
  block.rings[kBore + 1][kTurn] = (g / c.bore_mass) * force.y;
  const auto moment = [&](const Pack& f_r, const Pack& f_t, const Pack& of_roller) {
    return g * arm.moment(f_r, f_t, of_roller);
  };
  const Pack(&roller)[3][3] = stage.roller;
  const Pack(&body)[3][2] = stage.body;
  for (int k = 0; k < 3; ++k) block.of_shared[kTurn][k] = moment(roller[0][k], roller[1][k], roller[2][k]);
  // The force has another arm where rollers and bore have moved.
  const Pack along_r = (g * g) * at.outer_t, along_t = (-g * g) * at.outer_r;
  block.of_shared[kTurn][0] += along_r;
  block.of_shared[kTurn][1] += at.r * along_t;
  const Pair by_bore = to_plane(at, moment(body[0][0], body[1][0], body[2][0]) - along_r,
                                moment(body[0][1], body[1][1], body[2][1]) - along_t);
  block.rings[kTurn][kBore] = by_bore.x;
  block.rings[kTurn][kBore + 1] = by_bore.y;
  block.rings[kTurn][kTurn] = moment(by_turn[0], by_turn[1], by_turn[2]);
}

/// Rows and columns of a cage that these rollers do not touch.
inline void leave_cage_out(RollerBlock& block) {
  for (int k = kCage; k < kCage + 3; ++k) {
    for (int i = 0; i < 3; ++i) block.by_shared[i][k] = block.of_shared[k][i] = Pack{};
    for (int i = kCage; i < kCage + 3; ++i) block.rings[i][k] = Pack{};
  }
}

template <bool OpenBore, bool Caged>
void PackEngine::build_block(int p, double g) {
  const RollerPack& at = linear_[p];
  RollerBlock& block = block_[p];
  const bool rotating = OpenBore && Caged && rotating_;
  block.ring_end = rotating ? kOpenUnknowns : at.caged ? kRingUnknowns : kCage;
  const FreeSlopes& free = at.free;
  block.own[0][0] = 1.0 - g * g * free.radial_by_r;
  block.own[0][1] = -g * (g * free.radial_by_theta + free.radial_by_orbital);
  block.own[0][2] = Pack{};
  block.own[1][0] = -g * (g * free.orbital_by_r + free.orbital_by_radial);
  block.own[1][1] = 1.0 - g * (g * free.orbital_by_theta + free.orbital_by_orbital);
  block.own[1][2] = Pack{};
  block.own[2][0] = block.own[2][1] = Pack{};
  block.own[2][2] = 1.0 - g * free.spin_by_spin;
  const Pack roller_scale[3] = {spread(-g / c_.roller_mass), (-g / c_.roller_mass) * at.per_r,
                                spread(-g / c_.roller_inertia)};
  add_contact(g, roller_scale, c_.pin_mass, kPin, at, stage_slopes(g, at, at.inner), block);
  const StageSlopes outer = stage_slopes(g, at, at.outer);
  add_contact(g, roller_scale, c_.bore_mass, kBore, at, outer, block);
  if (rotating) {
    add_bore_rotation(g, roller_scale, c_, at, bore_arm(at), outer, block);
    if (!at.caged) leave_cage_out(block);
  }
  if (at.caged) {
    add_contact(g, roller_scale, c_.cage_mass, kCage, at, stage_slopes(g, at, at.pocket.on_roller), block);
    add_cage_rotation(g, roller_scale, c_, at, block);
  }
}

/// Forces on the rings apart from rollers: frame, support, land, drag of the cage. The rows of an open bore
/// hold only the forces on it.
template <bool OpenBore, bool Caged>
void PackEngine::add_rings(double g, RingBlock& rings) const {
  const auto frame = [&](int first) {
    rings.a[first][first] += 1.0 - g * g * c_.frame.centrifugal;
    rings.a[first + 1][first + 1] += 1.0 - g * g * c_.frame.centrifugal;
    rings.a[first][first + 1] -= g * (2.0 * c_.frame.coriolis_speed + g * c_.frame.euler);
    rings.a[first + 1][first] += g * (2.0 * c_.frame.coriolis_speed + g * c_.frame.euler);
  };
  frame(kPin);
  if constexpr (!OpenBore) frame(kBore);
  if constexpr (Caged) {
    frame(kCage);
    rings.a[kCage + 2][kCage + 2] +=
        1.0 + 2.0 * g * c_.cage_drag / c_.cage_inertia * __builtin_fabs(cage_speed_);
  } else {
    for (int i = kCage; i < kRingUnknowns; ++i) rings.a[i][i] = 1.0;
  }
  const double support = g / c_.pin_mass * (g * c_.support_stiffness + c_.support_damping);
  rings.a[kPin][kPin] += support;
  rings.a[kPin + 1][kPin + 1] += support;
  if (!c_.land.present) return;
  const int land = c_.land.on_bore ? kBore : kPin;
  const double land_mass = c_.land.on_bore ? c_.bore_mass : c_.pin_mass;
  const RegisterDual* force[3] = {&land_x_, &land_y_, &land_moment_};
  const double cage_scale[3] = {-g / c_.cage_mass, -g / c_.cage_mass, -g / c_.cage_inertia};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const double slope =
          k < 2 ? g * slope_by(*force[i], k) + slope_by(*force[i], 2 + k) : slope_by(*force[i], 4);
      rings.a[kCage + i][kCage + k] += cage_scale[i] * slope;
      if (k < 2) rings.a[kCage + i][land + k] -= cage_scale[i] * slope;
      if (i < 2) rings.a[land + i][kCage + k] += g / land_mass * slope;
      if (i < 2 && k < 2) rings.a[land + i][land + k] -= g / land_mass * slope;
    }
  }
}

template <int kEnd>
void eliminate_and_add(RollerBlock& block, double (&rings)[kOpenUnknowns][kRingRow]) {
  eliminate<kEnd>(block);
  add_rollers<kEnd>(block, rings);
}

template <bool OpenBore, bool Caged>
void PackEngine::assemble(double g) {
  g_ = g;
  rings_ = RingBlock{};
  if constexpr (!Caged) {
    if (touching_) {
      for (int p = 0; p < packs_; ++p) {
        build_block<OpenBore, Caged>(p, g);
        add_neighbours(p, g);
      }
      chain_rollers();
      for (int p = 0; p < packs_; ++p) add_rollers<kCage>(block_[p], rings_.a);
      add_rings<OpenBore, Caged>(g, rings_);
      return;
    }
  }
  for (int p = 0; p < packs_; ++p) {
    build_block<OpenBore, Caged>(p, g);
    if (OpenBore && Caged && block_[p].ring_end == kOpenUnknowns)
      eliminate_and_add<kOpenUnknowns>(block_[p], rings_.a);
    else if (block_[p].ring_end == kRingUnknowns)
      eliminate_and_add<kRingUnknowns>(block_[p], rings_.a);
    else
      eliminate_and_add<kCage>(block_[p], rings_.a);
  }
  add_rings<OpenBore, Caged>(g, rings_);
}

[[gnu::flatten]] inline bool PackEngine::factor(double g) {
  if (c_.caged)
    assemble<false, true>(g);
  else
    assemble_without_cage<false>(g);
  SharedBlock<kRingUnknowns> closed;
  static_assert(sizeof closed.a < sizeof rings_.a && kSharedRow<kRingUnknowns> == kRingRow);
  __builtin_memcpy(closed.a, rings_.a, sizeof closed.a);
  return inverse_.take(closed);
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
