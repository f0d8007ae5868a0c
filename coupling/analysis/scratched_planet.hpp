// A gear set with a scratched planet bearing: its vibration in the carrier's frame and on the housing, and
// which line is what (docs/defects/planet.md).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bearing/defect/scratch.hpp"
#include "coupling/analysis/drivetrain.hpp"
#include "coupling/analysis/planet_scratch.hpp"
#include "coupling/analysis/vibration_record.hpp"
#include "coupling/diagnosis/defect_view.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// Inputs of the run. Angles of the scratch are measured from the middle of the load zone.
struct ScratchedSet {
  PlanetaryDrivetrain drivetrain;
  bearing::defect::Scratch scratch;
  ScratchedPosition position;
  PlanetSampling sampling;
  EnvelopeBand band;
};

struct ScratchedSetVibration {
  std::vector<bearing::defect::Scratched> scratched;  // surfaces, the first named one first
  PlanetFrequencies rolling;                          // at pure rolling
  PlanetFrequencies turned;                           // as cage and planet turned
  std::optional<double> defect_frequency;             // [Hz]  of the first; none without a scratch
  bool run_up = false;
  PlanetVibration vibration;
  /// Envelopes are those of the signal less the lines of the teeth, but in a run-up, whose orders are the
  /// carrier's.
  diagnosis::InstrumentView
      carrier;  // damaged planet along the middle of its load zone, relative to its pin [m/s^2]
  diagnosis::InstrumentView housing;  // ring gear's force on the housing as an instrument measures it [N]

  double largest_load() const { return vibration.largest_load; }  // [N]  of a roller
};

/// `progress` gets the share done, if any. Throws NoResult where the motion cannot be followed.
ScratchedSetVibration vibration_of_scratched_set(const ScratchedSet& in,
                                                 const std::function<void(double)>& progress = {});

void describe(described::Record& record, const ScratchedSetVibration& result);

/// [s]  from the start to the last sample
double time_of_signal(const ScratchedSet& in);

/// Frequencies that follow from the inputs, as derived quantities.
struct ScratchedSetQuantities {
  PlanetFrequencies rolling;
};
void describe(described::Record& record, const ScratchedSetQuantities& quantities);

}  // namespace orbearing::analysis
