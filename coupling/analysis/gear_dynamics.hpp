// A planetary set run in time until its motion repeats, then observed over whole mesh periods.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "coupling/integration/integrate_pieces.hpp"
#include "gearset/dynamics/equations.hpp"
#include "gearset/dynamics/period_map.hpp"
#include "gearset/dynamics/snapshot.hpp"

namespace orbearing::described {
class Record;
}

namespace orbearing::analysis {

// Means, extremes and mesh harmonics of the signals of all planets, gathered sample by sample.

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

/// Settings of the method. A window is a whole number of mesh periods at nominal speed.
struct GearRunOptions {
  long window_periods = 50;     // [mesh period]
  double drift = 1e-2;          // [-]  steady: rms accelerations of two windows in turn differ by no more
  int least_windows = 2;        // before the criterion is checked
  int most_windows = 40;        // before the run is observed all the same, with a message
  long observed_periods = 100;  // [mesh period]  averaged once steady
  // [-]  and one more over all of the observed periods together, so that no two samples fall on the same
  // position of the mesh period: a grid that repeats would always be on one side of a stiffness jump.
  long samples_per_period = 128;
  long series_periods = 4;                      // [mesh period]  the last ones, kept as time series
  int harmonics = 12;                           // orders of the mesh frequency that are written
  double allowed_share = 1e-4;                  // [-]  error of one step over the mean deflection of a mesh
  integration::IntegrationOptions integration;  // allowed_error and step are filled in
};

/// The last periods as time series. Matrices are (planets, samples).
struct GearSeries {
  Eigen::ArrayXd time;                      // [s]
  Eigen::ArrayXXd sun_mesh_force;           // [N]  along the line of action; negative on the back flank
  Eigen::ArrayXXd ring_mesh_force;          // [N]
  Eigen::ArrayXXd radial_force;             // [N]  of its bearing on each planet, outward
  Eigen::ArrayXXd tangential_force;         // [N]  in the sense of carrier rotation
  Eigen::ArrayXXd radial_acceleration;      // [m/s^2]  of each planet in the carrier's frame
  Eigen::ArrayXXd tangential_acceleration;  // [m/s^2]
};

/// Result of a run.
struct GearRunResult {
  bool completed = false;  // false: reason in `message`; the rest holds what there was
  bool steady = false;     // false with completed: the motion still changed from window to window
  std::string message;
  std::vector<PlanetStatistics> planets;
  double separated = 0.0;       // [-]  share of time at which some mesh has parted
  double mesh_frequency = 0.0;  // [Hz]
  GearSeries series;
  Eigen::VectorXd final_state;
  int windows = 0;                        // until steady
  integration::IntegrationReport report;  // summed; smallest step of all
};

/// Statistics of each planet, load sharing, what the run took, and the time series of the last periods.
void describe(described::Record& record, const GearRunResult& result);

/// Runs from the static state under mean loads (a run-up from its start), or from `start`. Errors of the
/// integration are in the result.
GearRunResult run_gears(const gearset::dynamics::SetModel& model, const GearRunOptions& options);
GearRunResult run_gears_from(const Eigen::VectorXd& start, const gearset::dynamics::SetModel& model,
                             const GearRunOptions& options);

/// The same for a steady speed and a motion that repeats with the meshes: found from `start` by Newton's
/// method on `map`, instead of by a long run, and observed over ten mesh periods. If it is not found, a small
/// motion grows by the map, or teeth part and a disturbance does not die out, the long run is used.
GearRunResult run_gears_repeating(const Eigen::VectorXd& start, const gearset::dynamics::SetModel& model,
                                  const gearset::dynamics::PeriodMap& map, const GearRunOptions& options);

}  // namespace orbearing::analysis
