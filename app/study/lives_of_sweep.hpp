// The lives of one bearing side by side, at the point of a run or at the peak of a sweep.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_run.hpp"

namespace orbearing::app {

/// As text; empty where no point has a life.
std::string lives_text_of(const ResolvedCase& resolved, const SweepOutcome& outcome);

/// As lives_record(), with `speed_rpm` of the point; null where no point has a life.
nlohmann::ordered_json lives_record_of(const ResolvedCase& resolved, const SweepOutcome& outcome);

}  // namespace orbearing::app
