// The machine of a case as a structure: all that the case states of it, in SI, with units in the comments.
//
//     orbearing::PlanetaryDrivetrain reducer = orbearing::drivetrain_of(stated);
//     reducer.drive.power = 120e3;  // [W]
//     const orbearing::Case changed = orbearing::changed(stated, reducer);
#pragma once

#include <variant>

#include "coupling/analysis/contact_film.hpp"
#include "coupling/analysis/duplex_pair.hpp"
#include "coupling/analysis/pair_meshes.hpp"
#include "coupling/analysis/scratched_bearing.hpp"
#include "coupling/analysis/single_bearing.hpp"
#include "coupling/analysis/stated_drivetrain.hpp"
#include "orbearing/case.hpp"

namespace orbearing {

using PlanetaryDrivetrain = analysis::StatedDrivetrain;  // one set or several, with their planet bearings
using GearPair = analysis::PairOfGears;
using RollerBearing = analysis::RollerBearing;    // under a static load
using BallBearing = analysis::BallBearing;        // the same
using MovingBallBearing = analysis::BallsInTime;  // a ball bearing whose case has a block `simulation`
using DuplexPair = analysis::DuplexPair;          // on a shaft
using ScratchedBallBearing = analysis::ScratchedBallBearing;
using ScratchedRollerBearing = analysis::RingOnRollers;
using SpinFilm = analysis::SpinFilm;  // of one contact

using Machine = std::variant<PlanetaryDrivetrain, GearPair, RollerBearing, BallBearing, MovingBallBearing,
                             DuplexPair, ScratchedBallBearing, ScratchedRollerBearing, SpinFilm>;

/// The machine of the case.
Machine machine_of(const Case& stated);

/// The same of the model planetary-drivetrain. Throws BadInput for a case of another model.
PlanetaryDrivetrain drivetrain_of(const Case& stated);

/// The case with the machine's values where they differ from its own; what follows from them is derived anew,
/// and all is checked. Throws BadInput where that is no sound case, and for a change of what no single input
/// states: the number of sets, or members that follow from others, such as the profile of a roller from
/// StatedProfile and the viscosities of an oil from its grade.
Case changed(const Case& stated, const Machine& machine);

}  // namespace orbearing
