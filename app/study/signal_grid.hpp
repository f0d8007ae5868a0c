// A grid of scratched bearings whose signals are wanted: what varies, and what each signal is labelled with.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/study/defect_study.hpp"

namespace orbearing::app {

/// A path of the case and the texts of its values.
struct SignalAxis {
  std::string path;
  std::vector<std::string> values;
};

/// One signal of the grid, by what it differs in from the case.
struct SignalVariant {
  std::vector<Setting> settings;
};

/// Noise of the instrument, added to the acceleration along the load and across it.
struct SignalNoise {
  double rms = 0.0;        // [m/s^2]
  std::uint64_t seed = 1;  // of the first signal; each has its own
};

/// From options such as "operation.shaft_speed=[1000 rpm, 1500 rpm]"; without any, all that can be scratched
/// in that case. Throws BadInput for a text that is no path and list.
std::vector<SignalAxis> signal_axes(const std::vector<std::string>& options, const ResolvedCase& resolved);

/// All combinations, the last axis fastest. What only a scratch feels does not vary without one: a sound
/// bearing stands in the grid once. Throws BadInput where the case cannot be changed so.
std::vector<SignalVariant> signal_variants(const ResolvedCase& resolved, const std::vector<SignalAxis>& axes);

/// Warns of each axis along which no signal differs, though its labels do. Signals with noise differ always.
std::vector<std::string> axes_without_effect(const std::vector<SignalAxis>& axes,
                                             const std::vector<SignalVariant>& variants,
                                             const std::vector<nlohmann::ordered_json>& labels);

/// Adds noise of the `number`-th signal. The same for a seed and number, whatever the order of signals.
void add_noise(const SignalNoise& noise, std::size_t number, study::RingVibration& vibration);

/// What a diagnosis would be trained with: what is scratched, speed, load, size, frequencies, level.
void describe_labels(described::Record& record, const ResolvedCase& resolved, const DefectStudy& study,
                     const SignalNoise& noise);

/// Labels as rows of text, their names first.
std::string labels_csv(const std::vector<nlohmann::ordered_json>& labels);

}  // namespace orbearing::app
