// Ratings and equivalent loads of a bearing by the standards, of rollers or balls.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/basic_life.hpp"
#include "bearing/life/reference_life.hpp"

namespace orbearing::bearing::rating {

/// Which exponents and slopes hold for the bearing's contacts.
RollingElement rolling_element(const Bearing& bearing);

/// Stated values that replace those of the standards.
struct StatedRatings {
  std::optional<double> reduction_factor;            // [-]  reduction factor of roller bearings; none: 0.83
  std::optional<double> dynamic_capacity;            // [N]  C_r
  std::optional<double> static_capacity{};           // [N]  C_0r; C_u follows from it unless stated
  std::optional<double> fatigue_load_limit;          // [N]  C_u
  StressRiser stress_riser = StressRiser::position;  // of L10r and L10mr of rollers
};

/// Ratings of a bearing by the standards; independent of its load.
struct Ratings {
  double gamma = 0.0;               // [-]
  double capacity_factor = 0.0;     // [-]  f_c [N, mm]
  double dynamic_capacity = 0.0;    // [N]  C_r: stated, or by the standard
  double static_capacity = 0.0;     // [N]  C_0r
  double fatigue_load_limit = 0.0;  // [N]  C_u
  ContactCapacities contacts;       // of one element
  double slenderness_limit = 0.0;   // [-]  largest gamma of the standard's table of f_c
};

Ratings ratings_of(const Bearing& bearing, const StatedRatings& stated = {});
/// Ratings of roller bearings, with the reduction factor of the set.
Ratings ratings_of(const RollerSet& set, const StatedRatings& stated);

/// Equivalent load P of [ISO281] [N] under `radial` and `axial` [N]; none for balls of a nominal contact
/// angle that its table of X and Y does not have.
std::optional<double> equivalent_load(const Bearing& bearing, double radial, double axial);

/// Static equivalent load P_0 of [ISO76] [N], never less than the radial load; none as above.
std::optional<double> static_equivalent_load(const Bearing& bearing, double radial, double axial);

/// Loads of the elements on one race [N].
struct ElementLoads {
  Eigen::ArrayXd contact;   // (elements)
  Eigen::ArrayXXd laminae;  // (laminae, rollers); of balls none
};

}  // namespace orbearing::bearing::rating
