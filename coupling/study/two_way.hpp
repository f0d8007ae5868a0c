// Gears and all planet bearings that act on each other, run until their means stand still and then observed.
#pragma once

#include <vector>

#include "coupling/cosim/coupled_motion.hpp"
#include "coupling/integration/steady_state.hpp"

namespace orbearing::study {

/// Means of all bearings of a set.
struct TwoWayMeans {
  integration::SteadyStateResult
      pooled;  // loads of all bearings as if they were passages of one; series of the first
  std::vector<bearing::dynamics::WindowStatistics> bearings;  // (planets x bearings per planet)
  double duration = 0.0;  // [s]  from the start to the end of what was observed
};

/// Loads of several bearings as if all were passages of one: means over the bearings, the largest load of
/// all.
bearing::dynamics::WindowStatistics pooled(const std::vector<bearing::dynamics::WindowStatistics>& bearings);

/// Runs `motion` in windows of one kinematic cage revolution until the pooled loads stand still, then
/// observes `options.observed_windows` of them. @throws std::runtime_error where the motion cannot be
/// followed
TwoWayMeans run_two_way(cosim::CoupledMotion& motion, double kinematic_cage_speed, double kinematic_spin,
                        const integration::SteadyStateOptions& options);

/// Time [s] between two samples of such a run: to multiples of it the motion is advanced.
double sample_interval(double kinematic_cage_speed, const integration::SteadyStateOptions& options);

}  // namespace orbearing::study
