// A shaft on a duplex pair: modes, frequency response, and its constants identified from measured
// frequencies.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/duplex_case.hpp"
#include "app/results/life_table.hpp"

namespace orbearing::app {

/// One way to state the stiffness, with the shaft that belongs to it.
struct PairColumn {
  bearing::duplex::Shaft shaft;
  bearing::duplex::Stiffness stiffness;
  bearing::duplex::PairModes modes;
};

/// The pair under its preload at the speed of the shaft.
struct PairPoint {
  bool linear = false;  // the choice of the case
  PairColumn nonlinear;
  std::optional<PairColumn> published;  // linear formulas; for stationary face-to-face and tandem pairs
  bearing::equilibrium::RingState state;
  double approach = 0.0;  // [m]  of each row
  std::vector<std::string> warnings;

  const PairColumn& asked() const { return linear ? *published : nonlinear; }
};

/// Modes by the stiffness that the case selects, and by the other.
void describe(described::Record& record, const PairPoint& point);

/// A measured pair with the predictions of both models with their identified constants [Hz].
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

inline void describe(described::Record& record, const FrequencyErrors& errors) {
  using namespace described;
  record.value("mean_percent", dimension::percent, "mean error of the frequencies", errors.mean);
  record.value("worst_percent", dimension::percent, "largest error of a frequency", errors.worst);
}

/// Constants of one model identified from the measured frequencies, and its errors.
struct IdentifiedModel {
  bearing::duplex::Identified found;
  FrequencyErrors fit;         // of the pairs identified from
  FrequencyErrors prediction;  // of all others
};

inline void describe(described::Record& record, const IdentifiedModel& model) {
  describe(record, model.found.shaft);
  record.value("converged", "whether the search ended", model.found.converged);
  record.value("iterations", "of the search", model.found.iterations);
  record.child("fit", "of the pairs identified from", model.fit);
  record.child("prediction", "of all other pairs", model.prediction);
}

struct Identification {
  IdentifiedModel nonlinear;
  std::optional<IdentifiedModel> linear;
  std::vector<PredictedPair> pairs;
};

void describe(described::Record& record, const Identification& found);

struct Response {
  double step = 0.0;                                             // [Hz]  from one step on
  std::array<std::vector<std::complex<double>>, 3> accelerance;  // [1/kg]  along x, y, z
};

void describe(described::Record& record, const Response& response);

/// The pair at one of `operation.speeds`.
struct PairAtSpeed {
  double speed = 0.0;                               // [rad/s]
  std::optional<bearing::duplex::PairModes> modes;  // none: no equilibrium
  bearing::equilibrium::RingState state;            // its report has the reason
};

/// With the ball that has the largest load on the inner race.
void describe(described::Record& row, const PairAtSpeed& at);

/// By ISO/TS 16281, which needs the loads of the balls alone; P of ISO 281 is not held for rows that lean.
struct PairLives {
  BearingLives row;                          // the row with the shorter life, under its preload
  double pair = bearing::rating::kNotRated;  // [rev]  of both rows
};

struct DuplexStudy {
  PairPoint point;
  PairLives lives;
  std::vector<PairAtSpeed> over_speed;           // where the case states speeds
  std::optional<Identification> identification;  // where the case holds measured frequencies
  Response response;
  std::vector<std::string> warnings;
};

void describe(described::Record& record, const DuplexStudy& study);

/// Whether a case is that of a duplex pair.
bool is_duplex(const ResolvedCase& resolved);

/// Throws ComputationFailed where no equilibrium is found.
PairPoint pair_point(const ResolvedCase& resolved);
/// At each of `operation.speeds`, of the nonlinear pair; empty where the case has none.
std::vector<PairAtSpeed> pair_over_speed(const ResolvedCase& resolved);
DuplexStudy duplex_study(const ResolvedCase& resolved);

/// Quantities derived from the inputs, for `orbearing check`.
std::vector<Derived> duplex_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
