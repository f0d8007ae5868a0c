// The vibration of a gear set one of whose planet bearings is scratched: gears and all bearings as one
// system, as two instruments see it.
//
//   carrier frame    acceleration of the damaged planet's axis relative to its pin, outward and in the sense
//   of
//                    carrier rotation: what an instrument that turns with the carrier would show
//   housing          h = sum over planets of w(a) F_ring, w = (1 + cos a)/2, a: angle from the instrument to
//   the
//                    planet. The ring gear takes the meshes' forces to the housing, and one that meshes near
//                    the instrument is most sensitive. Shape and width of w are an assumption [FengZuo2012].
#pragma once

#include <Eigen/Core>
#include <functional>

#include "bearing/defect/scratched_bearing.hpp"
#include "coupling/analysis/drivetrain.hpp"
#include "coupling/analysis/signal_rows.hpp"
#include "coupling/diagnosis/planet_frequencies.hpp"
#include "coupling/integration/integration_options.hpp"
#include "coupling/system/coupled_model.hpp"
#include "mechanics/described.hpp"

namespace orbearing::analysis {

/// Sampling of the gear set's vibration.
struct PlanetSampling {
  double rate = 51200.0;              // [Hz]
  double revolutions = 16.0;          // [-]  of the carrier
  double settling_revolutions = 1.0;  // [-]  of the carrier, left out before
  double run_up_from = 1.0;           // [-]  share of the speed at which sampling begins; it ends at 1
};

template <class Visitor>
void describe(Visitor& visit, PlanetSampling& m) {
  using namespace described;
  members(visit, m, sampling_rate_row(m.rate),
          input(m.revolutions, "signal.carrier_revolutions",
                "sampled revolutions of the carrier; frequency resolution: its speed divided by this number",
                {.range = positive(1e4),
                 .reason = "side bands of the carrier sixteen lines apart",
                 .numerical = true}),
          input(m.settling_revolutions, "signal.carrier_settling",
                "revolutions of the carrier before sampling, in which the start transient decays",
                {.range = {0.0, 1e4}, .reason = "some turns of planets and cages", .numerical = true}),
          run_up_row(m.run_up_from));
}

/// A second scratched part of a planet bearing, which has rollers.
enum class SecondScratched { none, outer, inner, roller };

constexpr described::Names<SecondScratched, 4> names_of(SecondScratched) {
  return {{{SecondScratched::outer, "outer"},
           {SecondScratched::inner, "inner"},
           {SecondScratched::roller, "roller"},
           {SecondScratched::none, "none"}}};
}

/// Part with such a scratch.
constexpr bearing::defect::Scratched scratched_part(SecondScratched part) {
  using bearing::defect::Scratched;
  switch (part) {
    case SecondScratched::outer:
      return Scratched::outer;
    case SecondScratched::inner:
      return Scratched::inner;
    case SecondScratched::roller:
      return Scratched::roller;
    case SecondScratched::none:
      break;
  }
  return Scratched::none;
}

/// Which bearing is scratched, and what of it besides.
struct ScratchedPosition {
  int planet = 1;   // from 1
  int bearing = 1;  // of the planet, from 1
  SecondScratched also = SecondScratched::none;
  double also_angle = 0.0;  // [rad]
};

template <class Visitor>
void describe(Visitor& visit, ScratchedPosition& m) {
  using namespace described;
  constexpr Where scratched{"defect.race", "outer|inner|roller"};
  members(visit, m,
          input(m.planet, "defect.planet", "number of the planet with the scratched bearing",
                {.range = {1, 100}, .reason = "the first one", .where = scratched}),
          input(m.bearing, "defect.bearing", "number of the scratched bearing of that planet",
                {.range = {1, 8}, .reason = "the first one", .where = scratched}),
          input(m.also, "defect.also", "further part with a scratch like that of defect.race",
                {.reason = "one scratch", .where = scratched}),
          input(m.also_angle, "defect.also_angle", "angle of that scratch, as defect.angle",
                {.dimension = dimension::angle,
                 .range = {-360.0, 360.0},
                 .reason = "in the middle of the load zone",
                 .where = {"defect.also", "outer|inner|roller"}}));
}

using diagnosis::PlanetFrequencies;

PlanetFrequencies planet_frequencies(const PlanetaryDrivetrain& drivetrain);

/// Load of the gears on the bore of one bearing [N], whose rollers meet it on the other side of the pin: of
/// planets whose tilt is computed its own at rest, else the mean of all. Planet and bearing from 0.
Eigen::Vector2d load_on_bearing(const PlanetaryDrivetrain& drivetrain, int planet, int bearing);

/// At even times.
struct PlanetVibration {
  double rate = 0.0;             // [Hz]
  double begin = 0.0;            // [s]
  Eigen::Array2Xd acceleration;  // [m/s^2]  (outward and along, samples)
  Eigen::ArrayXd housing;        // [N]
  Eigen::ArrayXd carrier_angle;  // [rad]  (samples)
  Eigen::ArrayXd planet_angle;   // [rad]  (samples)  of the damaged planet relative to the carrier
  double largest_load = 0.0;     // [N]      of any roller of the damaged bearing at any sample
  double cage_speed = 0.0;       // [rad/s]  mean of the damaged bearing, relative to the carrier
  double planet_speed = 0.0;     // [rad/s]  mean, relative to the carrier
  double roller_speed = 0.0;     // [rad/s]  mean rotation of its scratched roller, or of the first, likewise
  integration::IntegrationReport report;
};

/// The drivetrain at its power and speed with `scratched` bearings, of which the first gives the
/// carrier-frame signal; without any, the first bearing of the first planet does. `progress` gets the share
/// done, if any. Throws std::invalid_argument for what coupled_model() refuses; a run that ends early states
/// it in the report.
PlanetVibration sample_vibration(const PlanetaryDrivetrain& drivetrain,
                                 const std::vector<system::ScratchedPlanet>& scratched,
                                 const PlanetSampling& sampling,
                                 const std::function<void(double)>& progress = {});

/// Frequencies of the bearing as its cage and rollers turned in that motion; in a run-up, which passes all
/// speeds at the same ratios, at the mean speed.
PlanetFrequencies as_turned(const PlanetFrequencies& rolling, const PlanetVibration& motion, int rollers,
                            bool run_up);

}  // namespace orbearing::analysis
