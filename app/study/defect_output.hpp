// The vibration of a bearing with scratches as JSON, as text, as content of files.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/results/point_content.hpp"
#include "app/study/defect_study.hpp"

namespace orbearing::app {

/// Peaks as objects; `where` is the key of their place, "frequency_Hz" or "order".
nlohmann::ordered_json peaks_json(const std::vector<NamedPeak>& peaks, const char* where);

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
