// A shaft on a duplex pair: modes and frequency response.
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
  std::vector<PairAtSpeed> over_speed;  // where the case states speeds
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
