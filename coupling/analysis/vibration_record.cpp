#include "coupling/analysis/vibration_record.hpp"

#include <array>
#include <cmath>

#include "mechanics/constants.hpp"
#include "mechanics/member_keys.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

using bearing::defect::Scratched;
using described::Record;
using mechanics::significant;
namespace dimension = described::dimension;

mechanics::Problems problems(const EnvelopeBand& band, double rate) {
  const double highest = 0.5 * rate;
  const std::vector<double>& ends = band.ends;
  if (ends.empty() || (ends.size() == 2 && ends[0] < ends[1] && ends[1] <= highest)) return {};
  const std::string found = ends.size() == 2
                                ? significant(ends[0], 6) + " to " + significant(ends[1], 6) + " Hz"
                                : "a list of " + std::to_string(ends.size());
  return {{mechanics::MemberKeys(band)(band.ends),
           found + "; its lower and upper end, at most " + significant(highest, 4) + " Hz, are required"}};
}

namespace {

bool has_profile(const bearing::defect::Scratch& scratch) {
  return scratch.form != bearing::ScratchForm::profile || scratch.profile.size() >= 3;
}

}  // namespace

mechanics::Problems problems(const bearing::defect::Scratch& scratch, bool rollers, double element_diameter) {
  const std::string element = rollers ? "roller" : "ball",
                    race = std::string(described::text_of(scratch.race));
  const mechanics::MemberKeys key(scratch);
  mechanics::Problems found;
  if (scratch.race == (rollers ? Scratched::ball : Scratched::roller))
    found.push_back({key(scratch.race), "'" + race + "' in a bearing of " + element + "s; outer, inner, " +
                                            element + " or none is required"});
  if (scratch.race == Scratched::none) return found;
  if (!has_profile(scratch))
    found.push_back({key(scratch.form), "'profile' without three depths in " + key(scratch.profile) +
                                            "; at least three, at equal distances "
                                            "from edge to edge, are required"});
  for (const double* size : {&scratch.width, &scratch.depth})
    if (!(*size > 0.0))
      found.push_back({key(scratch.race), "'" + race + "' without " + key(*size) +
                                              "; width and depth of the scratch, or none, are required"});
  // In a wider scratch an element would reach a depth without contact, which eq. 4 does not cover; two
  // elements share no scratch.
  const double widest = 0.5 * element_diameter;
  if (element_diameter > 0.0 && scratch.width > widest)
    found.push_back({key(scratch.width), mechanics::as_written(key(scratch.width)) + " for " + element +
                                             "s that enter between its edges; at most half a " + element +
                                             " diameter, " + significant(1e3 * widest, 4) +
                                             " mm, is required"});
  return found;
}

double time_of_turns(double turns, double speed, double run_up_from) {
  return constants::two_pi * turns / (0.5 * (1.0 + run_up_from) * std::abs(speed));
}

double root_mean_square(const Eigen::ArrayXd& signal) {
  return std::sqrt((signal - signal.mean()).square().mean());
}

Eigen::ArrayXd evenly_spaced(Eigen::Index count, double step) {
  return step * Eigen::ArrayXd::LinSpaced(count, 0.0, static_cast<double>(count - 1));
}

void describe_time(Record& record, Eigen::Index samples, double rate) {
  record.series("sampling_rate", dimension::cycles, "samples a second", {}, rate);
  record.series("time", dimension::time, "since the signal began", {"time"},
                evenly_spaced(samples, 1.0 / rate));
}

void describe_peaks(Record& record, const std::string& name, const std::string& along,
                    const std::vector<diagnosis::NamedPeak>& peaks, bool run_up,
                    const described::Dimension& amplitude) {
  record.table(name, along, "lines of the spectrum, the largest first", peaks,
               [&](Record& row, const diagnosis::NamedPeak& peak) {
                 if (run_up)
                   row.value("order", dimension::ratio, "turns", peak.frequency);
                 else
                   row.value("frequency_Hz", dimension::cycles, "of the line", peak.frequency);
                 row.value("amplitude", amplitude, "Hann window", peak.amplitude);
                 row.value("is", "source of the line", peak.is);
               });
}

void describe_lines(Record& record, const std::string& lines, const std::string& orders,
                    const std::string& along, const std::vector<diagnosis::NamedPeak>& peaks, bool run_up) {
  describe_peaks(record, lines, along, run_up ? std::vector<diagnosis::NamedPeak>{} : peaks, false,
                 dimension::acceleration);
  if (run_up)
    describe_peaks(record, orders, along, peaks, true, dimension::acceleration);
  else
    record.nothing(orders, "of a run-up");
}

void describe_vibration(Record& record, double shaft_frequency, double cage_frequency,
                        const std::optional<double>& defect_frequency, const diagnosis::InstrumentView& view,
                        bool run_up) {
  record.value("shaft_Hz", dimension::cycles, "of the shaft", shaft_frequency).variable = "shaft_frequency";
  record.value("cage_Hz", dimension::cycles, "of the cage", cage_frequency).variable = "cage_frequency";
  record.value("defect_Hz", dimension::cycles, "frequency of contacts with a scratch", defect_frequency)
      .variable = "defect_frequency";
  describe_lines(record, "envelope_peaks", "orders", "envelope_peak", view.envelope_peaks, run_up);
  record.value("amplitude_unit", "of the peaks", "m/s2");
}

void describe_band(Record& record, const diagnosis::InstrumentView& view, bool run_up) {
  const auto& band = view.band.band;
  record.array("band_Hz", dimension::cycles, "of the envelope", {"end"}, std::array{band.low, band.high});
  record.series("band_low", dimension::cycles, "lower end of the band of the envelope", {}, band.low);
  record.series("band_high", dimension::cycles, "upper end of the band of the envelope", {}, band.high);
  record.value("band_kurtosis", dimension::ratio, "spectral, of the band", view.band.kurtosis);
  record.value(run_up ? "order_resolution" : "resolution_Hz", run_up ? dimension::ratio : dimension::cycles,
               "distance of lines", view.envelope_spectrum.resolution);
}

}  // namespace orbearing::analysis
