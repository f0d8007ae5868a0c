// What the planet bearings carry over a revolution of the carrier, which its own bearings hold in the
// housing: gravity turns once a revolution in its frame, and clearance lets it sag and tilt.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/study/drivetrain.hpp"
#include "gearset/dynamics/model.hpp"
#include "gearset/spatial/spatial_balance.hpp"

namespace orbearing::described {
class Record;
}

namespace orbearing::study {

/// How finely a revolution is computed.
struct RevolutionOptions {
  int angles = 72;  // of the carrier
  int slices = 40;  // of the face width
};

/// One bearing of one planet over the revolution.
struct BearingOverRevolution {
  int planet = 0;
  double position = 0.0;          // [m]  axial, from the middle of the face
  double least = 0.0;             // [N]
  double mean = 0.0;              // [N]
  double largest = 0.0;           // [N]
  double equivalent_load = 0.0;   // [N]  mean with the exponent of roller bearings, 10/3
  double basic_life_hours = 0.0;  // [h]  L10h under it
};

/// One bearing of the carrier.
struct CarrierBearingOverRevolution {
  double position = 0.0;  // [m]
  double least = 0.0;     // [N]  radial
  double largest = 0.0;   // [N]
};

struct CarrierRevolution {
  double expected_load = 0.0;  // [N]  torque / (planets, bearings of a planet, centre distance)
  std::vector<BearingOverRevolution> bearings;  // planet by planet
  std::vector<CarrierBearingOverRevolution> carrier_bearings;
  double mesh_load_factor = 0.0;  // [-]  K_gamma: largest mesh force of a planet over the mean of all
  double sun_face_load = 0.0;     // [-]  K_Hbeta: largest load per width over its mean, of all planets
  double ring_face_load = 0.0;    // [-]
  double carrier_shift = 0.0;     // [m]    largest, radial, at the middle of the face
  double carrier_tilt = 0.0;      // [rad]  largest
  Eigen::ArrayXd angle;           // [rad]  of the carrier
  Eigen::ArrayXXd load;           // [N]    (angles, bearings)

  /// Largest load of one bearing over the expected one.
  double largest_share() const;
  /// The bearing with the shortest life.
  const BearingOverRevolution& worst() const;
};

void describe(described::Record& record, const CarrierRevolution& revolution);

/// The set in three dimensions as case and derived model have it. Springs of the planet bearings are linear
/// about their mean load and spread along the rollers; meshes have their mean stiffness, spread evenly over
/// the face width.
/// @throws std::invalid_argument where lists of `mounting` do not fit together
gearset::spatial::SpatialSet spatial_set(const PlanetaryDrivetrain& drivetrain,
                                         const gearset::dynamics::SetModel& model, double base_helix_angle,
                                         const gearset::spatial::CarrierMounting& mounting);
gearset::spatial::SpatialLoad spatial_load(const gearset::dynamics::SetModel& model,
                                           const gearset::spatial::CarrierMounting& mounting);

/// @param dynamic_capacity [N] C of one planet bearing
/// @param speed [rad/s] of the planet on its pin
/// @throws std::runtime_error where no balance is found
CarrierRevolution carrier_revolution(const gearset::spatial::SpatialSet& set,
                                     const gearset::spatial::SpatialLoad& load, double dynamic_capacity,
                                     double speed, const RevolutionOptions& options = {});

}  // namespace orbearing::study
