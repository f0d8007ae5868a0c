// Rollers on a race: forces and their derivatives, one roller a lane. The laws are those of
// dynamics/race_load.hpp, contact_damping.hpp, traction.hpp and race_forces.hpp, here with their slopes.
//
// Vectors are in polar axes (e_r, e_theta) of each roller. A derivative treats these axes as at rest; what
// their turning adds is the caller's (ContactSlopes).
#pragma once

#include "bearing/fast/constants.hpp"
#include "bearing/fast/lane_math.hpp"

namespace orbearing::bearing::fast::ORBEARING_LANES {

/// Motion of a roller relative to the centre of a race (or of the cage), in polar axes.
struct RelativeMotion {
  Pack d_r;   // [m]      position
  Pack d_t;   // [m]
  Pack w_r;   // [m/s]    velocity
  Pack w_t;   // [m/s]
  Pack spin;  // [rad/s]  of the roller
};

/// Force on the roller through its centre and moment about it; the other body feels the opposite force.
struct ContactForce {
  Pack f_r{};     // [N]
  Pack f_t{};     // [N]
  Pack moment{};  // [N m]
  Pack load{};    // [N]  normal
};

/// Slopes of (f_r, f_t, moment): by relative position, by relative velocity, by spin. [row][column]
struct ContactSlopes {
  Pack by_position[3][2]{};
  Pack by_velocity[3][2]{};
  Pack by_spin[3]{};
};

/// A value and its slopes by two arguments.
struct Slopes2 {
  Pack value;
  Pack by_first;
  Pack by_second;
};

/// x^(-13/90) to a few per cent, from the bits of `x` > 0, which are nearly its logarithm.
inline Pack rough_film_power(const Pack& x) {
  constexpr double m = 0.13 * 10.0 / 9.0;
  constexpr long long kOne = 0x3ff0000000000000LL;
  const Pack bits = detail::whole_numbers((Mask)x - (Mask{} + kOne), 32);
  return (Pack)((detail::nearest(bits * -m) << 32) + (Mask{} + kOne));
}

/// Binomial coefficients of a power.
struct BinomialSeries {
  double c[12];
  constexpr explicit BinomialSeries(double power) : c{1.0} {
    for (int k = 1; k < 12; ++k) c[k] = c[k - 1] * (power - (k - 1)) / k;
  }
};

/// (1 + x)^power for |x| < 0.1, relative error below 1e-12; pairs of terms first, which keeps all units busy.
inline Pack near_one_power(const Pack& x, const BinomialSeries& series) {
  const double(&c)[12] = series.c;
  const Pack x2 = x * x, x4 = x2 * x2;
  const Pack low = (c[0] + c[1] * x) + x2 * (c[2] + c[3] * x);
  const Pack middle = (c[4] + c[5] * x) + x2 * (c[6] + c[7] * x);
  const Pack high = (c[8] + c[9] * x) + x2 * (c[10] + c[11] * x);
  return low + x4 * (middle + x4 * high);
}

/// Root e of e - factor e^-m = approach, with film = factor e^-m and ninth = e^(1/9).
struct ThinnedFilm {
  Pack approach;
  Pack film;
  Pack ninth;
};

/// A start within a few per cent, one step of Halley, one of Newton; powers are followed by their series.
inline ThinnedFilm thinned_film(const Pack& approach, const Pack& factor, const Pack& beyond) {
  constexpr double m = 0.13 * 10.0 / 9.0;
  constexpr BinomialSeries kFilmSeries(-m), kNinthSeries(1.0 / 9.0);
  Pack e = larger(approach + factor * rough_film_power(beyond), 0.1 * beyond);
  e = larger(approach + factor * rough_film_power(e), 0.5 * e);
  Pack film{}, ninth{}, ratio{};
  for (int i = 0; i < 4; ++i) {
    const Pack log_e = logarithm(e);
    const Pack inverse = 1.0 / e;
    film = factor * exponential(-m * log_e);
    ninth = exponential(log_e * (1.0 / 9.0));
    const Pack residual = e - film - approach;
    const Pack share = m * film * inverse;
    const Pack slope = 1.0 + share;
    const Pack step = residual * slope / (slope * slope + residual * (0.5 * (m + 1.0)) * share * inverse);
    ratio = -step * inverse;
    if (!any(absolute(ratio) > 0.1)) break;
    e = larger(e - step, 0.2 * e);  // a start far off: begin again from here
  }
  const Pack near = e * (1.0 + ratio);
  const Pack near_film = film * near_one_power(ratio, kFilmSeries);
  const Pack last = (near - near_film - approach) / (1.0 + m * near_film / near);
  const Pack small = -last / near;
  return {near - last, near_film * (1.0 - m * small),
          ninth * near_one_power(ratio, kNinthSeries) * (1.0 + small * (1.0 / 9.0))};
}

/// Elastic load [N] by approach [m] and entrainment speed [m/s], given with its logarithm; zero where there
/// is no contact.
template <bool WithSlopes>
Slopes2 elastic_load(const RaceConstants& race, const Pack& approach, const Pack& entrainment,
                     const Pack& log_entrainment) {
  const Pack tiny = spread(1e-30);
  if (!race.film) {
    const Pack e = larger(approach, tiny);
    const Pack stiffness = race.stiffness * exponential(logarithm(e) * (1.0 / 9.0));
    const Mask touching = approach > 0.0;
    return {only(touching, stiffness * e), only(touching, stiffness * (10.0 / 9.0)), Pack{}};
  }
  // Powers of the entrainment speed, dynamics/race_load.cpp: cap ~ u^(19/29), its approach ~ u^(9/29), factor
  // ~ u^0.7.
  constexpr double m = 0.13 * 10.0 / 9.0;
  constexpr double kFilmSpeed = 0.7, kCapSpeed = 19.0 / 29.0;
  const Pack root29 = exponential(log_entrainment * (1.0 / 29.0));
  const Pack p2 = root29 * root29, p4 = p2 * p2, p8 = p4 * p4;
  const Pack cap = race.film_cap * (p8 * p8 * p2 * root29);
  const Pack cap_approach = race.film_cap_approach * (p8 * root29);
  const Pack beyond = larger(approach + cap, tiny);
  const Mask touching = approach + cap > 0.0;
  const Mask thinned = beyond > cap_approach;
  Pack e = beyond, film = cap, ninth{};
  if (any(thinned)) {
    const Pack factor = race.film_factor * exponential(kFilmSpeed * log_entrainment);
    const ThinnedFilm root = thinned_film(select(thinned, approach, cap_approach), factor,
                                          select(thinned, beyond, cap_approach + cap));
    e = select(thinned, root.approach, beyond);
    film = select(thinned, root.film, cap);
    ninth = root.ninth;
  }
  if (any(~thinned & touching)) ninth = select(thinned, ninth, exponential(logarithm(beyond) * (1.0 / 9.0)));
  const Pack stiffness = race.stiffness * ninth;
  Slopes2 result{only(touching, stiffness * e), Pack{}, Pack{}};
  if constexpr (WithSlopes) {
    const Pack yielding = only(thinned, m * film / e);
    result.by_first = only(touching, (10.0 / 9.0) * stiffness / (1.0 + yielding));
    result.by_second =
        result.by_first * select(thinned, spread(kFilmSpeed), spread(kCapSpeed)) * film / entrainment;
  }
  return result;
}

/// Friction on the roller [N] with slopes by load, sliding speed and entrainment speed.
struct Friction {
  Pack force;
  Pack by_load{};
  Pack by_sliding{};
  Pack by_entrainment{};
};

inline Friction coulomb(const RaceConstants& race, const Pack& load, const Pack& sliding) {
  const double scale_square = race.sliding_scale * race.sliding_scale;
  const Pack inverse = 1.0 / root(sliding * sliding + scale_square);
  const Pack share = race.friction * sliding * inverse;
  return {load * share, share, load * (race.friction * scale_square) * (inverse * inverse * inverse), Pack{}};
}

inline Friction limiting_shear(const RaceConstants& race, const Pack& load, const Pack& sliding,
                               const Pack& entrainment, const Pack& log_entrainment) {
  const Mask loaded = load > 0.0;
  const Pack q = select(loaded, load, spread(1.0));
  const Pack pressure = race.pressure_factor * root(q);
  const Pack exponent = race.pressure_viscosity * pressure;
  const Mask barus = exponent < race.largest_exponent;
  const Pack viscosity = race.viscosity * exponential(select(barus, exponent, spread(race.largest_exponent)));
  const Mask thinned = q > race.central_film_cap_load;
  const Pack film = race.central_film_factor *
                    exponential(0.7 * log_entrainment -
                                0.13 * logarithm(select(thinned, q, spread(race.central_film_cap_load))));
  const Pack sheared = race.friction * pressure * film / viscosity;
  const Pack scale = sheared + race.sliding_scale;
  const Pack size = absolute(sliding);
  const Pack ratio = size / scale;
  const Pack decay = exponential(-smaller(ratio, spread(600.0)));
  // 1 - exp(-x) loses digits for small x; there its series.
  const Pack series =
      ratio *
      (1.0 -
       ratio * (0.5 - ratio * (1.0 / 6 -
                               ratio * (1.0 / 24 -
                                        ratio * (1.0 / 120 - ratio * (1.0 / 720 - ratio * (1.0 / 5040)))))));
  const Pack rise = select(ratio < 1e-2, series, 1.0 - decay);
  const Pack share = with_sign_of(race.friction * rise, sliding);
  const Pack steep = race.friction * q * decay / scale;  // d(force)/d(sliding)
  const Pack log_slope = 0.5 / q - only(thinned, 0.13 / q) - only(barus, 0.5 * exponent / q);
  const Pack by_scale = -steep * sliding / scale;
  return {only(loaded, share * q), only(loaded, share + by_scale * sheared * log_slope), only(loaded, steep),
          only(loaded, by_scale * sheared * 0.7 / entrainment)};
}

/// Rolling resistance on each surface [N] with slopes by load and by the signed rolling speed; `turn` is the
/// rolling speed over the entrainment speed.
inline Slopes2 rolling_resistance(const RaceConstants& race, const Pack& load, const Pack& rolling,
                                  const Pack& log_entrainment, const Pack& turn) {
  constexpr double a = 0.658, b = 0.0126, kLoadScale = 1.0;
  const Mask loaded = load > 0.0;
  const Pack q = select(loaded, load, spread(1.0));
  const Pack powers = race.rolling_factor * exponential((a - 1.0) * log_entrainment + b * logarithm(q));
  const Pack over = 1.0 / (q + kLoadScale);
  const Pack share = powers * over;  // of the load
  const Pack force = only(loaded, share * q * rolling);
  return {force, only(loaded, share * rolling * (b + kLoadScale * over)),
          only(loaded, share * q * (1.0 + (a - 1.0) * turn * turn))};
}

/// Forces of one race on its rollers, and their slopes where wanted. `radius` [m] are those of the rollers;
/// lanes outside `present` have no contact.
template <bool WithSlopes>
ContactForce race_contact(const RaceConstants& race, const Pack& radius, const Mask& present,
                          const RelativeMotion& motion, ContactSlopes& slopes) {
  const double side = race.side;
  const Pack distance = root(motion.d_r * motion.d_r + motion.d_t * motion.d_t);
  const Pack inverse = 1.0 / distance;
  const Pack n_r = motion.d_r * inverse;
  const Pack n_t = motion.d_t * inverse;
  const Pack v_n = motion.w_r * n_r + motion.w_t * n_t;
  const Pack v_t = motion.w_t * n_r - motion.w_r * n_t;
  const Pack approach = select(present, side * (distance - race.radius) + radius, spread(-1.0));
  const Pack roller_arm = side * radius;
  const Pack race_arm = distance + roller_arm;
  const Pack line = v_t * inverse;
  const Pack race_surface = (race.speed - line) * race_arm;
  const Pack roller_surface = (motion.spin - line) * roller_arm;
  const Pack sliding = race_surface - roller_surface;
  const Pack rolling = 0.5 * (race_surface + roller_surface);
  const Pack entrainment = root(rolling * rolling + race.entrainment_scale * race.entrainment_scale);

  const bool needs_log = race.film || race.limiting_shear || race.rolling_factor > 0.0;
  const Pack log_entrainment = needs_log ? logarithm(entrainment) : Pack{};
  const Slopes2 elastic = elastic_load<WithSlopes>(race, approach, entrainment, log_entrainment);
  ContactForce result;
  if (!any(elastic.value > 0.0)) return result;
  const Pack growth = 1.0 + race.damping * side * v_n;
  const Mask pressed = growth > 0.0;
  const Pack damped = only(pressed, growth);
  const Pack load = elastic.value * damped;
  const Pack turn = rolling / entrainment;
  const Friction friction = race.limiting_shear
                                ? limiting_shear(race, load, sliding, entrainment, log_entrainment)
                                : coulomb(race, load, sliding);
  Slopes2 inlet{};
  if (race.rolling_factor > 0.0) inlet = rolling_resistance(race, load, rolling, log_entrainment, turn);
  const Pack tilt = (race_arm + roller_arm) * inverse;
  const Pack f_n = -side * load;
  const Pack f_t = friction.force + inlet.value * tilt;
  result.f_r = f_n * n_r - f_t * n_t;
  result.f_t = f_n * n_t + f_t * n_r;
  result.moment = (friction.force - inlet.value) * roller_arm;
  result.load = load;
  if constexpr (WithSlopes) {
    // By (distance, v_n, v_t, spin) first.
    const Pack line_by_distance = -line * inverse;
    const Pack race_by_distance = race.speed - line - line_by_distance * race_arm;
    const Pack roller_by_distance = -line_by_distance * roller_arm;
    const Pack race_by_vt = -race_arm * inverse;
    const Pack roller_by_vt = -roller_arm * inverse;
    const Pack load_by_rolling = damped * elastic.by_second * turn;
    const Pack friction_by_rolling = friction.by_entrainment * turn;

    struct Rates {
      Pack load, sliding, rolling;
    };
    const Pack elastic_rate = damped * elastic.by_first * side;
    const Pack roll_d = 0.5 * (race_by_distance + roller_by_distance);
    const Pack roll_t = 0.5 * (race_by_vt + roller_by_vt);
    const Pack roll_s = 0.5 * roller_arm;
    const Rates by_distance{elastic_rate + load_by_rolling * roll_d, race_by_distance - roller_by_distance,
                            roll_d};
    const Rates by_vn{only(pressed, elastic.value * race.damping * side), Pack{}, Pack{}};
    const Rates by_vt{load_by_rolling * roll_t, race_by_vt - roller_by_vt, roll_t};
    const Rates by_spin{load_by_rolling * roll_s, -roller_arm, roll_s};

    const auto friction_rate = [&](const Rates& x) {
      return friction.by_load * x.load + friction.by_sliding * x.sliding + friction_by_rolling * x.rolling;
    };
    const auto inlet_rate = [&](const Rates& x) {
      return inlet.by_first * x.load + inlet.by_second * x.rolling;
    };
    const Pack tilt_by_distance = (1.0 - tilt) * inverse;
    const Pack fr_d = friction_rate(by_distance), in_d = inlet_rate(by_distance);
    const Pack fr_n = friction.by_load * by_vn.load, in_n = inlet.by_first * by_vn.load;
    const Pack fr_v = friction_rate(by_vt), in_v = inlet_rate(by_vt);
    const Pack fr_s = friction_rate(by_spin), in_s = inlet_rate(by_spin);

    // Rows: along the normal, along the tangent, moment. Columns by (distance, v_n, v_t, spin).
    const Pack n_d = -side * by_distance.load, n_vn = -side * by_vn.load, n_vt = -side * by_vt.load,
               n_s = -side * by_spin.load;
    const Pack t_d = fr_d + in_d * tilt + inlet.value * tilt_by_distance, t_vn = fr_n + in_n * tilt,
               t_vt = fr_v + in_v * tilt, t_s = fr_s + in_s * tilt;
    const Pack m_d = (fr_d - in_d) * roller_arm, m_vn = (fr_n - in_n) * roller_arm,
               m_vt = (fr_v - in_v) * roller_arm, m_s = (fr_s - in_s) * roller_arm;

    // A shift along the tangent turns the normal, and with it v_n and v_t.
    const Pack up = v_t * inverse, down = v_n * inverse;
    const Pack n_across = n_vn * up - n_vt * down - f_t * inverse;
    const Pack t_across = t_vn * up - t_vt * down + f_n * inverse;
    const Pack m_across = m_vn * up - m_vt * down;

    // From (n, t) to polar axes: K' = R K R^T with R = [n_r -n_t; n_t n_r].
    const auto turned = [&](const Pack& nn, const Pack& nt, const Pack& tn, const Pack& tt,
                            Pack(&into)[3][2]) {
      const Pack a_n = nn * n_r - nt * n_t, a_t = nn * n_t + nt * n_r;
      const Pack b_n = tn * n_r - tt * n_t, b_t = tn * n_t + tt * n_r;
      into[0][0] = n_r * a_n - n_t * b_n;
      into[0][1] = n_r * a_t - n_t * b_t;
      into[1][0] = n_t * a_n + n_r * b_n;
      into[1][1] = n_t * a_t + n_r * b_t;
    };
    turned(n_d, n_across, t_d, t_across, slopes.by_position);
    turned(n_vn, n_vt, t_vn, t_vt, slopes.by_velocity);
    slopes.by_position[2][0] = m_d * n_r - m_across * n_t;
    slopes.by_position[2][1] = m_d * n_t + m_across * n_r;
    slopes.by_velocity[2][0] = m_vn * n_r - m_vt * n_t;
    slopes.by_velocity[2][1] = m_vn * n_t + m_vt * n_r;
    slopes.by_spin[0] = n_s * n_r - t_s * n_t;
    slopes.by_spin[1] = n_s * n_t + t_s * n_r;
    slopes.by_spin[2] = m_s;
  }
  return result;
}

}  // namespace orbearing::bearing::fast::ORBEARING_LANES
