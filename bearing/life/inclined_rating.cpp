#include "bearing/life/inclined_rating.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/life/lundberg_palmgren.hpp"

namespace orbearing::bearing::rating {

namespace {

constexpr double kSpherical = 1.15;  // [-]  b_m of spherical roller bearings [ISO281]

struct LoadFactors {
  double radial;
  double axial;
};

double by(const LoadFactors& factors, double radial, double axial) {
  return factors.radial * radial + factors.axial * axial;
}

}  // namespace

RollerSet roller_set(const Bearing& bearing, const PlanetRows& rows) {
  RollerSet set = roller_set(bearing);
  set.rows = rows.rows();
  if (!rows.is_cylindrical()) set.contact_angle = rows.contact_angle;
  if (rows.type == PlanetBearingType::spherical_roller) set.material_factor = kSpherical;
  return set;
}

double inclined_equivalent_load(const RollerSet& set, double radial, double axial) {
  const double tangent = std::tan(set.contact_angle);
  const bool beyond = axial > 1.5 * tangent * radial;
  const LoadFactors factors = set.rows == 1
                                  ? (beyond ? LoadFactors{0.4, 0.4 / tangent} : LoadFactors{1.0, 0.0})
                              : beyond ? LoadFactors{0.67, 0.67 / tangent}
                                       : LoadFactors{1.0, 0.45 / tangent};
  return by(factors, radial, axial);
}

double inclined_static_load(const RollerSet& set, double radial, double axial) {
  const double cotangent = 1.0 / std::tan(set.contact_angle);
  const LoadFactors factors =
      set.rows == 1 ? LoadFactors{0.5, 0.22 * cotangent} : LoadFactors{1.0, 0.44 * cotangent};
  return std::max(radial, by(factors, radial, axial));
}

BearingRating planet_bearing_rating(const Bearing& bearing, const PlanetRows& rows,
                                    const StatedRatings& stated) {
  if (rows.is_cylindrical() || rows.has_balls()) return bearing_rating(bearing, stated);
  BearingRating rating = bearing_rating(bearing, stated);  // races that turn, laminae
  RollerSet set = roller_set(bearing, rows);
  set.reduction_factor = stated.reduction_factor.value_or(set.reduction_factor);
  rating.ratings = ratings_of(set, stated);
  rating.elements = set.rows * set.rollers;
  rating.contact_angle = set.contact_angle;
  rating.laminae = rated_laminae(rating.ratings.contacts, bearing, stated.stress_riser);
  return rating;
}

ContactCapacities planet_contact_capacities(const Bearing& bearing, const PlanetRows& rows,
                                            double reduction_factor) {
  const Bearing of_contact = upright(bearing, rows);
  const double inclined = rows.is_cylindrical() ? 1.0 : std::pow(std::cos(rows.contact_angle), -2.0 / 9.0);
  return {.inner = inclined * contact_capacity(of_contact, Race::inner, reduction_factor),
          .outer = inclined * contact_capacity(of_contact, Race::outer, reduction_factor)};
}

Bearing upright(const Bearing& bearing, const PlanetRows& rows) {
  Bearing of_contact = bearing;
  if (!rows.is_cylindrical() && !rows.has_balls()) of_contact.pitch_diameter /= std::cos(rows.contact_angle);
  return of_contact;
}

}  // namespace orbearing::bearing::rating
