// A shaft on a duplex pair: modes, frequency response, and its constants identified from measured
// frequencies.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/duplex_case.hpp"

namespace orbearing::app {

/// One way to state the stiffness, with the shaft that belongs to it.
struct PairColumn {
  bearing::duplex::Shaft shaft;
  bearing::duplex::Stiffness stiffness;
  bearing::duplex::PairModes modes;
};

/// The pair under its preload at the speed of the shaft.
struct PairPoint {
  bool linear = false;  // what the case asks for
  PairColumn nonlinear;
  std::optional<PairColumn> printed;  // linear formulas; of face-to-face and tandem that stand
  bearing::equilibrium::RingState state;
  double approach = 0.0;  // [m]  of each row
  std::vector<std::string> warnings;

  const PairColumn& asked() const { return linear ? *printed : nonlinear; }
};

/// A measured pair beside what both models predict with their identified constants [Hz].
struct PredictedPair {
  MeasuredPair measured;
  bool identified_from = false;
  std::array<double, 5> nonlinear{};
  std::array<double, 5> linear{};  // NaN back to back
};

/// Errors of frequencies against measured ones [-].
struct FrequencyErrors {
  double mean = 0.0;  // of magnitudes
  double worst = 0.0;
};

struct Identification {
  bearing::duplex::Identified nonlinear;
  std::optional<bearing::duplex::Identified> linear;
  std::vector<PredictedPair> pairs;
  FrequencyErrors nonlinear_fit, nonlinear_prediction;  // pairs identified from, and all others
  FrequencyErrors linear_fit, linear_prediction;
};

struct Response {
  double step = 0.0;                                             // [Hz]  from one step on
  std::array<std::vector<std::complex<double>>, 3> accelerance;  // [1/kg]  along x, y, z
};

/// The pair at one of `operation.speeds`.
struct PairAtSpeed {
  double speed = 0.0;                               // [rad/s]
  std::optional<bearing::duplex::PairModes> modes;  // none: no balance
  bearing::equilibrium::RingState state;            // its report says why
};

struct DuplexStudy {
  PairPoint point;
  std::vector<PairAtSpeed> over_speed;           // where the case states speeds
  std::optional<Identification> identification;  // where the case holds measured frequencies
  Response response;
  std::vector<std::string> warnings;
};

/// Whether a case is that of a duplex pair.
bool is_duplex(const ResolvedCase& resolved);

/// Throws ComputationFailed where no balance is found.
PairPoint pair_point(const ResolvedCase& resolved);
/// At each of `operation.speeds`, of the nonlinear pair; empty where the case has none.
std::vector<PairAtSpeed> pair_over_speed(const ResolvedCase& resolved);
DuplexStudy duplex_study(const ResolvedCase& resolved);

/// A number by its name in the validation table: "tilt_x_Hz" and the like, "contact_angle_deg",
/// "predicted_mean_percent", "predicted_worst_percent", "linear_mean_percent"; NaN for a name that is not
/// known.
double duplex_property(const DuplexStudy& study, const std::string& quantity);

/// What follows from the inputs, for `orbearing check`.
std::vector<Derived> duplex_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
