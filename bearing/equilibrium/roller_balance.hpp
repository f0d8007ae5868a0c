// One roller or ball between both races: how it shares the approach between its two contacts.
#pragma once

#include "bearing/contact/point_contact.hpp"
#include "bearing/contact/race_contact.hpp"

namespace orbearing::bearing {

/// Loads of one roller and how the outer one follows the approach of the races.
struct RollerBalance {
  double inner_load = 0.0;  // [N]
  double outer_load = 0.0;  // [N]
  double stiffness = 0.0;   // [N/m]  d(outer load)/d(approach of the races)
};

/// Balance of a roller under the inertial load `inertial_load` [N] (outward positive, = outer load - inner
/// load) when the races have come closer by `approach` [m] than two unloaded dry contacts allow. A roller
/// that is not squeezed rests on the race towards which its inertial load points.
RollerBalance balance_roller(const RaceContact& inner, const RaceContact& outer, double inertial_load,
                             double approach);

/// The same of a ball whose contacts lie opposite to each other.
RollerBalance balance_ball(const PointContact& inner, const PointContact& outer, double inertial_load,
                           double approach);

}  // namespace orbearing::bearing
