// Effect of the form of a race on a contact: bearing/contact/race_form.hpp for packs of contacts, with one
// derivative more. The load stays the slope of the stored energy:
//
//   approach = s (distance - R(phi)) + a,   phi: angle of the normal n
//   force on the roller = -load d(approach)/d(position) = -s load n + s load R'(phi) / distance t
//
// so that a small tangential force joins the normal one; its moment about the race's centre, s load R', acts
// on the race, since the roller is round and takes none. A scratch of the race is a form too. So is a scratch
// of the roller, but it turns with the roller, which then takes the moment.
#pragma once

#include "bearing/motion/vectorised/race_load.hpp"
#include "mechanics/packs/elementary.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Height and slopes by the angle of the normal; `turning` is the share of what turns with the race.
template <class Number>
struct FormSlopes {
  Number height;  // [m]
  Number slope;   // [m/rad]
  Number bend;    // [m/rad^2]  second derivative
  Number rotating_slope;
  Number rotating_bend;
  Number rolling_slope;  // the share of what turns with the roller
  Number rolling_bend;
  Number rate;        // [m/s]  of a race that bends
  Number rate_slope;  // [m/s/rad]
};

/// Adds the scratches of a race: its floor lies lower there, outside on the outer race (side 1) and inside on the
/// inner one (side -1).
inline void add_scratches(const RaceConstants& race, const Pack& cosine, const Pack& sine,
                          FormSlopes<Pack>& sum) {
  for (const RaceScratch& scratch : race.scratches) {
    const TrackDepth<Pack> element_depth =
        depth_at(scratch.law, scratch.radius, scratch.angle + race.turned, cosine, sine);
    sum.height += race.side * element_depth.depth;
    sum.slope += race.side * element_depth.by_angle;
    sum.bend += race.side * element_depth.bend;
    sum.rotating_slope += race.side * element_depth.by_angle;
    sum.rotating_bend += race.side * element_depth.bend;
  }
}

/// State of the scratches of rollers and of the waves of an elastic rim, and the forces of the rollers on the
/// waves.
struct FormState {
  int first = 0;                       // number of the pack's first roller
  const double* turned = nullptr;      // [rad]  (followed)
  const double* wave = nullptr;        // [m]    (waves)
  const double* wave_speed = nullptr;  // [m/s]  (waves)
  Pack* wave_force = nullptr;          // [N]    (waves)  sums over packs
};

/// Cosine and sine of rising multiples of an angle, from 1 on.
struct PackMultiples {
  Pack first_cosine, first_sine, cosine, sine;

  PackMultiples(const Pack& c, const Pack& s) : first_cosine(c), first_sine(s), cosine(c), sine(s) {}
  void next() {
    const Pack c = cosine * first_cosine - sine * first_sine;
    sine = sine * first_cosine + cosine * first_sine;
    cosine = c;
  }
};

/// Adds the waves of the elastic outer race, as a form that is fixed in the carrier and changes.
inline void add_rim(int waves, const FormState& state, const Pack& cosine, const Pack& sine,
                    FormSlopes<PackPair>& form) {
  Pack height = spread(state.wave[0]), rate = spread(state.wave_speed[0]), slope{}, bend{}, rate_slope{};
  PackMultiples turned(cosine, sine);
  for (int i = 1; i + 1 < waves; i += 2) {
    turned.next();
    const double n = (i + 3) / 2, *position = state.wave + i, *speed = state.wave_speed + i;
    const Pack outward = position[0] * turned.cosine + position[1] * turned.sine;
    height += outward;
    slope += (n * position[1]) * turned.cosine - (n * position[0]) * turned.sine;
    bend -= (n * n) * outward;
    rate += speed[0] * turned.cosine + speed[1] * turned.sine;
    rate_slope += (n * speed[1]) * turned.cosine - (n * speed[0]) * turned.sine;
  }
  form.height.high += height;
  form.slope.high += slope;
  form.bend.high += bend;
  form.rate.high += rate;
  form.rate_slope.high += rate_slope;
}

/// Adds what `load` [N] on the outer race does to its waves.
inline void add_wave_forces(int waves, const Pack& load, const Pack& cosine, const Pack& sine, Pack* force) {
  force[0] += load;
  PackMultiples turned(cosine, sine);
  for (int i = 1; i + 1 < waves; i += 2) {
    turned.next();
    force[i] += load * turned.cosine;
    force[i + 1] += load * turned.sine;
  }
}

/// `cosine`, `sine` of the normal's angle in the carrier frame.
inline FormSlopes<Pack> form_slopes(const RaceConstants& race, const Pack& cosine, const Pack& sine) {
  FormSlopes<Pack> sum{};
  for (const RaceHarmonic& wave : race.form) {
    // (cosine + i sine)^order, by squaring.
    Pack c = spread(1.0), s{}, base_c = cosine, base_s = sine;
    for (int n = wave.order; n > 0; n /= 2) {
      if (n % 2 == 1) {
        const Pack next = c * base_c - s * base_s;
        s = c * base_s + s * base_c;
        c = next;
      }
      const Pack square = base_c * base_c - base_s * base_s;
      base_s = 2.0 * base_c * base_s;
      base_c = square;
    }
    const double order = wave.order, phase = wave.rotating ? wave.phase - order * race.turned : wave.phase;
    const double turn_c = wave.amplitude * __builtin_cos(phase);
    const double turn_s = wave.amplitude * __builtin_sin(phase);
    const Pack height = turn_c * c - turn_s * s;
    const Pack slope = -order * (turn_c * s + turn_s * c);
    sum.height += height;
    sum.slope += slope;
    sum.bend -= order * order * height;
    if (wave.rotating) {
      sum.rotating_slope += slope;
      sum.rotating_bend -= order * order * height;
    }
  }
  add_scratches(race, cosine, sine, sum);
  return sum;
}

inline FormSlopes<PackPair> form_slopes(const RacePair& race, const PackPair& cosine, const PackPair& sine) {
  const FormSlopes<Pack> inner = form_slopes(*race.inner, cosine.low, sine.low);
  const FormSlopes<Pack> outer = form_slopes(*race.outer, cosine.high, sine.high);
  return {{inner.height, outer.height},
          {inner.slope, outer.slope},
          {inner.bend, outer.bend},
          {inner.rotating_slope, outer.rotating_slope},
          {inner.rotating_bend, outer.rotating_bend},
          {inner.rolling_slope, outer.rolling_slope},
          {inner.rolling_bend, outer.rolling_bend},
          {inner.rate, outer.rate},
          {inner.rate_slope, outer.rate_slope}};
}

/// Adds what the scratches of the rollers do to one contact: `side` -1 on the inner race, 1 on the outer one.
inline void add_roller_scratch(const RollerScratch& scratch, double side, double turned, const Mask& own,
                               const Pack& cosine, const Pack& sine, Pack& height, Pack& slope, Pack& bend) {
  const TrackDepth<Pack> element_depth =
      depth_at(side < 0.0 ? scratch.on_inner : scratch.on_outer, scratch.radius, scratch.angle + turned,
               side * cosine, side * sine);
  height += only(own, side * element_depth.depth);
  slope += only(own, side * element_depth.by_angle);
  bend += only(own, side * element_depth.bend);
}

inline void add_roller_scratches(const RacePair& race, const FormState& rollers, const PackPair& cosine,
                                 const PackPair& sine, FormSlopes<PackPair>& form) {
  for (const RollerScratch& scratch : race.roller_scratches) {
    const int lane = scratch.roller - rollers.first;
    if (lane < 0 || lane >= kLanes) continue;
    const Mask own = first_lanes(lane + 1) & ~first_lanes(lane);
    const double turned = rollers.turned[scratch.followed];
    PackPair height{}, slope{}, bend{};
    add_roller_scratch(scratch, -1.0, turned, own, cosine.low, sine.low, height.low, slope.low, bend.low);
    add_roller_scratch(scratch, 1.0, turned, own, cosine.high, sine.high, height.high, slope.high, bend.high);
    form.height += height;
    form.slope += slope;
    form.bend += bend;
    form.rolling_slope += slope;
    form.rolling_bend += bend;
  }
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
