// From a resolved case of a planetary drivetrain with a block `defect` to the scratches of one of its planet
// bearings, and what is asked of the signal.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "coupling/study/planet_scratch.hpp"

namespace orbearing::app {

/// None where nothing is scratched. Angles of the case count from the middle of the load zone, those of the result
/// from outward; those of a roller stay.
std::vector<system::ScratchedPlanet> scratched_planets_of(const ResolvedCase& resolved);

study::PlanetSampling planet_sampling_of(const ResolvedCase& resolved);

/// Unit vector (outward, in the sense of carrier rotation) from the pin's axis to the middle of the load zone: the
/// rollers that carry the planet stand there.
Eigen::Vector2d load_zone_of(const ResolvedCase& resolved);

}  // namespace orbearing::app
