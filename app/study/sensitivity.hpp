// The life curve of a case in a few numbers, and what other readings of its assumptions do to them: at rest,
// and for those that affect motion alone at a few speeds in time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/study/derivatives.hpp"
#include "app/study/expected_file.hpp"
#include "app/study/named_change.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// Life and loads over speed. Arrays are over speeds.
struct LifeCurve {
  std::vector<double> speed_rpm;
  std::vector<double> life_h;
  std::vector<double> roller_load_rms;  // [N]  on the outer race
};

/// Points that failed are left out. Throws ComputationFailed where none is left.
LifeCurve life_curve(const ChangeResult& result);

/// Of the case as it stands by the quasi-static model, over its axis of input.speed; over its one speed where
/// it has none.
LifeCurve life_curve(const ResolvedCase& resolved);

/// Its longest and shortest life, least load and shape.
void describe(described::Record& record, const LifeCurve& curve);
/// A number of those by its name, such as "peak_life_h"; NaN for a name that is not known.
double property(const LifeCurve& curve, const std::string& quantity);

/// What one change does to the peak.
struct Sensitivity {
  NamedChange change;
  LifeCurve curve;
  double peak_speed_rpm = 0.0;
  double peak_life_h = 0.0;
  double difference_h = 0.0;  // [h]  peak life under the change less that of the case as it stands
  /// By the number that is read otherwise, where it is one and the life is smooth in it, of the case as it
  /// stands at its peak. Left out until put_derivatives().
  std::optional<Derivative> derivative{};
};

/// Of all results but the first, which is the case as it stands.
std::vector<Sensitivity> sensitivities(const std::vector<ChangeResult>& results);

/// Puts the derivatives of `resolved`, the case as it stands, at the speed [rpm] of its peak.
void put_derivatives(const ResolvedCase& resolved, double peak_rpm, int jobs, std::vector<Sensitivity>& all);

/// The speeds and the fidelity of a plan. Throws BadInput where a speed is not one of the case.
ChangeStudy study_of(const ResolvedCase& resolved, const MotionPlan& plan, int jobs);

/// Heading of the table of a plan, and the line of one reading: life at each speed, the best of these speeds,
/// and the difference at the best speed of `reference`, the case as it stands.
std::string motion_heading(const std::string& case_name, const MotionPlan& plan);
std::string motion_line(const MotionPlan& plan, const ChangeResult& reference, const ChangeResult& result);
/// One reading of a plan as a row of a table.
void describe_reading(described::Record& row, const std::string& case_name, const MotionPlan& plan,
                      const ChangeResult& reference, const ChangeResult& result);

// What a life hangs on that the case does not state.

/// An assumed input and what other values of it do to the lives: "oil-bath: L10mh -61 %, L10mrh -58 %".
struct AssumedEffect {
  std::string path;
  std::string text;
};

/// Of a run at rest: inputs that the case leaves to their defaults and of which another choice, or a number
/// 10 % larger, changes a life by 1 % or more; the largest effects first. Rims are taken as rigid and tilts
/// as stated, and none are given where planets carry unlike loads, which keeps it fast.
std::vector<AssumedEffect> assumed_effects(const ResolvedCase& resolved);
std::string assumed_effects_text(const ResolvedCase& resolved, const std::vector<AssumedEffect>& effects);

/// Warnings of `check`: the defaults of which a tenth more changes the life at rest by at least a tenth, the
/// three largest effects first, and what one pin off by its tolerance costs where `derived` has it. None for
/// cases without a life at rest. Rims are taken as rigid and tilts as stated, which keeps it fast.
std::vector<std::string> default_warnings(const ResolvedCase& resolved, const std::vector<Derived>& derived);

}  // namespace orbearing::app
