// Observed values of the rollers at one instant: the laws of the engines once more, without slopes and by one
// instruction set for all. No header of a library here, since a file compiled by the packs includes it.
#pragma once

#include "bearing/motion/vectorised/engine.hpp"

namespace orbearing::bearing::vectorised {

/// A roller in its contact with one race. Nothing but numbers; powers are lost, >= 0, but for the last.
template <class Number>
struct ObservedContact {
  Number approach;          // [m]    of the rigid bodies
  Number elastic_approach;  // [m]    in the middle; zero or negative where they do not touch
  Number load;              // [N]    with damping and squeeze
  Number f_r, f_t;          // [N]    on the roller, in its polar axes
  Number moment;            // [N m]  on the roller about its centre
  Number sliding;           // [m/s]  surface of the race less that of the roller
  Number entrainment;       // [m/s]  > 0
  Number damping_power;     // [W]
  Number traction_power;    // [W]
  Number rolling_power;     // [W]
  Number form_power;        // [W]    that what holds an out-of-round race takes from the turning race
};

struct ObservedRoller {
  ObservedContact<double> inner, outer;
  // Contact with the neighbour ahead, without a cage:
  double neighbour_load = 0.0;    // [N]
  double neighbour_energy = 0.0;  // [J]
  double neighbour_power = 0.0;   // [W]  lost
};

/// Observes the padded state `x`; `seen` holds as many entries as there are rollers.
void observe(const Constants& constants, const RollerConstants& rollers, const double* x,
             ObservedRoller* seen);

}  // namespace orbearing::bearing::vectorised
