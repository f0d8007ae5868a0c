#include "app/study/defect_study.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "app/case/defect_case.hpp"
#include "app/errors.hpp"

namespace orbearing::app {

namespace {

namespace defect = bearing::defect;
using defect::Scratched;

void warn(const ResolvedCase& in, DefectStudy& study) {
  constexpr double resolved_share = 0.4;  // of the sampling rate
  if (study.at_rest.natural_frequency > resolved_share * study.vibration.rate)
    study.warnings.push_back(
        fmt::format("signal.sampling_rate: {} cannot hold the ring's vibration at {:.4g} Hz",
                    in.given("signal.sampling_rate"), study.at_rest.natural_frequency));
}

// A ring on its contacts is no rigid body at such frequencies, and its motion would take hours in silence.
void require_few_steps(const ResolvedCase& in, double natural_frequency) {
  constexpr double most = 1e6;  // [Hz]
  if (natural_frequency > most)
    throw BadInput(fmt::format(
        "{}: bearing.outer_ring_mass: found {}, with which the ring vibrates at {:.3g} Hz on its contacts; "
        "required: a mass with at most {:.0f} Hz; above this the ring is not rigid",
        in.origin("bearing.outer_ring_mass"), in.given("bearing.outer_ring_mass"), natural_frequency, most));
}

}  // namespace

bool is_defect(const ResolvedCase& resolved) {
  return (resolved.model() & described::single_scratched) != 0;
}

DefectStudy defect_study(const ResolvedCase& in, DefectRung rung, const std::function<void(double)>& progress,
                         const std::function<void(study::RingVibration&)>& disturb) {
  const defect::ScratchedBearing scratched = scratched_bearing_of(in);
  const bearing::BearingGeometry geometry = bearing::geometry_of(scratched.bearing);
  DefectStudy study{.scratched = scratched.scratch.race,
                    .passing = defect::passing_frequencies(scratched.bearing, scratched.shaft_speed)};
  study.defect_frequency = diagnosis::defect_frequency(study.scratched, study.passing);
  study.at_rest = defect::ScratchedMotion(scratched).static_position();
  if (study.defect_frequency) {
    study.inner_depth = defect::greatest_depth(scratched.scratch.width, bearing::Race::inner, geometry);
    study.outer_depth = defect::greatest_depth(scratched.scratch.width, bearing::Race::outer, geometry);
  }
  require_few_steps(in, study.at_rest.natural_frequency);
  study.rollers = scratched.bearing.has_rollers();
  study.moving = rung == DefectRung::all;
  study.vibration = study.moving
                        ? study::sample_vibration(scratched, scratched_motion_of(in),
                                                  scratched_length_error_of(in), sampling_of(in), progress)
                        : study::sample_vibration(scratched, sampling_of(in));
  if (!study.vibration.report.completed)
    throw ComputationFailed(in.text("name") + ": " + study.vibration.report.message);
  if (disturb) disturb(study.vibration);
  study.run_up = sampling_of(in).run_up_from < 1.0;
  study.turned = study.passing;
  if (study.run_up)
    study.turned = diagnosis::slower(study.passing, study.vibration.shaft_speed / scratched.shaft_speed);
  if (study.moving)
    study.turned =
        diagnosis::as_turned(study.turned, scratched.bearing.element_count(), study.vibration.cage_speed);
  study.view = diagnosis::bearing_view(study.vibration.acceleration.row(0).transpose(),
                                       {.rate = study.vibration.rate,
                                        .band = stated_band_of(in),
                                        .angle = study.run_up ? &study.vibration.shaft_angle : nullptr},
                                       study.at_rest.natural_frequency, study.scratched, study.rollers,
                                       study.passing, study.turned);
  warn(in, study);
  return study;
}

std::vector<Derived> defect_quantities(const ResolvedCase& in) {
  const defect::ScratchedBearing scratched = scratched_bearing_of(in);
  const defect::PassingFrequencies passing =
      defect::passing_frequencies(scratched.bearing, scratched.shaft_speed);
  const defect::StaticPosition at_rest = defect::ScratchedMotion(scratched).static_position();
  require_few_steps(in, at_rest.natural_frequency);
  return {{"defect.shaft_frequency", passing.shaft, "Hz", "turns of the shaft"},
          {"defect.cage_frequency", passing.cage, "Hz", "turns of the cage at pure rolling"},
          {"defect.outer_pass_frequency", passing.outer_pass, "Hz", "balls over a point of the outer race"},
          {"defect.inner_pass_frequency", passing.inner_pass, "Hz", "balls over a point of the inner race"},
          {"defect.ball_pass_frequency", passing.element_pass, "Hz", "a point of a ball over either race"},
          {"defect.static_displacement", 1e6 * at_rest.position[0], "um", "outer ring along the load"},
          {"defect.natural_frequency", at_rest.natural_frequency, "Hz",
           "outer ring along the load, about its static equilibrium"}};
}

namespace {

using described::Record;
namespace dimension = described::dimension;

// Slip of the cage relative to pure rolling at the same speed of the shaft.
double cage_slip(const DefectStudy& study) {
  return 1.0 - study.turned.cage / (study.passing.cage * (study.turned.shaft / study.passing.shaft));
}

void describe_passing(Record& record, const DefectStudy& study) {
  record.value("outer_pass_Hz", dimension::cycles, "elements over the outer race", study.passing.outer_pass)
      .variable = "outer_pass_frequency";
  record.value("inner_pass_Hz", dimension::cycles, "elements over the inner race", study.passing.inner_pass)
      .variable = "inner_pass_frequency";
  record
      .value(study.rollers ? "roller_pass_Hz" : "ball_pass_Hz", dimension::cycles,
             "a point of an element over either race", study.passing.element_pass)
      .variable = "ball_pass_frequency";
  record
      .value("natural_frequency_Hz", dimension::cycles, "outer ring along the load",
             study.at_rest.natural_frequency)
      .variable = "natural_frequency";
}

void describe_levels(Record& record, const DefectStudy& study) {
  record.child("acceleration", "of the outer ring along the load", study.view.signal,
               [](Record& of, const Eigen::ArrayXd& signal) {
                 of.value("rms_m_s2", dimension::acceleration, "root mean square", root_mean_square(signal));
                 of.value("max_m_s2", dimension::acceleration, "largest magnitude", signal.abs().maxCoeff());
               });
  record.child("at_rest", "without motion", study.at_rest, [](Record& of, const auto& at_rest) {
    of.value("displacement_um", dimension::small_length, "outer ring along the load", at_rest.position[0]);
    of.value("contact_load_max_N", dimension::force, "largest load of an element", at_rest.load.maxCoeff());
  });
  record.value("contact_load_max_N", dimension::force, "largest load of an element in motion",
               study.vibration.largest_load);
  record.child("sinking", "largest depth of an element in the scratch", study,
               [](Record& of, const DefectStudy& s) {
                 of.value("inner_um", dimension::small_length, "of the inner race", s.inner_depth);
                 of.value("outer_um", dimension::small_length, "of the outer race", s.outer_depth);
               });
}

void describe_turned(Record& record, const DefectStudy& study) {
  record.child("turned", "means, as the cage turned", study, [](Record& of, const DefectStudy& s) {
    of.value("cage_Hz", dimension::cycles, "of the cage", s.turned.cage);
    of.value("cage_slip", dimension::ratio, "against pure rolling", cage_slip(s));
    of.value("outer_pass_Hz", dimension::cycles, "elements over the outer race", s.turned.outer_pass);
    of.value("inner_pass_Hz", dimension::cycles, "elements over the inner race", s.turned.inner_pass);
  });
}

// Expected lines that were searched for; of a run-up, whose lines are orders, none.
void describe_found(Record& record, const DefectStudy& study) {
  const std::string name = diagnosis::defect_name(study.scratched);
  const std::vector<diagnosis::NamedPeak>& envelope = study.view.envelope_peaks;
  const auto add = [&](const char* key, const char* meaning, double frequency) {
    record.value(key, dimension::cycles, meaning, study.run_up ? described::kAbsent : frequency);
  };
  const double peak = peak_frequency(envelope, name);
  add("defect_peak_Hz", "line of the scratch in the envelope", peak);
  add("side_band_Hz", "from there to its side band by the shaft",
      peak_frequency(envelope, name + " + shaft") - peak);
  add("passage_peak_Hz", "line of the balls that pass, in the spectrum",
      peak_frequency(study.view.spectrum_peaks, "ball passage"));
}

void describe_series(Record& record, const DefectStudy& study) {
  const study::RingVibration& vibration = study.vibration;
  describe_time(record, vibration.ball_load.size(), vibration.rate);
  const auto along_time = [&](const char* name, const described::Dimension& of, const char* meaning,
                              const Eigen::ArrayXd& values) {
    record.series(name, of, meaning, {"time"}, values);
  };
  if (study.run_up)
    along_time("shaft_angle", dimension::angle, "since the motion began", vibration.shaft_angle);
  record.series("acceleration", dimension::acceleration, "outer ring, along the load and across it",
                {"direction", "time"}, vibration.acceleration);
  record.series("displacement", dimension::length,
                "outer ring from the concentric position, along the load and across it",
                {"direction", "time"}, vibration.position);
  along_time("ball_deflection", dimension::length,
             "approach of both races at the first ball, negative where it is free", vibration.ball_approach);
  along_time("ball_load", dimension::force, "load of the first ball with damping", vibration.ball_load);
  along_time("envelope", dimension::acceleration, "of the acceleration along the load in the band",
             study.view.envelope);
  const diagnosis::Spectrum& spectrum = study.view.spectrum;
  const Eigen::Index lines = spectrum.amplitude.size();
  record.series(study.run_up ? "order" : "frequency", study.run_up ? dimension::ratio : dimension::cycles,
                "lines of both spectra", {"line"}, evenly_spaced(lines, spectrum.resolution));
  record.series("acceleration_spectrum", dimension::acceleration,
                "amplitude of the acceleration along the load, Hann window", {"line"}, spectrum.amplitude);
  record.series("envelope_spectrum", dimension::acceleration,
                "amplitude of its envelope in the band, Hann window", {"line"},
                study.view.envelope_spectrum.amplitude);
}

void append_number(std::uint32_t number, int bytes, std::string& text) {
  for (int i = 0; i < bytes; ++i) text.push_back(static_cast<char>(number >> (8 * i) & 0xffu));
}

}  // namespace

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

namespace {

void describe_lines(Record& record, const std::string& what, const std::string& orders,
                    const std::string& along, const std::vector<diagnosis::NamedPeak>& peaks, bool run_up) {
  describe_peaks(record, what, along, run_up ? std::vector<diagnosis::NamedPeak>{} : peaks, false,
                 dimension::acceleration);
  if (run_up)
    describe_peaks(record, orders, along, peaks, true, dimension::acceleration);
  else
    record.nothing(orders, "of a run-up");
}

}  // namespace

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

void describe(Record& record, const DefectStudy& study) {
  describe_vibration(record, study.passing.shaft, study.passing.cage, study.defect_frequency, study.view,
                     study.run_up);
  record.child("defect_frequencies", "at pure rolling, by their names in condition monitoring",
               study.passing);
  describe_passing(record, study);
  describe_band(record, study.view, study.run_up);
  describe_lines(record, "spectrum_peaks", "spectrum_orders", "spectrum_peak", study.view.spectrum_peaks,
                 study.run_up);
  describe_found(record, study);
  describe_levels(record, study);
  if (study.moving) describe_turned(record, study);
  describe_series(record, study);
}

std::string signal_csv(const DefectStudy& study) {
  std::string text =
      study.run_up ? "time_s,acceleration_m_s2,shaft_angle_rad\n" : "time_s,acceleration_m_s2\n";
  const Eigen::ArrayXd& signal = study.view.signal;
  for (Eigen::Index k = 0; k < signal.size(); ++k) {
    text += fmt::format("{:.9g},{:.9g}", static_cast<double>(k) / study.vibration.rate, signal[k]);
    text += study.run_up ? fmt::format(",{:.12g}\n", study.vibration.shaft_angle[k]) : "\n";
  }
  return text;
}

std::string signal_wav(const DefectStudy& study) {
  constexpr std::uint32_t bytes_each = 4, floating = 3, one_channel = 1, of_format = 16;
  const Eigen::ArrayXd& signal = study.view.signal;
  const double largest = signal.abs().maxCoeff();
  const auto bytes = bytes_each * static_cast<std::uint32_t>(signal.size());
  const auto rate = static_cast<std::uint32_t>(std::max(1L, std::lround(study.vibration.rate)));
  std::string text = "RIFF";
  append_number(36 + bytes, 4, text);
  text += "WAVEfmt ";
  append_number(of_format, 4, text);
  append_number(floating, 2, text);
  append_number(one_channel, 2, text);
  append_number(rate, 4, text);
  append_number(bytes_each * rate, 4, text);
  append_number(bytes_each, 2, text);
  append_number(8 * bytes_each, 2, text);
  text += "data";
  append_number(bytes, 4, text);
  for (const double sample : signal)
    append_number(std::bit_cast<std::uint32_t>(static_cast<float>(largest > 0.0 ? sample / largest : 0.0)), 4,
                  text);
  return text;
}

}  // namespace orbearing::app
