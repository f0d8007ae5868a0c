// The film as [Gai2025] prints it in the approach: subtracted, so that it opens the contact like a clearance.
//
// With the film h(Q) of Eq. (10), elastic approach = geometric approach - h has two loads for every approach
// beyond a least one and none below it, since e + h(e) first falls and then rises; which of them the source
// took is not said. What can be reproduced is the film of one load: here that of the most loaded roller
// without clearance, 4.08 F/Z, at pure rolling, for all rollers alike.
#pragma once

#include "bearing/geometry.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// Film on each race [m].
struct PublishedFilm {
  double inner = 0.0;
  double outer = 0.0;

  /// By how much both films enlarge the diametral clearance [m].
  double clearance() const { return 2.0 * (inner + outer); }
};

/// Least film of Eq. (10) of [Gai2025] under `load` [N] on the bearing, between races turning at the given
/// speeds [rad/s].
PublishedFilm published_film(const Bearing& bearing, const BearingGeometry& geometry,
                             const Lubricant& lubricant, double inner_speed, double outer_speed, double load);

}  // namespace orbearing::bearing
