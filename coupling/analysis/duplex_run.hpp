// A duplex pair under its preload: modes, loads of the balls, lives and frequency response of the shaft.
#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "bearing/life/bearing_lives.hpp"
#include "coupling/analysis/duplex_modes.hpp"

namespace orbearing::analysis {

/// By ISO/TS 16281, which needs the loads of the balls alone; P of ISO 281 is not held for rows that lean.
struct PairLives {
  bearing::rating::BearingLives row;         // the row with the shorter life, under its preload
  double pair = bearing::rating::kNotRated;  // [rev]  of both rows
};
void describe(described::Record& record, const PairLives& lives);

/// Frequency response of the shaft.
struct ShaftResponse {
  double step = 0.0;                                             // [Hz]  from one step on
  std::array<std::vector<std::complex<double>>, 3> accelerance;  // [1/kg]  along x, y, z
};
void describe(described::Record& record, const ShaftResponse& response);

struct DuplexRun {
  DuplexModes modes;
  PairLives lives;
  ShaftResponse response;
  std::vector<std::string> warnings;

  bool failed() const { return modes.failed(); }
};
void describe(described::Record& record, const DuplexRun& result);

/// Throws mechanics::NoResult where no equilibrium is found at the speed of the shaft.
DuplexRun duplex_run(const DuplexPair& machine);

/// Results that follow from the inputs.
struct DuplexQuantities {
  double approach = 0.0;       // [m]    of each row
  double contact_angle = 0.0;  // [rad]
  double contact_load = 0.0;   // [N]
  bearing::duplex::Shaft shaft;
};
void describe(described::Record& record, const DuplexQuantities& of);

/// Throws mechanics::NoResult as duplex_run.
DuplexQuantities quantities_of(const DuplexPair& machine);

}  // namespace orbearing::analysis
