// Planets on inclined rows: their forces are those of their energy.
#pragma once

#include <gtest/gtest.h>

#include "bearing/equilibrium/inclined_rows.hpp"

namespace orbearing::test {

/// Forces and stiffness at `at` are slopes of energy and forces, by central differences over 1 nm; the forces
/// within `tolerance` of their size, the stiffness within 1e-4.
inline void expect_slopes_of_energy(const bearing::InclinedPlanet& planet,
                                    const bearing::InclinedPlanet::Position& at, double tolerance) {
  const mechanics::Imbalance<5> forces = planet.forces(at, 0.1);
  constexpr double step = 1e-9;
  for (int i = 0; i < 5; ++i) {
    bearing::InclinedPlanet::Position ahead = at, behind = at;
    ahead[i] += step;
    behind[i] -= step;
    const double slope =
        (planet.stored_energy(ahead, 0.1) - planet.stored_energy(behind, 0.1)) / (2.0 * step);
    EXPECT_NEAR(forces.force[i], -slope, tolerance * forces.force.norm()) << i;
    const Eigen::Vector<double, 5> column =
        (planet.forces(behind, 0.1).force - planet.forces(ahead, 0.1).force) / (2.0 * step);
    EXPECT_LE((forces.stiffness.col(i) - column).norm(), 1e-4 * forces.stiffness.norm()) << i;
  }
}

}  // namespace orbearing::test
