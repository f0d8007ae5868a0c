#include "bearing/life/standard_life.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/life_modification.hpp"
#include "bearing/life/reference_life.hpp"
#include "bearing/life/roller_capacity.hpp"
#include "bearing/units.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::rating {

namespace {

// Upper limits of the standard's tables of f_c [-].
constexpr double kRollerTable = 0.30;
constexpr double kBallTable = 0.40;

// Factors of one row of angular-contact balls, [ISO281] and [ISO76].
struct AngularFactors {
  double degrees;
  double limit;         // [-]  e: up to this F_a/F_r the axial load has no effect; 0: by the load
  double radial;        // [-]  X
  double axial;         // [-]  Y; 0: by the load
  double static_axial;  // [-]  Y_0
};

constexpr std::array<AngularFactors, 7> kAngular{{{15.0, 0.0, 0.44, 0.0, 0.46},
                                                  {20.0, 0.57, 0.43, 1.00, 0.42},
                                                  {25.0, 0.68, 0.41, 0.87, 0.38},
                                                  {30.0, 0.80, 0.39, 0.76, 0.33},
                                                  {35.0, 0.95, 0.37, 0.66, 0.29},
                                                  {40.0, 1.14, 0.35, 0.57, 0.26},
                                                  {45.0, 1.34, 0.33, 0.50, 0.22}}};

// Null at other angles than those of the table: the standards do not interpolate.
const AngularFactors* angular_factors(double contact_angle) {
  constexpr double round_off = 1e-6;  // [deg]
  const double degrees = contact_angle * 180.0 / constants::pi;
  const auto found = std::find_if(kAngular.begin(), kAngular.end(), [&](const AngularFactors& one) {
    return std::abs(one.degrees - degrees) < round_off;
  });
  return found == kAngular.end() ? nullptr : &*found;
}

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
  return ratings_of(set, stated);
}

Ratings ratings_of(const RollerSet& set, const StatedRatings& stated) {
  return ratings_of_set(set, RollingElement::roller, kRollerTable, stated);
}

std::optional<double> equivalent_load(const Bearing& bearing, double radial, double axial) {
  if (bearing.has_rollers()) return radial;
  const BallSet set = ball_set(bearing);
  if (set.contact_angle == 0.0) return deep_groove_equivalent_load(set, radial, axial);
  const AngularFactors* factors = angular_factors(set.contact_angle);
  if (factors == nullptr) return std::nullopt;
  const auto [limit, share] =
      factors->axial == 0.0 ? axial_factors(set, axial) : AxialFactors{factors->limit, factors->axial};
  return axial > limit * radial ? std::max(radial, factors->radial * radial + share * axial) : radial;
}

std::optional<double> static_equivalent_load(const Bearing& bearing, double radial, double axial) {
  if (bearing.has_rollers()) return radial;
  constexpr double deep_radial = 0.6, deep_axial = 0.5, angular_radial = 0.5;  // X_0, Y_0; X_0
  if (bearing.contact_angle() == 0.0) return std::max(radial, deep_radial * radial + deep_axial * axial);
  const AngularFactors* factors = angular_factors(bearing.contact_angle());
  if (factors == nullptr) return std::nullopt;
  return std::max(radial, angular_radial * radial + factors->static_axial * axial);
}

}  // namespace orbearing::bearing::rating
