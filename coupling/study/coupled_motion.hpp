// Gears and bearings of a drivetrain in motion together: co-simulated, or as one system.
#pragma once

#include <memory>

#include "coupling/cosim/coupled_motion.hpp"
#include "coupling/study/drivetrain.hpp"
#include "coupling/study/fidelity.hpp"

namespace orbearing::study {

/// Gears and bearings at the drivetrain's power and speed, from rest in each other's forces. `fidelity` is
/// co_simulated or monolithic; times to which the motion is advanced are multiples of `interval` [s].
/// @throws std::invalid_argument where the drivetrain has no gears that can move
std::unique_ptr<cosim::CoupledMotion> coupled_motion(const PlanetaryDrivetrain& drivetrain,
                                                     const DrivetrainGeometry& geometry, Fidelity fidelity,
                                                     double interval);

}  // namespace orbearing::study
