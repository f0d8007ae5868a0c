#include "coupling/diagnosis/spectrum.hpp"

#include <algorithm>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "mechanics/constants.hpp"
#include "mechanics/easy_length.hpp"

namespace orbearing::diagnosis {

namespace {

using Complex = std::complex<double>;
using Bins = std::vector<Complex>;

Bins transform(const Eigen::ArrayXd& signal) {
  Eigen::FFT<double> fft;
  std::vector<double> samples(signal.begin(), signal.end());
  Bins bins;
  fft.fwd(bins, samples);
  return bins;
}

// Bins of positive frequencies within the band: lines low resolution <= f < high resolution.
struct Lines {
  Eigen::Index begin = 0;
  Eigen::Index end = 0;
};

Lines lines_in(const Band& band, double resolution, std::size_t samples) {
  const auto line = [&](double frequency) {
    return static_cast<Eigen::Index>(std::ceil(frequency / resolution - 1e-9));
  };
  const auto last = static_cast<Eigen::Index>(samples / 2);
  return {std::clamp<Eigen::Index>(line(band.low), 1, last),
          std::clamp<Eigen::Index>(line(band.high), 1, last)};
}

// Power and kurtosis of the analytic signal of some lines, at as many samples as it takes.
struct Moments {
  double power = 0.0;
  double kurtosis = 0.0;
};

Moments moments_of(const Bins& bins, const Lines& lines) {
  if (lines.end <= lines.begin) return {};
  // Twice the lines, so that the fourth power is held by the samples too.
  const auto wanted = std::max<long>(2, 2 * static_cast<long>(lines.end - lines.begin));
  Bins part(static_cast<std::size_t>(mechanics::easy_length_from(wanted)), Complex(0.0, 0.0));
  std::copy(bins.begin() + lines.begin, bins.begin() + lines.end, part.begin());
  Eigen::FFT<double> fft;
  Bins analytic;
  fft.inv(analytic, part);
  double second = 0.0, fourth = 0.0;
  for (const Complex& sample : analytic) {
    second += std::norm(sample);
    fourth += std::norm(sample) * std::norm(sample);
  }
  const auto count = static_cast<double>(analytic.size());
  if (!(second > 0.0)) return {};
  double power = 0.0;
  for (Eigen::Index k = lines.begin; k < lines.end; ++k)
    power += std::norm(bins[static_cast<std::size_t>(k)]);
  return {power, count * fourth / (second * second) - 2.0};
}

}  // namespace

Spectrum spectrum_of(const Eigen::ArrayXd& signal, double rate, Window window) {
  const Eigen::Index samples = signal.size();
  Eigen::ArrayXd weighted = signal - signal.mean();
  double gain = static_cast<double>(samples);  // of a constant
  if (window == Window::hann) {
    const double step = constants::two_pi / static_cast<double>(samples);
    const Eigen::ArrayXd hann =
        0.5 - 0.5 * (step * Eigen::ArrayXd::LinSpaced(samples, 0.0, static_cast<double>(samples - 1))).cos();
    weighted *= hann;
    gain = hann.sum();
  }
  const Bins bins = transform(weighted);
  Spectrum spectrum{.resolution = rate / static_cast<double>(samples),
                    .amplitude = Eigen::ArrayXd(samples / 2 + 1)};
  for (Eigen::Index k = 0; k < spectrum.amplitude.size(); ++k) {
    const bool alone = k == 0 || 2 * k == samples;  // its mirror image is itself
    spectrum.amplitude[k] = (alone ? 1.0 : 2.0) * std::abs(bins[static_cast<std::size_t>(k)]) / gain;
  }
  return spectrum;
}

Eigen::ArrayXd envelope_of(const Eigen::ArrayXd& signal, double rate, const Band& band) {
  Bins bins = transform(signal);
  const Lines lines = lines_in(band, rate / static_cast<double>(signal.size()), bins.size());
  for (Eigen::Index k = 0; k < signal.size(); ++k)
    bins[static_cast<std::size_t>(k)] *= k >= lines.begin && k < lines.end ? 2.0 : 0.0;
  Eigen::FFT<double> fft;
  Bins analytic;
  fft.inv(analytic, bins);
  Eigen::ArrayXd envelope(signal.size());
  for (Eigen::Index k = 0; k < signal.size(); ++k)
    envelope[k] = std::abs(analytic[static_cast<std::size_t>(k)]);
  return envelope;
}

double kurtosis_of(const Eigen::ArrayXd& signal, double rate, const Band& band) {
  const Bins bins = transform(signal);
  return moments_of(bins, lines_in(band, rate / static_cast<double>(signal.size()), bins.size())).kurtosis;
}

KurtosisOfBand most_impulsive_band(const Eigen::ArrayXd& signal, double rate, double least_width) {
  constexpr double least_share = 0.01;  // of the power
  const Bins bins = transform(signal - signal.mean());
  const double half = 0.5 * rate, resolution = rate / static_cast<double>(signal.size());
  const double all = moments_of(bins, lines_in({0.0, half}, resolution, bins.size())).power;
  KurtosisOfBand best{{0.0, half}, moments_of(bins, lines_in({0.0, half}, resolution, bins.size())).kurtosis};
  for (int parts = 2, next = 3; half / parts >= least_width; std::swap(parts, next), next = 2 * next) {
    for (int part = 0; part < parts; ++part) {
      const Band band{half * part / parts, half * (part + 1) / parts};
      const Moments moments = moments_of(bins, lines_in(band, resolution, bins.size()));
      if (moments.power >= least_share * all && moments.kurtosis > best.kurtosis)
        best = {band, moments.kurtosis};
    }
  }
  return best;
}

Eigen::ArrayXd without_lines(const Eigen::ArrayXd& signal, double rate,
                             const std::vector<double>& frequencies) {
  Bins bins = transform(signal);
  const auto size = static_cast<long>(bins.size());
  const double resolution = rate / static_cast<double>(size);
  for (const double frequency : frequencies) {
    const long line = std::lround(frequency / resolution);
    for (long k = line - 1; k <= line + 1; ++k)
      if (k > 0 && k < size)
        bins[static_cast<std::size_t>(k)] = bins[static_cast<std::size_t>(size - k)] = 0.0;
  }
  Eigen::FFT<double> fft;
  std::vector<double> samples;
  fft.inv(samples, bins);
  return Eigen::Map<const Eigen::ArrayXd>(samples.data(), signal.size());
}

namespace {

constexpr Eigen::Index kSideLobes = 4;  // lines

bool is_largest_around(const Eigen::ArrayXd& amplitude, Eigen::Index line) {
  const Eigen::Index begin = std::max<Eigen::Index>(line - kSideLobes + 1, 0);
  const Eigen::Index end = std::min(line + kSideLobes, amplitude.size());
  return amplitude[line] > 0.0 && amplitude.segment(begin, end - begin).maxCoeff() == amplitude[line];
}

// By the two highest lines, exact for a sine far from others: lobe of the Hann window over d lines,
// sin(pi d) / (pi d (1 - d^2)).
Peak refined(const Spectrum& spectrum, Eigen::Index line) {
  const double here = spectrum.amplitude[line];
  const double low = spectrum.amplitude[line - 1], high = spectrum.amplitude[line + 1];
  const double ratio = std::max(low, high) / here;
  const double beside = std::copysign((2.0 * ratio - 1.0) / (ratio + 1.0), high - low);  // [lines]
  const double turned = constants::pi * beside;
  return {(static_cast<double>(line) + beside) * spectrum.resolution,
          here * (1.0 - beside * beside) / boost::math::sinc_pi(turned)};
}

}  // namespace

std::string harmonic_name(int harmonic, const std::string& name) {
  return harmonic == 1 ? name : std::to_string(harmonic) + " x " + name;
}

std::vector<Peak> peaks_of(const Spectrum& spectrum, const PeakSearch& search) {
  const auto last = std::min(static_cast<Eigen::Index>(search.highest / spectrum.resolution),
                             spectrum.amplitude.size() - 2);
  std::vector<Peak> peaks;
  // The residual mean spreads over the first lines.
  for (Eigen::Index k = kSideLobes; k <= last; ++k)
    if (is_largest_around(spectrum.amplitude, k)) peaks.push_back(refined(spectrum, k));
  std::sort(peaks.begin(), peaks.end(),
            [](const Peak& one, const Peak& other) { return one.amplitude > other.amplitude; });
  const auto is_small = [&](const Peak& peak) {
    return peak.amplitude < search.least_share * peaks.front().amplitude;
  };
  peaks.erase(std::find_if(peaks.begin(), peaks.end(), is_small), peaks.end());
  if (peaks.size() > search.most) peaks.resize(search.most);
  return peaks;
}

void add_lines(double frequency, const std::string& name, int harmonics, double spacing,
               const std::string& spacing_name, int bands, int order, std::vector<ExpectedLine>& lines) {
  for (int harmonic = 1; harmonic <= harmonics; ++harmonic)
    for (int band = -bands; band <= bands; ++band) {
      ExpectedLine line{harmonic * frequency + band * spacing, harmonic_name(harmonic, name),
                        order + harmonic + std::abs(band)};
      if (band != 0) line.name += (band > 0 ? " + " : " - ") + harmonic_name(std::abs(band), spacing_name);
      if (line.frequency > 0.0) lines.push_back(std::move(line));
    }
}

std::string name_of(double frequency, const std::vector<ExpectedLine>& lines, double tolerance) {
  const ExpectedLine* best = nullptr;
  for (const ExpectedLine& line : lines)
    if (std::abs(line.frequency - frequency) <= tolerance && (best == nullptr || line.order < best->order))
      best = &line;
  return best != nullptr ? best->name : "unknown";
}

}  // namespace orbearing::diagnosis
