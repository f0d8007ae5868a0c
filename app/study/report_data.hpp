// report.json: all that the report's pictures need beyond the results themselves.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/case/resolved_case.hpp"
#include "app/results/manifest.hpp"

namespace orbearing::app {

/// What the page is made of, for a sweep whose rows stand in `manifest`. `every_effect`: a dynamic sweep is
/// asked what each single effect is worth, not only the chief ones. `progress`: of that on standard error.
nlohmann::ordered_json report_data(const ResolvedCase& resolved, const Manifest& manifest, bool every_effect,
                                   bool progress);

}  // namespace orbearing::app
