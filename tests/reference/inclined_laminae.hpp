// A planet on tapered rollers cut into laminae, as an engineer would write it from the geometry without the
// program: each lamina has a point on the outer race and the normals of both races as vectors, the planet is
// a rigid body, a roller approaches along the inner normal and rotates about the point where both normals of
// its middle meet. Roots by regula falsi, one within the other; the planet by Newton's method on differences
// with an elimination of its own. Slow and plain. It includes nothing of the library.
#pragma once

#include <array>
#include <vector>

namespace orbearing::reference {

struct LaminaRoller {
  std::array<double, 3> at{};            // [m]  middle of the outer line of contact, from the planet's middle
  std::array<double, 3> along{};         // [-]  of that line, towards +z
  std::array<double, 3> outer_normal{};  // [-]  from the roller to the outer race
  double between = 1.0;                  // [-]  cosine of the angle between the normals of both races
  double mounted = 0.0;                  // [m]  approach along the outer normal without displacement
  double stiffness = 0.0;                // [N/m^exponent]  of the whole contact, the same on both races
  double exponent = 10.0 / 9.0;
  std::vector<double> places;  // [m]  of the laminae along the line
  std::vector<double> drops;   // [m]  of either contact there
  double inertia = 0.0;        // [N]  along the inner normal, outward
};

struct LaminaLoads {
  std::vector<std::vector<double>> inner, outer;  // [N]  (rollers) (laminae)
  std::array<double, 5> place{};                  // [m], [rad]  displacement, then rotations about x and y
  double residual = 0.0;                          // [N]
};

/// Equilibrium of a planet under `force` [N] and `moment` [N m] (about x and y).
LaminaLoads laminae_in_balance(const std::vector<LaminaRoller>& rollers, const std::array<double, 3>& force,
                               const std::array<double, 2>& moment);

}  // namespace orbearing::reference
