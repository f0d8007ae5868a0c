// Equilibria of one bearing whose rollers stay aligned, dry, one cage angle a lane: the model of
// lamina_bearing by Newton's method on the rings' displacement and all rollers at once.
//
// In the lengths of AlignedConstants a squeezed roller with inertial load I and e = |I| has
//   Q(y) - Q(x) = e,   x + y = A = -half clearance - u . e_r,   Q(x) = sum over laminae share (x -
//   drop)_+^(10/9)
// with x on the race that carries only the squeeze. Eliminating x roller by roller leaves two equations for
// u.
//
// Lanes do not meet, and nothing depends on how many of them there are: without fused operations all
// instruction sets give the same bits.
#pragma once

#include "bearing/contact/least_approach.hpp"
#include "bearing/contact/line_law.hpp"
#include "bearing/equilibrium/aligned_engine.hpp"
#include "mechanics/packs/aligned_array.hpp"
#include "mechanics/packs/elementary.hpp"
#include "mechanics/packs/powers.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// A roller between two passes over all of them.
struct RollerUnknown {
  Pack e_x, e_y;  // [-]  direction
  Pack inertial;  // [N]
  Pack x;         // [N^0.9]  approach of the race that carries only the squeeze
  Pack step;      // [N^0.9]  its correction at the present displacement of the rings
  Pack slope;     // [-]      d(x)/d(A)
  Pack squeeze;   // [N]      load of that race
};

/// A vector in the plane, a lane for each cage angle.
struct PlaneVector {
  Pack x{}, y{};
};

inline Pack dot(const PlaneVector& a, const PlaneVector& b) {
  return a.x * b.x + a.y * b.y;
}

/// Two rollers of each lane.
struct FacingRollers {
  Pack e_x[2], e_y[2];  // [-]
  Pack inertial[2];     // [N]
};

/// Force [N] on the outer ring, with `force` from outside, while no roller is squeezed.
inline PlaneVector unsqueezed_force(const AlignedArray<RollerUnknown>& rollers, int count,
                                    PlaneVector force) {
  for (int j = 0; j < count; ++j) {
    const Pack outward = larger(rollers[j].inertial, Pack{});
    force.x += outward * rollers[j].e_x;
    force.y += outward * rollers[j].e_y;
  }
  return force;
}

/// The two rollers that a displacement along `d` meets first.
inline FacingRollers facing(const AlignedArray<RollerUnknown>& rollers, int count, const PlaneVector& d) {
  FacingRollers found{};
  Pack most = spread(-2.0), next = most;
  for (int j = 0; j < count; ++j) {
    const RollerUnknown& roller = rollers[j];
    const Pack towards = -(d.x * roller.e_x + d.y * roller.e_y);
    const Mask first = towards > most, second = towards > next;
    const auto keep = [&](const Pack& value, Pack(&of)[2]) {
      of[1] = select(first, of[0], select(second, value, of[1]));
      of[0] = select(first, value, of[0]);
    };
    keep(roller.e_x, found.e_x);
    keep(roller.e_y, found.e_y);
    keep(roller.inertial, found.inertial);
    next = select(first, most, larger(next, towards));
    most = larger(most, towards);
  }
  return found;
}

/// Position in which a small force along the facing rollers' bisector holds the ring: both gaps are closed.
inline PlaneVector closed_gaps(const FacingRollers& two, double half_clearance) {
  Pack gap[2];
  for (int i = 0; i < 2; ++i)
    gap[i] = larger(
        half_clearance + rough_power(absolute(two.inertial[i]) + 1e-200, LineLaw::kApproachExponent), Pack{});
  const Pack scale = -1.0 / (two.e_x[0] * two.e_y[1] - two.e_x[1] * two.e_y[0]);
  return {scale * (gap[0] * two.e_y[1] - gap[1] * two.e_y[0]),
          scale * (gap[1] * two.e_x[0] - gap[0] * two.e_x[1])};
}

/// Approach under the load `force` [N] beyond a gap: the load of the most loaded roller from the integral of
/// the load zone for line contacts [Harris2006], here a straight line over the zone's extent; with
/// interference from the stiffness of all rollers.
inline Pack rough_approach(const Pack& force, const Pack& gap, int count) {
  const double share = 1.0 / count;
  const Pack centred = 2.0 * rough_power(4.08 * share * force, LineLaw::kApproachExponent);
  const Pack open = larger(gap, Pack{});
  Pack approach = centred;
  for (int i = 0; i < 2; ++i) {
    const Pack extent = 0.5 * approach / (approach + open);
    const Pack zone = root(extent) * (0.4139 - 0.134 * extent);
    approach = centred * rough_power(0.2453 / larger(zone, spread(share)), LineLaw::kApproachExponent);
  }
  const Pack squeeze = larger(-0.5 * gap, spread(1e-200));
  const Pack preloaded = 3.6 * share * force / rough_power(squeeze, LineLaw::kExponent - 1.0);
  return select(gap > 0.0, approach, smaller(preloaded, centred));
}

/// A displacement [N^0.9] of the outer ring under `load` [N] that brings the rollers under the load into
/// contact.
inline PlaneVector starting_displacement(const AlignedArray<RollerUnknown>& rollers, int count,
                                         double half_clearance, const PlaneVector& load) {
  const PlaneVector force = unsqueezed_force(rollers, count, load);
  const Pack size = root(dot(force, force));
  const Pack safe = larger(size, spread(1e-200));
  const PlaneVector d{force.x / safe, force.y / safe};
  const FacingRollers two = facing(rollers, count, d);
  const Pack gap =
      half_clearance + rough_power(absolute(two.inertial[0]) + 1e-200, LineLaw::kApproachExponent);
  const Pack approach = rough_approach(safe, gap, count);
  const PlaneVector closed = closed_gaps(two, half_clearance);
  return {only(size > 0.0, closed.x + approach * d.x), only(size > 0.0, closed.y + approach * d.y)};
}

/// Unbalanced force on the outer ring, and its stiffness.
struct RingBalance {
  PlaneVector force;            // [N]
  Pack k_xx{}, k_xy{}, k_yy{};  // [N^0.1]
  Pack error{};                 // [N]  of the force, as the rollers are not yet in equilibrium
};

/// Loads [N] of both contacts of a roller, and their slopes over 10/9 [N^0.1].
struct ContactPair {
  Pack p, q;
  Pack root_x, root_y;
};

/// Load of one contact [N] and its slope over 10/9 [N^0.1].
struct LoadAndSlope {
  Pack load{}, root{};
};

class AlignedContacts {
 public:
  static constexpr double kBend = 1.0;    // curvature of the law of a contact, from above
  static constexpr double kOnset = 0.01;  // share of a step's load that these bear, as a rule

  explicit AlignedContacts(const AlignedConstants& constants)
      : c_(constants), load_at_drop_(constants.laminae) {
    for (int k = 0; k < c_.laminae; ++k) load_at_drop_[k] = contact(spread(c_.drop[k])).load.low[0];
  }

  ContactPair loads(const Pack& x, const Pack& y) const {
    const LoadAndSlope p = contact(x), q = contact(y);
    return {p.load, q.load, p.root, q.root};
  }

  /// Loads of all laminae at the equilibrium.
  void put(const AlignedArray<RollerUnknown>& rollers, int count, const PlaneVector& u, double half_clearance,
           int first, const AlignedOutput& output) const {
    if (output.lamina_loads == nullptr) return;
    for (int j = 0; j < count; ++j) {
      const RollerUnknown& roller = rollers[j];
      const Pack approach = -half_clearance - (u.x * roller.e_x + u.y * roller.e_y);
      const Mask squeezed = roller.squeeze > 0.0;
      const Pack x = only(squeezed, roller.x + roller.step);
      const Pack y = select(squeezed, approach - x, approach_under(absolute(roller.inertial), squeezed));
      const Mask inner_alone = roller.inertial > 0.0;  // carries only the squeeze
      put_laminae(select(inner_alone, x, y), output.lamina_loads + j * kBlock + first, count);
      put_laminae(select(inner_alone, y, x), output.lamina_loads + (c_.laminae * count + j) * kBlock + first,
                  count);
    }
  }

 private:
  static constexpr int kMostSteps = 60;

  LoadAndSlope contact(const Pack& approach) const {
    LoadAndSlope sum;
    for (int k = 0; k < c_.laminae; ++k) {
      const Pack depth = larger(approach - c_.drop[k], Pack{});
      if (!any(depth > 0.0)) break;
      const Pack root = c_.share[k] * ninth_root(depth);
      sum.load += depth * root;
      sum.root += root;
    }
    return sum;
  }

  /// The approach under `load`, by Newton's method from above, where the load is convex: it falls towards it,
  /// from the first drop at which the load is larger. Not sought where `known`.
  Pack approach_under(const Pack& load, const Mask& known) const {
    const Mask sought = (load > 0.0) & ~known;
    if (!any(sought)) return Pack{};
    Pack approach = larger(load, spread(1.0)) + c_.drop[c_.laminae - 1];  // x <= x^(10/9) from 1 on
    for (int k = c_.laminae - 1; k > 0; --k)
      approach = select(spread(load_at_drop_[k]) > load, spread(c_.drop[k]), approach);
    approach = only(sought, approach);
    Mask moving = sought;
    for (int i = 0; i < kMostSteps && any(moving); ++i) {
      const LoadAndSlope now = contact(approach);
      const Pack step = LineLaw::kApproachExponent * (now.load - load) / larger(now.root, spread(1e-200));
      moving = moving & (step > 1e-14 * approach);
      approach -= only(moving, step);
    }
    return approach;
  }

  void put_laminae(const Pack& approach, double* to, int count) const {
    for (int k = 0; k < c_.laminae; ++k) {
      const Pack depth = larger(approach - c_.drop[k], Pack{});
      store(any(depth > 0.0) ? only(depth > 0.0, depth * ninth_root(depth)) : Pack{},
            to + k * count * kBlock);
    }
  }

  AlignedConstants c_;
  AlignedArray<double> load_at_drop_;  // [N]  (laminae)
};

class PackEquilibrium final : public AlignedEngine {
 public:
  explicit PackEquilibrium(const AlignedConstants& constants)
      : c_(constants), contacts_(constants), roller_(constants.rollers) {}

  void solve(const AlignedInput& input, AlignedOutput& output, double* inner_load,
             double* outer_load) override {
    for (int first = 0; first < kBlock; first += kLanes) solve(input, first, output, inner_load, outer_load);
  }

 private:
  static constexpr int kMostIterations = 60;
  static constexpr double kNothing = 1e-300;   // so that zero is below zero
  static constexpr int kPatience = 8;          // iterations before move() becomes patient
  static constexpr double kTolerance = 2e-11;  // of the largest force at hand
  static constexpr double kAcceptable = 1e-9;  // of the largest force, where round-off ends the iteration
  static constexpr double kTrusted = 0.1;      // error of a force whose sign is relied on
  static constexpr double kRoundOff = 1e-15;   // of the lengths whose difference is the approach

  void solve(const AlignedInput& input, int first, AlignedOutput& output, double* inner_load,
             double* outer_load);
  void place_rollers(const AlignedInput& input, int first);
  void start(const AlignedInput& input, int first);
  RingBalance balance(const Mask& done);
  /// `touch` [N^0.9]: up to this an approach is round-off.
  void balance_roller(RollerUnknown& roller, const Mask& done, const Pack& touch, RingBalance& sums) const;
  PlaneVector newton_step(const RingBalance& now) const;
  /// Moves the rings of all lanes but `done` and those it returns: their step is lost in round-off.
  Mask move(const RingBalance& now, const Mask& done, bool patient);
  Pack round_off() const {
    return kRoundOff * (absolute(u_.x) + absolute(u_.y) + 2.0 * __builtin_fabs(c_.half_clearance));
  }

  AlignedConstants c_;
  AlignedContacts contacts_;
  AlignedArray<RollerUnknown> roller_;
  PlaneVector load_;   // [N]      on the outer ring
  Pack scale_;         // [N]      largest force at hand
  Pack reach_;         // [N^0.9]  on which the contacts change
  PlaneVector u_;      // [N^0.9]  displacement
  PlaneVector moved_;  // [N^0.9]  its last change
  PlaneVector trial_;  // [N^0.9]  the step on trial: from where it was made to here
  Pack slope_;         // [N^1.9]  force there times that step
  Mask trusted_;       // that force was known well enough to judge the step by
};

inline void PackEquilibrium::place_rollers(const AlignedInput& input, int first) {
  const auto [sine, cosine] = sine_cosine(load(input.first_roller + first));
  const Pack steady = load(input.steady + first), by_x = load(input.cosine + first),
             by_y = load(input.sine + first);
  load_.x = load(input.force_x + first);
  load_.y = load(input.force_y + first);
  Pack largest{};
  Pack all{};
  for (int j = 0; j < c_.rollers; ++j) {
    RollerUnknown& roller = roller_[j];
    const double own_x = c_.pocket_cosine[j], own_y = c_.pocket_sine[j];
    roller.e_x = own_x * cosine - own_y * sine;
    roller.e_y = own_x * sine + own_y * cosine;
    roller.inertial = steady + by_x * roller.e_x + by_y * roller.e_y;
    roller.x = spread(1e100);  // held at half the approach, where the first step finds it
    roller.step = roller.slope = Pack{};
    const Pack size = absolute(roller.inertial);
    largest = larger(largest, size);
    all += size;
  }
  const Pack force = root(dot(load_, load_));
  scale_ = larger(force, largest);
  const Pack forces = larger(force + all, spread(1e-200));
  reach_ = 2.0 * __builtin_fabs(c_.half_clearance) + 2.5 * rough_power(forces, LineLaw::kApproachExponent);
}

inline void PackEquilibrium::start(const AlignedInput& input, int first) {
  u_ = input.near_rollers == nullptr ? starting_displacement(roller_, c_.rollers, c_.half_clearance, load_)
                                     : PlaneVector{load(input.start_x + first), load(input.start_y + first)};
  moved_ = trial_ = {};
  slope_ = Pack{};
  trusted_ = Mask{};
  if (input.near_rollers == nullptr) return;
  moved_ = {u_.x - load(input.near_x + first), u_.y - load(input.near_y + first)};
  for (int j = 0; j < c_.rollers; ++j) {
    const double* near = input.near_rollers + 2 * j * kBlock + first;
    roller_[j].x = load(near);
    roller_[j].slope = load(near + kBlock);
  }
}

inline void PackEquilibrium::balance_roller(RollerUnknown& roller, const Mask& done, const Pack& touch,
                                            RingBalance& sums) const {
  const Pack gap = -c_.half_clearance - (u_.x * roller.e_x + u_.y * roller.e_y);
  const Pack approach = only(absolute(gap) > touch, gap);
  const Pack outward = larger(roller.inertial, Pack{});
  if (!any(approach > 0.0)) {
    roller.x = roller.step = roller.slope = roller.squeeze = Pack{};
    sums.force.x += outward * roller.e_x;
    sums.force.y += outward * roller.e_y;
    return;
  }
  const Pack change = -(moved_.x * roller.e_x + moved_.y * roller.e_y);
  const Pack a = larger(approach, spread(1e-150));
  const Pack moved = larger(roller.x + roller.step + roller.slope * change, Pack{});
  const Pack x = smaller(select(done, roller.x, moved), 0.5 * a);
  const Pack y = a - x;
  const auto [p, q, root_x, root_y] = contacts_.loads(x, y);
  const Pack residual = q - p - absolute(roller.inertial);
  const Pack size = absolute(residual);
  const Pack inverse = 1.0 / ((root_x + root_y) * (p + size + 1e-200));
  const Pack by_roots = inverse * (p + size + 1e-200);
  const Pack share_y = root_y * by_roots;
  const Pack step = LineLaw::kApproachExponent * residual * by_roots;
  const Mask squeezed = (approach > 0.0) & (x + step > 0.0);
  const Pack load = only(squeezed, larger(p + (1.0 - share_y) * residual, Pack{}));
  const Pack stiffness = only(squeezed, LineLaw::slope(root_x) * share_y);
  const Pack outer = load + outward;
  sums.force.x += outer * roller.e_x;
  sums.force.y += outer * roller.e_y;
  sums.k_xx += stiffness * roller.e_x * roller.e_x;
  sums.k_xy += stiffness * roller.e_x * roller.e_y;
  sums.k_yy += stiffness * roller.e_y * roller.e_y;
  // The step leaves an error of its square over the load, times the bend of the law.
  const Mask counts = (approach > 0.0) & ((x > 0.0) | (residual > 0.0));
  const Pack error = AlignedContacts::kBend * (residual * residual) * (inverse * (root_x + root_y)) +
                     AlignedContacts::kOnset * size;
  sums.error += only(counts, error);
  roller.x = x;
  roller.step = select(squeezed, step, -x);
  roller.slope = only(squeezed, share_y);
  roller.squeeze = load;
}

inline RingBalance PackEquilibrium::balance(const Mask& done) {
  RingBalance sums{load_};
  const Pack touch = kLeastApproach * (absolute(u_.x) + absolute(u_.y) + __builtin_fabs(c_.half_clearance));
  for (int j = 0; j < c_.rollers; ++j) balance_roller(roller_[j], done, touch, sums);
  return sums;
}

// As in race_equilibrium: a little is added to the stiffness, and the step kept within reach.
inline PlaneVector PackEquilibrium::newton_step(const RingBalance& now) const {
  const Pack lift = 1e-12 * (now.k_xx + now.k_yy) + 1e-30;
  const Pack k_xx = now.k_xx + lift, k_yy = now.k_yy + lift;
  const Pack inverse = 1.0 / (k_xx * k_yy - now.k_xy * now.k_xy);
  const Pack x = inverse * (k_yy * now.force.x - now.k_xy * now.force.y);
  const Pack y = inverse * (k_xx * now.force.y - now.k_xy * now.force.x);
  const Pack share = smaller(spread(1.0), reach_ / larger(root(x * x + y * y), spread(1e-200)));
  return {share * x, share * y};
}

// The forces are the slope of a convex energy: a step after which the force along it points back by more than
// 0.7 of its previous value was too long, and is halved. This criterion requires known forces; a patient
// iteration waits with the rings until the rollers are nearly in equilibrium.
inline Mask PackEquilibrium::move(const RingBalance& now, const Mask& done, bool patient) {
  const Mask known = now.error * now.error < kTrusted * kTrusted * dot(now.force, now.force);
  const Mask waiting = patient ? ~known : Mask{};
  const Mask too_far = trusted_ & (dot(now.force, trial_) < -0.7 * slope_);
  const PlaneVector step = newton_step(now);
  const Pack limit = round_off();
  const Mask lost =
      (dot(step, step) < limit * limit + kNothing) & (now.error < kAcceptable * scale_ + kNothing) & ~too_far;
  const Mask moving = ~(done | lost | waiting);
  const PlaneVector next{select(too_far, 0.5 * trial_.x, step.x), select(too_far, 0.5 * trial_.y, step.y)};
  moved_ = {only(moving, select(too_far, -next.x, next.x)), only(moving, select(too_far, -next.y, next.y))};
  trial_ = {select(moving, next.x, trial_.x), select(moving, next.y, trial_.y)};
  slope_ = select(moving, select(too_far, 0.5 * slope_, dot(now.force, next)), slope_);
  trusted_ = (moving & (too_far | known)) | (~moving & trusted_);
  u_.x += moved_.x;
  u_.y += moved_.y;
  return lost;
}

inline void PackEquilibrium::solve(const AlignedInput& input, int first, AlignedOutput& output,
                                   double* inner_load, double* outer_load) {
  place_rollers(input, first);
  start(input, first);
  Mask done{}, converged{};
  Pack iterations{};
  RingBalance now;
  for (int i = 0; i < kMostIterations; ++i) {
    now = balance(done);
    const Pack residual = root(dot(now.force, now.force));
    store(residual, output.residual + first);
    const Mask balanced = residual + now.error < kTolerance * scale_ + kNothing;
    const Pack unseen = (now.k_xx + now.k_yy) * round_off();
    done = done | balanced;
    converged = converged | balanced;
    if (!any(~done)) break;
    const Mask lost = move(now, done, i >= kPatience);
    converged = converged | (lost & (residual < kAcceptable * scale_ + unseen + kNothing));
    done = done | lost;
    iterations += only(~done, spread(1.0));
  }
  store(u_.x, output.displacement_x + first);
  store(u_.y, output.displacement_y + first);
  store(iterations, output.iterations + first);
  store(only(converged, spread(1.0)), output.converged + first);
  store(now.k_xx, output.stiffness_xx + first);
  store(now.k_xy, output.stiffness_xy + first);
  store(now.k_yy, output.stiffness_yy + first);
  contacts_.put(roller_, c_.rollers, u_, c_.half_clearance, first, output);
  for (int j = 0; j < c_.rollers; ++j) {
    const RollerUnknown& roller = roller_[j];
    store(roller.squeeze + larger(-roller.inertial, Pack{}), inner_load + j * kBlock + first);
    store(roller.squeeze + larger(roller.inertial, Pack{}), outer_load + j * kBlock + first);
    if (output.rollers == nullptr) continue;
    store(roller.x + roller.step, output.rollers + 2 * j * kBlock + first);
    store(roller.slope, output.rollers + (2 * j + 1) * kBlock + first);
  }
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
