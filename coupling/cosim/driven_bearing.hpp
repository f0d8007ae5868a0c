// One planet bearing that others move: motion of bore and carrier in, force and moment out. The core of the
// bearing as a participant and as an FMU.
#pragma once

#include <memory>
#include <vector>

#include "bearing/motion/bore_motion.hpp"
#include "bearing/motion/statistics.hpp"
#include "coupling/cosim/driven_output.hpp"
#include "coupling/cosim/driven_setup.hpp"
#include "coupling/cosim/participant.hpp"

namespace orbearing::cosim {

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
