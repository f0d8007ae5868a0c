// Ratings of roller bearings with a contact angle, tapered or spherical, [ISO281] and [ISO76]: one way with
// those of cylindrical rollers, whose contact angle is 0.
#pragma once

#include "bearing/life/rating_lives.hpp"
#include "bearing/life/roller_capacity.hpp"
#include "bearing/planet_rows.hpp"

namespace orbearing::bearing::rating {

/// The rating's view of one bearing of `rows`; `bearing` has the rollers of one row.
RollerSet roller_set(const Bearing& bearing, const PlanetRows& rows);

/// P [N] of tapered (one row) and spherical (two rows) roller bearings under `radial` and `axial` [N], e
/// = 1.5 tan(alpha): one row (1, 0), beyond e (0.4, 0.4 cot(alpha)); two rows (1, 0.45 cot), beyond e (0.67,
/// 0.67 cot).
double inclined_equivalent_load(const RollerSet& set, double radial, double axial);

/// P_0 [N], at least the radial load: one row (0.5, 0.22 cot(alpha)), two rows (1, 0.44 cot(alpha)).
double inclined_static_load(const RollerSet& set, double radial, double axial);

/// One bearing of a planet as the standards rate it, whatever its type. Contacts that are not cut count as
/// kLeastRatedLaminae laminae that carry alike.
BearingRating planet_bearing_rating(const Bearing& bearing, const PlanetRows& rows,
                                    const StatedRatings& stated = {});

/// Capacities [N] of one roller contact of one row by Lundberg and Palmgren, with (D/d_m)^(2/9) instead of
/// gamma^(2/9).
ContactCapacities planet_contact_capacities(const Bearing& bearing, const PlanetRows& rows,
                                            double reduction_factor);

/// The cylindrical bearing whose races are as curved as those of the inclined rows: its pitch diameter is
/// theirs over cos(alpha).
Bearing upright(const Bearing& bearing, const PlanetRows& rows);

}  // namespace orbearing::bearing::rating
