// Contact of a roller with one race: elastic line contact and oil film in series.
#pragma once

#include <optional>

#include "bearing/contact/film_law.hpp"
#include "bearing/contact/line_contact.hpp"
#include "bearing/geometry.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing {

// Oil film of a line contact: Dowson-Higginson, capped where the rigid-isoviscous film takes over.

/// Data of one contact that determine its film, besides load and speed.
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

/// Geometric approach of the rigid bodies = elastic approach - central film, so that the film adds to the
/// elastic approach (Eqs. (4) and (19) of [Gai2025] subtract it). The contact begins to carry at the approach
/// onset() <= 0.
class RaceContact {
 public:
  RaceContact(LineContact elastic, Film film) : elastic_(elastic), film_(film) {}

  /// Geometric approach [m] at contact load `load` [N] >= 0; increasing and concave in the load.
  double approach(double load) const { return elastic_.approach(load) - film_.central(load); }
  /// d(approach)/d(load) [m/N] at load > 0.
  double compliance(double load) const { return elastic_.compliance(load) - film_.slope(load); }
  /// Both at a load > 0, from one power.
  struct Response {
    double approach = 0.0;    // [m]
    double compliance = 0.0;  // [m/N]
  };
  Response response(double load) const {
    const double elastic = elastic_.approach(load);
    return {elastic - film_.central(load), LineContact::compliance(load, elastic) - film_.slope(load)};
  }
  /// Approach [m] at which the load begins.
  double onset() const { return -film_.cap(); }
  /// Stored energy [J] at contact load `load`: elastic energy and what the thinning film holds.
  double energy(double load) const { return elastic_.energy(elastic_.approach(load)) + film_.energy(load); }

  const LineContact& elastic() const { return elastic_; }
  const Film& film() const { return film_; }

 private:
  LineContact elastic_;
  Film film_;
};

/// Both contacts of a roller at pure rolling between races turning at the given speeds [rad/s].
struct RollerContacts {
  RaceContact inner;
  RaceContact outer;
};

/// Contacts of a roller at pure rolling, with the film of `lubricant` in the approach where one is given.
RollerContacts rolling_contacts(const Bearing& bearing, const BearingGeometry& geometry, double inner_speed,
                                double outer_speed, const std::optional<Lubricant>& lubricant);

}  // namespace orbearing::bearing
