// A planet bearing driven by gears that move without it, on springs and dampers that are fitted to how it
// moved: one way, and yet what gears and bearings do together.
#pragma once

#include <optional>

#include "coupling/study/affine_fit.hpp"
#include "coupling/study/mesh_excitation.hpp"
#include "coupling/system/steady_state.hpp"

namespace orbearing::study {

/// When the law that stands for the bearings counts as found.
struct OneWayOptions {
  double stiffness_change = 0.01;  // [-]  from one run to the next, in its force along the motion
  double damping_change = 0.1;     // [-]
  double load_difference = 0.002;  // [-]  of the mean load: a hundredth of the life
  int most_runs = 8;               // of gears and bearing; then the last one stands, and says so
};

/// What stood for the bearings while the gears moved.
struct OneWayRecord {
  FittedBearing fitted;   // after the last run; its changes are from what the gears moved on in that run
  int runs = 0;           // of gears and bearing
  // [-]  of the gears' mean force on the bearings from the load under which the bearing ran, over that load:
  // the gears have what displaced planets make of it, as where back flanks touch, the bearing has not
  double load_difference = 0.0;
  bool accepted = false;  // both changes, and that difference, within what is allowed
};

/// A bearing in its steady state, and what drove it.
struct OneWayRun {
  system::SteadyStateResult bearing;
  std::optional<OneWayRecord> fit;  // none where the gears give nothing but their mean loads
};

/// Gears on the tangent of their bearings (`gears`), the bearing under the load that they give it
/// (excitation_of()), the affine law fitted to its motion, and both again on that law until a run agrees with
/// the law that it was driven on. The gears move on the law fitted to all runs but the first (AffineFit):
/// what a single run shows swings about it. Runs that do not agree are broken off after a third of the
/// windows, one at least; the last one is observed to its end. Where the gears would run away on a law, the
/// run that it is fitted to is the last one; where they do all the same, the bearing is driven as before once
/// more. Each run goes on where the one before ended.
///
/// Of the planet's mass the bearing gets its own outer ring, and the gears' load is what moves that ring as
/// the planet moved: nearly the force of the bearing. With the whole mass, which is as good for a bearing
/// that is linear, the ring's own vibration on the rollers falls among the mesh harmonics, where a small
/// error of the law is a large one of the motion.
/// @param start state of the bearing to begin with; none: its quasi-static state
/// @throws std::runtime_error where the gears' motion cannot be computed
OneWayRun run_one_way(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                      const BearingDuty& duty, const GearsOnTangent& gears,
                      const std::optional<Eigen::VectorXd>& start = std::nullopt,
                      const OneWayOptions& options = {});

}  // namespace orbearing::study
