// Rollers on a race: how they move, forces and their derivatives, one roller a lane. The laws are those of
// bearing/contact/film_law.hpp, friction.hpp and damping.hpp, which give their own slopes.
//
//   inner race (side -1)          outer race (side +1)
//     o ---n--> (roller)            (roller) is inside; n from the race's centre to the roller's
//   race centre                     contact point at  side * roller_radius * n  from the roller's centre
//
// The tangential force of the rolling resistance on the roller makes the moments of both surfaces balance; it
// is what the tilted oil pressure leaves after the drag at the inlet.
//
// Vectors are in polar axes (e_r, e_theta) of each roller. A derivative treats these axes as at rest; what
// their turning adds is the caller's (ContactSlopes).
#pragma once

#include "bearing/motion/vectorised/race_form.hpp"
#include "bearing/motion/vectorised/race_load.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Motion of a roller relative to the centre of a race (or of the cage), in polar axes.
template <class Number>
struct RelativeMotion {
  Number d_r;  // [m]      position
  Number d_t;  // [m]
  Number w_r;  // [m/s]    velocity
  Number w_t;  // [m/s]
  Pack spin;   // [rad/s]  of the roller
};

/// Position and velocity of a ring or of the cage.
struct Body {
  double x, y, v_x, v_y;
};

/// Rollers in their own polar coordinates.
struct RollerMotion {
  Pack r, theta, radial, orbital;  // [m], [rad], [m/s], [rad/s]
  Pack spin;                       // [rad/s]
  Pack radius;                     // [m]  of the roller
};

/// Motion of the rollers relative to `body`, in their polar axes.
inline RelativeMotion<Pack> relative_motion(const Pack& r, const Pack& radial, const Pack& orbital,
                                            const Pack& spin, const Pack& cosine, const Pack& sine,
                                            const Body& body) {
  return {r - (body.x * cosine + body.y * sine), body.x * sine - body.y * cosine,
          radial - (body.v_x * cosine + body.v_y * sine), r * orbital + body.v_x * sine - body.v_y * cosine,
          spin};
}

/// Motions relative to the inner and to the outer race side by side.
inline RelativeMotion<PackPair> joined(const RelativeMotion<Pack>& inner, const RelativeMotion<Pack>& outer) {
  return {{inner.d_r, outer.d_r},
          {inner.d_t, outer.d_t},
          {inner.w_r, outer.w_r},
          {inner.w_t, outer.w_t},
          inner.spin};
}

/// Force on the roller through its centre and moment about it; the opposite force acts on the other body.
template <class Number>
struct ContactForce {
  Number f_r{};     // [N]
  Number f_t{};     // [N]
  Number moment{};  // [N m]
  Number load{};    // [N]  normal
};

/// Slopes of (f_r, f_t, moment): by relative position, by relative velocity, by spin. [row][column]
template <class Number>
struct ContactSlopes {
  Number by_position[3][2];
  Number by_velocity[3][2];
  Number by_spin[3];
};

/// The parts of slopes at both races.
inline void split(const ContactSlopes<PackPair>& both, ContactSlopes<Pack>& inner,
                  ContactSlopes<Pack>& outer) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 2; ++k) {
      inner.by_position[i][k] = both.by_position[i][k].low;
      outer.by_position[i][k] = both.by_position[i][k].high;
      inner.by_velocity[i][k] = both.by_velocity[i][k].low;
      outer.by_velocity[i][k] = both.by_velocity[i][k].high;
    }
    inner.by_spin[i] = both.by_spin[i].low;
    outer.by_spin[i] = both.by_spin[i].high;
  }
}

/// Motion of rollers against a race: exact kinematics of rigid bodies, where the line of centres turns at its
/// own rate; speeds along the tangent t = z x n.
struct RaceMotion {
  PackPair n_r, n_t;              // [-]    normal, from the race's centre to the roller's
  PackPair inverse;               // [1/m]  1 / distance of both centres
  PackPair v_n, v_t;              // [m/s]  relative velocity of the centres
  PackPair line;                  // [rad/s]  at which the line of centres turns
  PackPair approach;              // [m]
  PackPair closing;               // [m/s]  rate of the approach
  PackPairMask present;           // where there is a roller
  PackPair race_arm, roller_arm;  // [m]
  PackPair sliding, rolling;      // [m/s]
  PackPair entrainment;           // [m/s]
  Pack spin;                      // [rad/s]  of the roller
  PackPair log_turn;              // [s/m]  slope of the entrainment speed's logarithm by the rolling speed
  FormSlopes<PackPair> form;
};

inline RaceMotion race_motion(const RacePair& race, const Pack& radius, const Mask& present,
                              const Pack& cosine, const Pack& sine, const FormState& state,
                              const RelativeMotion<PackPair>& relative) {
  RaceMotion m;
  const PackPair square = relative.d_r * relative.d_r + relative.d_t * relative.d_t;
  m.inverse = inverse_root(square);
  const PackPair rough = square * m.inverse;
  const PackPair distance = rough + 0.5 * m.inverse * (square - rough * rough);  // to the last bit but one
  m.n_r = relative.d_r * m.inverse;
  m.n_t = relative.d_t * m.inverse;
  m.v_n = relative.w_r * m.n_r + relative.w_t * m.n_t;
  m.v_t = relative.w_t * m.n_r - relative.w_r * m.n_t;
  m.line = m.v_t * m.inverse;
  PackPair gap = distance - race.radius;
  PackPair opening = m.v_n;
  if (!race.round) {
    const PackPair c = m.n_r * cosine - m.n_t * sine, s = m.n_r * sine + m.n_t * cosine;
    m.form = form_slopes(race, c, s);
    if (race.rim_waves > 0) {
      add_rim(race.rim_waves, state, c.high, s.high, m.form);
      opening -= m.form.rate;
    }
    gap -= m.form.height;
    opening -= m.form.slope * m.line - m.form.rotating_slope * race.speed;
    if (!race.roller_scratches.empty()) {
      FormSlopes<PackPair> own{};
      add_roller_scratches(race, state, c, s, own);
      gap -= own.height;
      opening -= own.slope * m.line - own.rolling_slope * relative.spin;
      m.form.slope += own.slope;
      m.form.bend += own.bend;
      m.form.rolling_slope = own.rolling_slope;
      m.form.rolling_bend = own.rolling_bend;
    }
  }
  m.present = PackPairMask{present, present};
  m.approach = select(m.present, race.side * gap + radius, spread<PackPair>(-1.0));
  m.closing = race.side * opening;
  m.roller_arm = race.side * radius;
  m.race_arm = distance + m.roller_arm;
  const PackPair race_surface = (race.speed - m.line) * m.race_arm;
  const PackPair roller_surface = (relative.spin - m.line) * m.roller_arm;
  m.sliding = race_surface - roller_surface;
  m.rolling = 0.5 * (race_surface + roller_surface);
  m.spin = relative.spin;
  const PackPair entrainment = m.rolling * m.rolling + race.entrainment_scale * race.entrainment_scale;
  const PackPair per_entrainment = inverse_root(entrainment);
  m.log_turn = m.rolling * per_entrainment * per_entrainment;
  m.entrainment = entrainment * per_entrainment;
  return m;
}

/// The variables of the laws as forward differentiation numbers them.
enum LawVariable { kLoad, kSliding, kLogSpeed, kRolling };

/// A force along the tangent, with its slopes where they are wanted.
struct TangentForce {
  PackPair force{};  // [N]
  PackPair by_load{}, by_sliding{};
  PackPair by_rolling{};  // with the entrainment speed that follows
};

inline TangentForce tangent_force(const PackPair& force, const PackPair&) {
  return {force, PackPair{}, PackPair{}, PackPair{}};
}
template <unsigned kVariables>
TangentForce tangent_force(const mechanics::SparseDual<kVariables, PackPair>& x, const PackPair& log_turn) {
  using Dual = mechanics::SparseDual<kVariables, PackPair>;
  TangentForce t{x.value, x.template by<kLoad>(), x.template by<kSliding>(), x.template by<kRolling>()};
  if constexpr (Dual::depends(kLogSpeed)) {
    const PackPair by_entrainment = x.template by<kLogSpeed>() * log_turn;
    t.by_rolling = Dual::depends(kRolling) ? t.by_rolling + by_entrainment : by_entrainment;
  }
  return t;
}

/// Loads and slopes of the laws at one motion.
struct RaceLoads {
  PackPair elastic_approach, elastic_load;       // [m], [N]  in the middle of the contact
  PackPair load;                                 // [N]  >= 0, with damping and squeeze
  PackPair by_approach, by_closing, by_rolling;  // its slopes
  TangentForce friction;
  TangentForce inlet;  // rolling resistance
  PackPair tilt;       // [-]  arm of the oil pressure's tilt over the distance
};

/// A load under its elastic approach, and both as functions of the rigid bodies' approach and of ln u.
struct ElasticLoad {
  PackApproach approach;
  LoadSlope load;
};

/// Adds the squeeze film to `x`, which holds the elastic load with its damping.
template <bool WithSlopes>
void add_squeeze(const RacePair& race, const RaceMotion& m, const ElasticLoad& e, const PackPair& log_speed,
                 RaceLoads& x) {
  enum { kApproach, kClosing, kSpeed };
  const auto squeezed = [&](const auto& approach, const auto& elastic, const auto& load, const auto& log_u,
                            const auto& speed, const auto& closing) {
    const auto gap = race.squeeze.gap(race.film, race.film_law, approach, elastic, load, log_u);
    return race.squeeze.load(elastic, load, gap, speed, closing);
  };
  if constexpr (WithSlopes) {
    using mechanics::variable;
    using ByBoth = mechanics::SparseDual<(1u << kApproach | 1u << kSpeed), PackPair>;
    const mechanics::SparseDual<(1u << kSpeed), PackPair> speed{m.entrainment, {m.entrainment}};
    const ByBoth elastic{e.approach.value, {e.approach.by_approach, e.approach.by_log_speed}};
    const ByBoth load{e.load.load,
                      {e.load.slope * e.approach.by_approach, e.load.slope * e.approach.by_log_speed}};
    const auto film = squeezed(variable<kApproach>(m.approach), elastic, load, variable<kSpeed>(log_speed),
                               speed, variable<kClosing>(m.closing));
    x.load += only(m.present, film.value);
    x.by_approach += film.template by<kApproach>();
    x.by_closing += film.template by<kClosing>();
    x.by_rolling += film.template by<kSpeed>() * m.log_turn;
  } else {
    x.load += only(m.present,
                   squeezed(m.approach, e.approach.value, e.load.load, log_speed, m.entrainment, m.closing));
  }
  const PackPairMask open = x.load > 0.0;
  x.load = only(open, x.load);
  x.by_approach = only(open, x.by_approach);
  x.by_closing = only(open, x.by_closing);
  x.by_rolling = only(open, x.by_rolling);
}

template <bool WithSlopes>
RaceLoads race_loads(const RacePair& race, const RaceMotion& m, const Pack& cosine, const Pack& sine,
                     RollerApproaches& approaches) {
  using mechanics::variable;
  RaceLoads x;
  const PackPair log_speed =
      race.film || race.squeezed || race.friction.oiled() ? logarithm(m.entrainment) : PackPair{};
  ElasticLoad e{elastic_approach<WithSlopes>(race, m.approach, log_speed), {}};
  e.load = race.laminae.count > 0 ? lamina_load(race, e.approach, cosine, sine, approaches)
                                  : straight_load(race, e.approach);
  x.elastic_approach = e.approach.value;
  x.elastic_load = e.load.load;
  const auto damped = damping_factor(race.damping, variable<0>(m.closing));
  x.load = e.load.load * damped.value;
  if constexpr (WithSlopes) {
    x.by_approach = damped.value * (e.load.slope * e.approach.by_approach);
    x.by_closing = e.load.load * damped.template by<0>();
    x.by_rolling = damped.value * (e.load.slope * (e.approach.by_log_speed * m.log_turn));
  }
  if (race.squeezed) add_squeeze<WithSlopes>(race, m, e, log_speed, x);
  const auto tangential = [&](const auto& load, const auto& sliding, const auto& rolling, const auto& speed) {
    race.friction.friction(load, sliding, speed,
                           [&](const auto& force) { x.friction = tangent_force(force, m.log_turn); });
    if (race.friction.rolling_resistance)
      x.inlet = tangent_force(race.friction.inlet(load, rolling, speed), m.log_turn);
  };
  if constexpr (WithSlopes)
    tangential(variable<kLoad>(x.load), variable<kSliding>(m.sliding), variable<kRolling>(m.rolling),
               variable<kLogSpeed>(log_speed));
  else
    tangential(x.load, m.sliding, m.rolling, log_speed);
  x.tilt = (m.race_arm + m.roller_arm) * m.inverse;
  return x;
}

/// Derivatives of load, friction and rolling resistance of a contact by one variable of its motion.
struct LawRate {
  PackPair load, friction, inlet;
};

inline LawRate operator+(const LawRate& x, const LawRate& y) {
  return {x.load + y.load, x.friction + y.friction, x.inlet + y.inlet};
}
template <class Number>
LawRate operator*(const Number& scale, const LawRate& x) {
  return {scale * x.load, scale * x.friction, scale * x.inlet};
}

/// By what the laws see of a motion.
struct LawSlopes {
  LawRate approach, closing, rolling;
  PackPair sliding;  // of the friction only
};

inline LawSlopes law_slopes(const RaceLoads& x) {
  const auto by_load = [&](const PackPair& load) {
    return LawRate{load, x.friction.by_load * load, x.inlet.by_load * load};
  };
  LawSlopes slopes{by_load(x.by_approach), by_load(x.by_closing), by_load(x.by_rolling),
                   x.friction.by_sliding};
  slopes.rolling.friction += x.friction.by_rolling;
  slopes.rolling.inlet += x.inlet.by_rolling;
  return slopes;
}

/// Slopes of the force along n and along t and of the moment on the roller by one variable of its motion.
struct ForceRate {
  PackPair normal, tangential, moment;
};

inline ForceRate force_rate(const RacePair& race, const RaceMotion& m, const RaceLoads& x,
                            const LawRate& rate) {
  ForceRate force{-1.0 * race.side * rate.load, rate.friction + rate.inlet * x.tilt,
                  (rate.friction - rate.inlet) * m.roller_arm};
  if (!race.round) {
    force.tangential += race.side * m.inverse * m.form.slope * rate.load;
    force.moment -= race.side * m.form.rolling_slope * rate.load;
  }
  return force;
}

/// Slopes along the normal and the tangent: by the distance and a shift across, by both velocities, by spin.
struct NormalSlopes {
  ForceRate distance, across, v_n, v_t, spin;
};

inline NormalSlopes normal_slopes(const RacePair& race, const RaceMotion& m, const RaceLoads& x,
                                  const PackPair& f_n, const PackPair& f_t) {
  const NumberPair side = race.side;
  const LawSlopes laws = law_slopes(x);
  const auto sliding_and_rolling = [&](const PackPair& sliding, const PackPair& rolling) {
    LawRate rate = rolling * laws.rolling;
    rate.friction += sliding * laws.sliding;
    return rate;
  };
  const PackPair line_by_distance = -m.line * m.inverse;
  const PackPair race_by_distance = race.speed - m.line - line_by_distance * m.race_arm;
  const PackPair roller_by_distance = -line_by_distance * m.roller_arm;
  LawRate distance = sliding_and_rolling(race_by_distance - roller_by_distance,
                                         0.5 * (race_by_distance + roller_by_distance)) +
                     side * laws.approach;
  LawRate v_t = sliding_and_rolling((m.roller_arm - m.race_arm) * m.inverse,
                                    -0.5 * (m.race_arm + m.roller_arm) * m.inverse);
  if (!race.round) {
    const PackPair steep = -1.0 * side * m.form.slope;
    distance = distance + steep * line_by_distance * laws.closing;
    v_t = v_t + steep * m.inverse * laws.closing;
  }
  NormalSlopes n;
  n.distance = force_rate(race, m, x, distance);
  n.v_n = force_rate(race, m, x, side * laws.closing);
  n.v_t = force_rate(race, m, x, v_t);
  LawRate spin = sliding_and_rolling(-m.roller_arm, 0.5 * m.roller_arm);
  if (!race.round) spin = spin + side * m.form.rolling_slope * laws.closing;
  n.spin = force_rate(race, m, x, spin);
  n.distance.tangential += x.inlet.force * (1.0 - x.tilt) * m.inverse;
  // A shift across turns the normal: with it v_n and v_t, and the force itself.
  const PackPair up = m.v_t * m.inverse, down = m.v_n * m.inverse;
  n.across = {n.v_n.normal * up - n.v_t.normal * down - f_t * m.inverse,
              n.v_n.tangential * up - n.v_t.tangential * down + f_n * m.inverse,
              n.v_n.moment * up - n.v_t.moment * down};
  if (!race.round) {
    const PackPair per_distance = side * m.inverse;
    n.distance.tangential -= per_distance * x.load * m.form.slope * m.inverse;
    const PackPair climb = -1.0 * m.form.slope * per_distance;
    const PackPair gain = (m.form.rotating_bend * race.speed + m.form.rolling_bend * m.spin -
                           m.form.bend * m.line - m.form.rate_slope) *
                          per_distance;
    const ForceRate by_form = force_rate(race, m, x, climb * laws.approach + gain * laws.closing);
    n.across.normal += by_form.normal;
    n.across.tangential += by_form.tangential + per_distance * x.load * m.form.bend * m.inverse;
    n.across.moment += by_form.moment - per_distance * x.load * m.form.rolling_bend;
  }
  return n;
}

/// Slopes in polar axes, `f_n` and `f_t` being the force along n and t.
inline void race_slopes(const RacePair& race, const RaceMotion& m, const RaceLoads& x, const PackPair& f_n,
                        const PackPair& f_t, ContactSlopes<PackPair>& slopes) {
  const NormalSlopes n = normal_slopes(race, m, x, f_n, f_t);
  // From (n, t) to polar axes: K' = R K R^T with R = [n_r -n_t; n_t n_r].
  const auto turned = [&](const ForceRate& by_n, const ForceRate& by_t, PackPair(&into)[3][2]) {
    const PackPair n_by_r = by_n.normal * m.n_r - by_t.normal * m.n_t;
    const PackPair n_by_t = by_n.normal * m.n_t + by_t.normal * m.n_r;
    const PackPair t_by_r = by_n.tangential * m.n_r - by_t.tangential * m.n_t;
    const PackPair t_by_t = by_n.tangential * m.n_t + by_t.tangential * m.n_r;
    into[0][0] = m.n_r * n_by_r - m.n_t * t_by_r;
    into[0][1] = m.n_r * n_by_t - m.n_t * t_by_t;
    into[1][0] = m.n_t * n_by_r + m.n_r * t_by_r;
    into[1][1] = m.n_t * n_by_t + m.n_r * t_by_t;
    into[2][0] = by_n.moment * m.n_r - by_t.moment * m.n_t;
    into[2][1] = by_n.moment * m.n_t + by_t.moment * m.n_r;
  };
  turned(n.distance, n.across, slopes.by_position);
  turned(n.v_n, n.v_t, slopes.by_velocity);
  slopes.by_spin[0] = n.spin.normal * m.n_r - n.spin.tangential * m.n_t;
  slopes.by_spin[1] = n.spin.normal * m.n_t + n.spin.tangential * m.n_r;
  slopes.by_spin[2] = n.spin.moment;
}

/// Along the normal and the tangent, and about the roller's centre.
struct NormalForce {
  PackPair normal, tangential, moment;
};

inline NormalForce normal_force(const RacePair& race, const RaceMotion& m, const RaceLoads& x) {
  NormalForce force{-race.side * x.load, x.friction.force + x.inlet.force * x.tilt,
                    (x.friction.force - x.inlet.force) * m.roller_arm};
  if (!race.round) {
    force.tangential += race.side * x.load * m.form.slope * m.inverse;
    force.moment -= race.side * x.load * m.form.rolling_slope;
  }
  return force;
}

/// In polar axes.
inline ContactForce<PackPair> contact_force(const RaceMotion& m, const RaceLoads& x,
                                            const NormalForce& force) {
  return {force.normal * m.n_r - force.tangential * m.n_t, force.normal * m.n_t + force.tangential * m.n_r,
          force.moment, x.load};
}

/// Forces of both races on the rollers, and their slopes where wanted. `radius` [m] are those of the rollers;
/// lanes outside `present` have no contact. `cosine` and `sine` are those of the rollers' angles. `approaches` is
/// set where the contacts are cut into laminae.
template <bool WithSlopes>
ContactForce<PackPair> race_contact(const RacePair& race, const Pack& radius, const Mask& present,
                                    const Pack& cosine, const Pack& sine, const FormState& state,
                                    const RelativeMotion<PackPair>& relative, ContactSlopes<PackPair>& slopes,
                                    RollerApproaches& approaches) {
  const RaceMotion m = race_motion(race, radius, present, cosine, sine, state, relative);
  const RaceLoads x = race_loads<WithSlopes>(race, m, cosine, sine, approaches);
  if (!any(x.load > 0.0)) {
    if constexpr (WithSlopes) slopes = ContactSlopes<PackPair>{};
    return {};
  }
  const NormalForce force = normal_force(race, m, x);
  if (race.rim_waves > 0)
    add_wave_forces(race.rim_waves, x.load.high, m.n_r.high * cosine - m.n_t.high * sine,
                    m.n_r.high * sine + m.n_t.high * cosine, state.wave_force);
  if constexpr (WithSlopes) race_slopes(race, m, x, force.normal, force.tangential, slopes);
  return contact_force(m, x, force);
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
