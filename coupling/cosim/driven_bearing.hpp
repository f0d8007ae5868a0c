// One planet bearing that others move: motion of bore and carrier in, force and moment out. The core of the
// bearing as a participant and as an FMU.
#pragma once

#include <memory>
#include <vector>

#include "bearing/dynamics/bore_motion.hpp"
#include "bearing/dynamics/parameters.hpp"
#include "bearing/dynamics/statistics.hpp"
#include "bearing/parameters.hpp"
#include "coupling/cosim/course.hpp"
#include "coupling/cosim/participant.hpp"

namespace orbearing::cosim {

/// The race at rest relative to the load: the pin's.
inline constexpr bearing::Race kStanding = bearing::Race::inner;

/// All that is fixed before a run.
struct DrivenBearingSetup {
  bearing::CylindricalRollerBearing bearing;
  bearing::dynamics::DynamicsParameters dynamics;  // no run-up, no ripple: the inputs bring them
  double orbit_radius = 0.0;                       // [m]    from the carrier's axis to the pin's
  double first_roller = 0.0;                       // [rad]  place of the first roller at the start
  double lambda = 0.83;                            // [-]    of the Lundberg-Palmgren life
  /// Inclination [rad] of the bore's axis against the pin's, which stays: it runs along (x, y, 1). Felt by
  /// laminae only, and refused without them.
  Eigen::Vector2d bore_tilt = Eigen::Vector2d::Zero();
  double allowed_length_error = 2e-10;  // [m]    of one step; all other variables follow from it
  long places = 72;                     // [-]    bins on the races, for the life
  long most_steps = 10'000'000;         // [-]    in one call of advance() before it gives up
};

/// Inputs over a window.
struct BoreCourse {
  Course x, y;                  // [m]
  Course v_x, v_y;              // [m/s]  slopes of the above
  Course speed;                 // [rad/s]  of the bore, relative to the carrier
  Course carrier_speed;         // [rad/s]
  Course carrier_acceleration;  // [rad/s^2]

  /// All but the angle of the bore, which the bearing itself sums up.
  bearing::dynamics::BoreMotion at(double since) const;
};

/// At the present time.
struct DrivenBearingOutput {
  bearing::dynamics::BoreReaction reaction;
  double cage_speed = 0.0;   // [rad/s]  relative to the carrier
  double cage_slip = 0.0;    // [-]  1 - cage speed / kinematic cage speed; 0 where nothing turns
  double life_used = 0.0;    // [-]  revolutions so far over the life (in revolutions) under the loads so far
  double revolutions = 0.0;  // [-]  of the bore relative to the carrier, since the start; absolute value
  double friction_loss = 0.0;        // [W]
  std::vector<double> inner_load;    // [N]  (rollers)
  std::vector<double> outer_load;    // [N]  (rollers)
  std::vector<double> roller_angle;  // [rad]  (rollers)
};

/// Slopes of the force on the bore [N/m] and [N s/m]: rows x and y; the inner state held.
struct ForceSlopes {
  Eigen::Matrix2d by_displacement = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d by_velocity = Eigen::Matrix2d::Zero();
  Eigen::Vector2d by_speed = Eigen::Vector2d::Zero();  // [N s]  of the bore
};

/// Not for use by two threads at once; any number of objects side by side.
class DrivenBearing {
 public:
  /// Throws std::invalid_argument, with what was found and what is required.
  explicit DrivenBearing(const DrivenBearingSetup& setup);
  ~DrivenBearing();
  DrivenBearing(DrivenBearing&&) noexcept;
  DrivenBearing& operator=(DrivenBearing&&) noexcept;

  /// Rollers in balance under the displacement of the bore, all turning at pure rolling. All inputs may be
  /// zero.
  void initialize(const bearing::dynamics::BoreMotion& motion);
  /// From `window.begin` to its end with `inputs`, whose courses count from the beginning. On an error
  /// (std::runtime_error) the state is that at the beginning.
  void advance(const Window& window, const BoreCourse& inputs);
  /// What the bearing does to the bore under the motion at the present time: the cheap part of output().
  bearing::dynamics::BoreReaction reaction(const bearing::dynamics::BoreMotion& motion) const;
  /// Under the motion at the present time.
  DrivenBearingOutput output(const bearing::dynamics::BoreMotion& motion) const;
  ForceSlopes slopes(const bearing::dynamics::BoreMotion& motion) const;

  /// All that can be read off at the present time.
  void take_snapshot(const bearing::dynamics::BoreMotion& motion, bearing::dynamics::Snapshot& into) const;
  /// From now on the loads of every step, weighted by its length, also go to `collector`, which outlives this
  /// or is replaced; null: no longer. No part of the saved state.
  void collect_loads(bearing::dynamics::StatisticsCollector* collector);

  /// In the order of StateLayout, the bore where it was last.
  Eigen::VectorXd state() const;

  int rollers() const;
  void save(SavedState& state) const;
  /// Throws std::invalid_argument where `state` is not one of such a bearing.
  void restore(const SavedState& state);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace orbearing::cosim
