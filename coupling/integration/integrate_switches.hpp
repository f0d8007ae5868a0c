// Integration of equations whose form changes where functions of time and state change sign, as contacts that
// open: steps end exactly there, and within a step the form stays.
#pragma once

#include "coupling/integration/integrate.hpp"

namespace orbearing::integration {

/// Switches that change the form of the equations.
struct Switches {
  Eigen::Index count = 0;
  /// Writes a value for each switch.
  std::function<void(double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                     Eigen::Ref<Eigen::ArrayXd> values)>
      values;
  /// Called where a value has changed its sign, and for each switch at the start. The right-hand side keeps
  /// to that form until it is called again, and goes on smoothly a step beyond.
  std::function<void(Eigen::Index which, bool positive)> set;
  double largest_step = 0.0;  // [s]  short enough that no value changes its sign twice unseen; 0: any
};

/// As `integrate` with Method::dopri5.
IntegrationReport integrate_switches(const RightHandSide& derivative, Eigen::VectorXd& x,
                                     const OutputTimes& output, const Switches& switches,
                                     const IntegrationOptions& options, const Observer& observe);

}  // namespace orbearing::integration
