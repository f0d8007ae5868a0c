// A planet that finds its own tilt: all its bearings, each at its place on a pin that bends, and both meshes.
#pragma once

#include "bearing/equilibrium/planet_on_pin.hpp"
#include "coupling/study/drivetrain.hpp"

namespace orbearing::study {

/// Places of the bearings of a planet along its axis, from the middle of the face. [m]
std::vector<double> axial_places(const PlanetaryDrivetrain& drivetrain);

/// The pin: as stated, or as long as the face and the usual walls ask: resting in the middles of both walls,
/// each a quarter of the face thick, or clamped where the face ends.
bearing::PinBeam planet_pin(const PlanetaryDrivetrain& drivetrain);

/// How stiffly both meshes hold the planet against tilts of its axis, along x and y: each mean stiffness k
/// spread over the face b gives k b^2/12 about the middle, in its line of action. [N m/rad]
Eigen::Matrix2d mesh_tilt_stiffness(const PlanetaryDrivetrain& drivetrain);

/// Balance of one planet over a roller pitch: one result for each bearing. Laminae are needed.
/// @throws std::runtime_error where the planet finds no balance
bearing::laminae::PlanetOnPinResult tilting_planet(const PlanetaryDrivetrain& drivetrain,
                                                   const BearingDuty& duty);

}  // namespace orbearing::study
