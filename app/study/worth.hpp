// The life curve of a case in a few numbers, and what other readings of its assumptions do to them.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/study/expected_file.hpp"

namespace orbearing::app {

/// The case with settings such as "pair.teeth=[30, 20]". Throws BadInput.
ResolvedCase with_settings(const ResolvedCase& resolved, const std::vector<std::string>& settings);

/// Life and loads over the speeds of a case's sweep by the quasi-static model. Arrays are over speeds.
struct LifeCurve {
  std::vector<double> speed_rpm;
  std::vector<double> life_h;
  std::vector<double> roller_load_rms;  // [N]  on the outer race
};

/// Curve of `resolved` over its axis of input.speed; over its one speed where it has none. Points that fail
/// are left out. Throws ComputationFailed where none is left.
LifeCurve life_curve(const ResolvedCase& resolved);

/// A named property of a curve, such as "peak_life_h"; NaN for a name that is not known.
double property(const LifeCurve& curve, const std::string& quantity);

/// What one alternative does to the peak.
struct Worth {
  Alternative alternative;
  LifeCurve curve;
  double peak_speed_rpm = 0.0;
  double peak_life_h = 0.0;
  double worth_h = 0.0;  // [h]  peak life with the alternative less that of the case as it stands
};

std::vector<Worth> worth_of(const ResolvedCase& resolved, const LifeCurve& base,
                            const std::vector<Alternative>& alternatives);

}  // namespace orbearing::app
