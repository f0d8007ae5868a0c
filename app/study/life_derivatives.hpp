// Derivatives of the life of a case at rest by every number of the case. From the case to the numbers behind
// the balance an explicit map of closed forms leads: its slopes come by extrapolated differences, with an
// estimate of their error. From there on all is differentiated forward (differentiated_life.hpp).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// A slope of ln of the life by an offset of a number over its scale [-].
struct NumberSlope {
  double value = 0.0;
  double error = 0.0;  // estimated
  int side = 0;        // +1 or -1: to that side alone, where the other one is no case; 0: both
};

using NumbersOf = std::function<Eigen::VectorXd(double)>;  // the explicit map, of an offset
using SlopeBy =
    std::function<double(const Eigen::VectorXd&)>;  // of ln of the life by a change of the numbers

/// By a number of the size `scale`, where the map is `here`; else why there is none: a kink, a map that is
/// not smooth, or one that throws to both sides.
std::variant<NumberSlope, std::string> slope_by_number(const NumbersOf& numbers, const SlopeBy& of_life,
                                                       const Eigen::VectorXd& here, double scale);

/// By one number of the case. [life] is the unit of the life, [unit] the number's customary one.
struct LifeDerivative {
  std::string path;                  // of an element of a list with its index: "bearing.axial_places[0]"
  double value = 0.0;                // [unit]
  std::string unit;                  // "1" of a plain number
  std::string standing;              // given, assumed or default
  double derivative = 0.0;           // [life/unit]
  std::optional<double> elasticity;  // [-]  d ln(life)/d ln(value); none where the value is zero
  std::string step;                  // "1 um", "1 %": a change whose effect is stated
  double change = 0.0;               // [life]  by that step, to first order
  int side = 0;                      // as in NumberSlope
};

/// What a number or choice has in place of a derivative.
struct NoDerivative {
  std::string path;
  std::string given;
  std::string reason;
};

struct LifeDerivatives {
  std::string quantity;                // "life_h" or "L10r_Mrev"
  std::string unit;                    // "h" or "Mrev"
  double life = 0.0;                   // [unit]
  std::string of_set;                  // of several sets, the one whose bearings live shortest; else empty
  std::vector<LifeDerivative> inputs;  // the largest elasticity first
  std::vector<NoDerivative> not_differentiable;  // used by the life
  std::vector<std::string> without_effect;       // the life does not follow them
};

/// At the case's operating point, by the inputs at `paths`, or by all where there are none. Throws BadInput
/// where the case has no life at rest, ComputationFailed where there is no balance.
LifeDerivatives life_derivatives(const ResolvedCase& resolved, const std::vector<std::string>& paths = {});

}  // namespace orbearing::app
