// Stages of a linearly implicit method: builds 1 - g J from the slopes of the last linearisation, eliminates
// positions (their rate is the velocity) and rollers, and solves. Included by the file of each instruction
// set only.
#pragma once

#include "bearing/fast/lane_engine.hpp"

namespace orbearing::bearing::fast::ORBEARING_LANES {

/// Slopes of one contact by the velocities of a stage, whose positions move by g times the velocity.
/// Rows: force along e_r, along e_theta, moment on the roller.
struct StageSlopes {
  Pack roller[3][3];  // by radial speed, orbital speed, spin
  Pack body[3][2];    // by the velocity of the other body, along e_r and e_theta
};

inline void by_roller(double g, const RollerPack& at, const Pack& position_r, const Pack& position_t,
                      const Pack& velocity_r, const Pack& velocity_t, Pack& radial, Pack& orbital) {
  radial = g * position_r + velocity_r + g * at.orbital * velocity_t;
  orbital =
      at.r * (g * position_t + velocity_t) + g * (at.radial * velocity_t - at.r * at.orbital * velocity_r);
}

inline StageSlopes stage_slopes(double g, const RollerPack& at, const ContactSlopes& slopes) {
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

/// Puts one contact into the block of its rollers, whose rows have the factors `roller_scale`, and into the
/// sums of the ring whose rows begin at `first`.
inline void add_contact(double g, const Pack (&roller_scale)[3], double body_mass, int first,
                        const RollerPack& at, const StageSlopes& stage, RollerBlock& block,
                        Pack (&ring_sums)[kRingUnknowns][kRingUnknowns]) {
  const double body_scale = g / body_mass;  // the body feels the opposite force
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) block.own[i][k] += roller_scale[i] * stage.roller[i][k];
    const Pair row = to_plane(at, stage.roller[0][k], stage.roller[1][k]);
    block.of_ring[first][k] = body_scale * row.x;
    block.of_ring[first + 1][k] = body_scale * row.y;
  }
  Pair columns[3];
  for (int i = 0; i < 3; ++i) {
    columns[i] = to_plane(at, stage.body[i][0], stage.body[i][1]);
    block.by_ring[i][first] = roller_scale[i] * columns[i].x;
    block.by_ring[i][first + 1] = roller_scale[i] * columns[i].y;
  }
  const Pair by_x = to_plane(at, columns[0].x, columns[1].x);
  const Pair by_y = to_plane(at, columns[0].y, columns[1].y);
  ring_sums[first][first] += body_scale * by_x.x;
  ring_sums[first + 1][first] += body_scale * by_x.y;
  ring_sums[first][first + 1] += body_scale * by_y.x;
  ring_sums[first + 1][first + 1] += body_scale * by_y.y;
}

/// The cage's rotation and its moment, which the races do not have.
inline void add_cage_rotation(double g, const Pack (&roller_scale)[3], const Constants& c,
                              const RollerPack& at, RollerBlock& block,
                              Pack (&ring_sums)[kRingUnknowns][kRingUnknowns]) {
  constexpr int kTurn = kCage + 2;
  const PocketSlopes& slopes = at.pocket;
  Pack by_turn[3];
  for (int i = 0; i < 3; ++i) by_turn[i] = g * slopes.by_angle[i] + slopes.by_speed[i];
  for (int i = 0; i < 3; ++i) block.by_ring[i][kTurn] = roller_scale[i] * by_turn[i];
  const Pair force = to_plane(at, by_turn[0], by_turn[1]);
  ring_sums[kCage][kTurn] += (g / c.cage_mass) * force.x;
  ring_sums[kCage + 1][kTurn] += (g / c.cage_mass) * force.y;

  const double scale = -g / c.cage_inertia;
  Pack radial, orbital;
  by_roller(g, at, slopes.cage_by_position[0], slopes.cage_by_position[1], slopes.cage_by_velocity[0],
            slopes.cage_by_velocity[1], radial, orbital);
  block.of_ring[kTurn][0] = scale * radial;
  block.of_ring[kTurn][1] = scale * orbital;
  block.of_ring[kTurn][2] = scale * slopes.cage_by_spin;
  const Pair shift = to_plane(at, g * slopes.cage_by_position[0] + slopes.cage_by_velocity[0],
                              g * slopes.cage_by_position[1] + slopes.cage_by_velocity[1]);
  ring_sums[kTurn][kCage] -= scale * shift.x;
  ring_sums[kTurn][kCage + 1] -= scale * shift.y;
  ring_sums[kTurn][kTurn] += scale * (g * slopes.cage_by_angle + slopes.cage_by_speed);
}

/// Slopes of the accelerations of rollers that are not contact forces: inertia of the frame, drag, turning
/// axes.
struct FreeSlopes {
  Pack radial_by_r, radial_by_theta, radial_by_orbital;
  Pack orbital_by_r, orbital_by_theta, orbital_by_radial, orbital_by_orbital;
  Pack spin_by_spin;
};

inline FreeSlopes free_slopes(const Constants& c, const RollerPack& at) {
  const Pack twice = 2.0 * c.own_orbit * at.orbital + 2.0 * c.coriolis_speed;
  const Pack drag = -2.0 * c.orbit_drag / c.roller_mass * absolute(at.r * at.orbital);
  const Pack inverse = 1.0 / at.r;
  const double far = c.centrifugal * c.orbit_radius, late = c.euler * c.orbit_radius;
  return {.radial_by_r = at.orbital * (twice - c.own_orbit * at.orbital) + c.centrifugal,
          .radial_by_theta = at.f_t / c.roller_mass - far * at.sine - late * at.cosine,
          .radial_by_orbital = at.r * twice,
          .orbital_by_r = (drag * at.orbital - at.orbit_rate - c.euler) * inverse,
          .orbital_by_theta = (-at.f_r / c.roller_mass - far * at.cosine + late * at.sine) * inverse,
          .orbital_by_radial = -2.0 * (c.coriolis_speed + at.orbital) * inverse,
          .orbital_by_orbital = drag - 2.0 * at.radial * inverse,
          .spin_by_spin = -2.0 * c.spin_drag / c.roller_inertia * absolute(at.spin)};
}

inline void LaneEngine::build_block(int p, double g, Pack (&ring_sums)[kRingUnknowns][kRingUnknowns]) {
  const RollerPack& at = linear_[p];
  RollerBlock& block = block_[p];
  block.caged = at.caged;
  const FreeSlopes free = free_slopes(c_, at);
  block.own[0][0] = 1.0 - g * g * free.radial_by_r;
  block.own[0][1] = -g * (g * free.radial_by_theta + free.radial_by_orbital);
  block.own[0][2] = Pack{};
  block.own[1][0] = -g * (g * free.orbital_by_r + free.orbital_by_radial);
  block.own[1][1] = 1.0 - g * (g * free.orbital_by_theta + free.orbital_by_orbital);
  block.own[1][2] = Pack{};
  block.own[2][0] = block.own[2][1] = Pack{};
  block.own[2][2] = 1.0 - g * free.spin_by_spin;
  const Pack roller_scale[3] = {spread(-g / c_.roller_mass), -g / (c_.roller_mass * at.r),
                                spread(-g / c_.roller_inertia)};
  add_contact(g, roller_scale, c_.pin_mass, kPin, at, stage_slopes(g, at, at.inner), block, ring_sums);
  add_contact(g, roller_scale, c_.bore_mass, kBore, at, stage_slopes(g, at, at.outer), block, ring_sums);
  if (at.caged) {
    add_contact(g, roller_scale, c_.cage_mass, kCage, at, stage_slopes(g, at, at.pocket.on_roller), block,
                ring_sums);
    add_cage_rotation(g, roller_scale, c_, at, block, ring_sums);
  }
}

/// What the rings feel apart from rollers: frame, support, land, drag of the cage.
inline void LaneEngine::add_rings(double g, RingBlock& rings) const {
  const auto frame = [&](int first) {
    rings.a[first][first] += 1.0 - g * g * c_.centrifugal;
    rings.a[first + 1][first + 1] += 1.0 - g * g * c_.centrifugal;
    rings.a[first][first + 1] -= g * (2.0 * c_.coriolis_speed + g * c_.euler);
    rings.a[first + 1][first] += g * (2.0 * c_.coriolis_speed + g * c_.euler);
  };
  frame(kPin);
  frame(kBore);
  frame(kCage);
  rings.a[kCage + 2][kCage + 2] +=
      1.0 + 2.0 * g * c_.cage_drag / c_.cage_inertia * __builtin_fabs(cage_speed_);
  const double support = g / c_.pin_mass * (g * c_.support_stiffness + c_.support_damping);
  rings.a[kPin][kPin] += support;
  rings.a[kPin + 1][kPin + 1] += support;
  if (!c_.land.present) return;
  const int land = c_.land.on_bore ? kBore : kPin;
  const double land_mass = c_.land.on_bore ? c_.bore_mass : c_.pin_mass;
  const GuidanceDual* force[3] = {&land_x_, &land_y_, &land_moment_};
  const double cage_scale[3] = {-g / c_.cage_mass, -g / c_.cage_mass, -g / c_.cage_inertia};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const double slope = k < 2 ? g * force[i]->slope[k] + force[i]->slope[2 + k] : force[i]->slope[4];
      rings.a[kCage + i][kCage + k] += cage_scale[i] * slope;
      if (k < 2) rings.a[kCage + i][land + k] -= cage_scale[i] * slope;
      if (i < 2) rings.a[land + i][kCage + k] += g / land_mass * slope;
      if (i < 2 && k < 2) rings.a[land + i][land + k] -= g / land_mass * slope;
    }
  }
}

inline bool LaneEngine::factor(double g) {
  g_ = g;
  Pack sums[kRingUnknowns][kRingUnknowns]{};
  for (int p = 0; p < packs_; ++p) {
    build_block(p, g, sums);
    eliminate(block_[p]);
    subtract_schur(block_[p], sums);
  }
  for (int i = 0; i < kRingUnknowns; ++i)
    for (int k = 0; k < kRingUnknowns; ++k) rings_.a[i][k] = sum(sums[i][k]);
  add_rings(g, rings_);
  return rings_.factor();
}

/// Change of a contact force when positions alone move: rollers by (dr, dtheta), the body by (dx, dy).
struct Shift {
  Pack d_r, d_t, w_r, w_t;
};

inline Shift shift_of(const RollerPack& at, const Pack& dr, const Pack& dtheta, double dx, double dy) {
  return {dr - (dx * at.cosine + dy * at.sine), at.r * dtheta + (dx * at.sine - dy * at.cosine),
          -at.r * at.orbital * dtheta, at.radial * dtheta + at.orbital * dr};
}

inline ContactForce shifted(const ContactSlopes& slopes, const Shift& shift) {
  ContactForce change;
  Pack* into[3] = {&change.f_r, &change.f_t, &change.moment};
  for (int i = 0; i < 3; ++i)
    *into[i] = slopes.by_position[i][0] * shift.d_r + slopes.by_position[i][1] * shift.d_t +
               slopes.by_velocity[i][0] * shift.w_r + slopes.by_velocity[i][1] * shift.w_t;
  return change;
}

inline void LaneEngine::solve(const double* rhs, double* k) const {
  const double* cage = rhs + layout_.cage();
  const double* bore = rhs + layout_.bore();
  const double* pin = rhs + layout_.pin();
  const double g = g_;
  RingLoads loads;             // changes of force through the shifts of positions
  Pack sums[kRingUnknowns]{};  // of_ring own^-1 b
  for (int p = 0; p < packs_; ++p) {
    const RollerPack& at = linear_[p];
    const RollerBlock& block = block_[p];
    const Pack dr = load(entry(rhs, 0, p)), dtheta = load(entry(rhs, 1, p));
    const ContactForce inner = shifted(at.inner, shift_of(at, dr, dtheta, pin[0], pin[1]));
    const ContactForce outer = shifted(at.outer, shift_of(at, dr, dtheta, bore[0], bore[1]));
    react(inner, at.cosine, at.sine, loads.pin);
    react(outer, at.cosine, at.sine, loads.bore);
    Pack f_r = inner.f_r + outer.f_r, f_t = inner.f_t + outer.f_t, moment = inner.moment + outer.moment;
    if (at.caged) {
      const Shift shift = shift_of(at, dr, dtheta, cage[0], cage[1]);
      ContactForce pocket = shifted(at.pocket.on_roller, shift);
      pocket.f_r += at.pocket.by_angle[0] * cage[2];
      pocket.f_t += at.pocket.by_angle[1] * cage[2];
      pocket.moment += at.pocket.by_angle[2] * cage[2];
      react(pocket, at.cosine, at.sine, loads.cage);
      loads.cage_moment += at.pocket.cage_by_position[0] * shift.d_r +
                           at.pocket.cage_by_position[1] * shift.d_t +
                           at.pocket.cage_by_velocity[0] * shift.w_r +
                           at.pocket.cage_by_velocity[1] * shift.w_t + at.pocket.cage_by_angle * cage[2];
      f_r += pocket.f_r;
      f_t += pocket.f_t;
      moment += pocket.moment;
    }
    const FreeSlopes free = free_slopes(c_, at);
    const Pack b[3] = {load(entry(rhs, 2, p)) +
                           g * (f_r / c_.roller_mass + free.radial_by_r * dr + free.radial_by_theta * dtheta),
                       load(entry(rhs, 3, p)) + g * (f_t / (c_.roller_mass * at.r) + free.orbital_by_r * dr +
                                                     free.orbital_by_theta * dtheta),
                       load(entry(rhs, 4, p)) + g / c_.roller_inertia * moment};
    Pack y[3];
    for (int i = 0; i < 3; ++i) {
      y[i] = block.own[i][0] * b[0] + block.own[i][1] * b[1] + block.own[i][2] * b[2];
      store(y[i], entry(k, 2 + i, p));
    }
    for (int i = 0; i < block.ring_end(); ++i)
      sums[i] += block.of_ring[i][0] * y[0] + block.of_ring[i][1] * y[1] + block.of_ring[i][2] * y[2];
  }

  const auto ring_rhs = [&](int i) { return -sum(sums[i]); };
  const double turn = c_.centrifugal, late = c_.euler;
  double land[3]{};
  const double* guide = c_.land.on_bore ? bore : pin;
  const GuidanceDual* force[3] = {&land_x_, &land_y_, &land_moment_};
  for (int i = 0; i < 3 && c_.land.present; ++i)
    land[i] = force[i]->slope[0] * (cage[0] - guide[0]) + force[i]->slope[1] * (cage[1] - guide[1]);
  const double on_bore = c_.land.on_bore ? 1.0 : 0.0, on_pin = 1.0 - on_bore;
  double b[kRingUnknowns] = {
      ring_rhs(0) + pin[2] +
          g * ((sum(loads.pin.x) - on_pin * land[0] - c_.support_stiffness * pin[0]) / c_.pin_mass +
               turn * pin[0] + late * pin[1]),
      ring_rhs(1) + pin[3] +
          g * ((sum(loads.pin.y) - on_pin * land[1] - c_.support_stiffness * pin[1]) / c_.pin_mass +
               turn * pin[1] - late * pin[0]),
      ring_rhs(2) + bore[2] +
          g * ((sum(loads.bore.x) - on_bore * land[0]) / c_.bore_mass + turn * bore[0] + late * bore[1]),
      ring_rhs(3) + bore[3] +
          g * ((sum(loads.bore.y) - on_bore * land[1]) / c_.bore_mass + turn * bore[1] - late * bore[0]),
      ring_rhs(4) + cage[3] +
          g * ((sum(loads.cage.x) + land[0]) / c_.cage_mass + turn * cage[0] + late * cage[1]),
      ring_rhs(5) + cage[4] +
          g * ((sum(loads.cage.y) + land[1]) / c_.cage_mass + turn * cage[1] - late * cage[0]),
      ring_rhs(6) + cage[5] + g * (sum(loads.cage_moment) + land[2]) / c_.cage_inertia};
  rings_.solve(b);

  double* k_cage = k + layout_.cage();
  double* k_bore = k + layout_.bore();
  double* k_pin = k + layout_.pin();
  for (int p = 0; p < packs_; ++p) {
    const RollerBlock& block = block_[p];
    Pack y[3];
    for (int i = 0; i < 3; ++i) {
      y[i] = load(entry(k, 2 + i, p));
      for (int m = 0; m < block.ring_end(); ++m) y[i] -= block.by_ring[i][m] * b[m];
      store(y[i], entry(k, 2 + i, p));
    }
    store(load(entry(rhs, 0, p)) + g * y[0], entry(k, 0, p));
    store(load(entry(rhs, 1, p)) + g * y[1], entry(k, 1, p));
  }
  for (int i = layout_.end(); i < layout_.size(); ++i) k[i] = 0.0;
  for (int i = 0; i < 2; ++i) {
    k_pin[i] = pin[i] + g * b[kPin + i];
    k_pin[2 + i] = b[kPin + i];
    k_bore[i] = bore[i] + g * b[kBore + i];
    k_bore[2 + i] = b[kBore + i];
  }
  for (int i = 0; i < 3; ++i) {
    k_cage[i] = cage[i] + g * b[kCage + i];
    k_cage[3 + i] = b[kCage + i];
  }
}

}  // namespace orbearing::bearing::fast::ORBEARING_LANES
