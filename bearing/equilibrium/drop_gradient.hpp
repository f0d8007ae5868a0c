// How any measure of the lamina loads, a life say, follows the drops of the profiles: one adjoint solution
// for all drops at once, by the implicit function theorem.
#pragma once

#include <Eigen/Core>

#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/quasi_static.hpp"

namespace orbearing::bearing::laminae {

/// Derivatives of a measure L of the lamina loads at its equilibrium; [L] is its unit.
struct DropGradient {
  Eigen::ArrayXd
      inner;  // [L/m]  (laminae)  by the drop between roller and inner race, of all rollers at once
  Eigen::ArrayXd outer;  // [L/m]  (laminae)  by the drop between roller and outer race
};

/// From the measure's derivatives by the loads of single laminae [L/N], arrays (laminae, rollers), at the
/// equilibrium `state` of `bearing` under `point`. Laminae out of contact have no influence; where one just
/// touches, the derivative is that of its side.
DropGradient drop_gradient(const LaminaBearing& bearing, const OperatingPoint& point,
                           const QuasiStaticOptions& options, const QuasiStaticState& state,
                           const Eigen::Ref<const Eigen::ArrayXXd>& by_inner_load,
                           const Eigen::Ref<const Eigen::ArrayXXd>& by_outer_load);

/// The same for all cage angles of `result`, arrays (laminae, places).
DropGradient drop_gradient(const LaminaBearing& bearing, const OperatingPoint& point,
                           const QuasiStaticOptions& options, const QuasiStaticResult& result,
                           const Eigen::Ref<const Eigen::ArrayXXd>& by_inner_load,
                           const Eigen::Ref<const Eigen::ArrayXXd>& by_outer_load);

}  // namespace orbearing::bearing::laminae
