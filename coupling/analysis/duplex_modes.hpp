// Natural modes of the shaft on a duplex pair under its preload, at rest and over the speed of the shaft.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/analysis/duplex_pair.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// One way to state the stiffness, with the shaft that belongs to it.
struct PairColumn {
  bearing::duplex::Shaft shaft;
  bearing::duplex::Stiffness stiffness;
  bearing::duplex::PairModes modes;
};

/// The pair under its preload at the speed of the shaft.
struct PairPoint {
  bool linear = false;  // the choice of the inputs
  PairColumn nonlinear;
  std::optional<PairColumn> published;  // linear formulas; for stationary face-to-face and tandem pairs
  bearing::equilibrium::RingState state;
  double approach = 0.0;  // [m]  of each row
  std::vector<std::string> warnings;

  const PairColumn& chosen() const { return linear ? *published : nonlinear; }
};

/// Modes by the stiffness that the inputs choose, and by the other.
void describe(described::Record& record, const PairPoint& point);

/// The pair at one of `operation.speeds`.
struct PairAtSpeed {
  double speed = 0.0;                               // [rad/s]
  std::optional<bearing::duplex::PairModes> modes;  // none: no equilibrium
  bearing::equilibrium::RingState state;            // its report has the reason
};

/// With the ball that has the largest load on the inner race.
void describe(described::Record& row, const PairAtSpeed& at);

/// Throws mechanics::NoResult where no equilibrium is found.
PairPoint point_of(const PreloadedPair& pair);
/// At each of `operation.speeds`, by the nonlinear equilibrium.
std::vector<PairAtSpeed> over_speeds(const PreloadedPair& pair);

struct DuplexModes {
  PairPoint point;
  std::vector<PairAtSpeed> over_speed;
  std::vector<std::string> warnings;

  bool failed() const;  // at a speed
};
void describe(described::Record& record, const DuplexModes& result);

/// Throws mechanics::NoResult where no equilibrium is found at the speed of the shaft.
DuplexModes duplex_modes(const PreloadedPair& pair);

}  // namespace orbearing::analysis
