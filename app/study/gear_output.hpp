// Modes and vibration of a planetary set as results.
#pragma once

#include <vector>

#include "coupling/study/gear_dynamics.hpp"
#include "gearset/dynamics/modes.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// "rotational", "translational" or "planet".
const char* kind_name(gearset::dynamics::ModeKind kind);

/// Modes and the frequency by which published ones may be recognised.
struct ModeStudy {
  std::vector<gearset::dynamics::Mode> modes;
  double planet_frequency = 0.0;  // [Hz]  of a planet on its bearing alone
};
void describe(described::Record& record, const ModeStudy& study);

/// At rest, or in the frame of the carrier at the speed of the model.
ModeStudy mode_study(const gearset::dynamics::SetModel& model, bool at_speed = false);

/// Natural frequencies over speed from rest to the nominal speed [rad/s], and mesh harmonics, for a Campbell
/// diagram.
void describe_campbell(described::Record& record, const gearset::dynamics::SetModel& model,
                       double nominal_speed);

/// Statistics of each planet, load sharing, what the run took, and the time series of the last periods.
void describe_gear_run(described::Record& record, const study::GearRunResult& result);

}  // namespace orbearing::app
