// The setup of a driven bearing, described for FMUs.
#pragma once

#include "coupling/fmu/number_table.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "coupling/system/steady_state.hpp"
#include "mechanics/described.hpp"

namespace orbearing::fmu {

/// A bearing and the speeds at which an FMU of it starts.
struct BearingModel {
  cosim::DrivenBearingSetup setup;
  double planet_speed = 0.0;   // [rad/s]  of the bore relative to the carrier
  double carrier_speed = 0.0;  // [rad/s]
};

/// All that a bearing's future depends on beside its inputs, in a fixed order.
template <class Visitor>
void describe(Visitor& visit, BearingModel& m) {
  using namespace described;
  cosim::DrivenBearingSetup& setup = m.setup;
  const Details angle{.dimension = dimension::angle, .fmu = InFmu::parameter};
  members(
      visit, setup, part(setup.bearing), part(setup.dynamics),
      internal(setup.orbit_radius, "gearset.centre_distance", "from the carrier's axis to the pin's",
               {.dimension = dimension::length, .range = {.least = 0.0}, .fmu = InFmu::parameter}),
      internal(setup.first_roller, "first_roller", "place of the first roller at the start", angle),
      together(
          internal(setup.bore_tilt.x(), "bearing.misalignment.x",
                   "tilt of the bore's axis against the pin's: outward at the bearing's positive end; felt "
                   "by laminae",
                   angle),
          internal(setup.bore_tilt.y(), "bearing.misalignment.y", "the same in the sense of carrier rotation",
                   angle)),
      cosim::lambda_row(setup.lambda), system::length_error_row(setup.allowed_length_error),
      internal(setup.places, "simulation.places"), internal(setup.most_steps, "simulation.most_steps"));
  members(visit, m, apart(m.setup), internal(m.planet_speed, "operation.planet_speed"),
          internal(m.carrier_speed, "operation.carrier_speed"));
}

NumberTable numbers_of(const BearingModel& model);

/// Throws std::invalid_argument where a number is missing or makes no sense.
BearingModel bearing_from(const NumberTable& numbers);

}  // namespace orbearing::fmu
