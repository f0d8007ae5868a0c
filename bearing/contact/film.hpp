// Oil film of a line contact: Dowson-Higginson, capped where the rigid-isoviscous film takes over.
#pragma once

#include "bearing/contact/film_law.hpp"
#include "bearing/geometry.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// What the film of one contact depends on besides load and speed.
struct FilmContact {
  double equivalent_radius = 0.0;  // [m]
  double length = 0.0;             // [m]
  double reduced_modulus = 0.0;    // [Pa]  E' = E / (1 - nu^2)
  Lubricant lubricant;
};

/// Film data of a roller of `bearing` on `race`.
FilmContact film_contact(const Bearing& bearing, const BearingGeometry& geometry, Race race,
                         const Lubricant& lubricant);

/// Film at one entrainment speed as a function of the contact load Q.
///
/// Least film h = 2.65 alpha^0.54 (eta u)^0.7 R^0.43 / (E'^0.03 q^0.13), q = Q/l: Eq. (10) of [Gai2025],
/// after [DowsonHigginson1966]. The central film, which enters the approach, is 4/3 of it. As q -> 0 the
/// formula diverges; below the load where it meets the rigid-isoviscous film 4.896 eta u R / q [Martin1916]
/// it is held at the value of that crossing, since the elastic-piezoviscous law has no meaning there.
class Film {
 public:
  /// No film at all: central() is zero at every load.
  Film() = default;
  /// `entrainment_speed` [m/s] is half the sum of both surface speeds relative to the contact, >= 0.
  Film(const FilmContact& contact, double entrainment_speed);

  /// Central film thickness [m] at contact load `load` [N] >= 0.
  double central(double load) const;
  /// d(central)/d(load) [m/N], zero or negative.
  double slope(double load) const;
  /// Least film thickness [m].
  double least(double load) const;
  /// Load at which the cap begins [N].
  double cap_load() const { return cap_load_; }
  /// Central film of the unloaded contact [m]: the gap at which the contact begins to carry.
  double cap() const { return cap_; }
  /// Integral of load over -d(central) from zero to `load` [J]: what the film's thinning stores.
  double energy(double load) const;

  /// Whether there is a film at all; its law, and the logarithm of the entrainment speed [ln(m/s)].
  bool oiled() const { return oiled_; }
  const FilmLaw<double>& law() const { return law_; }
  double log_speed() const { return log_speed_; }

 private:
  bool loaded(double load) const { return oiled_ && load > cap_load_; }

  bool oiled_ = false;
  FilmLaw<double> law_;
  double log_speed_ = 0.0;  // [ln(m/s)]
  double cap_load_ = 0.0;   // [N]
  double cap_ = 0.0;        // [m]
};

}  // namespace orbearing::bearing
