// The life curve of a case in a few numbers, and the effects of other readings of its assumptions:
// quasi-static, and for those that affect motion alone at a few speeds in time.
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

/// Life curve of the unchanged case by the quasi-static model, over its axis of input.speed; over its one
/// speed where it has none.
LifeCurve life_curve(const ResolvedCase& resolved);

/// Its longest and shortest life, least load and shape.
void describe(described::Record& record, const LifeCurve& curve);
/// A number of those by its name, such as "peak_life_h"; NaN for a name that is not known.
double property(const LifeCurve& curve, const std::string& quantity);

/// Effect of one change on the peak.
struct Sensitivity {
  NamedChange change;
  LifeCurve curve;
  double peak_speed_rpm = 0.0;
  double peak_life_h = 0.0;
  double difference_h = 0.0;  // [h]  peak life under the change less that of the unchanged case
  /// Derivative by the number that is read otherwise, where it is one and the life is smooth in it, for the
  /// unchanged case at its peak. Left out until put_derivatives().
  std::optional<Derivative> derivative{};
};

/// Effects of all results but the first, which is the unchanged case.
std::vector<Sensitivity> sensitivities(const std::vector<ChangeResult>& results);

/// Adds the derivatives of `resolved`, the unchanged case, at the speed [rpm] of its peak.
void put_derivatives(const ResolvedCase& resolved, double peak_rpm, int jobs, std::vector<Sensitivity>& all);

/// The speeds and the fidelity of a plan. Throws BadInput where a speed is not one of the case.
ChangeStudy study_of(const ResolvedCase& resolved, const MotionPlan& plan, int jobs);

/// Heading of the table of a plan, and the line of one reading: life at each speed, the best of these speeds,
/// and the difference at the best speed of `reference`, the unchanged case.
std::string motion_heading(const std::string& case_name, const MotionPlan& plan);
std::string motion_line(const MotionPlan& plan, const ChangeResult& reference, const ChangeResult& result);
/// One reading of a plan as a row of a table.
void describe_reading(described::Record& row, const std::string& case_name, const MotionPlan& plan,
                      const ChangeResult& reference, const ChangeResult& result);

// Inputs of a life that the case does not state.

/// An assumed input and the effects of its other values on the lives: "oil-bath: L10mh -61 %, L10mrh -58 %".
struct AssumedEffect {
  std::string path;
  std::string text;
};

/// For a quasi-static run: inputs that the case leaves to their defaults and of which another choice, or a
/// number 10 % larger, changes a life by 1 % or more; the largest effects first. For short computing time
/// rims are rigid and tilts as stated, and there are no effects where planets carry unequal loads.
std::vector<AssumedEffect> assumed_effects(const ResolvedCase& resolved);
std::string assumed_effects_text(const ResolvedCase& resolved, const std::vector<AssumedEffect>& effects);

/// Warnings of `check`: the defaults of which a tenth more changes the quasi-static life by at least a tenth,
/// the three largest effects first, and the effect of one pin off by its tolerance where `derived` has it.
/// None for cases without a quasi-static life. Rims are rigid and tilts as stated, for short computing time.
std::vector<std::string> default_warnings(const ResolvedCase& resolved, const std::vector<Derived>& derived);

}  // namespace orbearing::app
