// A bearing with scratches: which lines they give, what these are called (docs/defects), and what one
// instrument shows of it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "bearing/defect/scratch.hpp"
#include "bearing/defect/scratched_bearing.hpp"
#include "coupling/diagnosis/planet_frequencies.hpp"
#include "coupling/diagnosis/spectrum.hpp"

namespace orbearing::diagnosis {

// Order tracking: a signal of a machine whose speed changes, sampled anew at equal angles of one of its
// shafts, so that the orders of that shaft are constant in the spectrum.

/// A signal at even angles.
struct AngleSignal {
  double per_revolution = 0.0;  // [-]  samples of a revolution: the rate, in orders
  Eigen::ArrayXd value;         // [unit of the signal]
};

/// `signal`, sampled at equal steps of angle instead of time; `angle` [rad] is that of the shaft at each
/// sample and grows or falls throughout. Between samples by a sine over its argument under Blackman's window,
/// which keeps what lies below 0.4 of the rate to 1e-4. As many samples to a revolution as the slowest part
/// of the signal has in time, so that there is no aliasing. Throws std::invalid_argument where the shaft is
/// stationary or turns back.
AngleSignal resampled(const Eigen::ArrayXd& signal, const Eigen::ArrayXd& angle);

/// Lines over orders: revolutions of the shaft replace seconds, orders replace hertz.
Spectrum order_spectrum(const AngleSignal& signal, Window window);

/// Name of the lines of a scratch; without one, of the balls that pass the load zone.
std::string defect_name(bearing::defect::Scratched scratched);
/// Frequency [Hz] of contacts with a scratch; none without one.
std::optional<double> defect_frequency(bearing::defect::Scratched scratched,
                                       const bearing::defect::PassingFrequencies& passing);

/// At a speed lower by `share`.
bearing::defect::PassingFrequencies slower(const bearing::defect::PassingFrequencies& full, double share);
/// Elements pass where the cage takes them, whatever its slip; `cage_speed` [rad/s].
bearing::defect::PassingFrequencies as_turned(const bearing::defect::PassingFrequencies& rolling,
                                              int elements, double cage_speed);

/// A peak of a spectrum and what it is: "inner race defect - shaft".
struct NamedPeak {
  double frequency = 0.0;  // [Hz], of a run-up the order [-]
  double amplitude = 0.0;  // of the signal's unit
  std::string is;
};

/// In a run-up the lines of both spectra are orders of a shaft.
struct InstrumentView {
  Eigen::ArrayXd signal;    // [m/s^2] or [N]
  KurtosisOfBand band;      // [Hz]  of the envelope
  Eigen::ArrayXd envelope;  // [unit of the signal]  in the band
  Spectrum spectrum;
  Spectrum envelope_spectrum;
  std::vector<NamedPeak> spectrum_peaks;  // largest first, as the next ones
  std::vector<NamedPeak> envelope_peaks;
};

/// Settings of the analysis of a signal.
struct Reading {
  double rate = 0.0;                      // [Hz]
  std::optional<Band> band;               // of the envelope; none: the most impulsive one
  const Eigen::ArrayXd* angle = nullptr;  // [rad]  of a run-up: spectra are over the turns of that shaft
};

/// View of the outer ring's acceleration; peaks up to beyond the vibration of `natural_frequency` [Hz] that a
/// scratch excites. `turned`: frequencies of the motion.
InstrumentView bearing_view(const Eigen::ArrayXd& signal, const Reading& reading, double natural_frequency,
                            bearing::defect::Scratched scratched, bool rollers,
                            const bearing::defect::PassingFrequencies& rolling,
                            const bearing::defect::PassingFrequencies& turned);

/// View of a gear set with a scratched planet bearing, on the housing or in the carrier's frame. The envelope
/// is that of the signal less the lines of the teeth, except in a run-up, whose orders are the carrier's.
InstrumentView planet_view(const Eigen::ArrayXd& signal, const Reading& reading, bool on_housing,
                           const std::vector<bearing::defect::Scratched>& scratched,
                           const PlanetFrequencies& rolling, const PlanetFrequencies& turned);

/// NaN where none of them is that.
double peak_frequency(const std::vector<NamedPeak>& peaks, const std::string& is);

}  // namespace orbearing::diagnosis
