// What assumptions are worth in the motion in time: life at a few speeds by a fidelity that expected.yaml
// names, under each other reading that only motion feels.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/study/expected_file.hpp"
#include "coupling/study/operating_point.hpp"

namespace orbearing::app {

/// Life of one bearing over the plan's speeds under one reading. Arrays are over speeds.
struct MotionCurve {
  Alternative alternative;          // no settings: the case as it stands
  std::vector<double> life_h;       // [h]  NaN where the point failed
  std::vector<std::string> status;  // "ok" or why it failed
};

/// All curves of a case, the case as it stands first.
struct MotionWorth {
  std::string case_name;
  std::string fidelity;
  std::vector<double> speed_rpm;
  std::vector<MotionCurve> curves;
};

/// Computes a point of a case; `study::evaluate` for all but tests.
using EvaluateMotion = std::function<study::PointResult(const ResolvedCase& at_speed, study::Fidelity)>;
study::PointResult evaluated_motion(const ResolvedCase& at_speed, study::Fidelity fidelity);

/// Computes all curves on `jobs` threads (0: one for each core), curve after curve; each is told when it is
/// done. Throws BadInput where a setting or speed is not one of the case.
MotionWorth motion_worth(const ResolvedCase& resolved, const MotionPlan& plan, int jobs,
                         const EvaluateMotion& evaluate,
                         const std::function<void(const MotionWorth& so_far)>& done);

/// Index of the speed of the longest life; points that failed do not count.
std::size_t best_speed(const MotionCurve& curve);

/// Heading of the table, and the line of its last curve: life at each speed, the best of these speeds, and
/// what the reading is worth at the best speed of the case as it stands.
std::string motion_heading(const MotionWorth& worth);
std::string motion_line(const MotionWorth& worth);
nlohmann::ordered_json motion_json(const MotionWorth& worth);

}  // namespace orbearing::app
