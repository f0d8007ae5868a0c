// From what the user states to the laws of one race, and those laws for plain numbers where no motion asks
// for them.
#pragma once

#include <vector>

#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/motion/parameters.hpp"
#include "bearing/motion/vectorised/constants.hpp"

namespace orbearing::bearing::motion {

/// One race with its laws, fixed for a run.
struct RaceModel : vectorised::RaceLaws {
  std::vector<RaceHarmonic> form;  // none: round
  std::vector<RaceScratch> scratches = {};
};

/// Laws of `race`. `point` gives the film that is subtracted where the source's printed approach is asked
/// for.
RaceModel race_model(const Bearing& bearing, const BearingGeometry& geometry, const OperatingPoint& point,
                     Race race, const DynamicsParameters& parameters);

/// |rolling| [m/s], rounded at zero over `scale` [m/s] so that film and resistance have a slope there.
double entrainment_speed(double rolling, double scale);

/// Load [N] of a straight contact at the approach [m] of its rigid bodies and the entrainment speed [m/s] >
/// 0, without damping: the elastic contact in series with its film, where that adds to the approach.
double race_load(const vectorised::RaceLaws& race, double approach, double entrainment);
/// Energy stored in a straight contact [J] at its elastic approach [m]: the work of the load from first touch
/// at constant entrainment speed.
double race_energy(const vectorised::RaceLaws& race, double elastic_approach, double entrainment);
/// d(energy)/d(entrainment speed) [J s/m] at constant approach of the rigid bodies: what a change of the film
/// does as work.
double race_energy_slope(const vectorised::RaceLaws& race, double elastic_approach, double entrainment);

}  // namespace orbearing::bearing::motion
