// The `uncertain:` block: which numbers of a case are not known for sure, and how likely they are.
//
//     uncertain:
//       input.power: {normal: {standard_deviation: 5 kW}}                        about the case's value
//       lubricant.viscosity: {normal: {relative_standard_deviation: 0.2}}        of its magnitude
//       bearing.profile.drop: {triangular: {from: 1 um, peak: 2 um, to: 4 um}, reason: grinding}
//       bearing.radial_clearance: {class: CN}                                    uniform over the range of
//       ISO 5753 gearset.dynamics.pin_error.tangential: {normal: {standard_deviation: 3 um}}    each element
//       by itself correlations: {of: [input.power, bearing.profile.drop], matrix: [[1, 0.3], [0.3, 1]]}
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Keys of the block that are no paths of inputs.
inline constexpr std::string_view kUncertain = "uncertain";
inline constexpr std::string_view kCorrelations = "correlations";

/// A number that is not known for sure. What its distribution does not have is NaN.
struct UncertainInput {
  std::string path;                 // an element of a list as "gearset.dynamics.pin_error.radial[0]"
  std::string distribution;         // normal, truncated-normal, uniform, triangular
  double value = 0.0;               // [SI] the case's own
  double mean = 0.0;                // [SI] of a normal distribution before it is cut off
  double standard_deviation = 0.0;  // [SI] the same
  double from = 0.0;                // [SI] least
  double peak = 0.0;                // [SI] likeliest of a triangle
  double to = 0.0;                  // [SI] most
  std::string si_unit;              // "1" of plain numbers
  std::string unit;                 // customary
  double units_per_si = 1.0;
  std::string written;  // as in the case: "{normal: {standard_deviation: 5 kW}}"
  std::string reason;
};

struct UncertainInputs {
  std::vector<UncertainInput> inputs;             // in the order written, elements of lists apart
  std::vector<std::vector<double>> correlations;  // [-]  (inputs, inputs)  of the normal scores
};

/// Whether the field can be uncertain: a real number, or a list of them.
bool can_be_uncertain(const Field& field);

/// Reads the block; `model` holds the bits of the models whose fields may be uncertain.
StatedUncertainty read_uncertain(const Entry& block, unsigned model, const CaseShape& shape,
                                 std::vector<Mistake>& mistakes);

/// Appends a mistake where the case has no such value or another input replaces it, where ends or three
/// standard deviations contradict the case, and where correlations belong to no distribution of joint normal
/// scores.
void check_uncertain(const ResolvedCase& resolved, std::vector<Mistake>& mistakes);

/// Distributions of a case without mistakes, all numbers in SI.
UncertainInputs uncertain_inputs(const ResolvedCase& resolved);
/// The same: {"inputs": [{"path", "distribution", "value", "mean", ...}], "correlations": [[...]]}; null for
/// quantities that a distribution does not have.
nlohmann::json uncertain_json(const ResolvedCase& resolved);

/// Warnings on uncertain inputs that do not affect the quasi-static lives of a drivetrain, which `orbearing
/// uncertainty` samples; one line each.
std::vector<std::string> uncertain_warnings(const ResolvedCase& resolved);

}  // namespace orbearing::app
