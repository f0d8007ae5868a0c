// A gear set with a scratched planet bearing: its vibration in the carrier's frame and on the housing, and
// which line is what (docs/defects/planet.md).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/study/defect_study.hpp"
#include "coupling/study/planet_scratch.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

struct PlanetDefectStudy {
  std::vector<bearing::defect::Scratched> scratched;  // surfaces, the first named one first
  study::PlanetFrequencies rolling;                   // at pure rolling
  study::PlanetFrequencies turned;                    // as cage and planet turned
  std::optional<double> defect_frequency;             // [Hz]  of the first; none without a scratch
  bool run_up = false;
  study::PlanetVibration vibration;
  /// Envelopes are those of the signal less the lines of the teeth, but in a run-up, whose orders are the
  /// carrier's.
  diagnosis::InstrumentView
      carrier;  // damaged planet along the middle of its load zone, relative to its pin [m/s^2]
  diagnosis::InstrumentView housing;  // ring gear's force on the housing as an instrument feels it [N]
};

/// `progress` gets the share done, if any. Throws ComputationFailed where the motion cannot be followed.
PlanetDefectStudy planet_defect_study(const ResolvedCase& resolved,
                                      const std::function<void(double)>& progress = {});

void describe(described::Record& record, const PlanetDefectStudy& study);

/// What follows from the inputs, for `orbearing check`.
std::vector<Derived> planet_defect_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
