#include "coupling/analysis/scratched_planet.hpp"

#include <Eigen/Core>
#include <cmath>
#include <string>

#include "mechanics/constants.hpp"
#include "mechanics/no_result.hpp"

namespace orbearing::analysis {

namespace {

using bearing::defect::Scratch;
using bearing::defect::Scratched;
using described::Record;
namespace dimension = described::dimension;

// Unit vector (outward, in the sense of carrier rotation) from the pin's axis to the middle of the load zone:
// the rollers that carry the planet are there.
Eigen::Vector2d load_zone_of(const ScratchedSet& in) {
  // The bore is pushed one way and meets the rollers on the other side of the pin.
  return -load_on_bearing(in.drivetrain, in.position.planet - 1, in.position.bearing - 1).normalized();
}

// None without scratches. Angles of the result are measured from outward; those of a roller stay.
std::vector<system::ScratchedPlanet> scratched_planets(const ScratchedSet& in, const Eigen::Vector2d& zone) {
  const ScratchedPosition& position = in.position;
  Scratch first = in.scratch;
  if (first.race == Scratched::none) return {};
  const double middle = std::atan2(zone.y(), zone.x());
  const auto turned = [&](Scratch scratch) {
    if (of_element(scratch.race)) return scratch;
    scratch.angle += middle;
    for (double& angle : scratch.more_angles) angle += middle;
    return scratch;
  };
  system::ScratchedPlanet planet{
      .planet = position.planet - 1, .bearing = position.bearing - 1, .scratches = {turned(first)}};
  if (position.also != SecondScratched::none) {
    first.race = scratched_part(position.also);
    first.angle = position.also_angle;
    first.more_angles.clear();
    planet.scratches.push_back(turned(first));
  }
  return {planet};
}

diagnosis::InstrumentView view_of(const ScratchedSet& in, const ScratchedSetVibration& result,
                                  const Eigen::ArrayXd& signal, bool on_housing) {
  return diagnosis::planet_view(signal,
                                {.rate = result.vibration.rate,
                                 .band = in.band.stated(),
                                 .angle = result.run_up ? &result.vibration.carrier_angle : nullptr},
                                on_housing, result.scratched, result.rolling, result.turned);
}

}  // namespace

ScratchedSetVibration vibration_of_scratched_set(const ScratchedSet& in,
                                                 const std::function<void(double)>& progress) {
  const Eigen::Vector2d loaded = load_zone_of(in);  // the way in which the load zone lies
  const std::vector<system::ScratchedPlanet> scratched = scratched_planets(in, loaded);
  ScratchedSetVibration result{.rolling = planet_frequencies(in.drivetrain),
                               .run_up = in.sampling.run_up_from < 1.0};
  for (const system::ScratchedPlanet& planet : scratched)
    for (const Scratch& one : planet.scratches) result.scratched.push_back(one.race);
  if (!result.scratched.empty())
    result.defect_frequency = diagnosis::defect_frequency(result.scratched.front(), result.rolling.bearing);
  result.vibration = sample_vibration(in.drivetrain, scratched, in.sampling, progress);
  const PlanetVibration& motion = result.vibration;
  if (!motion.report.completed) throw mechanics::NoResult(motion.report.message);
  result.turned = as_turned(result.rolling, motion, in.drivetrain.bearing.rollers().count, result.run_up);
  result.carrier = view_of(
      in, result,
      (loaded.x() * motion.acceleration.row(0) + loaded.y() * motion.acceleration.row(1)).transpose(), false);
  result.housing = view_of(in, result, motion.housing, true);
  return result;
}

double time_of_signal(const ScratchedSet& in) {
  const double carrier = planet_frequencies(in.drivetrain).carrier;
  return time_of_turns(in.sampling.settling_revolutions + in.sampling.revolutions,
                       constants::two_pi * carrier, in.sampling.run_up_from);
}

void describe(Record& record, const ScratchedSetQuantities& quantities) {
  const PlanetFrequencies& at = quantities.rolling;
  const auto add = [&](const char* name, const char* meaning, double frequency) {
    record.value(name, dimension::cycles, meaning, frequency);
  };
  add("carrier_frequency_Hz", "turns of the carrier", at.carrier);
  add("planet_frequency_Hz", "turns of the planet relative to the carrier", at.planet);
  add("cage_frequency_Hz", "turns of the cage relative to the carrier", at.bearing.cage);
  add("outer_pass_frequency_Hz", "rollers over a point of the planet's bore", at.bearing.outer_pass);
  add("inner_pass_frequency_Hz", "rollers over a point of the pin", at.bearing.inner_pass);
  add("roller_pass_frequency_Hz", "a point of a roller over either race", at.bearing.element_pass);
  add("mesh_frequency_Hz", "teeth of both meshes", at.mesh);
}

namespace {

void describe_frequencies(Record& record, const PlanetFrequencies& at) {
  const auto add = [&](const char* name, const char* meaning, double frequency) {
    record.value(name, dimension::cycles, meaning, frequency);
  };
  add("carrier_Hz", "turns of the carrier", at.carrier);
  add("planet_Hz", "turns of the planet relative to the carrier", at.planet);
  add("planet_pass_Hz", "planets past a point of the ring", at.planets * at.carrier);
  add("mesh_Hz", "teeth of both meshes", at.mesh);
  add("cage_Hz", "turns of the cage relative to the carrier", at.bearing.cage);
  add("outer_pass_Hz", "rollers over a point of the planet's bore", at.bearing.outer_pass);
  add("inner_pass_Hz", "rollers over a point of the pin", at.bearing.inner_pass);
  add("roller_pass_Hz", "a point of a roller over either race", at.bearing.element_pass);
}

// Signal of one instrument.
struct Instrument {
  const char* key;
  const char* name;  // of its series
  const char* meaning;
  const diagnosis::InstrumentView& view;
  const described::Dimension& of;
  bool run_up;
};

void describe_instrument(Record& record, const Instrument& instrument) {
  const auto& [key, name, meaning, view, of, run_up] = instrument;
  record.value("amplitude_unit", "of the signal", of.customary);
  record.value("rms", of, "root mean square about the mean", root_mean_square(view.signal));
  record.value("max", of, "largest deviation from the mean",
               (view.signal - view.signal.mean()).abs().maxCoeff());
  describe_band(record, view, run_up);
  describe_peaks(record, "envelope_peaks", name + std::string("_envelope_peak"), view.envelope_peaks, run_up,
                 of);
  describe_peaks(record, "spectrum_peaks", name + std::string("_spectrum_peak"), view.spectrum_peaks, run_up,
                 of);
}

void describe_spectra(Record& record, const Instrument& instrument) {
  const std::string of = instrument.name;
  const auto add = [&](const std::string& lines, const std::string& name, const diagnosis::Spectrum& spectrum,
                       const char* meaning) {
    record.series(name + "_place", instrument.run_up ? dimension::ratio : dimension::cycles,
                  instrument.run_up ? "order of the carrier" : "frequency", {lines},
                  evenly_spaced(spectrum.amplitude.size(), spectrum.resolution));
    record.series(name, instrument.of, meaning, {lines}, spectrum.amplitude);
  };
  add(of + "_line", of + "_spectrum", instrument.view.spectrum, "amplitude, Hann window");
  add(of + "_envelope_line", of + "_envelope_spectrum", instrument.view.envelope_spectrum,
      "amplitude of the envelope, Hann window");
}

// Expected lines that were searched for; of a run-up, whose lines are orders, none.
void describe_named_lines(Record& record, const ScratchedSetVibration& study) {
  const std::string name = study.scratched.empty() ? "" : diagnosis::defect_name(study.scratched.front());
  const auto add = [&](const char* key, const char* meaning, const std::vector<diagnosis::NamedPeak>& peaks,
                       const std::string& line, const std::string& from = "") {
    const double frequency = peak_frequency(peaks, line) - (from.empty() ? 0.0 : peak_frequency(peaks, from));
    record.value(key, dimension::cycles, meaning, study.run_up ? described::kAbsent : frequency);
  };
  const auto& carrier = study.carrier.envelope_peaks;
  const auto& housing = study.housing.envelope_peaks;
  add("defect_peak_Hz", "line of the scratch in the envelope in the carrier's frame", carrier, name);
  add("planet_band_Hz", "from there to its side band by the planet", carrier, name + " + planet", name);
  add("carrier_band_Hz", "from it to its side band by the carrier, on the housing", housing,
      name + " + carrier", name);
  add("mesh_on_housing_Hz", "side band of the teeth by the carrier, on the housing",
      study.housing.spectrum_peaks, "mesh + carrier");
}

void describe_series(Record& record, const ScratchedSetVibration& study) {
  const PlanetVibration& motion = study.vibration;
  const auto along_time = [&](const char* name, const described::Dimension& of, const char* meaning,
                              const Eigen::ArrayXd& values) {
    record.series(name, of, meaning, {"time"}, values);
  };
  describe_time(record, motion.housing.size(), motion.rate);
  record.series("acceleration", dimension::acceleration,
                "damaged planet relative to its pin, outward and in the sense of carrier rotation",
                {"direction", "time"}, motion.acceleration);
  along_time("loaded_acceleration", dimension::acceleration, "the same along the middle of the load zone",
             study.carrier.signal);
  along_time("housing_force", dimension::force,
             "meshes of the ring as an instrument on the housing measures them", motion.housing);
  along_time("carrier_angle", dimension::angle, "turned by the carrier", motion.carrier_angle);
  along_time("planet_angle", dimension::angle, "turned by the damaged planet relative to the carrier",
             motion.planet_angle);
}

}  // namespace

void describe(Record& record, const ScratchedSetVibration& study) {
  const auto& at = study.rolling;
  describe_vibration(record, at.planet, at.bearing.cage, study.defect_frequency, study.carrier, study.run_up);
  record.child("at_pure_rolling", "frequencies", at, describe_frequencies);
  record.child("turned", "frequencies, as cage and planet turned", study.turned, describe_frequencies);
  record.value("cage_slip", dimension::ratio, "against pure rolling",
               1.0 - study.turned.bearing.cage / study.turned.planet * at.planet / at.bearing.cage);
  const Instrument instruments[] = {
      {"carrier_frame", "carrier", "damaged planet in the carrier's frame", study.carrier,
       dimension::acceleration, study.run_up},
      {"housing", "housing", "an instrument on the housing", study.housing, dimension::force, study.run_up}};
  for (const Instrument& one : instruments) record.child(one.key, one.meaning, one, describe_instrument);
  record.value("contact_load_max_N", dimension::force, "largest load of a roller",
               study.vibration.largest_load);
  describe_named_lines(record, study);
  describe_series(record, study);
  for (const Instrument& one : instruments) describe_spectra(record, one);
}

}  // namespace orbearing::analysis
