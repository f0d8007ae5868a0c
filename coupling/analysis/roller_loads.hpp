// Loads of the rollers of a planet bearing by position, which drawings of a bearing show.
#pragma once

#include <vector>

#include "coupling/analysis/multi_stage.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// Roller loads of one bearing of a set at its operating point, quasi-static.
struct RollerLoads {
  NamedSet set;  // without a name in a case of one set
  PointResult point;
};

/// The most loaded roller is that of the inner race; what is along it there is of a bearing cut into laminae
/// alone.
void describe(described::Record& row, const RollerLoads& loads);

/// Roller loads of all sets with bearings. Throws std::runtime_error where a bearing has no equilibrium.
std::vector<RollerLoads> roller_loads(std::vector<NamedSet> sets);

/// `roller_loads: [{set, angle_deg, inner_load_N, outer_load_N, along_mm, inner_pressure_MPa,
/// outer_pressure_MPa}]`.
void describe(described::Record& record, const std::vector<RollerLoads>& sets);

}  // namespace orbearing::analysis
