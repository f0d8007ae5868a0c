#include "gearset/mesh/loaded/transmission_error.hpp"
#include "mechanics/constants.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace orbearing::gearset {

namespace {

TransmissionError error_of(const std::function<double(double)>& approach, double force) {
  constexpr double middle = 0.5;  // of each step, off the jumps of a stiffness at 0
  TransmissionError out{.force = force};
  for (int i = 0; i < transmission_samples; ++i)
    out.curve.push_back(approach((i + middle) / transmission_samples));
  out.mean = std::accumulate(out.curve.begin(), out.curve.end(), 0.0) / transmission_samples;
  const auto [least, most] = std::minmax_element(out.curve.begin(), out.curve.end());
  out.peak_to_peak = *most - *least;
  for (int order = 1; order <= transmission_orders; ++order) {
    std::complex<double> sum = 0.0;
    for (int i = 0; i < transmission_samples; ++i)
      sum += out.curve[static_cast<std::size_t>(i)] *
             std::polar(1.0, -constants::two_pi * order * i / transmission_samples);
    out.harmonics.push_back(2.0 * std::abs(sum) / transmission_samples);
  }
  return out;
}

}  // namespace

TransmissionError transmission_error(const LoadedTeeth& teeth, double force) {
  return error_of([&](double position) { return teeth.approach_under(position, force); }, force);
}

TransmissionError transmission_error(const PeriodicCurve& stiffness, double force) {
  return error_of([&](double position) { return force / stiffness.value(position); }, force);
}

namespace {

// Places at which `function` has a step of more than a fiftieth of its largest value, where a pair comes or
// goes.
std::vector<double> steps_of(const std::function<double(double)>& function, int samples) {
  constexpr double least_step = 0.02, resolution = 1e-10;  // [-], [period]
  std::vector<double> values, positions;
  for (int i = 0; i <= samples; ++i) values.push_back(function(static_cast<double>(i) / samples));
  const double step = least_step * *std::max_element(values.begin(), values.end());
  for (int i = 0; i < samples; ++i) {
    double low = static_cast<double>(i) / samples, high = static_cast<double>(i + 1) / samples;
    double at_low = values[static_cast<std::size_t>(i)], at_high = values[static_cast<std::size_t>(i) + 1];
    while (high - low > resolution && std::abs(at_high - at_low) > step) {
      const double middle = 0.5 * (low + high), at_middle = function(middle);
      const bool below = std::abs(at_middle - at_low) > std::abs(at_high - at_middle);
      (below ? high : low) = middle;
      (below ? at_high : at_low) = at_middle;
    }
    if (std::abs(at_high - at_low) > step && high < 1.0) positions.push_back(high);
  }
  return positions;
}

}  // namespace

TangentSpring tangent_spring(const LoadedTeeth& teeth, double force) {
  constexpr int samples = 256;
  const auto stiffness = [&](double position) {
    const double approach = teeth.approach_under(position, force);
    constexpr double aside = 1e-9;  // [-]  of the approach: where a slice just touches, the stiffer side
    return teeth.at(position, approach * (1.0 + aside)).stiffness;
  };
  TangentSpring spring{PeriodicCurve(stiffness, steps_of(stiffness, samples), samples)};
  spring.free = transmission_error(teeth, force).mean - force / spring.stiffness.mean();
  return spring;
}

}  // namespace orbearing::gearset
