// One bearing under a static load: displacement, contact loads and standard lives.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/study/static_result.hpp"

namespace orbearing::app {

/// Whether a case is that of one bearing under a static load.
bool is_static_bearing(const ResolvedCase& resolved);

/// Throws ComputationFailed where no balance is found, BadInput for another model.
StaticStudy static_study(const ResolvedCase& resolved);

}  // namespace orbearing::app
