// Bearings in motion: a single one under its load, or all of a gear set with it, for any integrator and
// exchange.
#pragma once

#include <functional>
#include <vector>

#include "bearing/motion/snapshot.hpp"
#include "bearing/motion/statistics.hpp"
#include "coupling/integration/integrate.hpp"

namespace orbearing::system {

/// The bore of a bearing in motion.
struct BoreSample {
  double time = 0.0;                                   // [s]
  double weight = 0.0;                                 // any unit: how long it counts
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // [m/s]
  Eigen::Vector2d force = Eigen::Vector2d::Zero();     // [N]  of the bearing on the bore
};
using BoreObserver = std::function<void(const BoreSample&)>;

/// Observers of every step.
struct StepObservers {
  std::vector<bearing::motion::StatisticsCollector*> loads;  // (bearings)  get the loads
  BoreObserver on_bore;  // gets the bore of a single bearing; may be empty
};

/// Bearings are counted from 0.
class Motion {
 public:
  virtual ~Motion() = default;

  virtual int bearings() const = 0;
  /// Whether one interval holds for all times of a run, and times count from its start, as where participants
  /// exchange in windows.
  virtual bool keeps_to_interval() const { return true; }
  /// Whether the observers see every step; else they see the output times, which then must be close.
  virtual bool shows_steps() const { return true; }

  /// From now on `observers`, which outlive this or are replaced, see every step.
  virtual void observe_steps(const StepObservers& observers) = 0;
  /// Through all of `times`, the first of which is the present one; at each of the others `observe` may take
  /// snapshots. @throws std::runtime_error with the reason; the state is then not to be used
  virtual void advance(const integration::OutputTimes& times,
                       const std::function<void(double time)>& observe) = 0;
  /// Bearing `b` at the present time.
  virtual void take_snapshot(int b, bearing::motion::Snapshot& into) const = 0;
  /// Sums since the start; a step may be an exchange.
  virtual integration::IntegrationReport report() const = 0;
};

}  // namespace orbearing::system
