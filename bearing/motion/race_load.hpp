// Load of a race contact from its geometric approach: elastic contact in series with the oil film.
#pragma once

#include "bearing/contact/race_contact.hpp"

namespace orbearing::bearing::dynamics {

/// Inverse of RaceContact::approach with a film that follows the entrainment speed.
///
/// The film h = A(u) Q^-0.13, A ~ u^0.7, is capped as in Film; cap film and cap load follow u by known
/// powers, so that one logarithm and two exponentials serve them all. Without film the law is the elastic
/// contact alone.
class RaceLoadLaw {
 public:
  /// Dry contact.
  explicit RaceLoadLaw(LineContact elastic) : elastic_(elastic) {}
  /// Contact with the film of `contact` in its approach.
  RaceLoadLaw(LineContact elastic, const FilmContact& contact);

  /// Load [N] at geometric approach `approach` [m] and entrainment speed `entrainment` [m/s] > 0.
  double load(double approach, double entrainment) const;
  /// Stored energy [J]: the work of the load from first touch, at constant entrainment speed.
  double energy(double approach, double entrainment) const;
  /// d(energy)/d(entrainment) [J s/m] at constant approach: what a change of the film does as work.
  double energy_slope(double approach, double entrainment) const;
  /// Elastic approach [m] = geometric approach + central film; zero or negative without contact.
  double elastic_approach(double approach, double entrainment) const;

  /// The film at one entrainment speed.
  struct FilmScale {
    double factor;        // A K^-0.13, so that h = factor e^-(13/90) at elastic approach e  [m^(103/90)]
    double cap;           // [m]
    double cap_approach;  // elastic approach at which the cap begins [m]
  };
  const LineContact& elastic() const { return elastic_; }
  bool with_film() const { return with_film_; }
  FilmScale film_at_unit_speed() const { return {factor_, cap_, cap_approach_}; }

 private:
  FilmScale film_scale(double entrainment) const;

  LineContact elastic_;
  bool with_film_ = false;
  double factor_ = 0.0;        // FilmScale::factor at 1 m/s
  double cap_ = 0.0;           // [m]  at 1 m/s
  double cap_approach_ = 0.0;  // [m]  at 1 m/s
};

}  // namespace orbearing::bearing::dynamics
