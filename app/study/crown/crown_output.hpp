// A crowning study as JSON, as a table, as a file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/results/point_file.hpp"
#include "app/study/crown/crown_study.hpp"

namespace orbearing::app {

/// `points`, `optimum`, `straight` and what stands beside them; null where a point failed.
nlohmann::ordered_json crown_json(const CrownStudy& study);

/// What a person reads.
std::string crown_text(const CrownStudy& study);

/// Life, pressure and edge ratio over profile, drop and tilt.
PointContent crown_content(const CrownStudy& study);

}  // namespace orbearing::app
