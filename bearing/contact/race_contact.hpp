// Contact of a roller with one race: elastic line contact and oil film in series.
#pragma once

#include <optional>

#include "bearing/contact/film.hpp"
#include "bearing/contact/line_contact.hpp"

namespace orbearing::bearing {

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
