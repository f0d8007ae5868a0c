#include "coupling/analysis/single_bearing.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/equilibrium/row_group.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace {

namespace equilibrium = bearing::equilibrium;
namespace rating = bearing::rating;
using mechanics::significant;

// Balls with a contact angle require an axial load of at least the radial load times the tangent of that
// angle. With less there is no equilibrium: the rings separate.
std::string too_little_thrust(const bearing::Bearing& bearing, const equilibrium::RingLoad& load) {
  const double angle = std::abs(bearing.contact_angle()), axial = std::abs(load.axial);
  const double least = std::abs(load.radial) * std::tan(angle);
  if (angle == 0.0 || load.tilt || load.moment != 0.0 || load.moment_across != 0.0 || !(axial < least))
    return "";
  return ". The axial load of " + significant(axial, 4) + " N is too small: at a contact angle of " +
         significant(angle * 180.0 / constants::pi, 3) + " deg a radial load of " +
         significant(std::abs(load.radial), 4) + " N requires at least " + significant(least, 4) +
         " N. Increase load.axial, or use model: duplex-pair for two bearings side by side";
}

// The unbalanced load is informative only where the search for an equilibrium failed.
std::string no_equilibrium_text(const equilibrium::BalanceReport& report, double load) {
  constexpr double found = 1e-6;  // [-]  of the load
  if (report.residual <= found * load) return report.message;
  return report.message + " (" + std::to_string(report.iterations) + " iterations, " +
         significant(report.residual, 2) + " N unbalanced)";
}

}  // namespace

bearing::Bearing rotating_bearing(const LoadedBearing& in) {
  bearing::Bearing bearing = in.bearing;
  bearing::put_profile(in.profile, bearing);
  bearing.motions = rating::rotating(in.rotation.turning_race);
  return bearing;
}

equilibrium::RowMotion row_motion(const RingRotation& rotation, const BallsOnRaces& balls,
                                  const bearing::Lubricant& lubricant) {
  equilibrium::RowMotion motion{.speeds = rotation.speeds(), .inertia = balls.inertia};
  if (balls.film) motion.film = lubricant;
  return motion;
}

rating::StatedRatings stated_ratings(const RollersUnderLoad& in) {
  rating::StatedRatings ratings = in.loaded.capacities.ratings();
  ratings.reduction_factor = in.life.reduction_factor;
  ratings.stress_riser = in.life.stress_riser;
  return ratings;
}

std::optional<rating::StatedOil> stated_oil(const LoadedBearing& in) {
  const LifeInputs& life = in.life;
  if (!life.contamination_factor && !life.cleanliness && !life.viscosity_ratio && !in.oil.kinematic_viscosity)
    return std::nullopt;
  rating::StatedOil oil{.viscosity_ratio = life.viscosity_ratio,
                        .contamination_factor = life.contamination_factor,
                        .lubrication = life.lubrication};
  if (!life.viscosity_ratio) oil.kinematic_viscosity = in.oil.kinematic_viscosity.value_or(0.0);
  if (life.cleanliness) oil.cleanliness = *life.cleanliness;
  return oil;
}

rating::RatingCondition rating_condition(const LoadedBearing& in) {
  rating::RatingCondition condition{
      .dynamic_load = rating::equivalent_load(in.bearing, in.load.radial, in.load.axial),
      .static_load = rating::static_equivalent_load(in.bearing, in.load.radial, in.load.axial),
      .oil = {},
      .reliability_factor = rating::reliability_factor(in.life.reliability)};
  // A speed and a ratio from which a_ISO is known are checked where the case is read.
  if (const std::optional<rating::StatedOil> oil = stated_oil(in))
    condition.oil = rating::oil_condition(*oil, in.rotation.relative(), in.bearing.pitch_diameter);
  return condition;
}

rating::Life governing_life(const LoadedBearing& in) {
  return rating::governing_life(in.life.method, stated_oil(in).has_value());
}

equilibrium::RingState balanced(const bearing::Bearing& bearing, const equilibrium::RowMotion& motion,
                                const equilibrium::RingLoad& load) {
  equilibrium::RingState state = equilibrium::balance_bearing(bearing, motion, load);
  if (!state.report.converged)
    throw NoResult(no_equilibrium_text(state.report, std::hypot(load.radial, load.axial)) +
                   too_little_thrust(bearing, load));
  return state;
}

}  // namespace orbearing::analysis
