#include "coupling/diagnosis/peaks.hpp"
#include "mechanics/constants.hpp"

#include <algorithm>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>
#include <cstdlib>

namespace orbearing::diagnosis {

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
  // What is left of the mean spreads over the first lines.
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
