// What is known at the joints, and the polynomials that follow from it.
#pragma once

#include <deque>
#include <vector>

#include "coupling/cosim/polynomials.hpp"
#include "coupling/cosim/port.hpp"

namespace orbearing::cosim {

/// At one joint and instant.
struct JointValue {
  double displacement = 0.0;  // [m] or [rad]
  double velocity = 0.0;      // [m/s] or [rad/s]
  double force = 0.0;         // [N] or [N m]  sum of all givers
};

/// At one joint over a window; one half, the other is zero.
struct JointPolynomial {
  InputPolynomial displacement = {};  // [m] or [rad]
  InputPolynomial velocity = {};      // [m/s] or [rad/s]
  InputPolynomial force = {};         // [N] or [N m]
};

/// All joints at one instant.
struct InterfaceValues {
  double time = 0.0;  // [s]
  std::vector<JointValue> joints;
};

/// Accepted values at the ends of windows, the newest last.
using InterfaceHistory = std::deque<InterfaceValues>;

/// What the values at the end of `window` will be: velocities and forces by the polynomial of degree `order`
/// (0 to 2, less where the history is short) through the last ends; displacements by integrating the velocity
/// from the last one. Eqs. (3) and (4) of coupling/cosim/README.md.
InterfaceValues extrapolated(const InterfaceHistory& history, int order, const Window& window);

/// Polynomials of `joint` over `window` that end with `end`: the displacement as a cubic with both values and
/// velocities, the force as the polynomial through `end` and the last order + 1 ends. Eqs. (5) and (6). Where
/// `end` is what extrapolated() says, these are the extrapolated polynomials.
InputPolynomial motion_polynomial(const InterfaceHistory& history, std::size_t joint, const JointValue& end,
                                  const Window& window);
InputPolynomial force_polynomial(const InterfaceHistory& history, std::size_t joint, double end, int order,
                                 const Window& window);

}  // namespace orbearing::cosim
