// Means, extremes and mesh harmonics of the signals of all planets, gathered sample by sample.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearset/dynamics/snapshot.hpp"

namespace orbearing::study {

/// One quantity of one planet over the observed periods.
struct SignalStatistics {
  double mean = 0.0;
  double rms = 0.0;      // about zero
  double maximum = 0.0;  // largest absolute value
  double least = 0.0;
  double largest = 0.0;
  // At 1, 2, ... times the mesh frequency: the signal is the mean and the sum of
  // cosine cos(order angle) + sine sin(order angle), with the angle of the mesh period since time zero.
  std::vector<double> cosines, sines;
  std::vector<double> amplitudes;  // hypot(cosine, sine)
};

/// All quantities of one planet.
struct PlanetStatistics {
  SignalStatistics sun_mesh_force;           // [N]
  SignalStatistics ring_mesh_force;          // [N]
  SignalStatistics radial_force;             // [N]
  SignalStatistics tangential_force;         // [N]
  SignalStatistics radial_acceleration;      // [m/s^2]
  SignalStatistics tangential_acceleration;  // [m/s^2]
  // [m/s^2]  rms along any one direction fixed in the housing, over whole orbits: 1/sqrt(2) of the
  // resultant's
  double housing_acceleration = 0.0;
  double load_share = 0.0;  // [-]  mean tangential bearing force over the planets' average: 1 where all share
  double most_load_share = 0.0;  // [-]  largest tangential force at an instant over the planets' mean one
};

/// Sums of one signal, sampled uniformly over whole mesh periods.
class SignalSums {
 public:
  /// @param harmonics number of orders
  explicit SignalSums(int harmonics);

  /// `waves` are exp(-i order angle) for the angle in the mesh period, one for each order.
  void add(double value, const Eigen::ArrayXcd& waves);
  SignalStatistics statistics() const;
  double mean_square() const { return square_ / static_cast<double>(samples_); }

 private:
  long samples_ = 0;
  double sum_ = 0.0;
  double square_ = 0.0;
  double least_;
  double largest_;
  Eigen::ArrayXcd waves_;  // (orders)
};

/// The signals of PlanetStatistics, of all planets.
class GearSignals {
 public:
  GearSignals(Eigen::Index planets, int harmonics);

  /// @param periods mesh periods since time zero
  void add(double periods, const gearset::dynamics::SetSnapshot& now);
  std::vector<PlanetStatistics> statistics() const;
  /// [m/s^2]  of all planets together
  double rms_acceleration() const;
  /// [N]  of all meshes together
  double rms_mesh_force() const;

 private:
  struct Planet {
    SignalSums sun_mesh, ring_mesh, radial, tangential, radial_acceleration, tangential_acceleration;
    double housing_squares = 0.0;  // [m^2/s^4]  of both components
  };
  std::vector<Planet> planets_;
  long samples_ = 0;
  Eigen::ArrayXcd waves_;  // (orders)  at the present sample
};

}  // namespace orbearing::study
