// Spectra of signals sampled at equal times, and envelopes of bands. Nothing here is specific to bearings.
// The transform is that of Eigen (KissFFT), which comes with a package that the program requires anyhow,
// under a free licence.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace orbearing::diagnosis {

/// Amplitudes of the lines k resolution, k = 0, 1, ...: a sine of amplitude a on a line shows as a.
struct Spectrum {
  double resolution = 0.0;   // [Hz]
  Eigen::ArrayXd amplitude;  // [unit of the signal]

  double frequency(Eigen::Index line) const { return resolution * static_cast<double>(line); }  // [Hz]
};

enum class Window { none, hann };

/// Spectrum of the signal less its mean. Amplitudes are those of lines far apart whatever the window; without
/// one half the sum of their squares is the mean square of the signal (Parseval), but for the last line of an
/// even number of samples, which counts twice.
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

/// `signal` without its lines at `frequencies` [Hz] and their neighbours. A signal of whole periods of
/// all of them loses only these.
Eigen::ArrayXd without_lines(const Eigen::ArrayXd& signal, double rate,
                             const std::vector<double>& frequencies);

// Peaks of a spectrum, and which of the expected lines each one is.

struct Peak {
  double frequency = 0.0;  // [Hz]  between the lines of the spectrum, by the shape of the Hann window
  double amplitude = 0.0;  // [unit of the signal]
};

/// Which peaks are looked for.
struct PeakSearch {
  double highest = 0.0;       // [Hz]
  double least_share = 0.01;  // [-]  of the largest one up to there
  std::size_t most = 24;
};

/// Largest first. In a spectrum by Window::hann, a peak less than four lines from a larger one is its side
/// lobe.
std::vector<Peak> peaks_of(const Spectrum& spectrum, const PeakSearch& search);

/// A line that may be there, and how many steps it is from what causes it: the least explains a peak.
struct ExpectedLine {
  double frequency = 0.0;  // [Hz]
  std::string name;
  int order = 1;
};

/// "name", "2 x name".
std::string harmonic_name(int harmonic, const std::string& name);

/// Adds harmonics 1 to `harmonics` of `frequency`, each with side bands up to `bands` times `spacing` to both
/// sides: "name", "2 x name - spacing name". Their order grows from `order` on.
void add_lines(double frequency, const std::string& name, int harmonics, double spacing,
               const std::string& spacing_name, int bands, int order, std::vector<ExpectedLine>& lines);

/// The name of the simplest expected line within `tolerance` [Hz]; "unknown" where none is.
std::string name_of(double frequency, const std::vector<ExpectedLine>& lines, double tolerance);

}  // namespace orbearing::diagnosis
