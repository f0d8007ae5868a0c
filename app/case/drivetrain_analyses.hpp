// Analyses of planetary drivetrains: what they hold and which drivetrains they take, one row for each.
#pragma once

#include <string>
#include <vector>

#include "app/case/analysis_id.hpp"
#include "coupling/analysis/drivetrain_physics.hpp"

namespace orbearing::app {

/// Drivetrains that an analysis takes.
struct TakenDrivetrains {
  bool single_set = true;  // with planet bearings
  bool several_sets = false;
  bool without_bearing = false;
  bool without_teeth = false;  // masses and stiffnesses instead
};

struct DrivetrainAnalysis {
  const char* name;  // for users
  analysis::PhysicsSet holds;
  analysis::PhysicsSet leaves_out{};  // ought to be held: a stated input of it is warned of
  TakenDrivetrains takes{};
};

/// The row of an analysis of drivetrains.
const DrivetrainAnalysis& drivetrain_analysis(AnalysisId analysis);

/// All analyses of drivetrains, in the order in which they are listed.
const std::vector<AnalysisId>& drivetrain_analyses();
AnalysisSet all_of_drivetrains();

/// Those that hold the physics, and those that ought to and leave it out.
AnalysisSet analyses_with(analysis::Physics physics);
AnalysisSet analyses_leaving_out(analysis::Physics physics);

/// Those with lives and all that rates them.
inline AnalysisSet analyses_with_lives() {
  return analyses_with(analysis::Physics::rated_lives);
}
/// Of one set whose gears and bearings move together.
inline AnalysisSet analyses_of_one_set_in_time() {
  return analyses_with(analysis::Physics::run) & analyses_with(analysis::Physics::gear_motion);
}

/// Name of an analysis for users: "--fidelity dynamic".
std::string analysis_name(AnalysisId analysis);
/// Analyses of all machines, in the order in which they are listed.
const std::vector<AnalysisId>& every_analysis();

}  // namespace orbearing::app
