// Gear set and all its planet bearings as one system: what is fixed before a run, and where it begins.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "bearing/defect/scratch.hpp"
#include "bearing/motion/bore_motion.hpp"
#include "bearing/motion/model.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "coupling/system/driven_gears.hpp"
#include "gearset/dynamics/equations.hpp"

namespace orbearing::system {

/// Scratches of one bearing of one planet, both counted from 0.
struct ScratchedPlanet {
  int planet = 0;
  int bearing = 0;
  std::vector<bearing::defect::Scratch> scratches;
};

/// Data of a single bearing if planets are unlike or their tilt was computed at rest; constant in motion.
struct BearingSeat {
  double clearance_difference = 0.0;                    // [m]    beyond that of `CoupledSetup::bearing`
  Eigen::Vector2d bore_tilt = Eigen::Vector2d::Zero();  // [rad]
  bearing::ElasticRace outer_race;
  /// Offset of its pin beyond the deflection of its support, relative to the middle of a rigid planet.
  Eigen::Vector2d pin_offset = Eigen::Vector2d::Zero();  // [m]
};

/// All that is fixed before a run. Bearings of one planet see the same motion, but for their seats; their
/// first rollers are evenly spaced over one pitch, so that they are no copies of each other.
struct CoupledSetup {
  DrivenGearsSetup gears;
  DrivenBearingSetup bearing;  // of each; first_roller is that of the first bearing of a planet
  int bearings_per_planet = 2;
  /// Bearings that may take shorter steps than all others at a time; how many do is decided by what it costs.
  int most_substepped = std::numeric_limits<int>::max();  // [-]
  std::vector<ScratchedPlanet> scratched = {};            // all others are sound
  std::vector<BearingSeat> seats = {};  // (bearings of all planets) where unlike; empty: as `bearing`
};

/// Setup of one bearing of a planet, both counted from 0.
DrivenBearingSetup bearing_of_planet(const CoupledSetup& setup, int planet, int bearing);

/// Motion of the bore of a planet by that of the gear set: linear in (x, y, u) of carrier and planet, less
/// the error of its pin.
struct PlanetPort {
  Eigen::Index planet_index = 0;  // of the planet in the layout
  double planet_angle = 0.0;      // [rad]  on the carrier
  // Rows: position x and y [-], rotation of the planet relative to the carrier [1/m].
  Eigen::Matrix3d of_carrier, of_planet;
  Eigen::Vector2d pin_error;  // [m]

  /// Position and rotation.
  Eigen::Vector3d of(const Eigen::Ref<const Eigen::VectorXd>& q) const {
    return of_carrier * q.segment<3>(gearset::dynamics::SetLayout::carrier()) +
           of_planet * q.segment<3>(planet_index);
  }
  Eigen::Vector2d along(const Eigen::Ref<const Eigen::VectorXd>& q) const { return of(q).head<2>(); }
  double turn(const Eigen::Ref<const Eigen::VectorXd>& q) const { return of(q)[2]; }
};

/// All constants of a run. Bearing b belongs to planet b / per_planet.
struct CoupledModel {
  gearset::dynamics::SetModel gears;
  bearing::motion::BearingModel bearing;
  std::vector<PlanetPort> ports;  // (planets)
  int per_planet = 1;
  std::vector<bearing::motion::BearingModel> seated = {};  // (bearings) where each has its own seat
  std::vector<Eigen::Vector2d> pin_offset = {};            // [m]  (bearings) of those on seats; none: zero

  std::vector<bearing::motion::BearingModel> scratched = {};
  std::vector<int> scratched_bearing = {};  // to which of all each of these belongs

  const bearing::motion::BearingModel& bearing_of(int b) const {
    for (std::size_t i = 0; i < scratched.size(); ++i)
      if (scratched_bearing[i] == b) return scratched[i];
    return seated.empty() ? bearing : seated[static_cast<std::size_t>(b)];
  }
  int bearings() const { return static_cast<int>(ports.size()) * per_planet; }
  const PlanetPort& port_of(int b) const { return ports[static_cast<std::size_t>(b / per_planet)]; }
};

/// Throws std::invalid_argument, with what was found and what is required.
CoupledModel coupled_model(const CoupledSetup& setup);

/// Motion of the bore at `port` at `time` [s] with positions `q` [m] and velocities `v` [m/s] of the gear
/// set; without acceleration.
bearing::motion::BoreMotion bore_motion(const CoupledModel& model, const PlanetPort& port, double time,
                                        const Eigen::Ref<const Eigen::VectorXd>& q,
                                        const Eigen::Ref<const Eigen::VectorXd>& v);

/// The same of bearing `b`, whose planet moves as `planet`.
inline bearing::motion::BoreMotion at_seat(const CoupledModel& model, int b,
                                           bearing::motion::BoreMotion planet) {
  if (!model.pin_offset.empty()) planet.position -= model.pin_offset[static_cast<std::size_t>(b)];
  return planet;
}

/// A state to begin with.
struct CoupledStart {
  Eigen::VectorXd gears;                  // in the order of SetLayout
  std::vector<Eigen::VectorXd> bearings;  // in the order of StateLayout
};

/// Gears and bearings at rest in each other's forces, as a co-simulation begins: the gear set in its static
/// state under mean loads, the rollers of each bearing in equilibrium at its planet's angle.
/// @throws std::runtime_error where no equilibrium is found
CoupledStart coupled_start(const CoupledSetup& setup, const CoupledModel& model, double time);

}  // namespace orbearing::system
