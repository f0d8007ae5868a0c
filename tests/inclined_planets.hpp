// Planets on inclined rows: their forces have an energy.
#pragma once

#include <gtest/gtest.h>

#include "bearing/equilibrium/inclined_rows.hpp"

namespace orbearing::test {

/// The stiffness at `at` is the slope of the forces, by central differences over 1 nm within 1e-4 of its
/// size; and it is symmetric to round-off, so that the forces have an energy.
inline void expect_slopes_of_energy(const bearing::InclinedPlanet& planet,
                                    const bearing::InclinedPlanet::Position& at) {
  const mechanics::Imbalance<5> forces = planet.forces(at, 0.1);
  constexpr double step = 1e-9, round_off = 1e-12;
  EXPECT_LE((forces.stiffness - forces.stiffness.transpose()).norm(), round_off * forces.stiffness.norm());
  for (int i = 0; i < 5; ++i) {
    bearing::InclinedPlanet::Position ahead = at, behind = at;
    ahead[i] += step;
    behind[i] -= step;
    const Eigen::Vector<double, 5> column =
        (planet.forces(behind, 0.1).force - planet.forces(ahead, 0.1).force) / (2.0 * step);
    EXPECT_LE((forces.stiffness.col(i) - column).norm(), 1e-4 * forces.stiffness.norm()) << i;
  }
}

}  // namespace orbearing::test
