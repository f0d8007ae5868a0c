#include "coupling/analysis/scratched_bearing.hpp"

#include <cmath>
#include <stdexcept>

#include "bearing/geometry.hpp"
#include "coupling/analysis/friction_conditions.hpp"
#include "coupling/diagnosis/signal_file.hpp"
#include "mechanics/append.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/member_keys.hpp"
#include "mechanics/no_result.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace defect = bearing::defect;
using described::Record;
using mechanics::significant;
namespace dimension = described::dimension;

namespace {

// Depths of a profile are those of a scratch.
template <class Inputs>
std::vector<mechanics::Conditional<Inputs>> conditions_of_scratch() {
  const defect::Scratch scratch;
  const mechanics::MemberKeys key(scratch);
  return {
      {.keys = {key(scratch.profile)},
       .premises = {{.on = {key(scratch.race)},
                     .holds = [](const Inputs& in) { return in.of.scratch.race != defect::Scratched::none; },
                     .value = "outer|inner|ball|roller"}}}};
}

}  // namespace

std::vector<mechanics::Conditional<RingOnBalls>> RingOnBalls::conditions() {
  return conditions_of_scratch<RingOnBalls>();
}

std::vector<mechanics::Conditional<RingOnRollers>> RingOnRollers::conditions() {
  return conditions_of_scratch<RingOnRollers>();
}

std::vector<std::string> ScratchedBallsInMotion::required() {
  const ScratchedBallsInMotion m;
  const bearing::Cage& cage = m.of.bearing.cage;
  return mechanics::MemberKeys(m).of(cage.inner_diameter, cage.outer_diameter, cage.width, cage.density);
}

std::vector<mechanics::Conditional<ScratchedBallsInMotion>> ScratchedBallsInMotion::conditions() {
  auto all = conditions_of_scratch<ScratchedBallsInMotion>();
  const ScratchedBallsInMotion m;
  mechanics::append(conditions_of_ball_friction(m, mechanics::MemberKeys(m)), all);
  return all;
}

mechanics::Problems problems(const ScratchOfBalls& machine) {
  return problems(machine.scratch, false, machine.balls.diameter);
}

mechanics::Problems problems(const ScratchOfRollers& machine) {
  return problems(machine.scratch, true, machine.rollers.diameter);
}

mechanics::Problems problems(const SampledRing& machine) {
  const Sampling& sampling = machine.sampling;
  const mechanics::MemberKeys key(machine);
  mechanics::Problems found;
  if (!(machine.load.radial > 0.0))
    found.push_back({key(machine.load.radial), "no load; a radial load greater than 0 N is required"});
  const double turns = std::abs(machine.rotation.shaft_speed) / constants::two_pi;  // [1/s]
  if (turns == 0.0) {
    found.push_back({key(machine.rotation.shaft_speed), "a stationary shaft; a speed is required"});
    return found;
  }
  constexpr double most = 1e7;
  const double samples = sampling.rate / turns * (sampling.revolutions + sampling.settling_revolutions);
  if (samples > most)
    found.push_back({key(sampling.rate), significant(samples, 3) +
                                             " samples in all; at most 1e+07, by a lower rate or fewer "
                                             "revolutions, are required"});
  if (sampling.rate < 100.0 * turns)
    found.push_back({key(sampling.rate), mechanics::as_written(key(sampling.rate)) + " at " +
                                             significant(turns, 4) +
                                             " revolutions a second; at least 100 samples a revolution, " +
                                             significant(100.0 * turns, 4) + " Hz, are required"});
  mechanics::append(problems(machine.band, sampling.rate), found);
  return found;
}

namespace {

// None where the inputs have other mistakes, which are found elsewhere.
std::optional<double> natural_frequency(const ScratchedInHousing& in) {
  try {
    return defect::ScratchedMotion(in.bodies()).static_position().natural_frequency;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

mechanics::Problems rigid_ring_problems(const ScratchedInHousing& in) {
  constexpr double most = 1e6;  // [Hz]
  const double frequency = natural_frequency(in).value_or(0.0);
  if (!(frequency > most)) return {};
  const std::string key = mechanics::MemberKeys(in.ring)(in.ring.mass);
  return {{key, mechanics::as_written(key) + ", with which the ring vibrates at " +
                    significant(frequency, 3) + " Hz on its contacts; a mass with at most " +
                    significant(most, 7) + " Hz is required: above this the ring is not rigid"}};
}

}  // namespace

mechanics::Problems problems(const RingOnBalls& machine) {
  return rigid_ring_problems(machine.of);
}

mechanics::Problems problems(const RingOnRollers& machine) {
  return rigid_ring_problems(machine.of);
}

namespace {

// Before the motion.
ScratchedVibration at_rest(const ScratchedInHousing& in) {
  const defect::ScratchedBearing bodies = in.bodies();
  const bearing::BearingGeometry geometry = bearing::geometry_of(in.bearing);
  ScratchedVibration study{.scratched = in.scratch.race,
                           .rollers = in.bearing.has_rollers(),
                           .run_up = in.sampling.run_up_from < 1.0,
                           .passing = defect::passing_frequencies(in.bearing, in.rotation.shaft_speed)};
  study.defect_frequency = diagnosis::defect_frequency(study.scratched, study.passing);
  study.at_rest = defect::ScratchedMotion(bodies).static_position();
  if (study.defect_frequency) {
    study.inner_depth = defect::greatest_depth(in.scratch.width, bearing::Race::inner, geometry);
    study.outer_depth = defect::greatest_depth(in.scratch.width, bearing::Race::outer, geometry);
  }
  return study;
}

void add_view(const ScratchedInHousing& in, ScratchedVibration& study) {
  const RingVibration& vibration = study.vibration;
  study.turned = study.passing;
  if (study.run_up)
    study.turned = diagnosis::slower(study.passing, vibration.shaft_speed / in.rotation.shaft_speed);
  if (study.moving)
    study.turned = diagnosis::as_turned(study.turned, in.bearing.element_count(), vibration.cage_speed);
  study.view = diagnosis::bearing_view(vibration.acceleration.row(0).transpose(),
                                       {.rate = vibration.rate,
                                        .band = in.band.stated(),
                                        .angle = study.run_up ? &vibration.shaft_angle : nullptr},
                                       study.at_rest.natural_frequency, study.scratched, study.rollers,
                                       study.passing, study.turned);
  constexpr double resolved_share = 0.4;  // of the sampling rate
  if (study.at_rest.natural_frequency > resolved_share * vibration.rate)
    study.warnings.push_back("signal.sampling_rate: " + significant(vibration.rate, 6) +
                             " Hz cannot hold the ring's vibration at " +
                             significant(study.at_rest.natural_frequency, 4) + " Hz");
}

ScratchedVibration seen(const ScratchedInHousing& in, ScratchedVibration study, const Disturb& disturb) {
  if (!study.vibration.report.completed) throw mechanics::NoResult(study.vibration.report.message);
  if (disturb) disturb(study.vibration);
  add_view(in, study);
  return study;
}

}  // namespace

ScratchedVibration vibration_of_ring(const ScratchedInHousing& in, const Disturb& disturb) {
  ScratchedVibration study = at_rest(in);
  study.vibration = sample_vibration(in.bodies(), in.sampling);
  return seen(in, std::move(study), disturb);
}

std::vector<std::pair<std::string, std::string>> ScratchedVibration::files() const {
  const Eigen::ArrayXd* angle = run_up ? &vibration.shaft_angle : nullptr;
  return {{"signal.csv", diagnosis::signal_csv(view.signal, vibration.rate, angle)},
          {"signal.wav", diagnosis::signal_wav(view.signal, vibration.rate)}};
}

ScratchedVibration ring_on_balls(const RingOnBalls& in) {
  return vibration_of_ring(in.of);
}

ScratchedVibration ring_on_rollers(const RingOnRollers& in) {
  return vibration_of_ring(in.of);
}

ScratchedVibration vibration_in_motion(const ScratchedBallsInMotion& in,
                                       const std::function<void(double)>& progress, const Disturb& disturb) {
  ScratchedVibration study = at_rest(in.of);
  study.moving = true;
  study.vibration = sample_vibration(in.of.bodies(), in.motion, in.length_error, in.of.sampling, progress);
  return seen(in.of, std::move(study), disturb);
}

ScratchedVibration moving_scratched_balls(const ScratchedBallsInMotion& in,
                                          const std::function<void(double)>& progress) {
  return vibration_in_motion(in, progress);
}

double time_of_signal(const ScratchedInHousing& in) {
  return time_of_turns(in.sampling.settling_revolutions + in.sampling.revolutions, in.rotation.shaft_speed,
                       in.sampling.run_up_from);
}

namespace {

ScratchQuantities quantities(const ScratchedInHousing& in) {
  return {defect::passing_frequencies(in.bearing, in.rotation.shaft_speed),
          defect::ScratchedMotion(in.bodies()).static_position()};
}

}  // namespace

ScratchQuantities quantities_of(const ScratchedBallBearing& machine) {
  return quantities(machine.all.of);
}

ScratchQuantities quantities_of(const RingOnRollers& machine) {
  return quantities(machine.of);
}

void describe(Record& record, const ScratchQuantities& quantities) {
  const auto frequency = [&](const char* name, const char* meaning, double value) {
    record.value(name, dimension::cycles, meaning, value);
  };
  const defect::PassingFrequencies& passing = quantities.passing;
  frequency("shaft_frequency_Hz", "turns of the shaft", passing.shaft);
  frequency("cage_frequency_Hz", "turns of the cage at pure rolling", passing.cage);
  frequency("outer_pass_frequency_Hz", "balls over a point of the outer race", passing.outer_pass);
  frequency("inner_pass_frequency_Hz", "balls over a point of the inner race", passing.inner_pass);
  frequency("ball_pass_frequency_Hz", "a point of a ball over either race", passing.element_pass);
  record.value("static_displacement_um", dimension::small_length, "outer ring along the load",
               quantities.at_rest.position[0]);
  frequency("natural_frequency_Hz", "outer ring along the load, about its static equilibrium",
            quantities.at_rest.natural_frequency);
}

namespace {

// Slip of the cage relative to pure rolling at the same speed of the shaft.
double cage_slip(const ScratchedVibration& study) {
  return 1.0 - study.turned.cage / (study.passing.cage * (study.turned.shaft / study.passing.shaft));
}

void describe_passing(Record& record, const ScratchedVibration& study) {
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

void describe_levels(Record& record, const ScratchedVibration& study) {
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
               [](Record& of, const ScratchedVibration& s) {
                 of.value("inner_um", dimension::small_length, "of the inner race", s.inner_depth);
                 of.value("outer_um", dimension::small_length, "of the outer race", s.outer_depth);
               });
}

void describe_turned(Record& record, const ScratchedVibration& study) {
  record.child("turned", "means, as the cage turned", study, [](Record& of, const ScratchedVibration& s) {
    of.value("cage_Hz", dimension::cycles, "of the cage", s.turned.cage);
    of.value("cage_slip", dimension::ratio, "against pure rolling", cage_slip(s));
    of.value("outer_pass_Hz", dimension::cycles, "elements over the outer race", s.turned.outer_pass);
    of.value("inner_pass_Hz", dimension::cycles, "elements over the inner race", s.turned.inner_pass);
  });
}

// Expected lines that were searched for; of a run-up, whose lines are orders, none.
void describe_found(Record& record, const ScratchedVibration& study) {
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

void describe_series(Record& record, const ScratchedVibration& study) {
  const RingVibration& vibration = study.vibration;
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

}  // namespace

void describe(Record& record, const ScratchedVibration& study) {
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

}  // namespace orbearing::analysis
