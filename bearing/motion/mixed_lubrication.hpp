// Mixed lubrication: film and asperities share load and friction by the film ratio.
#pragma once

#include <algorithm>
#include <cmath>

#include "bearing/contact/film.hpp"
#include "bearing/motion/traction.hpp"

namespace orbearing::bearing::dynamics {

/// Share of the load that asperities carry at `film_ratio` [-] = least film / composite roughness: 1 without
/// film, 0 where the film is thick; 1 / (1 + ratio)^2 [OlverSpikes1998].
inline double asperity_share(double film_ratio) {
  return 1.0 / ((1.0 + film_ratio) * (1.0 + film_ratio));
}

/// Least film of a line contact as in Film, for many speeds: the smaller of A u^0.7 Q^-0.13 and its cap C
/// u^0.655.
struct LeastFilm {
  double factor = 0.0;  // [m]  A at 1 m/s and 1 N
  double cap = 0.0;     // [m]  C at 1 m/s

  LeastFilm() = default;
  explicit LeastFilm(const FilmContact& contact) {
    const Film film(contact, 1.0);
    cap = film.least(0.0);
    factor = cap * std::pow(film.cap_load(), kLoadExponent);
  }

  /// [m] at `load` [N] > 0 and `entrainment` [m/s] > 0.
  double at(double load, double entrainment) const {
    const double speed = std::log(entrainment);
    const double thinned = factor * std::exp(kSpeedExponent * speed - kLoadExponent * std::log(load));
    return std::min(thinned, cap * std::exp(kCapSpeedExponent * speed));
  }

  static constexpr double kLoadExponent = 0.13;
  static constexpr double kSpeedExponent = 0.7;
  static constexpr double kCapSpeedExponent =
      kSpeedExponent - kLoadExponent * (1.0 - kSpeedExponent) / (1.0 - kLoadExponent);
};

/// Mixed lubrication of one race.
struct MixedLubrication {
  bool on = false;
  double roughness = 0.0;      // [m]    composite rms
  double friction = 0.0;       // [-]    of asperities
  double sliding_scale = 0.0;  // [m/s]  rounds the friction of asperities at zero
  LeastFilm film;

  /// Traction [N] of a contact whose film alone, under the whole load, would give `film_traction` [N].
  /// Asperities carry their share with boundary friction, the film the rest: both have the sign of the
  /// sliding.
  double shared(double film_traction, double load, double sliding, double entrainment) const;
};

}  // namespace orbearing::bearing::dynamics
