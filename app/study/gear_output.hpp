// Modes and vibration of a planetary set as JSON, for terminals, and as content of a result file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/results/point_file.hpp"
#include "coupling/study/gear_dynamics.hpp"
#include "gearset/dynamics/modes.hpp"

namespace orbearing::app {

/// [{frequency_Hz, kind, multiplicity, growth_per_s, central_share}]
nlohmann::ordered_json modes_json(const std::vector<gearset::dynamics::Mode>& modes);
/// "rotational", "translational" or "planet".
const char* kind_name(gearset::dynamics::ModeKind kind);
std::string modes_text(const std::vector<gearset::dynamics::Mode>& modes);

/// Modes at rest and the frequency by which published ones may be recognised.
struct ModeStudy {
  std::vector<gearset::dynamics::Mode> modes;
  double planet_frequency = 0.0;  // [Hz]  of a planet on its bearing alone
};

ModeStudy mode_study(const gearset::dynamics::SetModel& model);

/// A frequency by its name in the validation table: "rotational_2_Hz" in hertz, "rotational_2_1" over that of a planet
/// on its bearing; the second of its kind, counted from the first above zero. NaN for a name that is not
/// known or a mode that is not there.
double mode_property(const ModeStudy& study, const std::string& quantity);

/// Natural frequencies over speed from rest to the nominal speed, and mesh harmonics, for a Campbell diagram.
nlohmann::ordered_json campbell_json(const gearset::dynamics::SetModel& model, double nominal_speed);

/// planet_acceleration, mesh_force, bearing_force, load_sharing and what the run took.
nlohmann::ordered_json gear_run_json(const study::GearRunResult& result);
std::string gear_run_text(const study::GearRunResult& result);

/// Statistics of each planet and time series of the last periods, dimensions planet, harmonic and time.
PointContent gear_run_content(const study::GearRunResult& result);

}  // namespace orbearing::app
