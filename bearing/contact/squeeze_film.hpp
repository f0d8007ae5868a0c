// The oil that roller and race press out as they come closer: the rate of the film that FilmLaw states.
//
// A contact is its film in series with what yields elastically; both carry one load. Of the closing speed V
// of the bodies the film takes the share
//
//     (1)  s = c_f / (c_f + c_e),   c_e = 9/10 e/Q,   c_f = n h/Q,   n = (W + m Q)/(W + Q)
//
// with e the elastic approach and Q its load, h the film, W = 4 eta u l R/h the load that a wedge of rigid
// bodies would carry at that film: oil between rigid bodies thins as 1/Q (n = 1), between elastic ones as
// Q^-m (n = m, FilmLaw). Where the bodies do not touch, h is what is left between them, and s = 1. The film
// so closes at s V, and its resistance is that of RigidLineFilm; on the bodies it acts by the same share:
//
//     (2)  Q_s = s (rigid film(h, u, s V) - rigid film(h, u, 0)),   lost: Q_s V >= 0
//
// Load and Q_s together are cut at zero: cavitated oil does not pull. (1) and (2) are what a film whose
// thickness is a variable of its own comes to where it follows the load within a time short beside that of
// the motion, c/(k_f + k_e), some microseconds at 1 N and less at more. Under load s goes to zero, and with
// it the resistance; pressure does not raise the viscosity in it. Both err to the side of too little damping.
// No header of a library here: files compiled for special instruction sets include it.
#pragma once

#include "bearing/contact/film_law.hpp"
#include "bearing/contact/point_film.hpp"
#include "bearing/contact/rigid_line_film.hpp"
#include "bearing/contact/rigid_point_film.hpp"

namespace orbearing::bearing {

/// The share (1) at a film of `gap` [m] and an elastic approach `elastic` [m] under `load` [N] >= 0, `wedge`
/// [N] > 0 being W. `thinning` is m, `yielding` the power of the load with which the elastic approach grows.
template <class Wedge, class Load, class Gap, class Elastic>
auto film_share(const Wedge& wedge, const Load& load, const Gap& gap, const Elastic& elastic, double thinning,
                double yielding) {
  using namespace mechanics;
  const auto film_gives = (wedge + thinning * load) * gap;
  const auto bodies_give =
      yielding * (larger(elastic, Plain<decltype(value_of(elastic))>{}) * (wedge + load));
  return film_gives / (film_gives + bodies_give);
}

/// Squeeze of the film between roller and race. Numbers alone, see RigidLineFilm.
template <class Number>
struct SqueezeFilm {
  RigidLineFilm<Number> film;
  Number least{};  // [m]  where asperities hold the film

  /// Requires oil and `roughness` [m] > 0. Contact is a FilmContact.
  template <class Contact>
  static SqueezeFilm of(const Contact& contact, double roughness) {
    return {RigidLineFilm<Number>::of(contact.lubricant.viscosity, contact.length, contact.equivalent_radius),
            roughness};
  }

  /// Least distance of the surfaces [m], where they touch the central film of `law`, at the geometric
  /// `approach` [m], elastic approach `elastic` [m] (negative where they are apart) and its load [N].
  /// `in_approach`: the film takes room, which is what tells both approaches apart; else it is there all the
  /// same.
  template <class Law, class Approach, class Elastic, class Load, class LogSpeed>
  auto gap(bool in_approach, const Law& law, const Approach& approach, const Elastic& elastic,
           const Load& load, const LogSpeed& log_speed) const {
    using namespace mechanics;
    constexpr double kLeastLoad = 1e-9;  // [N]  far below any at which the film thins
    const Plain<decltype(value_of(elastic))> zero{};
    const auto central = [&] {
      return exponential(law.log_central(logarithm(larger(load, zero + kLeastLoad)), log_speed)) -
             smaller(elastic, zero);
    };
    decltype(central()) gap{};
    if (in_approach)
      gap = larger(elastic, zero) - approach;
    else
      gap = central();
    return larger(gap, zero + least);
  }

  /// The share (1) at elastic approach `elastic` [m], under `load` [N] >= 0 with a film of `gap` [m] > 0 and
  /// entrainment `speed` [m/s] > 0.
  template <class Elastic, class Load, class Gap, class Speed>
  auto share(const Elastic& elastic, const Load& load, const Gap& gap, const Speed& speed) const {
    return film_share(film.wedge(film.slenderness(gap), speed), load, gap, elastic, FilmLaw<Number>::kLoad,
                      kLineApproachExponent);
  }

  /// Load (2) [N] at closing speed `closing` [m/s], with its sign, before it is cut together with the elastic
  /// load.
  template <class Elastic, class Load, class Gap, class Speed, class Closing>
  auto load(const Elastic& elastic, const Load& elastic_load, const Gap& gap, const Speed& speed,
            const Closing& closing) const {
    const auto part = share(elastic, elastic_load, gap, speed);
    return part * film.squeeze(film.slenderness(gap), speed, part * closing);
  }
};

/// What (2) gives in a contact of a ball, with its slopes. Those of film and share under load are left out.
template <class Number>
struct BallSqueeze {
  Number load;         // [N]      with the sign of the closing speed
  Number by_approach;  // [N/m]    where the bodies are apart
  Number by_closing;   // [N s/m]
};

/// Squeeze of the film between ball and race.
struct PointSqueezeFilm {
  static constexpr double kYielding = 2.0 / 3.0;  // of Hertz' elastic approach over the load
  static constexpr double kLeastLoad =
      1.0;  // [N]  below it the film is no thicker: its law is that of elastic bodies

  RigidPointFilm film;  // x along the direction of rolling

  bool present() const { return film.present(); }

  /// At the approach `approach` [m], negative where ball and race are apart, under `load` [N] >= 0, entrained
  /// with `speed` [m/s] > 0 along the direction of rolling.
  template <class Number>
  BallSqueeze<Number> at(const PointFilmLaw& law, const Number& approach, const Number& load,
                         const Number& speed, const Number& closing) const {
    using namespace mechanics;
    const Number zero{};
    const Number central =
        exponential(law.log_film(logarithm(larger(load, zero + kLeastLoad)), logarithm(speed)));
    const Number gap = larger(central - smaller(approach, zero), zero + film.least_gap);
    const Number share = film_share(film.wedge(gap, speed), load, gap, approach, law.load, kYielding);
    const SqueezedPoint<Number> pressed = film.squeezed(gap, share * closing, speed);
    return {share * pressed.load, only(approach < zero, -pressed.by_gap), share * share * pressed.by_closing};
  }
};

}  // namespace orbearing::bearing
