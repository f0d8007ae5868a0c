#include "app/study/defect_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>

#include "app/case/defect_case.hpp"
#include "app/errors.hpp"
#include "app/signals/orders.hpp"

namespace orbearing::app {

namespace {

namespace defect = bearing::defect;
using defect::Scratched;

// The compliance that varies as balls or rollers pass the load zone.
constexpr const char* kPassage = "ball passage";
constexpr const char* kRollerPassage = "roller passage";

// Up to `highest` [Hz]. A scratch that goes round meets the load zone once in each turn of what carries it.
std::vector<signals::ExpectedLine> expected_lines(Scratched scratched, bool rollers,
                                                  const defect::PassingFrequencies& passing, double highest) {
  constexpr int bands = 6, rare = 3;
  std::vector<signals::ExpectedLine> lines;
  const auto add = [&](double frequency, const std::string& name, double spacing, const char* of, int order) {
    const int harmonics = static_cast<int>(std::ceil(highest / frequency)) + 1;
    signals::add_lines(frequency, name, harmonics, spacing, of, spacing > 0.0 ? bands : 0, order, lines);
  };
  const std::string name = defect_name(scratched);
  if (scratched == Scratched::outer) add(passing.outer_pass, name, 0.0, "", 0);
  if (scratched == Scratched::inner) add(passing.inner_pass, name, passing.shaft, "shaft", 0);
  if (of_element(scratched)) {
    add(passing.element_pass, name, passing.cage, "cage", 0);
    // It meets both races, each once a turn, and sinks less on the outer one.
    add(0.5 * passing.element_pass, scratched == Scratched::ball ? "ball spin" : "roller spin", passing.cage, "cage", rare);
  }
  add(passing.outer_pass, rollers ? kRollerPassage : kPassage, 0.0, "", 1);
  add(passing.shaft, "shaft", 0.0, "", 1);
  add(passing.cage, "cage", 0.0, "", rare);
  return lines;
}

// What a line of the spectra is counted in [Hz]: orders of a run-up are turns of the shaft.
double unit_of(const DefectStudy& study) {
  return study.run_up ? study.turned.shaft : 1.0;
}

std::vector<NamedPeak> peaks_up_to(double highest, const signals::Spectrum& spectrum,
                                   const DefectStudy& study) {
  const double unit = unit_of(study);
  highest /= unit;
  return named_peaks(
      spectrum, {.highest = highest},
      expected_lines(study.scratched, study.rollers, slower(study.turned, 1.0 / unit), highest), 0.5);
}

double highest_pass(const defect::PassingFrequencies& passing) {
  return std::max({passing.outer_pass, passing.inner_pass, passing.element_pass});
}

void analyse(const ResolvedCase& in, DefectStudy& study) {
  constexpr double passes_in_band = 8.0, passes_shown = 8.0;
  const Eigen::ArrayXd signal = study.vibration.acceleration.row(0).transpose();
  const double pass = highest_pass(study.passing);
  InstrumentView& view = study.view;
  view = view_of(in, signal, signal, study.vibration.rate, passes_in_band * pass,
                 study.run_up ? &study.vibration.shaft_angle : nullptr);
  // Up to beyond the vibration that a scratch strikes.
  view.spectrum_peaks = peaks_up_to(2.0 * study.at_rest.natural_frequency, view.spectrum, study);
  view.envelope_peaks = peaks_up_to(passes_shown * pass, view.envelope_spectrum, study);
}

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
        "{}: bearing.outer_ring_mass: found {}, with which the ring vibrates at {:.3g} Hz on its contacts; required: a "
        "mass with at most {:.0f} Hz, far above which no ring is rigid",
        in.origin("bearing.outer_ring_mass"), in.given("bearing.outer_ring_mass"), natural_frequency, most));
}

// Balls pass where the cage takes them, whatever its slip.
defect::PassingFrequencies as_turned(const defect::ScratchedBearing& scratched, const DefectStudy& study) {
  const double balls = scratched.bearing.element_count();
  defect::PassingFrequencies turned = study.turned;
  turned.cage = std::abs(study.vibration.cage_speed) / boost::math::double_constants::two_pi;
  turned.outer_pass = balls * turned.cage;
  turned.inner_pass = balls * (turned.shaft - turned.cage);
  return turned;
}

}  // namespace

InstrumentView view_of(const ResolvedCase& in, const Eigen::ArrayXd& signal, const Eigen::ArrayXd& residual,
                       double rate, double least_width, const Eigen::ArrayXd* angle) {
  using namespace signals;
  const auto spectrum = [&](const Eigen::ArrayXd& of) {
    return angle ? order_spectrum(resampled(of, *angle), Window::hann) : spectrum_of(of, rate, Window::hann);
  };
  InstrumentView view{.signal = signal};
  if (const std::optional<Band> stated = stated_band_of(in))
    view.band = {*stated, kurtosis_of(residual, rate, *stated)};
  else
    view.band = most_impulsive_band(residual, rate, least_width);
  view.envelope = envelope_of(residual, rate, view.band.band);
  view.spectrum = spectrum(signal);
  view.envelope_spectrum = spectrum(view.envelope);
  return view;
}

std::vector<NamedPeak> named_peaks(const signals::Spectrum& spectrum, const signals::PeakSearch& search,
                                   const std::vector<signals::ExpectedLine>& lines, double tolerance) {
  std::vector<NamedPeak> named;
  for (const signals::Peak& peak : signals::peaks_of(spectrum, search))
    named.push_back({peak.frequency, peak.amplitude,
                     signals::name_of(peak.frequency, lines, tolerance * spectrum.resolution)});
  return named;
}

double peak_frequency(const std::vector<NamedPeak>& peaks, const std::string& is) {
  for (const NamedPeak& peak : peaks)
    if (peak.is == is) return peak.frequency;
  return std::numeric_limits<double>::quiet_NaN();
}

defect::PassingFrequencies slower(const defect::PassingFrequencies& full, double share) {
  return {share * full.shaft, share * full.cage, share * full.outer_pass, share * full.inner_pass,
          share * full.element_pass};
}

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
  return kPassage;
}

std::optional<double> defect_frequency(Scratched scratched, const defect::PassingFrequencies& passing) {
  switch (scratched) {
    case Scratched::outer:
      return passing.outer_pass;
    case Scratched::inner:
      return passing.inner_pass;
    case Scratched::ball:
    case Scratched::roller:
      return passing.element_pass;
    case Scratched::none:
      break;
  }
  return std::nullopt;
}

bool is_defect(const ResolvedCase& resolved) {
  return (resolved.model() & described::lone_scratched) != 0;
}

DefectStudy defect_study(const ResolvedCase& in, DefectRung rung, const std::function<void(double)>& progress,
                         const std::function<void(study::RingVibration&)>& disturb) {
  const defect::ScratchedBearing scratched = scratched_bearing_of(in);
  const bearing::BearingGeometry geometry = bearing::geometry_of(scratched.bearing);
  DefectStudy study{.scratched = scratched.scratch.race,
                    .passing = defect::passing_frequencies(scratched.bearing, scratched.shaft_speed)};
  study.defect_frequency = defect_frequency(study.scratched, study.passing);
  study.at_rest = defect::ScratchedMotion(scratched).static_place();
  if (study.defect_frequency) {
    study.inner_sinking = defect::deepest_sinking(scratched.scratch.width, bearing::Race::inner, geometry);
    study.outer_sinking = defect::deepest_sinking(scratched.scratch.width, bearing::Race::outer, geometry);
  }
  require_few_steps(in, study.at_rest.natural_frequency);
  study.rollers = scratched.bearing.has_rollers();
  study.moving = rung == DefectRung::all;
  study.vibration = study.moving ? study::sample_vibration(scratched, scratched_motion_of(in),
                                                           scratched_length_error_of(in), sampling_of(in), progress)
                                 : study::sample_vibration(scratched, sampling_of(in));
  if (!study.vibration.report.completed)
    throw ComputationFailed(in.text("name") + ": " + study.vibration.report.message);
  if (disturb) disturb(study.vibration);
  study.run_up = sampling_of(in).run_up_from < 1.0;
  study.turned = study.passing;
  if (study.run_up) study.turned = slower(study.passing, study.vibration.shaft_speed / scratched.shaft_speed);
  if (study.moving) study.turned = as_turned(scratched, study);
  analyse(in, study);
  warn(in, study);
  return study;
}

double defect_property(const DefectStudy& study, const std::string& quantity) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const std::vector<NamedPeak>& peaks = study.view.envelope_peaks;
  const std::string name = defect_name(study.scratched);
  if (quantity == "shaft_Hz") return study.passing.shaft;
  if (quantity == "cage_Hz") return study.passing.cage;
  if (quantity == "defect_Hz") return study.defect_frequency.value_or(nothing);
  if (quantity == "defect_peak_Hz") return peak_frequency(peaks, name);
  if (quantity == "side_band_Hz")
    return peak_frequency(peaks, name + " + shaft") - peak_frequency(peaks, name);
  if (quantity == "passage_peak_Hz") return peak_frequency(study.view.spectrum_peaks, kPassage);
  return nothing;
}

std::vector<Derived> defect_quantities(const ResolvedCase& in) {
  const defect::ScratchedBearing scratched = scratched_bearing_of(in);
  const defect::PassingFrequencies passing =
      defect::passing_frequencies(scratched.bearing, scratched.shaft_speed);
  const defect::StaticPlace at_rest = defect::ScratchedMotion(scratched).static_place();
  return {{"defect.shaft_frequency", passing.shaft, "Hz", "turns of the shaft"},
          {"defect.cage_frequency", passing.cage, "Hz", "turns of the cage at pure rolling"},
          {"defect.outer_pass_frequency", passing.outer_pass, "Hz", "balls over a place of the outer race"},
          {"defect.inner_pass_frequency", passing.inner_pass, "Hz", "balls over a place of the inner race"},
          {"defect.ball_pass_frequency", passing.element_pass, "Hz", "a place of a ball over either race"},
          {"defect.static_displacement", 1e6 * at_rest.place[0], "um", "outer ring along the load"},
          {"defect.natural_frequency", at_rest.natural_frequency, "Hz",
           "outer ring along the load, about its static balance"}};
}

}  // namespace orbearing::app
