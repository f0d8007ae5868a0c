// Rollers on a race: forces and their derivatives, one roller a lane. The laws are those of
// dynamics/race_load.hpp, contact_damping.hpp, traction.hpp and race_forces.hpp, here with their slopes.
//
// Vectors are in polar axes (e_r, e_theta) of each roller. A derivative treats these axes as at rest; what
// their turning adds is the caller's (ContactSlopes).
#pragma once

#include "bearing/fast/friction.hpp"
#include "bearing/fast/race_load.hpp"

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
