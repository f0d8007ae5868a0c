// A bearing with scratches: its vibration in time, and the signal of an instrument.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "bearing/defect/scratched_bearing.hpp"
#include "coupling/diagnosis/defect_view.hpp"
#include "coupling/study/planet_scratch.hpp"
#include "coupling/study/scratch_run.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

struct DefectStudy {
  bearing::defect::Scratched scratched = bearing::defect::Scratched::none;
  bool moving = false;                          // all bodies, balls and cage too
  bool rollers = false;                         // instead of balls
  bool run_up = false;                          // spectra are over orders of the shaft
  bearing::defect::PassingFrequencies passing;  // at pure rolling, at the end of a run-up
  bearing::defect::PassingFrequencies
      turned;  // means, as the cage turned: those of pure rolling unless moving
  std::optional<double>
      defect_frequency;  // [Hz]  at pure rolling, at the end of a run-up; none without a scratch
  bearing::defect::StaticPosition at_rest;
  double inner_depth = 0.0;  // [m]  deepest, on a scratch of the inner race
  double outer_depth = 0.0;  // [m]
  study::RingVibration vibration;
  diagnosis::InstrumentView view;  // acceleration of the outer ring along the load [m/s^2]
  std::vector<std::string> warnings;
};

/// Whether a case is that of a bearing with scratches.
bool is_defect(const ResolvedCase& resolved);

/// How much of the bearing moves: the outer ring alone on balls without mass, or all of it.
enum class DefectRung { ring, all };

/// `progress` gets the share done, if any; for the ring alone it is not called. `disturb` may add to the
/// recorded signal before it is analysed. Throws ComputationFailed where the motion cannot be integrated,
/// BadInput as scratched_motion_of().
DefectStudy defect_study(const ResolvedCase& resolved, DefectRung rung = DefectRung::ring,
                         const std::function<void(double)>& progress = {},
                         const std::function<void(study::RingVibration&)>& disturb = {});

/// Quantities derived from the inputs, for `orbearing check`.
std::vector<Derived> defect_quantities(const ResolvedCase& resolved);

// The vibration of a bearing with scratches as results, and its signal as files.

double root_mean_square(const Eigen::ArrayXd& signal);  // about its mean

/// 0, `step` and so on.
Eigen::ArrayXd evenly_spaced(Eigen::Index count, double step);

/// Time of a signal of so many `samples`, `rate` [Hz] of them a second.
void describe_time(described::Record& record, Eigen::Index samples, double rate);

/// Peaks as rows; in a run-up they are given at orders.
void describe_peaks(described::Record& record, const std::string& name, const std::string& along,
                    const std::vector<diagnosis::NamedPeak>& peaks, bool run_up,
                    const described::Dimension& amplitude);
/// First entries of every vibration result, with the acceleration that `view` shows.
void describe_vibration(described::Record& record, double shaft_frequency, double cage_frequency,
                        const std::optional<double>& defect_frequency, const diagnosis::InstrumentView& view,
                        bool run_up);
void describe_band(described::Record& record, const diagnosis::InstrumentView& view, bool run_up);

void describe(described::Record& record, const DefectStudy& study);

/// Time and acceleration, as rows of text.
std::string signal_csv(const DefectStudy& study);

/// The acceleration as a sound: one channel of 32-bit numbers, largest magnitude 1. Players require a rate in
/// whole Hz.
std::string signal_wav(const DefectStudy& study);

// A gear set with a scratched planet bearing: its vibration in the carrier's frame and on the housing, and
// which line is what (docs/defects/planet.md).

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
  diagnosis::InstrumentView housing;  // ring gear's force on the housing as an instrument measures it [N]
};

/// `progress` gets the share done, if any. Throws ComputationFailed where the motion cannot be followed.
PlanetDefectStudy planet_defect_study(const ResolvedCase& resolved,
                                      const std::function<void(double)>& progress = {});

void describe(described::Record& record, const PlanetDefectStudy& study);

/// Quantities derived from the inputs, for `orbearing check`.
std::vector<Derived> planet_defect_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
