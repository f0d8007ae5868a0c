// The vibration of a gear set one of whose planet bearings is scratched: gears and all bearings as one system, as
// two instruments see it.
//
//   carrier frame    acceleration of the damaged planet's axis relative to its pin, outward and in the sense of
//                    carrier rotation: what an instrument that turns with the carrier would show
//   housing          h = sum over planets of w(a) F_ring, w = (1 + cos a)/2, a: angle from the instrument to the
//                    planet. The ring gear takes the meshes' forces to the housing, and one that meshes near the
//                    instrument is felt most. Shape and width of w are an assumption [FengZuo2012].
#pragma once

#include <Eigen/Core>
#include <functional>

#include "bearing/defect/frequencies.hpp"
#include "coupling/integration/integration_options.hpp"
#include "coupling/study/drivetrain.hpp"
#include "coupling/system/coupled_model.hpp"

namespace orbearing::study {

/// How the gear set's vibration is sampled.
struct PlanetSampling {
  double rate = 51200.0;              // [Hz]
  double revolutions = 16.0;          // [-]  of the carrier
  double settling_revolutions = 1.0;  // [-]  of the carrier, left out before
  double run_up_from = 1.0;           // [-]  share of the speed at which sampling begins; it ends at 1
};

/// What pure rolling and the teeth give. Frequencies of the bearing are relative to the carrier.
struct PlanetFrequencies {
  double carrier = 0.0;                         // [Hz]  turns of the carrier in the housing
  double planet = 0.0;                          // [Hz]  turns of the planet relative to the carrier
  double mesh = 0.0;                            // [Hz]
  int planets = 0;                              // each passes the instrument once a turn of the carrier
  bearing::defect::PassingFrequencies bearing;  // of which `shaft` is `planet`
};

PlanetFrequencies planet_frequencies(const PlanetaryDrivetrain& drivetrain);

/// At even times, or at times at which a run-up is sampled evenly.
struct PlanetVibration {
  double rate = 0.0;              // [Hz]
  double begin = 0.0;             // [s]
  Eigen::Array2Xd acceleration;   // [m/s^2]  (outward and along, samples)
  Eigen::ArrayXd housing;         // [N]
  Eigen::ArrayXd carrier_angle;   // [rad]  (samples)
  Eigen::ArrayXd planet_angle;    // [rad]  (samples)  of the damaged planet relative to the carrier
  double largest_load = 0.0;      // [N]      of any roller of the damaged bearing at any sample
  double cage_speed = 0.0;        // [rad/s]  mean of the damaged bearing, relative to the carrier
  double planet_speed = 0.0;      // [rad/s]  mean, relative to the carrier
  integration::IntegrationReport report;
};

/// The drivetrain at its power and speed with `scratched` bearings, of which the first gives the carrier-frame
/// signal; without any, the first bearing of the first planet does. `progress` gets the share done, if any. Throws
/// std::invalid_argument for what coupled_model() refuses; a run that ends early says so in the report.
PlanetVibration sample_vibration(const PlanetaryDrivetrain& drivetrain,
                                 const std::vector<system::ScratchedPlanet>& scratched,
                                 const PlanetSampling& sampling,
                                 const std::function<void(double)>& progress = {});

}  // namespace orbearing::study
