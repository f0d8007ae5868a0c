#include "app/signals/residual.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace orbearing::app::signals {

Eigen::ArrayXd without_lines(const Eigen::ArrayXd& signal, double rate,
                             const std::vector<double>& frequencies, int beside) {
  Eigen::FFT<double> fft;
  std::vector<double> samples(signal.begin(), signal.end());
  std::vector<std::complex<double>> bins;
  fft.fwd(bins, samples);
  const auto size = static_cast<long>(bins.size());
  const double resolution = rate / static_cast<double>(size);
  for (const double frequency : frequencies) {
    const long line = std::lround(frequency / resolution);
    for (long k = line - beside; k <= line + beside; ++k)
      if (k > 0 && k < size)
        bins[static_cast<std::size_t>(k)] = bins[static_cast<std::size_t>(size - k)] = 0.0;
  }
  fft.inv(samples, bins);
  return Eigen::Map<const Eigen::ArrayXd>(samples.data(), signal.size());
}

}  // namespace orbearing::app::signals
