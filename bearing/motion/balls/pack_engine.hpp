// The engine of one instruction set: walks the balls pack by pack and gathers what acts on cage and rings.
#pragma once

#include "bearing/motion/balls/bodies.hpp"
#include "bearing/motion/balls/engine.hpp"
#include "bearing/motion/balls/pocket_contact.hpp"
#include "bearing/motion/balls/race_contact.hpp"
#include "mechanics/packs/aligned_array.hpp"
#include "mechanics/packs/block_arrow.hpp"
#include "mechanics/packs/elementary.hpp"
#include "mechanics/packs/register_dual.hpp"

namespace orbearing::bearing::balls::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

inline constexpr int kBallUnknowns = 6;  // velocity radial, tangential, axial; spin about the same
inline constexpr int kCage = 0, kInner = kCageUnknowns, kOuter = kInner + kRingUnknowns;
inline constexpr int kShared = kOuter + kRingUnknowns;

/// Motion of a body's point at a ball's centre, in the ball's axes, by the body's unknowns: velocity,
/// turning.
struct BodyColumns {
  Pack by[kBallUnknowns][kCageUnknowns];
};

/// One pack of balls at the last linearisation.
struct BallPack {
  Ball<Pack> ball;
  Triple<Pack> from_inner, from_outer, from_cage;  // [m]
  ContactSlopes<Pack> inner, outer, pocket;
  PocketFilmSlopes<Pack> film;
  bool caged = false;
};

/// Forces of the balls on a body, summed pack by pack, in the bearing's axes; moments about the body's
/// centre.
struct BodySums {
  Triple<Pack> force{}, moment{};
};

/// The same of all balls.
struct BodyLoad {
  Triple<double> force{}, moment{};
};
inline BodyLoad total(const BodySums& sums) {
  return {{sum(sums.force.x), sum(sums.force.y), sum(sums.force.z)},
          {sum(sums.moment.x), sum(sums.moment.y), sum(sums.moment.z)}};
}

class PackEngine final : public Engine {
 public:
  explicit PackEngine(const BallNumbers& numbers)
      : c_(numbers),
        layout_{numbers.balls, numbers.spots.count},
        packs_((numbers.balls + kLanes - 1) / kLanes),
        linear_(packs_),
        block_(packs_),
        inner_load_(packs_),
        outer_load_(packs_),
        pocket_(packs_),
        pocket_angle_(packs_) {
    constexpr double kTwoPi = 6.283185307179586476925286766559;
    for (int p = 0; p < packs_; ++p) {
      double angle[kLanes];
      for (int i = 0; i < kLanes; ++i) angle[i] = kTwoPi * (p * kLanes + i) / c_.balls;
      pocket_angle_[p] = load(angle);
    }
  }

  void derivative(const double* x, const Surroundings& now, double* dx) override {
    with_shear_law(c_.shear.law, [&](auto law) { evaluate<false>(law, x, now, dx); });
  }
  void linearise(const double* x, const Surroundings& now, double* dx) override {
    with_shear_law(c_.shear.law, [&](auto law) { evaluate<true>(law, x, now, dx); });
  }
  bool factor(double g) override;
  void solve(const double* rhs, double* k) const override;
  ContactLoads loads() const override {
    const auto numbers = [](const AlignedArray<Pack>& packs) {
      return reinterpret_cast<const double*>(&packs[0]);
    };
    return {numbers(inner_load_), numbers(outer_load_), numbers(pocket_)};
  }

 private:
  template <bool kSlopes, class Law>
  [[gnu::flatten, gnu::noinline]] void evaluate(const Law& law, const double* x, const Surroundings& now,
                                                double* dx);
  // Whatever handles plain numbers is flattened: a copy of its own, left for other files to use, would run
  // the instructions of this one.
  template <bool kSlopes, class Law>
  [[gnu::noinline]] void evaluate_balls(const Law& law, int p, const double* x, const Body& inner,
                                        const Body& outer, const Body& cage, double cage_turn,
                                        BodySums& on_inner, BodySums& on_outer, BodySums& on_cage,
                                        double* dx);
  template <bool kSlopes>
  [[gnu::flatten, gnu::noinline]] void evaluate_lands(const Body& cage, const Body& ring, BodyLoad& on_cage,
                                                      BodyLoad& on_ring);
  void add_film(const BallPack& at, const BodyColumns& columns, const double* cage, const Triple<Pack>& own,
                const Mask& here, double* rows, BallWrench<Pack>& sum) const;
  template <int kEnd>
  void build_block(int p, double g);
  void add_bodies(double g);
  void add_lands(double g);
  template <int kEnd>
  bool assemble(double g);

  ScratchesFromBall<Pack> seen_spots(int p, const double* x, const Ball<Pack>& ball) const {
    ScratchesFromBall<Pack> seen;
    for (int i = 0; i < c_.spots.count; ++i) {
      const int lane = c_.spots.ball[i] - p * kLanes;
      if (lane < 0 || lane >= kLanes) continue;
      const Mask own = first_lanes(lane + 1) & ~first_lanes(lane);
      const double* position = x + layout_.spot(i);
      seen.spot[seen.count++] = {
          in_axes_of(ball, unit(Triple<double>{position[0], position[1], position[2]})),
          only(own, spread(1.0))};
    }
    return seen;
  }
  [[gnu::flatten]] void turn_spots(const double* x, double* dx) const;

  Mask present(int p) const { return first_lanes(c_.balls - p * kLanes); }
  Pack entry(const double* x, int group, int p) const {
    return load(x + group * layout_.lanes() + p * kLanes);
  }
  void put(const Pack& value, double* x, int group, int p) const {
    store(value, x + group * layout_.lanes() + p * kLanes);
  }
  // Lanes of the padded arrays that no pack reaches.
  void clear_rest(double* x) const {
    for (int group = 0; group < StateLayout::kGroups; ++group)
      for (int i = packs_ * kLanes; i < layout_.lanes(); ++i) x[group * layout_.lanes() + i] = 0.0;
  }
  int shared_end() const { return c_.outer_ring.mass > 0.0 ? kShared : kOuter; }

  BallNumbers c_;
  StateLayout layout_;
  int packs_;
  AlignedArray<BallPack> linear_;
  AlignedArray<ElementBlock<kBallUnknowns, kShared>> block_;
  AlignedArray<Pack> inner_load_, outer_load_, pocket_, pocket_angle_;
  RegisterDual land_[2][3];  // both lands: force x y, moment on the cage
  SharedBlock<kShared> shared_;
  double g_ = 0.0;  // [s]
};

/// Columns of a body at `d` [m] from its centre to the ball's: five unknowns, and the spin for a cage.
inline BodyColumns columns_of(const Ball<Pack>& ball, const Triple<Pack>& d) {
  const Pack c = ball.cosine, s = ball.sine, zero{};
  // A rate of the axis along x turns the body about y, along y about -x.
  return {{{c, s, zero, c * d.z, s * d.z, -d.y},
           {-s, c, zero, -s * d.z, c * d.z, d.x},
           {zero, zero, spread(1.0), s * d.y - c * d.x, -c * d.y - s * d.x, zero},
           {zero, zero, zero, s, -c, zero},
           {zero, zero, zero, c, s, zero},
           {zero, zero, zero, zero, zero, spread(1.0)}}};
}

/// Adds the opposite of `wrench`, which acts at `d` [m] from the body's centre, to the forces of the balls on
/// it.
inline void react(const Ball<Pack>& ball, const Triple<Pack>& d, const BallWrench<Pack>& wrench,
                  const Mask& present, BodySums& sum) {
  const auto kept = [&](const Triple<Pack>& v) {
    return Triple<Pack>{only(present, v.x), only(present, v.y), only(present, v.z)};
  };
  sum.force = sum.force - kept(in_bearing_axes(ball, wrench.force));
  sum.moment = sum.moment - kept(in_bearing_axes(ball, wrench.moment + cross(d, wrench.force)));
}

template <bool kSlopes, class Law>
void PackEngine::evaluate_balls(const Law& law, int p, const double* x, const Body& inner, const Body& outer,
                                const Body& cage, double cage_turn, BodySums& on_inner, BodySums& on_outer,
                                BodySums& on_cage, double* dx) {
  const Mask here = present(p);
  const Pack angle = entry(x, 1, p), orbital = entry(x, 4, p);
  const SineCosine direction = sine_cosine(angle);
  Ball<Pack> ball{select(here, entry(x, 0, p), spread(c_.pitch_radius)),
                  entry(x, 2, p),
                  direction.cosine,
                  direction.sine,
                  {entry(x, 3, p), Pack{}, entry(x, 5, p)},
                  {entry(x, 6, p), entry(x, 7, p), entry(x, 8, p)},
                  orbital};
  ball.velocity.y = ball.radius * orbital;
  BallPack& at = linear_[p];
  BallWrench<Pack> sum;
  const ScratchesFromBall<Pack> spots = seen_spots(p, x, ball);
  // One copy of the code serves both races.
#pragma GCC unroll 1
  for (int race = 0; race < 2; ++race) {
    const bool in = race == 0;
    const BodyFromBall<Pack> ring = seen(ball, in ? inner : outer);
    const RaceTouch<Pack> touch =
        race_touch<kSlopes>(law, c_, in ? c_.inner : c_.outer, ball, ring, spots, in ? at.inner : at.outer);
    react(ball, ring.from_centre, touch.on_ball, here, in ? on_inner : on_outer);
    sum += touch.on_ball;
    if constexpr (kSlopes) (in ? at.from_inner : at.from_outer) = ring.from_centre;
    (in ? inner_load_ : outer_load_)[p] = only(here, touch.load);
  }

  const BodyFromBall<Pack> seen_cage = seen(ball, cage);
  const SineCosine ahead = sine_cosine(pocket_angle_[p] + cage_turn - angle);
  const Triple<Pack> pocket = pocket_direction(seen_cage.axis, ahead.cosine, ahead.sine);
  const PocketTouch<Pack> held = pocket_touch<kSlopes>(c_, ball, seen_cage, pocket, at.pocket, at.film);
  const bool caged = c_.pocket.film.present() || any((held.load > Pack{}) & here);
  pocket_[p] = only(here, held.load);
  if (caged) {
    react(ball, seen_cage.from_centre, held.on_ball, here, on_cage);
    sum += held.on_ball;
  }
  const Pack speed = ball.velocity.y;
  const Pack rotating = root(dot(ball.spin, ball.spin) + 1e-12);
  sum.force.y -= c_.drag.translation * speed * absolute(speed);
  sum.moment += scaled(-c_.drag.churning * rotating, ball.spin);

  const double per_mass = 1.0 / c_.mass, per_inertia = 1.0 / c_.inertia;
  put(ball.velocity.x, dx, 0, p);
  put(orbital, dx, 1, p);
  put(ball.velocity.z, dx, 2, p);
  put(only(here, per_mass * sum.force.x + speed * orbital), dx, 3, p);
  put(only(here, (per_mass * sum.force.y - 2.0 * ball.velocity.x * orbital) / ball.radius), dx, 4, p);
  put(only(here, per_mass * sum.force.z), dx, 5, p);
  put(only(here, per_inertia * sum.moment.x + orbital * ball.spin.y), dx, 6, p);
  put(only(here, per_inertia * sum.moment.y - orbital * ball.spin.x), dx, 7, p);
  put(only(here, per_inertia * sum.moment.z), dx, 8, p);
  if constexpr (kSlopes) {
    at.ball = ball;
    at.caged = caged;
    at.from_cage = seen_cage.from_centre;
  }
}

/// Scratches turn with their balls.
inline void PackEngine::turn_spots(const double* x, double* dx) const {
  const int lanes = layout_.lanes();
  for (int i = 0; i < c_.spots.count; ++i) {
    const int j = c_.spots.ball[i];
    const double c = __builtin_cos(x[lanes + j]), s = __builtin_sin(x[lanes + j]);
    const double r = x[6 * lanes + j], t = x[7 * lanes + j];
    const double* position = x + layout_.spot(i);
    const Triple<double> rate = cross(Triple<double>{r * c - t * s, r * s + t * c, x[8 * lanes + j]},
                                      Triple<double>{position[0], position[1], position[2]});
    dx[layout_.spot(i)] = rate.x;
    dx[layout_.spot(i) + 1] = rate.y;
    dx[layout_.spot(i) + 2] = rate.z;
  }
}

/// Adds the lands' forces.
template <bool kSlopes>
void PackEngine::evaluate_lands(const Body& cage, const Body& ring, BodyLoad& on_cage, BodyLoad& on_ring) {
  if (!c_.land.present) return;
  for (int side = 0; side < 2; ++side) {
    const double position = side == 0 ? -c_.land.offset : c_.land.offset;
    const LandOffset at = land_offset(cage, ring, position);
    double x = 0.0, y = 0.0, moment = 0.0;
    if constexpr (kSlopes) {
      const auto variable = [&](int i) { return register_variable(at.by[i], i); };
      const LandForce<RegisterDual> force = c_.land.law.force(
          LandMotion<RegisterDual>{variable(0), variable(1), variable(2), variable(3), variable(4)},
          ring.spin);
      land_[side][0] = force.x;
      land_[side][1] = force.y;
      land_[side][2] = force.on_cage;
      x = force.x.value;
      y = force.y.value;
      moment = force.on_cage.value;
    } else {
      const LandForce<double> force =
          c_.land.law.force(LandMotion<double>{at.by[0], at.by[1], at.by[2], at.by[3], at.by[4]}, ring.spin);
      x = force.x;
      y = force.y;
      moment = force.on_cage;
    }
    const Triple<double> force{x, y, 0.0};
    on_cage.force += force;
    on_cage.moment += scaled(position, cross(cage.axis, force)) + scaled(moment, cage.axis);
    on_ring.force += -force;
    on_ring.moment += scaled(-position, cross(ring.axis, force));
  }
}

/// Rates of a body's velocities under `load`. A held one keeps its velocity.
inline void put_rates(const BodyNumbers& numbers, const Body& body, const BodyLoad& load, double* rate) {
  if (!(numbers.mass > 0.0)) {
    for (int i = 0; i < kRingUnknowns; ++i) rate[i] = 0.0;
    return;
  }
  rate[0] = load.force.x / numbers.mass;
  rate[1] = load.force.y / numbers.mass;
  rate[2] = load.force.z / numbers.mass;
  // d/dt (I_d a x a' + I_p s a) = M: I_d a x a'' is what M has across a, less I_p s a'.
  const Triple<double> across = load.moment - scaled(dot(load.moment, body.axis), body.axis);
  const Triple<double> turned =
      scaled(1.0 / numbers.across, across - scaled(numbers.polar * body.spin, body.axis_rate));
  const Triple<double> bend = cross(turned, body.axis);
  const double square = dot(body.axis_rate, body.axis_rate);
  rate[3] = bend.x - square * body.axis.x;
  rate[4] = bend.y - square * body.axis.y;
}

template <bool kSlopes, class Law>
void PackEngine::evaluate(const Law& law, const double* x, const Surroundings& now, double* dx) {
  const double* at_cage = x + layout_.cage();
  const double* at_inner = x + layout_.inner();
  const double* at_outer = x + layout_.outer();
  const Body cage = body_at(at_cage, at_cage + kCageUnknowns, at_cage[2 * kCageUnknowns - 1]);
  const Body inner = body_at(at_inner, at_inner + kRingUnknowns, now.inner_spin, now.inner_turn);
  const Body outer = body_at(at_outer, at_outer + kRingUnknowns, now.outer_spin, now.outer_turn);
  BodySums inner_sum, outer_sum, cage_sum;
  for (int p = 0; p < packs_; ++p)
    evaluate_balls<kSlopes>(law, p, x, inner, outer, cage, at_cage[5], inner_sum, outer_sum, cage_sum, dx);
  BodyLoad on_cage = total(cage_sum), on_inner = total(inner_sum), on_outer = total(outer_sum);
  const auto add = [](const RingLoad& given, BodyLoad& load) {
    load.force += Triple<double>{given.by[0], given.by[1], given.by[2]};
    load.moment += Triple<double>{-given.by[4], given.by[3], 0.0};
  };
  add(now.on_inner, on_inner);
  add(now.on_outer, on_outer);
  if (c_.land.on_outer)
    evaluate_lands<kSlopes>(cage, outer, on_cage, on_outer);
  else
    evaluate_lands<kSlopes>(cage, inner, on_cage, on_inner);
  const auto move = [&](int first, int unknowns, const BodyNumbers& numbers, const Body& body,
                        const BodyLoad& load) {
    for (int i = 0; i < unknowns; ++i) dx[first + i] = x[first + unknowns + i];
    put_rates(numbers, body, load, dx + first + unknowns);
  };
  move(layout_.inner(), kRingUnknowns, c_.inner_ring, inner, on_inner);
  move(layout_.outer(), kRingUnknowns, c_.outer_ring, outer, on_outer);
  move(layout_.cage(), kCageUnknowns, c_.cage, cage, on_cage);
  // The angle of the pockets, counted after the shortest turn that tilts the cage.
  double* cage_rate = dx + layout_.cage();
  cage_rate[5] =
      cage.spin + (cage.axis.x * cage.axis_rate.y - cage.axis.y * cage.axis_rate.x) / (1.0 + cage.axis.z);
  cage_rate[2 * kCageUnknowns - 1] =
      (dot(on_cage.moment, cage.axis) - c_.drag.cage_churning * cage.spin * __builtin_fabs(cage.spin)) /
      c_.cage.polar;
  turn_spots(x, dx);
  for (int i = layout_.end(); i < layout_.size(); ++i) dx[i] = 0.0;
  clear_rest(dx);
}

}  // namespace orbearing::bearing::balls::ORBEARING_PACKS
