// A crowning study as a result.
#pragma once

#include "app/study/crown/crown_study.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// `points`, `optimum`, `straight` and what stands beside them; nothing where a point failed.
void describe(described::Record& record, const CrownStudy& study);

}  // namespace orbearing::app
