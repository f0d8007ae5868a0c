#define ORBEARING_PACKS packs_baseline
#include "bearing/motion/vectorised/observed.hpp"

#include "bearing/motion/vectorised/neighbour_contact.hpp"

namespace orbearing::bearing::vectorised {

namespace packs_baseline {
namespace {

ObservedContact<PackPair> seen_contact(const RacePair& race, const RaceMotion& m, const RaceLoads& x) {
  const NormalForce force = normal_force(race, m, x);
  const ContactForce<PackPair> on_roller = contact_force(m, x, force);
  PackPair form_power{};
  if (!race.round)
    form_power =
        race.side * x.load * race.speed * (m.form.slope - m.form.rotating_slope - m.form.rolling_slope);
  return {.approach = m.approach,
          .elastic_approach = x.elastic_approach,
          .load = x.load,
          .f_r = on_roller.f_r,
          .f_t = on_roller.f_t,
          .moment = on_roller.moment,
          .sliding = m.sliding,
          .entrainment = m.entrainment,
          .damping_power = (x.load - x.elastic_load) * m.closing,
          .traction_power = x.friction.force * m.sliding,
          .rolling_power = 2.0 * x.inlet.force * m.rolling,
          .form_power = form_power};
}

// The numbers of so many rollers, the first of a pack.
void put_lanes(const ObservedContact<PackPair>& both, int count, ObservedRoller* seen) {
  constexpr int kNumbers = sizeof(ObservedContact<double>) / sizeof(double);
  static_assert(sizeof both == kNumbers * sizeof(PackPair));
  double packs[kNumbers][2][kLanes], inner[kNumbers], outer[kNumbers];
  __builtin_memcpy(packs, &both, sizeof packs);
  for (int lane = 0; lane < count; ++lane) {
    for (int i = 0; i < kNumbers; ++i) {
      inner[i] = packs[i][0][lane];
      outer[i] = packs[i][1][lane];
    }
    __builtin_memcpy(&seen[lane].inner, inner, sizeof inner);
    __builtin_memcpy(&seen[lane].outer, outer, sizeof outer);
  }
}

class Observer {
 public:
  Observer(const Constants& constants, const RollerConstants& rollers, const double* x)
      : c_(constants), races_(race_pair(c_)), given_(rollers), x_(x), layout_(layout_of(c_)) {}

  void observe(ObservedRoller* seen) const {
    for (int first = 0; first < c_.rollers; first += kLanes)
      put_lanes(races_at(first), c_.rollers - first < kLanes ? c_.rollers - first : kLanes, seen + first);
    if (!c_.caged) observe_neighbours(seen);
  }

 private:
  RollerMotion rollers_at(int first) const {
    const auto entry = [&](int group) { return load(x_ + group * layout_.lanes() + first); };
    return {entry(0), entry(1), entry(2), entry(3), entry(4), load(given_.radius + first)};
  }

  ObservedContact<PackPair> races_at(int first) const {
    const RollerMotion now = rollers_at(first);
    const SineCosine turn = sine_cosine(now.theta);
    const auto motion_to = [&](const double* ring) {
      return relative_motion(now.r, now.radial, now.orbital, now.spin, turn.cosine, turn.sine,
                             {ring[0], ring[1], ring[2], ring[3]});
    };
    RollerApproaches stand;
    if (layout_.tilting) stand.end_displacement = load(x_ + 5 * layout_.lanes() + first);
    const RaceMotion m =
        race_motion(races_, now.radius, first_lanes(c_.rollers - first), turn.cosine, turn.sine,
                    {first, x_ + layout_.turned(), x_ + layout_.wave(), x_ + layout_.wave_speed(), nullptr},
                    joined(motion_to(x_ + layout_.pin()), motion_to(x_ + layout_.bore())));
    return seen_contact(races_, m, race_loads<false>(races_, m, turn.cosine, turn.sine, stand));
  }

  void observe_neighbours(ObservedRoller* seen) const {
    const int packs = layout_.lanes() / kLanes;
    Neighbours moved(packs), radii(packs);
    moved.take(x_, 5, c_.rollers);
    radii.take(given_.radius, 1, c_.rollers);
    for (int first = 0, p = 0; first < c_.rollers; first += kLanes, ++p) {
      const RollerMotion ahead{moved.ahead(0, p), moved.ahead(1, p), moved.ahead(2, p),
                               moved.ahead(3, p), moved.ahead(4, p), radii.ahead(0, p)};
      NeighbourForce force;
      NeighbourSlopes unused;
      neighbour_contact<false>(c_.neighbours, first_lanes(c_.rollers - first), rollers_at(first), ahead,
                               force, unused);
      double loads[kLanes], energies[kLanes], powers[kLanes];
      store(force.load, loads);
      store(force.energy, energies);
      store(force.power, powers);
      for (int lane = 0; lane < kLanes && first + lane < c_.rollers; ++lane) {
        seen[first + lane].neighbour_load = loads[lane];
        seen[first + lane].neighbour_energy = energies[lane];
        seen[first + lane].neighbour_power = powers[lane];
      }
    }
  }

  const Constants& c_;
  RacePair races_;
  RollerConstants given_;
  const double* x_;
  PaddedLayout layout_;
};

}  // namespace
}  // namespace packs_baseline

void observe(const Constants& constants, const RollerConstants& rollers, const double* x,
             ObservedRoller* seen) {
  packs_baseline::Observer(constants, rollers, x).observe(seen);
}

}  // namespace orbearing::bearing::vectorised
