// Further results of a single point besides its lives: skid risk by the rule of minimum load and, in motion,
// slip and the power loss by cause.
#pragma once

#include <optional>
#include <string>

#include "app/results/record_writers.hpp"
#include "coupling/analysis/operating_point.hpp"

namespace orbearing::app {

/// Minimum load P/C of a case without a spectrum: makers' rule of thumb for roller bearings [SKFMinimumLoad].
inline constexpr double kMinimumLoad = 0.02;  // [-]

/// Whether rolling elements may skid and smear.
struct SkidRisk {
  double load_ratio = 0.0;             // [-]  P/C of the bearing with the least one
  double minimum_load = kMinimumLoad;  // [-]
  bool present() const { return load_ratio < minimum_load; }
};

/// Skid risk of the point's bearing, of several sets of the least loaded one; none where a load is not known.
std::optional<SkidRisk> skid_risk_of(const analysis::PointNumbers& point, double minimum_load = kMinimumLoad);

void describe(described::Record& record, const SkidRisk& risk);

/// Lines for terminals: slip of cage and rollers, power loss by cause (of a single set, where the row has
/// them), skid risk. Empty of a point that failed.
std::string motion_summary_text(const analysis::PointRow& point, const std::optional<SkidRisk>& risk);

}  // namespace orbearing::app
