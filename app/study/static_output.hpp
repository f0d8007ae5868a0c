// A bearing under a static load as JSON, for terminals, and as content of a result file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/results/point_file.hpp"
#include "app/study/static_study.hpp"

namespace orbearing::app {

/// displacement, tilt_mrad, contact loads and lives; null for a life without end or without factors.
nlohmann::ordered_json static_json(const StaticStudy& study);
std::string static_text(const StaticStudy& study);

/// Loads by rolling element and lamina, displacement and lives.
PointContent static_content(const StaticStudy& study);

}  // namespace orbearing::app
