// What an iteration works on: all that is expected of the end of a window before it is computed, in one
// vector.
#pragma once

#include <Eigen/Core>

#include "coupling/cosim/exchange.hpp"

namespace orbearing::cosim {

/// Sizes of typical values, one over which is their weight.
struct JointScales {
  JointValue translation;
  JointValue rotation;
};

/// Largest absolute values of each kind in both; 1 where all are zero. A velocity counts at least as much as
/// would move the joint a thousandth of the displacements in a window of `length` [s], so that joints at rest
/// can converge.
JointScales scales_of(const Exchange& exchange, const InterfaceValues& a, const InterfaceValues& b,
                      double length);

/// Of each joint displacement and velocity where its motion is expected, the force where that is.
Eigen::VectorXd packed(const Exchange& exchange, const InterfaceValues& values);
/// The inverse; writes into `values` what the vector holds.
void unpack(const Exchange& exchange, const Eigen::VectorXd& vector, InterfaceValues& values);
/// One over the size of each of them.
Eigen::VectorXd weights(const Exchange& exchange, const JointScales& scales);

}  // namespace orbearing::cosim
