// Squeeze film between roller and race that approach each other: the rate of the film of FilmLaw.
//
// A contact is its film in series with its elastic deflection; both carry one load. The film has the
// following share of the closing speed V of the bodies:
//
//     (1)  s = c_f / (c_f + c_e),   c_e = 9/10 e/Q,   c_f = n h/Q,   n = (W + m Q)/(W + Q)
//
// with e the elastic approach and Q its load, h the film, W = 4 eta u l R/h the load that a wedge of rigid
// bodies would carry at that film: oil between rigid bodies thins as 1/Q (n = 1), between elastic ones as
// Q^-m (n = m, FilmLaw). Without contact of the bodies, h is the gap between them, and s = 1. The film
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
#include "mechanics/numbers.hpp"

namespace orbearing::bearing {

// Oil between two rigid bodies that nearly touch in a point: constant viscosity, flooded, squeezed and
// entrained at once. Written once for plain numbers and packs; no header of a library here, since files
// compiled for special instruction sets include it.
//
//   gap h = g + x^2 / (2 R_x) + y^2 / (2 R_y),   V = -dg/dt,   u = half the sum of both surface velocities
//   relative to the contact; Reynolds' equation  div(h^3 grad p) = 12 eta (u . grad h - V)  is solved by
//
//     p = (c - a_x x - a_y y) / h^2,   c = 6 eta V / (1/R_x + 1/R_y),   a_x = 12 eta u_x / (3 + 2 R_x / R_y),
//
//   cut where it would fall below zero (half-Sommerfeld), so that the film never pulls. With
//   A^2 = 2 g (R_x a_x^2 + R_y a_y^2) its resultant is  pi sqrt(R_x R_y) / g (c + sqrt(A^2 + c^2)).
//
// Squeeze alone on a sphere before a plane is Taylor's 6 pi eta R^2 V / g; entrainment alone that of
// [Kapitza1955], as in [Hamrock2004].

/// Load of a film and what it does to surfaces that slide, with the slopes that a stage of a step needs.
template <class Number>
struct RigidPointLoad {
  Number load;          // [N]      pushes apart, >= 0
  Number by_gap;        // [N/m]    <= 0
  Number by_closing;    // [N s/m]  >= 0
  Number by_ux, by_uy;  // [N s/m]
  Number shear;         // [N s/m]  of both surfaces against sliding
};

/// Contribution of closing to the load of the wedge, with slopes.
template <class Number>
struct SqueezedPoint {
  Number load;        // [N]      with the sign of the closing speed
  Number by_gap;      // [N/m]
  Number by_closing;  // [N s/m]  >= 0
};

struct RigidPointFilm {
  double size = 0.0;         // [m]       pi sqrt(R_x R_y); 0: no film
  double squeeze = 0.0;      // [N s/m]   c / V
  double entrained_x = 0.0;  // [N s m^-1.5]  A / (sqrt(g) u_x)
  double entrained_y = 0.0;
  double rolling_x = 0.0;  // [-]       traction on each surface over shear times u_x
  double rolling_y = 0.0;
  double viscosity = 0.0;  // [Pa s]
  double extent = 0.0;     // [m]       gap by which the film ends: that at its edge less that in its middle
  double least_gap = 0.0;  // [m]       where asperities hold it

  bool present() const { return size > 0.0; }

  /// Film between bodies of radii `rx`, `ry` [m] that extends to `wide_x`, `wide_y` [m] from its middle.
  static RigidPointFilm between(double viscosity, double rx, double ry, double wide_x, double wide_y,
                                double least_gap) {
    constexpr double kPi = 3.14159265358979323846;
    const auto wedge = [&](double along, double across) {
      return 12.0 * viscosity / (3.0 + 2.0 * along / across);
    };
    const auto rolling = [](double along, double across) { return 6.0 / (3.0 + 2.0 * along / across); };
    const double mean = __builtin_sqrt(rx * ry);
    return {.size = kPi * mean,
            .squeeze = 6.0 * viscosity / (1.0 / rx + 1.0 / ry),
            .entrained_x = wedge(rx, ry) * __builtin_sqrt(2.0 * rx),
            .entrained_y = wedge(ry, rx) * __builtin_sqrt(2.0 * ry),
            .rolling_x = rolling(rx, ry),
            .rolling_y = rolling(ry, rx),
            .viscosity = viscosity,
            .extent = wide_x * wide_y / (2.0 * mean),
            .least_gap = least_gap};
  }

  /// Load [N] of the wedge only at `gap` [m], entrained along x with `ux` [m/s].
  template <class Number>
  Number wedge(const Number& gap, const Number& ux) const {
    using namespace mechanics;
    return (size * entrained_x) * absolute(ux) * inverse_root(gap);
  }
  /// Contribution of closing at `closing` [m/s]: if the surfaces separate, less than the load of the wedge.
  template <class Number>
  SqueezedPoint<Number> squeezed(const Number& gap, const Number& closing, const Number& ux) const {
    using namespace mechanics;
    constexpr double kAtRest = 1e-30;  // [N^2/m^2]  keeps the slope finite
    const Number c = squeeze * closing, per_gap = size / gap;
    const Number x = entrained_x * ux, carried = x * x;
    const Number alone = root(gap * carried + kAtRest), together = root(gap * carried + c * c + kAtRest);
    const Number load = per_gap * c * (1.0 + c / (together + alone));
    return {load, per_gap * (0.5 * carried) * (1.0 / together - 1.0 / alone) - load / gap,
            (squeeze * per_gap) * (1.0 + c / together)};
  }

  /// At `gap` [m], which the least gap bounds, closing at `closing` and entrained with `ux`, `uy` [m/s].
  /// Shear is that of h from its middle to its edge over the half that carries, and over both where it is
  /// squeezed.
  template <class Number>
  RigidPointLoad<Number> at(const Number& gap, const Number& closing, const Number& ux,
                            const Number& uy) const {
    using namespace mechanics;
    constexpr double kAtRest = 1e-30;  // [N^2/m^2]  keeps the slope finite
    const Number held = Number{} + least_gap;
    const Number g = larger(gap, held);
    const auto free = gap > held;
    const Number c = squeeze * closing;
    const Number x = entrained_x * ux, y = entrained_y * uy;
    const Number wedge = x * x + y * y;
    const Number together = root(g * wedge + c * c + kAtRest);
    const Number per_gap = size / g;
    const Number load = per_gap * (c + together);
    const Number pressed = larger(c, Number{}) / together;
    return {load,
            only(free, per_gap * (0.5 * wedge / together) - load / g),
            (squeeze * per_gap) * (1.0 + c / together),
            (size * entrained_x) * x / together,
            (size * entrained_y) * y / together,
            (size * viscosity) * (1.0 + pressed) * logarithm(1.0 + extent / g)};
  }
};

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

/// Squeeze of the film between roller and race. Numbers only, see RigidLineFilm.
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
  /// `in_approach`: the film takes room, which is the difference of both approaches; else it is there all the
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
                      LineLaw::kApproachExponent);
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

/// Load (2) in a contact of a ball, with its slopes. Those of film and share under load are left out.
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
