// Means over a window of time: loads by place on the race, losses, cage; and the life that follows.
#pragma once

#include <Eigen/Core>

#include "bearing/dynamics/snapshot.hpp"
#include "bearing/lundberg_palmgren.hpp"

namespace orbearing::bearing::dynamics {

/// Cause by cause.
PowerLoss& operator+=(PowerLoss& sum, const PowerLoss& other);
PowerLoss operator/(const PowerLoss& loss, double by);

/// Loads of one race over a window. Places are evenly spaced bins on the race in the carrier frame, the first
/// centred on the outward direction.
struct RaceStatistics {
  Eigen::ArrayXd roller_rms;         // [N]    (rollers)  unloaded time included
  double load_rms = 0.0;             // [N]    over all rollers
  double load_max = 0.0;             // [N]
  Eigen::ArrayXd mean_load;          // [N]    (places)  over the passages of rollers
  Eigen::ArrayXd mean_fourth_power;  // [N^4]  (places)
  double mean_sliding = 0.0;         // [m/s]  mean of |sliding| over all rollers
  double least_film = 0.0;           // [m]    least film of the most loaded roller
};

/// One window.
struct WindowStatistics {
  long samples = 0;
  double duration = 0.0;  // [s]
  RaceStatistics inner;
  RaceStatistics outer;
  double cage_speed = 0.0;                       // [rad/s]  relative to the carrier, from the angle it turned
  double mean_spin = 0.0;                        // [rad/s]  over all rollers
  double mean_cage_eccentricity = 0.0;           // [-]
  double largest_cage_eccentricity = 0.0;        // [-]
  Vector2 mean_cage_position = Vector2::Zero();  // [m]
  double bore_friction_moment = 0.0;             // [N m]
  PowerLoss loss;                                // [W]
};

/// The bin, of `places` on a race, in which `angle` [rad] lies.
Eigen::Index place_of(double angle, Eigen::Index places);

/// Gathers samples evenly spaced in time and turns them into means.
class StatisticsCollector {
 public:
  StatisticsCollector(Eigen::Index rollers, Eigen::Index places);

  /// `at_start` is the snapshot at the beginning of the window.
  void begin(double time, const Snapshot& at_start);
  void add(double time, const Snapshot& sample);
  /// As add(), in two parts: loads at `angle` [rad] (rollers) that count for `weight` (any unit), and all the
  /// rest.
  void add_loads(double weight, const double* angle, const double* inner, const double* outer);
  void add_state(double time, const Snapshot& sample);
  /// Means over all samples since begin(); at least one sample.
  WindowStatistics means() const;

 private:
  struct RaceSums {
    Eigen::ArrayXd roller_square;  // [N^2]
    Eigen::ArrayXd load;           // [N]    by place
    Eigen::ArrayXd fourth_power;   // [N^4]  by place
    double largest = 0.0;          // [N]
    double sliding = 0.0;          // [m/s]
    double least_film = 0.0;       // [m]
  };
  void add_state(const RaceSnapshot& race, RaceSums& sums);
  RaceStatistics means(const RaceSums& sums) const;

  Eigen::Index rollers_;
  Eigen::Index places_;
  RaceSums inner_;
  RaceSums outer_;
  Eigen::ArrayXd passages_;  // weight by place
  double weight_ = 0.0;      // of all loads
  WindowStatistics sums_;
  double begin_time_ = 0.0;        // [s]
  double begin_cage_angle_ = 0.0;  // [rad]
  double end_cage_angle_ = 0.0;    // [rad]
};

/// Equivalent load of a race [N] from the fourth powers of the loads by place: the standing race takes each
/// place's own life, [(1/2pi) integral <Q^4>^(4.5/4)]^(1/4.5); the turning race the mean over all passages,
/// Eqs. (37) and (39) of [Gai2025] with the sums over rollers taken over passages.
double equivalent_load(const RaceStatistics& race, RaceMotion motion);

/// Life by Lundberg and Palmgren from dynamic loads; arguments as in lundberg_palmgren_life().
BearingLife dynamic_life(const CylindricalRollerBearing& bearing, double lambda, Race standing,
                         const WindowStatistics& statistics);

}  // namespace orbearing::bearing::dynamics
