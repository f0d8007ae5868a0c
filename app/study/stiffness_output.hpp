// The stiffness of a bearing as JSON, text, rows, content of a result file, and as a table that ROSS reads.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/results/point_content.hpp"
#include "app/study/stiffness_study.hpp"

namespace orbearing::app {

/// Five rows of five.
nlohmann::ordered_json stiffness_json(const bearing::equilibrium::RingStiffness& stiffness);

/// points: speed_rpm, load, stiffness (5 x 5), displacement; null where there is no balance.
nlohmann::ordered_json stiffness_json(const StiffnessStudy& study);
std::string stiffness_text(const StiffnessStudy& study);
std::string stiffness_csv(const StiffnessStudy& study);
PointContent stiffness_content(const StiffnessStudy& study);

/// The points of one series as a worksheet (BIFF 4, .xls) with the columns that ROSS's
/// BearingElement.from_table reads: kxx, kxy, kyx, kyy [N/m], damping 0 [N s/m] and frequency [rad/s], the
/// speed, rising. A single point stands there twice, at two speeds. ROSS takes nothing of the axis and of
/// tilts.
std::string ross_table(const StiffnessStudy& study, std::size_t series);

}  // namespace orbearing::app
