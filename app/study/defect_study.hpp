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

/// A peak of a spectrum and what it is: "inner race defect - shaft".
struct NamedPeak {
  double frequency = 0.0;  // [Hz], of a run-up the order [-]
  double amplitude = 0.0;  // of the signal's unit
  std::string is;
};

/// What one instrument shows. In a run-up the lines of both spectra are orders of a shaft.
struct InstrumentView {
  Eigen::ArrayXd signal;         // [m/s^2] or [N]
  signals::KurtosisOfBand band;  // [Hz]  of the envelope
  Eigen::ArrayXd envelope;       // [unit of the signal]  in the band
  signals::Spectrum spectrum;
  signals::Spectrum envelope_spectrum;
  std::vector<NamedPeak> spectrum_peaks;  // largest first, as the next ones
  std::vector<NamedPeak> envelope_peaks;
};

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
  InstrumentView view;  // acceleration of the outer ring along the load [m/s^2]
  std::vector<std::string> warnings;
};

/// Whether a case is that of a bearing with scratches.
bool is_defect(const ResolvedCase& resolved);

/// How much of the bearing moves: the outer ring alone on balls without mass, or all of it.
enum class DefectRung { ring, all };

/// Throws BadInput where a scratch is so narrow that an element sinks into it by less than the size of an atom: its
/// signal would take hours of steps.
void require_wide_scratch(const ResolvedCase& in);

/// `progress` gets the share done, if any; of the ring alone it is not asked. `disturb` may add to what the
/// instrument records before it is analysed. Throws ComputationFailed where the motion cannot be followed,
/// BadInput as scratched_motion_of().
DefectStudy defect_study(const ResolvedCase& resolved, DefectRung rung = DefectRung::ring,
                         const std::function<void(double)>& progress = {},
                         const std::function<void(study::RingVibration&)>& disturb = {});

/// Without peaks yet. The envelope is that of `residual`, `signal` or what is left of it, in the band that
/// the case states, else in the most impulsive one of at least `least_width` [Hz]; spectra are over the turns
/// of `angle` [rad] where there is one.
InstrumentView view_of(const ResolvedCase& resolved, const Eigen::ArrayXd& signal,
                       const Eigen::ArrayXd& residual, double rate, double least_width,
                       const Eigen::ArrayXd* angle);
/// `tolerance` [-] of the resolution.
std::vector<NamedPeak> named_peaks(const signals::Spectrum& spectrum, const signals::PeakSearch& search,
                                   const std::vector<signals::ExpectedLine>& lines, double tolerance);
/// NaN where none of them is that.
double peak_frequency(const std::vector<NamedPeak>& peaks, const std::string& is);

/// What lines of a scratch are called; without one, those of the balls that pass the load zone.
std::string defect_name(bearing::defect::Scratched scratched);
/// At a speed lower by `share`.
bearing::defect::PassingFrequencies slower(const bearing::defect::PassingFrequencies& full, double share);
/// How often a scratch is met [Hz]; none without one.
std::optional<double> defect_frequency(bearing::defect::Scratched scratched,
                                       const bearing::defect::PassingFrequencies& passing);

/// A number by its name in the validation table: "shaft_Hz", "cage_Hz", "defect_Hz", "defect_peak_Hz",
/// "side_band_Hz", "passage_peak_Hz"; NaN for a name that is not known or a peak that is not there.
double defect_property(const DefectStudy& study, const std::string& quantity);

/// What follows from the inputs, for `orbearing check`.
std::vector<Derived> defect_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
