#include "app/study/defect_output.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "app/results/json_number.hpp"
#include "app/units.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

// Lines stand at frequencies or, in a run-up, at orders.
Json lines_json(const std::vector<NamedPeak>& peaks, bool run_up) {
  return run_up ? Json::array() : peaks_json(peaks, run_up);
}
Json orders_json(const std::vector<NamedPeak>& peaks, bool run_up) {
  return run_up ? peaks_json(peaks, run_up) : Json(nullptr);
}

// Of the cage against pure rolling at the same turns of the shaft.
double cage_slip(const DefectStudy& study) {
  return 1.0 - study.turned.cage / (study.passing.cage * (study.turned.shaft / study.passing.shaft));
}

Eigen::ArrayXd evenly_spaced(Eigen::Index count, double step) {
  return step * Eigen::ArrayXd::LinSpaced(count, 0.0, static_cast<double>(count - 1));
}

void add_scalars(const DefectStudy& study, PointContent& content) {
  content.add("sampling_rate", "s-1", "samples a second", study.vibration.rate);
  content.add("shaft_frequency", "s-1", "of the shaft", study.passing.shaft);
  content.add("cage_frequency", "s-1", "of the cage", study.passing.cage);
  content.add("outer_pass_frequency", "s-1", "balls over the outer race", study.passing.outer_pass);
  content.add("inner_pass_frequency", "s-1", "balls over the inner race", study.passing.inner_pass);
  content.add("ball_pass_frequency", "s-1", "a place of a ball over either race", study.passing.element_pass);
  content.add("natural_frequency", "s-1", "outer ring along the load", study.at_rest.natural_frequency);
  content.add("band_low", "s-1", "lower end of the band of the envelope", study.view.band.band.low);
  content.add("band_high", "s-1", "upper end of the band of the envelope", study.view.band.band.high);
}

void add_spectra(const DefectStudy& study, PointContent& content) {
  const signals::Spectrum& spectrum = study.view.spectrum;
  const Eigen::Index lines = spectrum.amplitude.size();
  content.add_dimension("line", lines);
  content.add(study.run_up ? "order" : "frequency", {"line"}, study.run_up ? "1" : "s-1",
              study.run_up ? "lines of both spectra, turns of the shaft" : "lines of both spectra",
              evenly_spaced(lines, spectrum.resolution));
  content.add("acceleration_spectrum", {"line"}, "m s-2",
              "amplitude of the acceleration along the load, Hann window", spectrum.amplitude);
  content.add("envelope_spectrum", {"line"}, "m s-2", "amplitude of its envelope in the band, Hann window",
              study.view.envelope_spectrum.amplitude);
}

void append_number(std::uint32_t number, int bytes, std::string& text) {
  for (int i = 0; i < bytes; ++i) text.push_back(static_cast<char>(number >> (8 * i) & 0xffu));
}

}  // namespace

double root_mean_square(const Eigen::ArrayXd& signal) {
  return std::sqrt((signal - signal.mean()).square().mean());
}

Json peaks_json(const std::vector<NamedPeak>& peaks, bool run_up) {
  Json list = Json::array();
  for (const NamedPeak& peak : peaks)
    list.push_back({{run_up ? "order" : "frequency_Hz", peak.frequency},
                    {"amplitude", peak.amplitude},
                    {"is", peak.is}});
  return list;
}

Json vibration_json(double shaft_frequency, double cage_frequency,
                    const std::optional<double>& defect_frequency, const InstrumentView& view, bool run_up) {
  return {{"shaft_Hz", shaft_frequency},
          {"cage_Hz", cage_frequency},
          {"defect_Hz", defect_frequency ? Json(*defect_frequency) : Json(nullptr)},
          {"envelope_peaks", lines_json(view.envelope_peaks, run_up)},
          {"orders", orders_json(view.envelope_peaks, run_up)},
          {"amplitude_unit", "m/s2"}};
}

Json band_json(const InstrumentView& view, bool run_up) {
  return {{"band_Hz", {view.band.band.low, view.band.band.high}},
          {"band_kurtosis", view.band.kurtosis},
          {run_up ? "order_resolution" : "resolution_Hz", view.envelope_spectrum.resolution}};
}

std::string band_text(const InstrumentView& view) {
  return fmt::format("envelope of {:.0f} to {:.0f} Hz, spectral kurtosis {:.3g}", view.band.band.low,
                     view.band.band.high, view.band.kurtosis);
}

std::string peaks_text(const char* title, const std::vector<NamedPeak>& peaks, bool run_up, const char* unit,
                       int digits) {
  std::string text = fmt::format("\n{}\n{:>14} {:>18}  {}\n", title, run_up ? "order" : "frequency [Hz]",
                                 fmt::format("amplitude [{}]", unit), "is");
  for (const NamedPeak& peak : peaks)
    text += fmt::format("{:>14.{}f} {:>18.4g}  {}\n", peak.frequency, digits, peak.amplitude, peak.is);
  return text;
}

Json defect_json(const DefectStudy& study) {
  const Eigen::ArrayXd& signal = study.view.signal;
  Json object = vibration_json(study.passing.shaft, study.passing.cage, study.defect_frequency, study.view,
                               study.run_up);
  object.update({{"outer_pass_Hz", study.passing.outer_pass},
                 {"inner_pass_Hz", study.passing.inner_pass},
                 {study.rollers ? "roller_pass_Hz" : "ball_pass_Hz", study.passing.element_pass},
                 {"natural_frequency_Hz", study.at_rest.natural_frequency}});
  object.update(band_json(study.view, study.run_up));
  object.update(
      {{"spectrum_peaks", lines_json(study.view.spectrum_peaks, study.run_up)},
       {"spectrum_orders", orders_json(study.view.spectrum_peaks, study.run_up)},
       {"acceleration", {{"rms_m_s2", root_mean_square(signal)}, {"max_m_s2", signal.abs().maxCoeff()}}},
       {"at_rest",
        {{"displacement_um", kMicro * study.at_rest.place[0]},
         {"contact_load_max_N", study.at_rest.load.maxCoeff()}}},
       {"contact_load_max_N", study.vibration.largest_load},
       {"sinking",
        {{"inner_um", kMicro * study.inner_sinking}, {"outer_um", kMicro * study.outer_sinking}}}});
  if (study.moving)
    object["turned"] = {{"cage_Hz", study.turned.cage},
                        {"cage_slip", cage_slip(study)},
                        {"outer_pass_Hz", study.turned.outer_pass},
                        {"inner_pass_Hz", study.turned.inner_pass}};
  return object;
}

std::string defect_text(const DefectStudy& study) {
  const Eigen::ArrayXd& signal = study.view.signal;
  const char* const element = study.rollers ? "roller" : "ball";
  std::string text = fmt::format(
      "shaft {:.4g} Hz, cage {:.4g} Hz; a place is passed by {}s at {:.5g} Hz on the outer and {:.5g} Hz "
      "on the inner race,\n"
      "one of a {} by races at {:.5g} Hz; defect: {}\n",
      study.passing.shaft, study.passing.cage, element, study.passing.outer_pass, study.passing.inner_pass,
      element, study.passing.element_pass,
      study.defect_frequency ? fmt::format("{:.5g} Hz", *study.defect_frequency) : std::string("none"));
  text += fmt::format(
      "at rest: outer ring {:.4g} um along the load, largest contact load {:.4g} N, natural frequency {:.0f} "
      "Hz\n",
      kMicro * study.at_rest.place[0], study.at_rest.load.maxCoeff(), study.at_rest.natural_frequency);
  text += fmt::format(
      "in motion: acceleration {:.4g} m/s2 rms, at most {:.4g} m/s2; largest contact load {:.4g} N\n",
      root_mean_square(signal), signal.abs().maxCoeff(), study.vibration.largest_load);
  if (study.moving)
    text += fmt::format(
        "as turned: cage {:.5g} Hz, slip {:.3g} %; passes {:.5g} Hz (outer), {:.5g} Hz (inner)\n",
        study.turned.cage, 100.0 * cage_slip(study), study.turned.outer_pass, study.turned.inner_pass);
  text += fmt::format("{}; lines {:.3g} {} apart\n", band_text(study.view),
                      study.view.envelope_spectrum.resolution, study.run_up ? "orders of the shaft" : "Hz");
  return text + peaks_text("envelope", study.view.envelope_peaks, study.run_up, "m/s2", 2) +
         peaks_text("acceleration along the load", study.view.spectrum_peaks, study.run_up, "m/s2", 2);
}

PointContent defect_content(const DefectStudy& study) {
  const study::RingVibration& vibration = study.vibration;
  const Eigen::Index samples = vibration.ball_load.size();
  PointContent content;
  content.add_dimension("time", samples);
  content.add_dimension("direction", 2);
  add_scalars(study, content);
  const auto along_time = [&](const char* name, const char* units, const char* meaning,
                              const Eigen::ArrayXd& values) {
    content.add(name, {"time"}, units, meaning, values);
  };
  along_time("time", "s", "time since the signal began", evenly_spaced(samples, 1.0 / vibration.rate));
  if (study.run_up) along_time("shaft_angle", "rad", "since the motion began", vibration.shaft_angle);
  content.add("acceleration", {"direction", "time"}, "m s-2", "outer ring, along the load and across it",
              vibration.acceleration);
  content.add("displacement", {"direction", "time"}, "m",
              "outer ring from the concentric place, along the load and across it", vibration.place);
  along_time("ball_deflection", "m", "approach of both races at the first ball, negative where it is free",
             vibration.ball_approach);
  along_time("ball_load", "N", "load of the first ball with damping", vibration.ball_load);
  along_time("envelope", "m s-2", "of the acceleration along the load in the band", study.view.envelope);
  add_spectra(study, content);
  return content;
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
