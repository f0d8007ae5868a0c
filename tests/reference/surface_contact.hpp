// Contact of a roller with a race over the whole plane: the reference for the strips.
//
// Least complementary energy over pressures p >= 0 on all rectangles, by conjugate gradients whose set of
// loaded elements follows the pressure, after [PolonskyKeer1999]; here preconditioned by the elements' own
// influence, since their lengths differ, and with displacements as means over the elements, so that the
// matrix is symmetric.
#pragma once

#include "bearing/pressure/contact.hpp"

namespace orbearing::bearing::half_space {

/// Grid and end of the iteration.
struct SurfaceSettings {
  int elements = 64;      // [-]  along the roller
  double grading = 0.92;  // [-]  see graded_grid
  double reach = 0.0;     // [m]  of the grid across, from the middle; 0: by the strips' widths
  int rows = 24;          // [-]  from the middle outwards, over the reach
  double tolerance =
      1e-8;  // [-]  rms distance of the loaded surfaces, and overlap of unloaded ones, over the
             //      greatest displacement
  int most_iterations = 2000;
};

/// Solution under `load` [N] > 0 at `tilt` [rad]. Throws std::runtime_error where the iteration does not end.
RollerContactMap contact_map(const HalfSpaceContact& contact, const Relief& relief, double load, double tilt,
                             const SurfaceSettings& settings = {});

/// Solution at `approach` [m] and `tilt` [rad]. Throws std::runtime_error also where the bodies do not meet.
RollerContactMap contact_map_at(const HalfSpaceContact& contact, const Relief& relief, double approach,
                                double tilt, const SurfaceSettings& settings = {});

}  // namespace orbearing::bearing::half_space
