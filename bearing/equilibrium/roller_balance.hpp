// One roller or ball on whole contacts between both races: how it shares the approach between them.
#pragma once

#include <variant>

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

/// Rollers, between races whose normals may be inclined to each other: the taper.
struct WholeRoller {
  RollerContacts contacts;    // outer one of tapered rollers: through the lever of the taper
  double taper_cosine = 1.0;  // [-]  1: cylinders and symmetric barrels
};

/// Dry rollers with the same line contact at both races and `taper` [rad] between the normals of these.
WholeRoller tapered_roller(const LineContact& contact, double taper);

/// Dry balls whose contacts lie opposite to each other.
struct WholeBall {
  PointContact inner, outer;
};

using WholeElement = std::variant<WholeRoller, WholeBall>;

/// The same of either; approach and inertial load along the normals of the outer and the inner race. The rib
/// of the inner ring holds tapered rollers along that ring's race: Eq. (18) of README.md.
RollerBalance balance_whole(const WholeElement& element, double inertial_load, double approach);

/// Approach [m] of an element without inertia at `outer_load` [N].
double whole_approach(const WholeElement& element, double outer_load);

}  // namespace orbearing::bearing
