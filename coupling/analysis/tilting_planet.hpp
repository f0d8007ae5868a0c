// A planet with a computed tilt: all its bearings, each at its position on a pin that bends, and both meshes.
#pragma once

#include "bearing/equilibrium/planet_on_pin.hpp"
#include "coupling/analysis/drivetrain.hpp"

namespace orbearing::analysis {

/// Positions of the bearings of a planet along its axis, from the middle of the face. [m]
std::vector<double> axial_positions(const PlanetaryDrivetrain& drivetrain);

/// The pin: as stated, or of the length required by the face and usual walls: supported in the middles of
/// both walls, each a quarter of the face thick, or clamped where the face ends.
bearing::PinBeam planet_pin(const PlanetaryDrivetrain& drivetrain);

/// Contribution of the carrier's twist to the compliance of all pins along y, in the order of
/// pin_compliance(). The wall at the positive end passes its part of all N planets' load through the body of
/// the carrier to the other wall, of stiffness k: a force on it displaces it by N a^2/k, a the centre
/// distance. Empty where the walls are rigid to each other.
Eigen::MatrixXd carrier_twist_compliance(const PlanetaryDrivetrain& drivetrain);

/// Stiffness of both meshes against tilts of the planet's axis, along x and y: each mean stiffness k spread
/// over the face b gives k b^2/12 about the middle, in its line of action. [N m/rad]. The axial forces of
/// helical teeth are held by the torques, whatever the tilt, and give no stiffness.
Eigen::Matrix2d mesh_tilt_stiffness(const PlanetaryDrivetrain& drivetrain);

/// Seat of a planet, independent of its load, its speed, and the clearance and profiles of its bearings:
/// derived once, used from any thread.
struct PlanetSeat {
  std::vector<double> positions;              // [m]  (bearings)
  std::vector<double> clearance_differences;  // [m]  (bearings)  beyond the clearance that a bearing has
  Eigen::MatrixXd pin_compliance;             // bearing::pin_compliance() at these positions
  Eigen::MatrixXd tangential_compliance;      // the same with carrier_twist_compliance(); empty: rigid walls
  Eigen::Vector2d pin_inclination;            // [rad]  of the unloaded pin: outward, ahead
  Eigen::Matrix2d tilt_stiffness;             // [N m/rad]  of both meshes
};

/// Throws std::invalid_argument where the gears have no meshes.
PlanetSeat planet_seat(const PlanetaryDrivetrain& drivetrain);

/// The same for one of planets that carry unlike loads. The walls of the carrier twist against each other by
/// what all planets press: by the mean planet, so that each planet finds its pin inclined by that twist.
/// @throws std::runtime_error if the mean planet has no equilibrium
PlanetSeat unlike_planet_seat(const PlanetaryDrivetrain& drivetrain, const BearingDuty& mean);

/// The seat of each planet of the drivetrain, whether they carry alike or not.
PlanetSeat seat_of_each(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry);

/// The planet on its seat, all its bearings like `bearing` but for their clearances.
bearing::laminae::PlanetOnPin planet_on(const PlanetSeat& seat, const bearing::Bearing& bearing);

/// Balance of one planet over a roller pitch: one result for each bearing. `point` is that of one bearing of
/// a planet whose bearings carry alike; axial forces of helical teeth and the two gears of a stepped planet
/// lean it outward and ahead by `moment` [N m]. Laminae are needed.
/// @throws std::runtime_error if the planet has no equilibrium
bearing::laminae::PlanetOnPinResult tilting_planet(const bearing::laminae::PlanetOnPin& planet,
                                                   const bearing::OperatingPoint& point,
                                                   const Eigen::Vector2d& moment,
                                                   const bearing::QuasiStaticOptions& options,
                                                   const bearing::laminae::PlanetOnPinResult* near = nullptr);

/// The same of a drivetrain at one duty.
bearing::laminae::PlanetOnPinResult tilting_planet(const PlanetSeat& seat,
                                                   const PlanetaryDrivetrain& drivetrain,
                                                   const BearingDuty& duty);

/// One bearing of a planet that found its tilt at rest, as it goes on in motion: load, tilt and clearance
/// stay what they are at rest; on an elastic planet so does what the other bearings press beyond this one.
struct SeatedBearing {
  PlanetaryDrivetrain drivetrain;  // with its own clearance
  DrivetrainGeometry geometry;
  BearingDuty duty;  // its part of the planet's load, the tilt of its bore
  /// Offset of its pin beyond the deflection of the support under this load, relative to the pin of a planet
  /// whose bearings share its load evenly. It keeps the loads at rest where all bearings follow one planet.
  /// [m]
  Eigen::Vector2d pin_offset = Eigen::Vector2d::Zero();
};

/// All bearings of a planet, from its equilibrium at rest on `seat`.
std::vector<SeatedBearing> seated_bearings(const PlanetSeat& seat, const PlanetaryDrivetrain& drivetrain,
                                           const DrivetrainGeometry& geometry, const BearingDuty& duty);

}  // namespace orbearing::analysis
