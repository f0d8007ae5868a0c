// Central film of an oiled line contact over load and entrainment speed, and the elastic approach of a
// contact with that film in series: written once, for plain numbers, packs and both with their slopes.
//
// A film law gives three values: log_central() at a load and a speed, both as logarithms, log_unloaded()
// without load, and load_integral(), from which the energy and all its slopes follow. The search for the
// elastic approach requires no more. No header of a library here: files compiled for special instruction sets
// include it.
#pragma once

#include "bearing/contact/line_law.hpp"
#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing {

/// Dowson-Higginson, h = H u^0.7 Q^-0.13, held at its value at the load where it meets the rigid film ~ u /
/// Q: Eq. (10) of [Gai2025], see Film.
template <class Number>
struct FilmLaw {
  static constexpr double kCentralOverLeast = 4.0 / 3.0;
  static constexpr double kLoad = 0.13;
  static constexpr double kSpeed = 0.7;
  static constexpr double kCapLoadSpeed = (1.0 - kSpeed) / (1.0 - kLoad);  // cap load ~ u^0.345
  static constexpr double kCapSpeed = kSpeed - kLoad * kCapLoadSpeed;      // film there ~ u^0.655

  Number log_factor{};    // [ln(m N^0.13)]  of the central film at 1 m/s and 1 N, were it not capped
  Number log_cap_load{};  // [ln N]          at 1 m/s

  /// Law of an oiled contact, a FilmContact, which is not named here: see below.
  template <class Contact>
  static FilmLaw of(const Contact& contact) {
    using mechanics::logarithm, mechanics::larger;
    constexpr double kLeast = -400.0;  // no film, and still a number
    const double alpha = contact.lubricant.pressure_viscosity, eta = contact.lubricant.viscosity;
    if (eta <= 0.0) return {kLeast, 0.0};
    const double factor =
        larger(kLeast, logarithm(kCentralOverLeast * 2.65) + 0.54 * logarithm(alpha) +
                           kSpeed * logarithm(eta) + 0.43 * logarithm(contact.equivalent_radius) -
                           0.03 * logarithm(contact.reduced_modulus) + kLoad * logarithm(contact.length));
    const double rigid = logarithm(4.896 * eta * contact.equivalent_radius * contact.length);
    return {factor, (rigid - factor) / (1.0 - kLoad)};
  }

  /// Whether elastic approaches may be sought by whole powers of their ninetieth root, as a power law's can.
  bool has_powers() const { return true; }

  /// ln(central film / m) without the cap.
  template <class LogLoad, class LogSpeed>
  auto log_uncapped(const LogLoad& log_load, const LogSpeed& log_speed) const {
    return kSpeed * log_speed - kLoad * log_load + log_factor;
  }
  /// ln(central film / m).
  template <class LogLoad, class LogSpeed>
  auto log_central(const LogLoad& log_load, const LogSpeed& log_speed) const {
    using mechanics::larger;
    return log_uncapped(larger(log_load, kCapLoadSpeed * log_speed + log_cap_load), log_speed);
  }
  /// ln(central film / m) of the unloaded contact, to the last bit that of log_central() below the cap.
  template <class LogSpeed>
  auto log_unloaded(const LogSpeed& log_speed) const {
    return log_uncapped(kCapLoadSpeed * log_speed + log_cap_load, log_speed);
  }
  /// Energy [J] stored by the film as the load, `load` [N] > 0, thins it: the integral of the load over
  /// -d(central film).
  template <class Load, class LogSpeed>
  auto energy(const Load& load, const LogSpeed& log_speed) const {
    using mechanics::exponential, mechanics::logarithm, mechanics::larger;
    const auto log_cap = kCapLoadSpeed * log_speed + log_cap_load;
    const auto log_loaded = larger(logarithm(load), log_cap);
    const auto at_cap = exponential(log_uncapped(log_cap, log_speed) + log_cap);
    return (kLoad / (1.0 - kLoad)) * (exponential(log_uncapped(log_loaded, log_speed) + log_loaded) - at_cap);
  }
};

/// Integral of the central film of any law over the load from zero to `load` [N] > 0 [J]. Its slope by the
/// speed is what a change of the film does as work at constant load.
template <class Law, class Load, class LogSpeed>
auto film_integral(const Law& film, const Load& load, const LogSpeed& log_speed) {
  using mechanics::exponential, mechanics::logarithm;
  const auto log_load = logarithm(load);
  return film.energy(load, log_speed) + exponential(film.log_central(log_load, log_speed) + log_load);
}

/// Elastic approach e [m] of a line contact with a film h in series, e - h(K e^(10/9), u) = `approach` [m],
/// with its slopes; zero or negative without contact.
template <class Number>
struct ElasticApproach {
  Number value;         // [m]
  Number by_approach;   // [-]
  Number by_log_speed;  // [m]  by ln u
};

/// For any film law: Newton's method within the bracket that a film gives that does not grow with the load.
/// `log_stiffness` is ln K; the law is rigid oil down to a load of K (1e-30 m)^(10/9), that is to none.
template <class Law, class Number, class Stiffness>
ElasticApproach<Number> elastic_approach(const Law& film, const Stiffness& log_stiffness,
                                         const Number& approach, const Number& log_speed) {
  using namespace mechanics;
  constexpr int kMostIterations = 60;
  constexpr double kLeast = 1e-30;  // [m]
  constexpr double kSmall = 1e-14;  // of the elastic approach: round-off
  const auto film_at = [&](const auto& e, const auto& speed) {
    return exponential(film.log_central(LineLaw::log_load(logarithm(e), log_stiffness), speed));
  };
  const Number unloaded = exponential(film.log_unloaded(log_speed));
  const auto touching = approach + unloaded > Number{} + kLeast;
  Number high = select(touching, approach + unloaded, Number{} + 1.0);
  Number low = larger(approach, Number{} + kLeast);
  low = select(touching, smaller(low, high), high);
  Number e = high;
  for (int i = 0; i < kMostIterations; ++i) {
    const auto h = film_at(variable<0>(e), log_speed);
    const Number excess = e - h.value - approach;
    const Number step = excess / (1.0 - h.template by<0>());
    const auto open = touching & (absolute(step) > kSmall * e) & (high - low > kSmall * e);
    if (!any(open)) break;
    low = select(excess > Number{}, low, e);
    high = select(excess > Number{}, e, high);
    const Number newton = e - step;
    e = select(open, select((newton > low) & (newton < high), newton, 0.5 * (low + high)), e);
  }
  const auto h = film_at(variable<0>(e), variable<1>(log_speed));
  const Number by_approach = 1.0 / (1.0 - h.template by<0>());
  const auto idle = exponential(film.log_unloaded(variable<1>(log_speed)));
  return {select(touching, e, approach + unloaded), select(touching, by_approach, Number{} + 1.0),
          select(touching, by_approach * h.template by<1>(), idle.template by<1>())};
}

}  // namespace orbearing::bearing
