#include "coupling/diagnosis/defect_view.hpp"

#include <algorithm>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "coupling/diagnosis/spectrum.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/easy_length.hpp"

namespace orbearing::diagnosis {

namespace {

using constants::pi;
using constants::two_pi;

constexpr Eigen::Index kReach = 32;  // samples to each side

// Interpolated signal at `position`, counted in samples.
double between(const Eigen::ArrayXd& signal, double position) {
  const auto nearest = static_cast<Eigen::Index>(std::floor(position));
  const Eigen::Index from = std::max<Eigen::Index>(0, nearest - kReach + 1);
  const Eigen::Index to = std::min(signal.size() - 1, nearest + kReach);
  double sum = 0.0;
  for (Eigen::Index k = from; k <= to; ++k) {
    const double off = position - static_cast<double>(k), turn = pi * off / static_cast<double>(kReach);
    const double blackman = 0.42 + 0.5 * std::cos(turn) + 0.08 * std::cos(2.0 * turn);
    sum += signal[k] * blackman * boost::math::sinc_pi(pi * off);
  }
  return sum;
}

// Position at which the angle is `wanted`: within the samples after `k` by the parabola through three of
// them.
double position_of(const Eigen::ArrayXd& angle, Eigen::Index k, double wanted) {
  const Eigen::Index middle = std::clamp<Eigen::Index>(k, 1, angle.size() - 2);
  const double slope = 0.5 * (angle[middle + 1] - angle[middle - 1]);
  const double bend = angle[middle + 1] - 2.0 * angle[middle] + angle[middle - 1];
  double off = (wanted - angle[middle]) / slope;
  for (int i = 0; i < 4; ++i)
    off -= (angle[middle] + off * (slope + 0.5 * bend * off) - wanted) / (slope + bend * off);
  return static_cast<double>(middle) + off;
}

}  // namespace

AngleSignal resampled(const Eigen::ArrayXd& signal, const Eigen::ArrayXd& angle) {
  const Eigen::Index samples = signal.size();
  if (samples < 3 || angle.size() != samples)
    throw std::invalid_argument(
        "order tracking: found a signal without an angle for each of its samples; "
        "required: at least 3 of both");
  const double sense = angle[samples - 1] > angle[0] ? 1.0 : -1.0;
  const Eigen::ArrayXd turned = sense * (angle - angle[0]);
  const Eigen::ArrayXd steps = turned.tail(samples - 1) - turned.head(samples - 1);
  if (!(steps.minCoeff() > 0.0))
    throw std::invalid_argument(
        "order tracking: found a shaft that is stationary or turns back; required: one that rotates");
  AngleSignal out{.per_revolution = std::ceil(two_pi / steps.minCoeff())};
  // Interpolation requires neighbours on both sides.
  const Eigen::Index edge = std::min(kReach, samples / 4);
  const double begin = turned[edge], end = turned[samples - 1 - edge];
  const double spacing = two_pi / out.per_revolution;
  const auto most = static_cast<long>(std::floor((end - begin) / spacing)) + 1;
  const auto count = static_cast<Eigen::Index>(mechanics::easy_length_within(most));
  out.value.resize(count);
  Eigen::Index k = edge;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double wanted = begin + spacing * static_cast<double>(i);
    while (k + 2 < samples && turned[k + 1] <= wanted) ++k;
    out.value[i] = between(signal, position_of(turned, k, wanted));
  }
  return out;
}

Spectrum order_spectrum(const AngleSignal& signal, Window window) {
  return spectrum_of(signal.value, signal.per_revolution, window);
}

namespace {

using bearing::defect::PassingFrequencies;
using bearing::defect::Scratched;
using constants::two_pi;

// Harmonics of `frequency` up to `highest` [Hz], each with `bands` side bands where there is a spacing.
struct LineAdder {
  std::vector<ExpectedLine>& lines;
  double highest, unit;  // [Hz]
  int bands;

  void operator()(double frequency, const std::string& name, double spacing, const char* of,
                  int order) const {
    const int harmonics = static_cast<int>(std::ceil(highest / frequency)) + 1;
    add_lines(frequency / unit, name, harmonics, spacing / unit, of, spacing > 0.0 ? bands : 0, order, lines);
  }
};

// Teeth shake the bearing as rollers strike: sums and differences of `struck` with their lines.
void add_sums_with_teeth(double mesh, double highest, double unit, std::vector<ExpectedLine>& lines) {
  constexpr int simple = 6;
  const std::vector<ExpectedLine> struck = lines;
  const int meshes = static_cast<int>(std::min(2.0, highest / mesh + 1.0));
  for (const ExpectedLine& line : struck)
    for (int k = 1; k <= meshes && line.order <= simple; ++k) {
      const std::string teeth = harmonic_name(k, "mesh");
      const double at = k * mesh / unit;
      lines.push_back({std::abs(at - line.frequency), teeth + " - " + line.name, line.order + 2 * k});
      lines.push_back({at + line.frequency, teeth + " + " + line.name, line.order + 2 * k});
    }
}

// The path from the planet to an instrument on the housing turns by once a turn of the carrier.
std::vector<ExpectedLine> seen_from_housing(const std::vector<ExpectedLine>& lines, double carrier,
                                            double highest, double unit) {
  std::vector<ExpectedLine> seen = lines;
  for (const ExpectedLine& line : lines)
    for (const int band : {-1, 1})
      seen.push_back({line.frequency + band * carrier / unit,
                      line.name + (band > 0 ? " + carrier" : " - carrier"), line.order + 1});
  const auto turns = static_cast<int>(std::min(40.0, highest / carrier));
  for (int k = 1; k <= turns; ++k) seen.push_back({k * carrier / unit, harmonic_name(k, "carrier"), 3 + k});
  return seen;
}

// Lines of a bearing up to `highest` [Hz]. A scratch that goes round meets the load zone once in each turn of
// what carries it.
std::vector<ExpectedLine> bearing_lines(Scratched scratched, bool rollers, const PassingFrequencies& passing,
                                        double highest) {
  constexpr int rare = 3;
  std::vector<ExpectedLine> lines;
  const LineAdder add{lines, highest, 1.0, 6};
  const std::string name = defect_name(scratched);
  if (scratched == Scratched::outer) add(passing.outer_pass, name, 0.0, "", 0);
  if (scratched == Scratched::inner) add(passing.inner_pass, name, passing.shaft, "shaft", 0);
  if (of_element(scratched)) {
    add(passing.element_pass, name, passing.cage, "cage", 0);
    // It meets both races, each once a turn, and sinks less on the outer one.
    add(0.5 * passing.element_pass, scratched == Scratched::ball ? "ball spin" : "roller spin", passing.cage,
        "cage", rare);
  }
  // The compliance varies as elements pass the load zone.
  add(passing.outer_pass, rollers ? "roller passage" : "ball passage", 0.0, "", 1);
  add(passing.shaft, "shaft", 0.0, "", 1);
  add(passing.cage, "cage", 0.0, "", rare);
  return lines;
}

// Lines of a gear set in the spectra of one instrument; `unit` 1 for hertz, or the carrier's turns a second
// for its orders.
std::vector<ExpectedLine> planet_lines(const std::vector<Scratched>& scratched, const PlanetFrequencies& at,
                                       bool on_housing, double highest, double unit) {
  constexpr int common = 1, rare = 2;
  std::vector<ExpectedLine> lines;
  const LineAdder add{lines, highest, unit, 3};
  for (const Scratched one : scratched) {
    const std::optional<double> pass = defect_frequency(one, at.bearing);
    if (!pass) continue;
    // The planet carries its race's scratch into the load zone and out again, the cage a roller; the pin is
    // stationary.
    if (one == Scratched::outer) add(*pass, defect_name(one), at.planet, "planet", 0);
    if (one == Scratched::inner) add(*pass, defect_name(one), 0.0, "", 0);
    if (of_element(one)) {
      add(*pass, defect_name(one), at.bearing.cage, "cage", 0);
      add(0.5 * *pass, "roller spin", at.bearing.cage, "cage", rare);
    }
  }
  add_sums_with_teeth(at.mesh, highest, unit, lines);
  add(at.mesh, "mesh", at.planet, "planet", common);
  add(at.planet, "planet", 0.0, "", common);
  add(at.bearing.cage, "cage", 0.0, "", rare);
  add(at.bearing.inner_pass, "rollers past the pin", 0.0, "", rare);
  // With enough of them any line would have a name.
  constexpr int farthest = 12;
  std::erase_if(lines, [](const ExpectedLine& line) { return line.order > farthest; });
  return on_housing ? seen_from_housing(lines, at.carrier, highest, unit) : lines;
}

double fastest_pass(const PassingFrequencies& passing) {
  return std::max({passing.outer_pass, passing.inner_pass, passing.element_pass});
}

// Without peaks yet. The envelope is that of `residual`, `signal` or what is left of it, in no band narrower
// than `least_width` [Hz] but a stated one.
InstrumentView view_of(const Eigen::ArrayXd& signal, const Eigen::ArrayXd& residual, const Reading& reading,
                       double least_width) {
  const auto spectrum = [&](const Eigen::ArrayXd& of) {
    return reading.angle ? order_spectrum(resampled(of, *reading.angle), Window::hann)
                         : spectrum_of(of, reading.rate, Window::hann);
  };
  InstrumentView view{.signal = signal};
  if (reading.band)
    view.band = {*reading.band, kurtosis_of(residual, reading.rate, *reading.band)};
  else
    view.band = most_impulsive_band(residual, reading.rate, least_width);
  view.envelope = envelope_of(residual, reading.rate, view.band.band);
  view.spectrum = spectrum(signal);
  view.envelope_spectrum = spectrum(view.envelope);
  return view;
}

// `tolerance` [-] of the resolution.
std::vector<NamedPeak> named_peaks(const Spectrum& spectrum, const PeakSearch& search,
                                   const std::vector<ExpectedLine>& lines, double tolerance) {
  std::vector<NamedPeak> named;
  for (const Peak& peak : peaks_of(spectrum, search))
    named.push_back(
        {peak.frequency, peak.amplitude, name_of(peak.frequency, lines, tolerance * spectrum.resolution)});
  return named;
}

// The signal lasts whole turns of the carrier, in each of which whole teeth pass.
Eigen::ArrayXd without_teeth(const Eigen::ArrayXd& signal, double rate, const PlanetFrequencies& at,
                             bool on_housing) {
  std::vector<double> lines;
  for (int k = 1; k * at.mesh < 0.5 * rate + at.mesh; ++k) {
    lines.push_back(k * at.mesh);
    if (on_housing) lines.insert(lines.end(), {k * at.mesh - at.carrier, k * at.mesh + at.carrier});
  }
  return without_lines(signal, rate, lines);
}

}  // namespace

std::string defect_name(Scratched scratched) {
  switch (scratched) {
    case Scratched::outer:
      return "outer race defect";
    case Scratched::inner:
      return "inner race defect";
    case Scratched::ball:
      return "ball defect";
    case Scratched::roller:
      return "roller defect";
    case Scratched::none:
      break;
  }
  return "ball passage";
}

std::optional<double> defect_frequency(Scratched scratched, const PassingFrequencies& passing) {
  if (scratched == Scratched::none) return std::nullopt;
  if (of_element(scratched)) return passing.element_pass;
  return scratched == Scratched::outer ? passing.outer_pass : passing.inner_pass;
}

PassingFrequencies slower(const PassingFrequencies& full, double share) {
  return {share * full.shaft, share * full.cage, share * full.outer_pass, share * full.inner_pass,
          share * full.element_pass};
}

PassingFrequencies as_turned(const PassingFrequencies& rolling, int elements, double cage_speed) {
  PassingFrequencies turned = rolling;
  turned.cage = std::abs(cage_speed) / two_pi;
  turned.outer_pass = elements * turned.cage;
  turned.inner_pass = elements * (turned.shaft - turned.cage);
  return turned;
}

InstrumentView bearing_view(const Eigen::ArrayXd& signal, const Reading& reading, double natural_frequency,
                            Scratched scratched, bool rollers, const PassingFrequencies& rolling,
                            const PassingFrequencies& turned) {
  constexpr double passes_in_band = 8.0, passes_shown = 8.0;
  const double pass = fastest_pass(rolling), unit = reading.angle ? turned.shaft : 1.0;  // [Hz]
  InstrumentView view = view_of(signal, signal, reading, passes_in_band * pass);
  const auto peaks = [&](const Spectrum& spectrum, double highest) {
    return named_peaks(spectrum, {.highest = highest / unit},
                       bearing_lines(scratched, rollers, slower(turned, 1.0 / unit), highest / unit), 0.5);
  };
  view.spectrum_peaks = peaks(view.spectrum, 2.0 * natural_frequency);
  view.envelope_peaks = peaks(view.envelope_spectrum, passes_shown * pass);
  return view;
}

InstrumentView planet_view(const Eigen::ArrayXd& signal, const Reading& reading, bool on_housing,
                           const std::vector<Scratched>& scratched, const PlanetFrequencies& rolling,
                           const PlanetFrequencies& turned) {
  constexpr double passes_shown = 4.0, narrowest = 2.0;  // bands hold a line and its neighbours
  const double pass = fastest_pass(turned.bearing), unit = reading.angle ? turned.carrier : 1.0;  // [Hz]
  InstrumentView view =
      view_of(signal, reading.angle ? signal : without_teeth(signal, reading.rate, rolling, on_housing),
              reading, narrowest * pass);
  const auto peaks = [&](const Spectrum& spectrum, double highest) {
    return named_peaks(spectrum, {.highest = highest / unit, .least_share = 0.02, .most = 32},
                       planet_lines(scratched, turned, on_housing, highest, unit), 0.75);
  };
  const double high = std::min(0.4 * reading.rate, 3.0 * turned.mesh);
  view.spectrum_peaks = peaks(view.spectrum, high);
  view.envelope_peaks = peaks(view.envelope_spectrum, std::min(high, passes_shown * pass));
  return view;
}

double peak_frequency(const std::vector<NamedPeak>& peaks, const std::string& is) {
  for (const NamedPeak& peak : peaks)
    if (peak.is == is) return peak.frequency;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace orbearing::diagnosis
