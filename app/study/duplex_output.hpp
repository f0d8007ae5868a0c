// Modes and identification of a duplex pair as JSON, as text, as content of files.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/results/point_content.hpp"
#include "app/study/duplex_study.hpp"

namespace orbearing::app {

/// modes: [{frequency_Hz, kind, multiplicity, shape, energy_share}], five rows; the other stiffness beside.
nlohmann::ordered_json pair_modes_json(const PairPoint& point);
std::string pair_modes_text(const PairPoint& point);
/// over_speed: [{speed_rpm, status, tilt_x_Hz, ..., inner_angle_deg, ...}], null where there is no balance;
/// the same as text and as a table. Empty without speeds.
nlohmann::ordered_json pair_speeds_json(const std::vector<PairAtSpeed>& points);
std::string pair_speeds_text(const std::vector<PairAtSpeed>& points);
std::string pair_speeds_csv(const std::vector<PairAtSpeed>& points);

/// The same with the balance under preload, the identification and its predictions.
nlohmann::ordered_json duplex_json(const DuplexStudy& study);
std::string duplex_text(const DuplexStudy& study);

/// Modes, balls, frequency response, measured and predicted frequencies.
PointContent duplex_content(const DuplexStudy& study);

/// Measured and predicted frequencies, one row each; a head alone without measured ones.
std::string predictions_csv(const DuplexStudy& study);

}  // namespace orbearing::app
