// A planet on rollers or balls as nonlinear springs in space, as an engineer would write it from the geometry
// without the program: each element has a point, a normal of the outer race and one of the inner race as
// vectors, the planet is a rigid body whose points move by translation and a small rotation. The position of
// an element between its races is found by bisection, that of the planet by Newton's method on differences
// with an elimination of its own. Slow and plain. It includes nothing of the library.
#pragma once

#include <array>
#include <vector>

namespace orbearing::reference {

using Space = std::array<double, 3>;

/// One element between both races.
struct InclinedSpring {
  Space at{};              // [m]  centre of the element, from the middle of the planet on the pin's axis
  Space outer_normal{};    // [-]  from the element to the outer race
  Space inner_normal{};    // [-]  of the inner race, pointing the same way: towards the element
  double mounted = 0.0;    // [m]  approach along the outer normal without displacement
  double stiffness = 0.0;  // [N/m^exponent]  of either contact
  double exponent = 10.0 / 9.0;
  double outward_inertia = 0.0;  // [N]  along the radius
};

struct SpringLoads {
  std::vector<double> inner, outer;  // [N]
  std::array<double, 5> place{};     // [m], [rad]  displacement, then rotations about x and y
  double residual = 0.0;             // [N]  largest of the forces left, moments over 1 m
};

/// Equilibrium of a planet under `force` [N] and `moment` [N m] (about x and y).
SpringLoads springs_in_balance(const std::vector<InclinedSpring>& springs, const Space& force,
                               const std::array<double, 2>& moment, bool tilts);

}  // namespace orbearing::reference
