// Means over a window of time: loads by bin on the race, losses, cage; and the life that follows.
#pragma once

#include <Eigen/Core>

#include "bearing/life/damage.hpp"
#include "bearing/motion/snapshot.hpp"

namespace orbearing::bearing::motion {

/// Cause by cause.
PowerLoss& operator+=(PowerLoss& sum, const PowerLoss& other);
PowerLoss operator/(const PowerLoss& loss, double by);

/// Loads of one race over a window. Places are the bins of bin_of().
struct RaceStatistics {
  Eigen::ArrayXd roller_rms;      // [N]    (rollers)  unloaded time included
  double load_rms = 0.0;          // [N]    over all rollers
  double load_max = 0.0;          // [N]
  Eigen::ArrayXd mean_load;       // [N]    (bins)  over the passages of rollers
  Eigen::ArrayXd passages;        // [-]    (bins)  that happened, over those of pure rolling
  Eigen::ArrayXd damage;          // [N^4]  (bins)  fourth powers of all passages over those of pure rolling
  Eigen::ArrayXXd lamina_damage;  // [N^4]  (laminae, bins)  the same; no rows: all laminae carry alike
  double lamina_load_max = 0.0;   // [N]
  double mean_sliding = 0.0;      // [m/s]  mean of |sliding| over all rollers
  double least_film = 0.0;        // [m]    least film of the most loaded roller
};

/// One window.
struct WindowStatistics {
  long samples = 0;
  double duration = 0.0;  // [s]
  RaceStatistics inner;
  RaceStatistics outer;
  double orbit_speed = 0.0;  // [rad/s]  of the cage, without one the mean over the rollers, relative to the
                             //          carrier, from the angle turned
  double mean_spin = 0.0;                        // [rad/s]  over all rollers
  double mean_cage_eccentricity = 0.0;           // [-]
  double largest_cage_eccentricity = 0.0;        // [-]
  Vector2 mean_cage_position = Vector2::Zero();  // [m]
  double bore_friction_moment = 0.0;             // [N m]
  double vibration_power = 0.0;                  // [W]  that the bore's vibration brings into the bearing
  Eigen::VectorXd mean_waves;                    // [m]  of an elastic race; none: rigid
  PowerLoss loss;                                // [W]
};

/// Gathers samples spread evenly over time and turns them into means.
class StatisticsCollector {
 public:
  /// `laminae` as returned by uneven_laminae().
  StatisticsCollector(Eigen::Index rollers, Eigen::Index bins, Eigen::Index laminae = 0);

  /// `at_start` is the snapshot at the beginning of the window.
  void begin(double time, const Snapshot& at_start);
  void add(double time, const Snapshot& sample);
  /// As add(), in two parts: loads that count for `weight` (any unit), also in `other`, and all the rest.
  void add_loads(double weight, const RollerLoads& loads, DamageSums* other = nullptr);
  void add_state(double time, const Snapshot& sample);
  /// Adds the power between bearing and bore, for `weight` (any unit). The mean of -moment speed - travel is
  /// the power that the bearing receives. Mean friction moment times mean speed is that of a bore that turns
  /// evenly about a fixed axis, and the rest the power of its vibration.
  void add_bore(double weight, const BorePort& port);
  /// Means over all samples since begin(); at least one sample.
  WindowStatistics means() const;

 private:
  struct RaceSums {
    Eigen::ArrayXd roller_square;  // [N^2]
    double largest = 0.0;          // [N]
    double sliding = 0.0;          // [m/s]
    double least_film = 0.0;       // [m]
  };
  void add_state(const RaceSnapshot& race, RaceSums& sums);
  RaceStatistics means(const RaceSums& sums, const RacePassages& passages) const;

  Eigen::Index rollers_;
  Eigen::Index bins_;
  Eigen::Index laminae_;
  RaceSums inner_;
  RaceSums outer_;
  DamageSums damage_;
  double weight_ = 0.0;  // of all loads
  struct BoreSums {
    double weight = 0.0;
    double speed = 0.0;   // [rad/s]
    double moment = 0.0;  // [N m]
    double power = 0.0;   // [W]  of the bearing on the bore
  };
  BoreSums bore_;
  WindowStatistics sums_;
  double begin_time_ = 0.0;        // [s]
  double begin_orbit_angle_ = 0.0;  // [rad]
  double end_orbit_angle_ = 0.0;    // [rad]
};

/// Accumulated damage of a race.
RaceDamageView damage_of(const RaceStatistics& race);

}  // namespace orbearing::bearing::motion
