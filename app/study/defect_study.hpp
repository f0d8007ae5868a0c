// A bearing with scratches: its vibration in time, and what an instrument would make of it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/signals/peaks.hpp"
#include "app/signals/spectrum.hpp"
#include "bearing/defect/frequencies.hpp"
#include "bearing/defect/scratched_bearing.hpp"
#include "coupling/study/scratch_run.hpp"

namespace orbearing::app {

/// A peak of the envelope's spectrum and what it is: "inner race defect - shaft".
struct NamedPeak {
  double frequency = 0.0;  // [Hz], of a run-up the order [-]
  double amplitude = 0.0;  // [m/s^2]
  std::string is;
};

/// Accelerations are those of the outer ring along the load.
struct DefectStudy {
  bearing::defect::Scratched scratched = bearing::defect::Scratched::none;
  bool moving = false;                         // all bodies, balls and cage too
  bool rollers = false;                        // in place of balls
  bool run_up = false;                         // spectra are over orders of the shaft
  bearing::defect::PassingFrequencies passing;  // at pure rolling, at the end of a run-up
  bearing::defect::PassingFrequencies
      turned;  // means, as the cage turned: those of pure rolling unless moving
  std::optional<double>
      defect_frequency;  // [Hz]  at pure rolling, at the end of a run-up; none without a scratch
  bearing::defect::StaticPlace at_rest;
  double inner_sinking = 0.0;  // [m]  deepest, on a scratch of the inner race
  double outer_sinking = 0.0;  // [m]
  study::RingVibration vibration;
  signals::Spectrum spectrum;  // [m/s^2]
  std::vector<NamedPeak> spectrum_peaks;
  signals::KurtosisOfBand band;
  Eigen::ArrayXd envelope;              // [m/s^2]  of the acceleration in the band
  signals::Spectrum envelope_spectrum;  // [m/s^2]
  std::vector<NamedPeak> peaks;         // largest first
  std::vector<std::string> warnings;
};

/// Whether a case is that of a bearing with scratches.
bool is_defect(const ResolvedCase& resolved);

/// How much of the bearing moves: the outer ring alone on balls without mass, or all of it.
enum class DefectRung { ring, all };

/// `progress` gets the share done, if any; of the ring alone it is not asked. `disturb` may add to what the
/// instrument records before it is analysed. Throws ComputationFailed where the motion cannot be followed,
/// BadInput as scratched_motion_of().
DefectStudy defect_study(const ResolvedCase& resolved, DefectRung rung = DefectRung::ring,
                         const std::function<void(double)>& progress = {},
                         const std::function<void(study::RingVibration&)>& disturb = {});

/// What lines of a scratch are called; without one, those of the balls that pass the load zone.
std::string defect_name(bearing::defect::Scratched scratched);
/// How often a scratch is met [Hz]; none without one.
std::optional<double> defect_frequency(bearing::defect::Scratched scratched,
                                       const bearing::defect::PassingFrequencies& passing);

/// A number by its name in the validation table: "shaft_Hz", "cage_Hz", "defect_Hz", "defect_peak_Hz",
/// "side_band_Hz", "passage_peak_Hz"; NaN for a name that is not known or a peak that is not there.
double defect_property(const DefectStudy& study, const std::string& quantity);

/// What follows from the inputs, for `orbearing check`.
std::vector<Derived> defect_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
