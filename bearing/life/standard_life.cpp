#include "bearing/life/standard_life.hpp"

#include <algorithm>

#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/life_modification.hpp"
#include "bearing/life/reference_life.hpp"
#include "bearing/life/roller_capacity.hpp"

namespace orbearing::bearing::rating {

namespace {

// Where the standard's tables of f_c end [-].
constexpr double kRollerTable = 0.30;
constexpr double kBallTable = 0.40;

double factor_of(const RollerSet& set) {
  return roller_capacity_factor(gamma(set), set.reduction_factor);
}
double factor_of(const BallSet& set) {
  return ball_capacity_factor(set);
}

template <class Set>
Ratings ratings_of_set(const Set& set, RollingElement element, double table_end,
                       const StatedRatings& stated) {
  Ratings ratings{.gamma = gamma(set),
                  .capacity_factor = factor_of(set),
                  .dynamic_capacity = stated.dynamic_capacity.value_or(dynamic_capacity(set)),
                  .static_capacity = stated.static_capacity.value_or(static_capacity(set)),
                  .slenderness_limit = table_end};
  ratings.fatigue_load_limit = stated.fatigue_load_limit.value_or(
      fatigue_load_limit(element, ratings.static_capacity, set.pitch_diameter));
  ratings.contacts = contact_capacities(set, ratings.dynamic_capacity);
  return ratings;
}

}  // namespace

RollingElement rolling_element(const Bearing& bearing) {
  return bearing.has_rollers() ? RollingElement::roller : RollingElement::ball;
}

Ratings ratings_of(const Bearing& bearing, const StatedRatings& stated) {
  if (!bearing.has_rollers())
    return ratings_of_set(ball_set(bearing), RollingElement::ball, kBallTable, stated);
  RollerSet set = roller_set(bearing);
  set.reduction_factor = stated.reduction_factor.value_or(set.reduction_factor);
  return ratings_of_set(set, RollingElement::roller, kRollerTable, stated);
}

std::optional<double> equivalent_load(const Bearing& bearing, double radial, double axial) {
  if (bearing.has_rollers()) return radial;
  if (bearing.contact_angle() != 0.0) return std::nullopt;
  return deep_groove_equivalent_load(ball_set(bearing), radial, axial);
}

std::optional<double> static_equivalent_load(const Bearing& bearing, double radial, double axial) {
  constexpr double radial_share = 0.6, axial_share = 0.5;  // X_0, Y_0 of deep-groove bearings
  if (bearing.has_rollers()) return radial;
  if (bearing.contact_angle() != 0.0) return std::nullopt;
  return std::max(radial, radial_share * radial + axial_share * axial);
}

BearingLife reference_life(const Bearing& bearing, const ContactCapacities& capacities,
                           const ElementLoads& inner, const ElementLoads& outer) {
  if (bearing.has_rollers())
    return lamina_reference_life(capacities, inner.laminae, outer.laminae, bearing.motions);
  return ball_reference_life(capacities, inner.contact, outer.contact, bearing.motions);
}

}  // namespace orbearing::bearing::rating
