// The vibration of a bearing with scratches as JSON, as text, as content of files.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/results/point_content.hpp"
#include "app/study/defect_study.hpp"

namespace orbearing::app {

double root_mean_square(const Eigen::ArrayXd& signal);  // about its mean

/// Peaks as objects; in a run-up they stand at orders.
nlohmann::ordered_json peaks_json(const std::vector<NamedPeak>& peaks, bool run_up);
/// What every vibration tells first, with the acceleration that `view` shows.
nlohmann::ordered_json vibration_json(double shaft_frequency, double cage_frequency,
                                      const std::optional<double>& defect_frequency,
                                      const InstrumentView& view, bool run_up);
nlohmann::ordered_json band_json(const InstrumentView& view, bool run_up);
std::string band_text(const InstrumentView& view);
/// A table; places with `digits` behind the point.
std::string peaks_text(const char* title, const std::vector<NamedPeak>& peaks, bool run_up, const char* unit,
                       int digits);

nlohmann::ordered_json defect_json(const DefectStudy& study);
std::string defect_text(const DefectStudy& study);

/// The signal, the ring's place, one ball, spectra.
PointContent defect_content(const DefectStudy& study);

/// Time and acceleration, as rows of text.
std::string signal_csv(const DefectStudy& study);

/// The acceleration as a sound: one channel of 32-bit numbers, largest magnitude 1. Players want a rate in
/// whole Hz.
std::string signal_wav(const DefectStudy& study);

}  // namespace orbearing::app
