// The engine of one instruction set: walks the rollers pack by pack and gathers what acts on the rings.
#pragma once

#include "bearing/motion/vectorised/engine.hpp"
#include "bearing/motion/vectorised/neighbour_contact.hpp"
#include "bearing/motion/vectorised/pocket_contact.hpp"
#include "bearing/motion/vectorised/roller_chain.hpp"
#include "mechanics/packs/block_arrow.hpp"
#include "mechanics/packs/register_dual.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

// The matrix 1 - g J of a roller bearing, reduced to velocities: three unknowns for each roller and the seven
// velocities of the rings, with an open bore also that of its rotation, in the block-arrow form of
// mechanics/packs/block_arrow.hpp.

using namespace mechanics::ORBEARING_PACKS;

inline constexpr int kRollerUnknowns = 3;  // radial speed, orbital speed, spin
inline constexpr int kRingUnknowns = 7;    // pin x y, bore x y, cage x y, cage rotation
inline constexpr int kOpenUnknowns = 8;    // and rotation of the bore
inline constexpr int kPin = 0, kBore = 2, kCage = 4, kTurn = 7;
inline constexpr int kRingRow = kSharedRow<kOpenUnknowns>;

/// Blocks of kLanes rollers. Ring rows: the pin's forces see the inner race only, and so on, so all columns
/// of the rings are kept but only the coupled ones are filled, up to `ring_end`.
struct RollerBlock : ElementBlock<kRollerUnknowns, kOpenUnknowns> {
  Pack rings[kOpenUnknowns][kOpenUnknowns];  // what the rollers add to each body's own block, else unset
  int ring_end = kCage;
};

using RingBlock = SharedBlock<kOpenUnknowns>;

/// Whether two unknowns of the rings belong to one body, pin, bore or cage.
constexpr bool same_body(int i, int k) {
  const auto body = [](int unknown) {
    return unknown == kTurn ? kBore / 2 : unknown < kCage ? unknown / 2 : 2;
  };
  return body(i) == body(k);
}

/// Adds what is left of the rollers of `block` once they are eliminated.
template <int kEnd>
void add_rollers(const RollerBlock& block, double (&into)[kOpenUnknowns][kRingRow]) {
  add_schur<kEnd>(
      block,
      [&](int i, int k, Register& share) {
        if (same_body(i, k)) share += block.rings[i][k].low + block.rings[i][k].high;
      },
      into);
}

using namespace mechanics::ORBEARING_PACKS;

/// A vector in the plane.
struct Pair {
  Pack x{}, y{};
};

/// Slopes of the accelerations of rollers that are not contact forces: inertia of the frame, drag, turning
/// axes.
struct FreeSlopes {
  Pack radial_by_r, radial_by_theta, radial_by_orbital;
  Pack orbital_by_r, orbital_by_theta, orbital_by_radial, orbital_by_orbital;
  Pack spin_by_spin;
};

/// From the centre of the bore to the rollers [m], in their polar axes.
struct BoreArm {
  Pack r, t;

  /// About that centre, of a force and a moment on the rollers.
  Pack moment(const Pack& f_r, const Pack& f_t, const Pack& of_roller) const {
    return of_roller + r * f_t - t * f_r;
  }
};

/// One pack of rollers at the last linearisation.
struct RollerPack {
  Pack r, per_r, radial, orbital;  // [m], [1/m], [m/s], [rad/s]
  Pack cosine, sine;
  FreeSlopes free;
  ContactSlopes<Pack> inner, outer;
  Pack outer_r, outer_t;  // [N]  force of the outer race on the roller
  PocketSlopes pocket;
  Pack rate_by_end_displacement, rate_by_inner, rate_by_outer;  // [1/s]  RollerApproaches
  bool caged = false;
};

/// The same of rollers that may touch their neighbours.
struct NeighbourPack {
  NeighbourSlopes ahead, behind;
};

/// Forces of the rollers on the rings, summed pack by pack.
struct RingLoads {
  Pair pin, bore, cage;
  Pack cage_moment{};
  Pack bore_moment{};  // about the origin
};

class PackEngine final : public Engine {
 public:
  PackEngine(const Constants& constants, const RollerConstants& rollers)
      : c_(constants),
        races_(race_pair(c_)),
        given_(rollers),
        layout_(layout_of(c_)),
        packs_(layout_.lanes() / kLanes),
        linear_(packs_),
        block_(packs_),
        inner_load_(packs_),
        outer_load_(packs_),
        inner_approach_(packs_),
        outer_approach_(packs_),
        tip_(packs_),
        wave_force_(constants.rim.count),
        neighbour_(c_.caged ? 0 : packs_),
        neighbours_(c_.caged ? 0 : packs_),
        radii_(c_.caged ? 0 : packs_),
        chain_(c_.caged ? 0 : c_.rollers, c_.caged ? 0 : packs_) {
    if (!c_.caged) radii_.take(given_.radius, 1, c_.rollers);
  }

  [[gnu::flatten]] void derivative(const double* x, double load_x, double load_y, double* dx) override {
    if (c_.caged)
      evaluate<false, true>(x, load_x, load_y, dx);
    else
      evaluate_without_cage<false>(x, load_x, load_y, dx);
  }
  [[gnu::flatten]] void linearise(const double* x, double load_x, double load_y, double* dx) override {
    if (c_.caged)
      evaluate<true, true>(x, load_x, load_y, dx);
    else
      evaluate_without_cage<true>(x, load_x, load_y, dx);
  }
  bool factor(double g) override;
  void solve(const double* rhs, double* k) const override;
  ContactLoads loads() const override {
    const auto numbers = [](const AlignedArray<Pack>& packs) {
      return reinterpret_cast<const double*>(&packs[0]);
    };
    ContactLoads loads{numbers(inner_load_), numbers(outer_load_)};
    if (c_.laminae.count > 0) {
      loads.inner_approach = numbers(inner_approach_);
      loads.outer_approach = numbers(outer_approach_);
      loads.end_displacement = numbers(tip_);
    }
    return loads;
  }
  void set_surroundings(const Surroundings& now) override;
  BoreForces bore_forces() const override { return on_bore_; }
  BoreSlopes bore_slopes() const override;
  bool factor_open(double g, bool rotating, PortMatrix& port) override;
  void reduce(const double* rhs, double* k, double (&force)[3]) override;
  void complete(const double* rhs, const double (&rate)[3], double* k) const override;

 private:
  static constexpr int kEndDisplacement = 5;  // group of the end displacements in the state

  // The code of a full complement is compiled separately, so that bearings with a cage do not carry it: their
  // right-hand side would take a tenth longer.
  template <bool WithSlopes, bool Caged>
  void evaluate(const double* x, double load_x, double load_y, double* dx);
  template <bool WithSlopes>
  [[gnu::noinline, gnu::flatten]] void evaluate_without_cage(const double* x, double load_x, double load_y,
                                                             double* dx) {
    evaluate<WithSlopes, false>(x, load_x, load_y, dx);
  }
  template <bool WithSlopes, bool Caged>
  void evaluate_rollers(int p, const double* x, double* dx, RingLoads& sums);
  template <bool WithSlopes>
  [[gnu::noinline, gnu::flatten]] void add_weight_of_rollers(const double* x, double* dx);
  template <bool WithSlopes>
  bool push_neighbours(int p, const RollerMotion& own, ContactForce<Pack>& pushed);
  template <bool WithSlopes>
  LandForce<double> evaluate_land(const double* x);
  template <bool Caged>
  void evaluate_rings(const double* x, double load_x, double load_y, const RingLoads& sums,
                      const LandForce<double>& guided, double* dx);
  void evaluate_waves(const double* x, double* dx) const;
  void complete_waves(const double* rhs, double* k) const;
  template <bool OpenBore, bool Caged>
  void build_block(int p, double g);
  void add_neighbours(int p, double g);
  void chain_rollers();
  void push_shifted(int p, const Pack& dr, const Pack& dtheta, Pack& f_r, Pack& f_t, Pack& moment) const;
  template <bool OpenBore, bool Caged>
  void assemble(double g);
  template <bool OpenBore>
  [[gnu::noinline, gnu::flatten]] void assemble_without_cage(double g) {
    assemble<OpenBore, false>(g);
  }
  template <bool OpenBore, bool Caged>
  void add_rings(double g, RingBlock& rings) const;
  template <bool OpenBore, bool Caged>
  void reduce_rollers(const double* rhs, double* k, double (&b)[kOpenUnknowns]) const;
  template <bool OpenBore>
  [[gnu::noinline, gnu::flatten]] void reduce_without_cage(const double* rhs, double* k,
                                                           double (&b)[kOpenUnknowns]) const {
    reduce_rollers<OpenBore, false>(rhs, k, b);
  }
  template <bool Caged>
  void reduce_open(const double* rhs, double* k, double (&force)[3]);
  template <bool Caged>
  void complete_open(const double* rhs, const double (&rate)[3], double* k) const;
  template <bool Caged>
  void complete_rollers(const double* rhs, const double (&b)[kOpenUnknowns], double* k) const;
  void tilt_rollers(int p, const double* rhs, const Pack& shift, const double (&b)[kOpenUnknowns],
                    double* k) const;

  BoreArm bore_arm(const RollerPack& at) const {
    return {at.r - (bore_x_ * at.cosine + bore_y_ * at.sine), bore_x_ * at.sine - bore_y_ * at.cosine};
  }
  // Scale of the bore's rows: forces are divided by its mass, the moment is not.
  double bore_scale(int i) const { return i < 2 ? c_.bore_mass : 1.0; }

  Mask present(int p) const { return first_lanes(c_.rollers - p * kLanes); }
  const double* entry(const double* x, int group, int p) const {
    return x + group * layout_.lanes() + p * kLanes;
  }
  double* entry(double* x, int group, int p) const { return x + group * layout_.lanes() + p * kLanes; }

  Constants c_;
  RacePair races_;
  RollerConstants given_;
  PaddedLayout layout_;
  int packs_;
  AlignedArray<RollerPack> linear_;
  AlignedArray<RollerBlock> block_;
  AlignedArray<Pack> inner_load_;
  AlignedArray<Pack> outer_load_;
  AlignedArray<Pack> inner_approach_, outer_approach_, tip_;  // [m]  of contacts cut into laminae
  AlignedArray<Pack> wave_force_;                             // [N]  (waves)
  AlignedArray<NeighbourPack> neighbour_;  // slopes at the last linearisation, without a cage
  mutable Neighbours neighbours_;          // of the state, then of a right-hand side
  Neighbours radii_;
  RollerChain chain_;
  bool touching_ = false;  // rollers touched one another at the last linearisation
  RingBlock rings_;
  SharedInverse<kRingUnknowns> inverse_;  // of rings_, after factor()
  double g_ = 0.0;
  bool rotating_ = false;                       // the rotation of the bore is in the factors
  RegisterDual land_x_, land_y_, land_moment_;  // by offset x y, velocity x y, cage speed
  double bore_x_ = 0.0, bore_y_ = 0.0;          // [m]  at the last linearisation
  double cage_speed_ = 0.0;
  double cage_cosine_ = 1.0;
  double cage_sine_ = 0.0;
  BoreForces on_bore_;
  double reduced_[kOpenUnknowns]{};  // between reduce() and complete(), the bore last
};

/// `f_r`, `f_t`: all contact forces on the rollers [N]; `orbit_rate`: theta'' [rad/s^2].
inline FreeSlopes free_slopes(const Constants& c, const RollerPack& at, const Pack& f_r, const Pack& f_t,
                              const Pack& spin, const Pack& orbit_rate) {
  const double per_mass = 1.0 / c.roller_mass;
  const CarrierFrame& frame = c.frame;
  const Pack twice = 2.0 * frame.own_orbit * at.orbital + 2.0 * frame.coriolis_speed;
  const Pack drag = (-2.0 * c.orbit_drag * per_mass) * absolute(at.r * at.orbital);
  const double far = frame.centrifugal * frame.orbit_radius, late = frame.euler * frame.orbit_radius;
  FreeSlopes s;
  s.radial_by_r = at.orbital * (twice - frame.own_orbit * at.orbital) + frame.centrifugal;
  s.radial_by_theta = f_t * per_mass - far * at.sine - late * at.cosine;
  s.radial_by_orbital = at.r * twice;
  s.orbital_by_r = (drag * at.orbital - orbit_rate - frame.euler) * at.per_r;
  s.orbital_by_theta = (late * at.sine - f_r * per_mass - far * at.cosine) * at.per_r;
  s.orbital_by_radial = -2.0 * (frame.coriolis_speed + at.orbital) * at.per_r;
  s.orbital_by_orbital = drag - 2.0 * at.radial * at.per_r;
  s.spin_by_spin = (-2.0 * c.spin_drag / c.roller_inertia) * absolute(spin);
  return s;
}

/// Adds the opposite of a force in polar axes to a sum in x and y.
inline void react(const Pack& f_r, const Pack& f_t, const Pack& cosine, const Pack& sine, Pair& sum) {
  sum.x -= f_r * cosine - f_t * sine;
  sum.y -= f_r * sine + f_t * cosine;
}

/// Force of both neighbours on each roller; whether any touches.
template <bool WithSlopes>
bool PackEngine::push_neighbours(int p, const RollerMotion& own, ContactForce<Pack>& pushed) {
  const Mask here = present(p);
  const Neighbours& all = neighbours_;
  const RollerMotion ahead{all.ahead(0, p), all.ahead(1, p), all.ahead(2, p),
                           all.ahead(3, p), all.ahead(4, p), radii_.ahead(0, p)};
  const RollerMotion behind{all.behind(0, p), all.behind(1, p), all.behind(2, p),
                            all.behind(3, p), all.behind(4, p), radii_.behind(0, p)};
  NeighbourForce one, other;
  NeighbourPack& slopes = neighbour_[p];
  const bool before = neighbour_contact<WithSlopes>(c_.neighbours, here, own, ahead, one, slopes.ahead);
  const bool after = neighbour_contact<WithSlopes>(c_.neighbours, here, own, behind, other, slopes.behind);
  pushed = {one.f_r + other.f_r, one.f_t + other.f_t, one.moment + other.moment, one.load};
  return before || after;
}

template <bool WithSlopes, bool Caged>
void PackEngine::evaluate_rollers(int p, const double* x, double* dx, RingLoads& sums) {
  const Pack r = load(entry(x, 0, p)), theta = load(entry(x, 1, p)), radial = load(entry(x, 2, p)),
             orbital = load(entry(x, 3, p)), spin = load(entry(x, 4, p));
  const double* cage = x + layout_.cage();
  const double* bore = x + layout_.bore();
  const double* pin = x + layout_.pin();
  const SineCosine turn = sine_cosine(theta);
  const Pack cosine = turn.cosine, sine = turn.sine;
  const Mask here = present(p);
  const Pack radius = load(given_.radius + p * kLanes);
  RollerPack& linear = linear_[p];

  const auto motion_to = [&](const Body& body) {
    return relative_motion(r, radial, orbital, spin, cosine, sine, body);
  };
  ContactSlopes<PackPair> slopes;
  RollerApproaches approaches;
  if (layout_.tilting) approaches.end_displacement = load(entry(x, kEndDisplacement, p));
  const ContactForce<PackPair> races = race_contact<WithSlopes>(
      races_, radius, here, cosine, sine,
      {p * kLanes, x + layout_.turned(), x + layout_.wave(), x + layout_.wave_speed(), &wave_force_[0]},
      joined(motion_to({pin[0], pin[1], pin[2], pin[3]}), motion_to({bore[0], bore[1], bore[2], bore[3]})),
      slopes, approaches);
  if (c_.laminae.count > 0) {
    inner_approach_[p] = approaches.inner_approach;
    outer_approach_[p] = approaches.outer_approach;
    tip_[p] = approaches.end_displacement;
  }
  if (layout_.tilting) {
    store(only(here, approaches.rate), entry(dx, kEndDisplacement, p));
    if constexpr (WithSlopes) {
      linear.rate_by_end_displacement = approaches.by_end_displacement;
      linear.rate_by_inner = approaches.by_inner;
      linear.rate_by_outer = approaches.by_outer;
    }
  }
  if constexpr (WithSlopes) {
    split(slopes, linear.inner, linear.outer);
    linear.outer_r = races.f_r.high;
    linear.outer_t = races.f_t.high;
  }
  const PocketForce pocket = [&] {
    if constexpr (Caged) {
      const Pack own_cosine = load(given_.pocket_cosine + p * kLanes),
                 own_sine = load(given_.pocket_sine + p * kLanes);
      const Pack e_x = own_cosine * cage_cosine_ - own_sine * cage_sine_;
      const Pack e_y = own_cosine * cage_sine_ + own_sine * cage_cosine_;
      return pocket_contact<WithSlopes>(c_.pocket, c_.roller_radius, radius, here, e_x * cosine + e_y * sine,
                                        e_y * cosine - e_x * sine, cage[5],
                                        motion_to({cage[0], cage[1], cage[3], cage[4]}), linear.pocket);
    } else {
      PocketForce pushed;  // by the neighbours, instead of a pocket
      const bool touched =
          push_neighbours<WithSlopes>(p, {r, theta, radial, orbital, spin, radius}, pushed.on_roller);
      if constexpr (WithSlopes) touching_ = touching_ || touched;
      return pushed;
    }
  }();
  inner_load_[p] = races.load.low;
  outer_load_[p] = races.load.high;
  react(races.f_r.low, races.f_t.low, cosine, sine, sums.pin);
  react(races.f_r.high, races.f_t.high, cosine, sine, sums.bore);
  if (pocket.touched) react(pocket.on_roller.f_r, pocket.on_roller.f_t, cosine, sine, sums.cage);
  sums.cage_moment += pocket.cage_moment;
  sums.bore_moment -= races.moment.high + r * races.f_t.high;

  const Pack f_r = races.f_r.low + races.f_r.high + pocket.on_roller.f_r;
  const Pack f_t = races.f_t.low + races.f_t.high + pocket.on_roller.f_t;
  const Pack moment = races.moment.low + races.moment.high + pocket.on_roller.moment;
  const Pack speed = r * orbital;
  const Pack drag = -c_.orbit_drag * speed * absolute(speed);
  const double per_mass = 1.0 / c_.roller_mass, per_inertia = 1.0 / c_.roller_inertia;
  const CarrierFrame& frame = c_.frame;
  const Pack radial_rate = f_r * per_mass + radial_inertial_acceleration(frame, r, cosine, sine, orbital);
  const Pack orbit_rate =
      ((f_t + drag) * per_mass + tangential_inertial_acceleration(frame, r, cosine, sine, radial) -
       2.0 * radial * orbital) /
      r;
  const Pack spin_rate = (moment - c_.spin_drag * spin * absolute(spin)) * per_inertia - frame.euler;
  store(radial, entry(dx, 0, p));
  store(orbital, entry(dx, 1, p));
  store(only(here, radial_rate), entry(dx, 2, p));
  store(only(here, orbit_rate), entry(dx, 3, p));
  store(only(here, spin_rate), entry(dx, 4, p));
  if constexpr (WithSlopes) {
    linear.r = r;
    linear.per_r = 1.0 / linear.r;
    linear.radial = radial;
    linear.orbital = orbital;
    linear.cosine = cosine;
    linear.sine = sine;
    linear.free = free_slopes(c_, linear, f_r, f_t, spin, only(here, orbit_rate));
    linear.caged = pocket.touched;
  }
}

/// Apart, so that bearings without weight do not carry it.
template <bool WithSlopes>
void PackEngine::add_weight_of_rollers(const double* x, double* dx) {
  for (int p = 0; p < packs_; ++p) {
    const SineCosine turn = sine_cosine(load(entry(x, 1, p)));
    const Mask here = present(p);
    const Pack per_r = 1.0 / load(entry(x, 0, p));
    const Pack outward = only(here, c_.gravity.x * turn.cosine + c_.gravity.y * turn.sine);
    const Pack ahead = only(here, c_.gravity.y * turn.cosine - c_.gravity.x * turn.sine);
    store(load(entry(dx, 2, p)) + outward, entry(dx, 2, p));
    store(load(entry(dx, 3, p)) + ahead * per_r, entry(dx, 3, p));
    if constexpr (WithSlopes) {
      FreeSlopes& free = linear_[p].free;
      free.radial_by_theta += ahead;
      free.orbital_by_theta -= outward * per_r;
      free.orbital_by_r -= ahead * per_r * per_r;
    }
  }
}

template <bool WithSlopes, bool Caged>
void PackEngine::evaluate(const double* x, double load_x, double load_y, double* dx) {
  RingLoads sums;
  if constexpr (WithSlopes) {
    bore_x_ = x[layout_.bore()];
    bore_y_ = x[layout_.bore() + 1];
  }
  const LandForce<double> guided = evaluate_land<WithSlopes>(x);
  if constexpr (Caged) {
    const SineCosine cage = sine_cosine(spread(x[layout_.cage() + 2]));
    cage_cosine_ = cage.cosine.low[0];
    cage_sine_ = cage.sine.low[0];
  } else {
    neighbours_.take(x, 5, c_.rollers);
    if constexpr (WithSlopes) touching_ = false;
  }
  for (int i = 0; i < layout_.waves; ++i) wave_force_[i] = Pack{};
  for (int p = 0; p < packs_; ++p) evaluate_rollers<WithSlopes, Caged>(p, x, dx, sums);
  if (c_.gravity.x != 0.0 || c_.gravity.y != 0.0) add_weight_of_rollers<WithSlopes>(x, dx);
  for (int i = layout_.wave(); i < layout_.size(); ++i) dx[i] = 0.0;
  for (const RollerScratch& scratch : c_.roller_scratches)
    dx[layout_.turned() + scratch.followed] = x[4 * layout_.lanes() + scratch.roller];
  evaluate_waves(x, dx);
  evaluate_rings<Caged>(x, load_x, load_y, sums, guided, dx);
}

inline void PackEngine::evaluate_waves(const double* x, double* dx) const {
  const double *position = x + layout_.wave(), *speed = x + layout_.wave_speed();
  for (int i = 0; i < layout_.waves; ++i) {
    dx[layout_.wave() + i] = speed[i];
    const RimWave& wave = c_.rim[i];
    dx[layout_.wave_speed() + i] = (sum(wave_force_[i]) - wave.damping * speed[i] -
                                    wave.stiffness * (position[i] - c_.meshes * wave.at_rest)) /
                                   wave.mass;
  }
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
