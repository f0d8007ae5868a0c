// Loads of the planet bearings over a revolution of the carrier on its own bearings in the housing: gravity
// turns once a revolution in its frame, and clearance lets it sag and tilt.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/life/rating_lives.hpp"
#include "coupling/analysis/drivetrain.hpp"
#include "gearset/dynamics/parameters.hpp"
#include "gearset/spatial/spatial_modes.hpp"

namespace orbearing::described {
class Record;
}

namespace orbearing::analysis {

/// Resolution of a revolution.
struct RevolutionOptions {
  int angles = 72;    // of the carrier; at least, so that planets at equal steps meet the same ones
  int slices = 40;    // of the face width
  int life_step = 6;  // of so many angles the rollers are computed at one
};

/// One bearing of one planet over the revolution.
struct BearingOverRevolution {
  int planet = 0;
  double position = 0.0;         // [m]  axial, from the middle of the face
  double least = 0.0;            // [N]  with cage and rollers, as PointResult::planet_load
  double mean = 0.0;             // [N]
  double largest = 0.0;          // [N]
  double largest_tilt = 0.0;     // [rad]  of the bore against the pin
  double least_film = 0.0;       // [m]    of both races; NaN: no oil is given
  double equivalent_load = 0.0;  // [N]  mean with the exponent of roller bearings, 10/3
  double static_load = 0.0;      // [N]  P_0 of [ISO76]: under the largest load
  double static_safety = 0.0;    // [-]  S_0 of it
  double largest_pressure =
      0.0;                  // [Pa]  after Hertz, where its rollers are computed and under the largest load
  double life_hours = 0.0;  // [h]  Lundberg and Palmgren, of the loads of its rollers
  bearing::rating::RatedHours rated_hours;
};

/// One bearing of the carrier.
struct CarrierBearingOverRevolution {
  double position = 0.0;  // [m]
  double least = 0.0;     // [N]  radial
  double largest = 0.0;   // [N]
};

/// One mesh of one planet.
struct MeshOverRevolution {
  int planet = 0;
  bool of_sun = true;         // else of the ring
  double mean = 0.0;          // [N]  normal force of its driving flanks
  double largest = 0.0;       // [N]
  double largest_back = 0.0;  // [N]  of its back flanks
  double face_load = 0.0;     // [-]  K_Hbeta: largest load per width over its mean at that angle
  Eigen::ArrayXd by_width;    // [N/m]  (slices)  where the load per width is largest
};

struct CarrierRevolution {
  double expected_load = 0.0;  // [N]  torque / (planets, bearings of a planet, centre distance)
  std::vector<BearingOverRevolution> bearings;  // planet by planet
  std::vector<CarrierBearingOverRevolution> carrier_bearings;
  std::vector<MeshOverRevolution> meshes;  // planet by planet, that of the sun first
  double mesh_load_factor = 0.0;  // [-]  K_gamma: largest mesh force of a planet over the mean of all
  double carrier_shift = 0.0;     // [m]    largest, radial, at the middle of the face
  double carrier_tilt = 0.0;      // [rad]  largest
  Eigen::ArrayXd angle;           // [rad]  of the carrier
  Eigen::ArrayXXd load;           // [N]    (angles, bearings)
  Eigen::ArrayXd height;          // [m]    (slices)  middles, from the middle of the face

  /// Largest load of one bearing over the expected one.
  double largest_share() const;
  /// K_Hbeta: the largest of all planets.
  double face_load(bool of_sun) const;
  /// Largest load of back flanks [N]; 0: all flanks that carry drive.
  double back_flank_load() const;
  /// The bearing with the shortest life by `hours`.
  const BearingOverRevolution& worst(
      double bearing::rating::RatedHours::*hours = &bearing::rating::RatedHours::basic) const;
  /// The bearing with the largest of `loads`: static load or pressure.
  const BearingOverRevolution& most_loaded(double BearingOverRevolution::*loads) const;
};

void describe(described::Record& record, const CarrierRevolution& revolution);

/// @throws std::invalid_argument where lists of `mounting` do not fit together
void require_sound(const gearset::spatial::CarrierMounting& mounting);

/// The set in three dimensions as drivetrain and bodies have it. Springs of the planet bearings are linear
/// about their mean load and spread along the rollers; meshes have their mean stiffness, spread evenly over
/// the face width. The drivetrain has a carrier_mounting.
gearset::spatial::SpatialSet spatial_set(const PlanetaryDrivetrain& drivetrain,
                                         const gearset::dynamics::SetParameters& bodies,
                                         double base_helix_angle);

/// The same with bodies that move. If their lengths are not known, sun, ring and planets are discs of the
/// face width, and so is the carrier; the support of the ring is uniform around its base circle.
gearset::spatial::MovingSet moving_set(const PlanetaryDrivetrain& drivetrain,
                                       const gearset::dynamics::SetParameters& bodies,
                                       double base_helix_angle);

/// Loads of a drivetrain with a carrier_mounting and a gear_set. Rollers are computed under the load and the
/// tilt of their bearing at each of some angles.
/// @throws std::runtime_error where no equilibrium is found
CarrierRevolution carrier_revolution(const PlanetaryDrivetrain& drivetrain,
                                     const DrivetrainGeometry& geometry,
                                     const RevolutionOptions& options = {});

}  // namespace orbearing::analysis
