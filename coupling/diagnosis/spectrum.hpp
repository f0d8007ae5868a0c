// Spectra of signals sampled at even times, and envelopes of bands. Nothing here knows a bearing. The
// transform is that of Eigen (KissFFT), which comes with a package that the program needs anyhow, under a
// free licence.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace orbearing::diagnosis {

/// Amplitudes of the lines k resolution, k = 0, 1, ...: a sine of amplitude a on a line shows as a.
struct Spectrum {
  double resolution = 0.0;   // [Hz]
  Eigen::ArrayXd amplitude;  // [unit of the signal]

  double frequency(Eigen::Index line) const { return resolution * static_cast<double>(line); }  // [Hz]
};

enum class Window { none, hann };

/// Of the signal less its mean. Amplitudes are those of lines far apart whatever the window; without one half
/// the sum of their squares is the mean square of the signal (Parseval), but for the last line of an even
/// number of samples, which counts twice.
Spectrum spectrum_of(const Eigen::ArrayXd& signal, double rate, Window window);

/// Frequencies of a band [Hz].
struct Band {
  double low = 0.0;
  double high = 0.0;
};

/// Magnitude of the analytic signal of what `signal` holds in `band` (ideal band-pass, Hilbert transform).
Eigen::ArrayXd envelope_of(const Eigen::ArrayXd& signal, double rate, const Band& band);

/// A band and how unevenly its power comes in time.
struct KurtosisOfBand {
  Band band;
  double kurtosis =
      0.0;  // [-]  mean of |x|^4 over the square of that of |x|^2, less 2: 0 for noise, -1 for a sine
};

/// Spectral kurtosis of one band.
double kurtosis_of(const Eigen::ArrayXd& signal, double rate, const Band& band);

/// The band of largest spectral kurtosis among those that cut the frequencies up to half the rate into 2, 3,
/// 4, 6, 8, 12, ... equal ones [Antoni2007], none narrower than `least_width` [Hz] or with less than a
/// hundredth of the power.
KurtosisOfBand most_impulsive_band(const Eigen::ArrayXd& signal, double rate, double least_width);

/// `signal` without its lines at `frequencies` [Hz] and the ones beside each. A signal of whole periods of
/// all of them loses these alone.
Eigen::ArrayXd without_lines(const Eigen::ArrayXd& signal, double rate,
                             const std::vector<double>& frequencies);

}  // namespace orbearing::diagnosis
