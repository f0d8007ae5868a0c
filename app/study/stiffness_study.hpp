// The 5 x 5 stiffness of a bearing over speed and load: of a single ball or roller bearing, of a duplex
// pair and of the planet bearings of a drivetrain.
#pragma once

#include <string>

#include "app/case/resolved_case.hpp"
#include "coupling/analysis/bearing_stiffness.hpp"

namespace orbearing::app {

using analysis::StiffnessPoint;
using analysis::StiffnessStudy;

/// Stiffness of a single bearing: the inner ring against the outer one, x along the radial load, at each of
/// `operation.load_factors` over each of `operation.speeds`, else at the case's own load and speed. For a
/// drivetrain: the bore of one planet bearing against its pin, x outward from the sun, y along the carrier's
/// rotation, at the points of its sweep; rollers and cage at their kinematic speeds, mean over the cage
/// angles. For a duplex pair: the shaft about its mass centre, at each of `operation.speeds`. Throws BadInput
/// for a case without a bearing.
StiffnessStudy stiffness_study(const ResolvedCase& resolved);

// The stiffness of a bearing as rows of text, and as a table that ROSS reads.

/// Displacements and stiffnesses, a row for each point.
std::string stiffness_csv(const StiffnessStudy& study);

/// The points of one series as a worksheet (BIFF 4, .xls) with the columns that ROSS's
/// BearingElement.from_table reads: kxx, kxy, kyx, kyy [N/m], damping 0 [N s/m] and the rotor's speed
/// [rad/s], rising. It has five rows at least: rows between fewer points are linear, a single point is
/// constant over 1000 rad/s. x is along the radial load, while weight in ROSS is along y. ROSS takes nothing
/// of the axis and of tilts.
std::string ross_table(const StiffnessStudy& study, std::size_t series);

}  // namespace orbearing::app
