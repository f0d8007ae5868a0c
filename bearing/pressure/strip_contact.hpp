// Contact along the roller with semi-elliptic pressure across: line loads and widths of least energy.
//
// Complementary energy of line loads q >= 0 and half widths b, elements of length h, c = 1/(pi E*):
//
//   (1)  c/2 sum q_i W_ij(b) q_j  +  sum h q b^2/(8 R)  -  sum h q (approach + tilt x - relief)
//
// Its least value over q and b lies above that over all pressures but for the common width of unlike strips
// (strip_influence.hpp), and meets it in Hertz's line and elliptical contacts. Over q it gives the balance of
// displacements,
//
//   (2)  c sum_j W_ij q_j = h_i (approach + tilt x_i - relief_i - b_i^2/(8 R))   where q_i > 0,
//
// over b a Hertzian width of the line load about x_i, averaged over a stretch of about one width:
//
//   (3)  b_i^2 = (4 R c/h_i) sum_j V_ij q_j b_i^2,   V = -dW/d(B)/(2 B)
//
// One strip across is the idea of [Reusner1977] and [Mul1986]; energy instead of displacement along y = 0
// makes it symmetric and its loads derivatives of its energy.
#pragma once

#include "bearing/geometry.hpp"
#include "bearing/pressure/contact.hpp"
#include "bearing/pressure/strip_influence.hpp"
#include "bearing/profile/profile.hpp"

namespace orbearing::bearing::half_space {

/// Resolution and accuracy of the strips.
struct StripSettings {
  int elements = 64;        // [-]  along the roller
  double grading = 0.92;    // [-]  see graded_grid
  double tolerance = 1e-6;  // [-]  greatest change of a width over the greatest width
  int most_iterations = 400;
};

/// One roller on one race; made once and used for many loads, tilts and profiles, from any thread.
class StripContact {
 public:
  explicit StripContact(const HalfSpaceContact& contact, const StripSettings& settings = {});

  const LengthGrid& grid() const { return grid_; }
  /// Means of a profile over the elements [m], for the calls below.
  Eigen::ArrayXd relief(const Relief& profile) const { return mean_relief(grid_, profile); }

  /// Solution under `load` [N] > 0 at `tilt` [rad]. Throws std::runtime_error where the iteration does not
  /// end.
  RollerContactPressure under_load(const Eigen::ArrayXd& relief, double load, double tilt) const;
  /// Solution at `approach` [m] and `tilt` [rad]; without load where the bodies do not meet.
  RollerContactPressure at_approach(const Eigen::ArrayXd& relief, double approach, double tilt) const;

 private:
  struct Iteration;
  RollerContactPressure solve(const Eigen::ArrayXd& relief, double tilt, Iteration& iteration) const;
  void balance(Iteration& iteration) const;
  bool update_contact(Iteration& iteration) const;
  double update_widths(Iteration& iteration) const;
  RollerContactPressure result(const Iteration& iteration, double tilt, double change) const;

  double radius_ = 0.0;      // [m]
  double compliance_ = 0.0;  // [1/Pa]  c = 1/(pi E*)
  StripSettings settings_;
  LengthGrid grid_;
  StripInfluence influence_;
};

/// The same for one load, tilt and profile.
RollerContactPressure contact_pressure(const HalfSpaceContact& contact, const Relief& relief, double load,
                                       double tilt, const StripSettings& settings = {});

// The half-space contact of a bearing's roller with one of its races.

/// Roller with corrected free ends on a race that goes on beyond them.
inline HalfSpaceContact contact_of(const Bearing& bearing, Race race) {
  return {.length = bearing.rollers().length,
          .equivalent_radius = equivalent_radius(geometry_of(bearing), race),
          .roller = bearing.material,
          .race = bearing.material};
}

/// Relief of both bodies together.
inline Relief relief_of(const profile::Profile& roller, const profile::Profile& race = profile::Straight{}) {
  return [roller, race](double x) { return profile::drop(roller, x) + profile::drop(race, x); };
}

}  // namespace orbearing::bearing::half_space
