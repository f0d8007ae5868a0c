// Means, extremes and mesh harmonics of the signals of all planets, gathered sample by sample.
#pragma once

#include <vector>

#include "coupling/study/gear_dynamics.hpp"
#include "gearset/dynamics/snapshot.hpp"

namespace orbearing::study {

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
  };
  std::vector<Planet> planets_;
  Eigen::ArrayXcd waves_;  // (orders)  at the present sample
};

}  // namespace orbearing::study
