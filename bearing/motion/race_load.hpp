// Load of a race contact from its geometric approach: elastic contact in series with the oil film.
#pragma once

#include "bearing/contact/race_contact.hpp"

namespace orbearing::bearing::motion {

/// Inverse of RaceContact::approach with a film that follows the entrainment speed. Without film the law is
/// the elastic contact alone.
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

  const LineContact& elastic() const { return elastic_; }
  bool with_film() const { return with_film_; }
  const FilmLaw<double>& film() const { return film_; }

 private:
  LineContact elastic_;
  bool with_film_ = false;
  FilmLaw<double> film_;
  double log_stiffness_ = 0.0;  // ln K
};

}  // namespace orbearing::bearing::motion
