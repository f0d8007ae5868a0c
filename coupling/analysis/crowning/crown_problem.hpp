// One planet bearing, where it works, and what a crown of its rollers makes of its life.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/life/lamina_life.hpp"
#include "bearing/parameters.hpp"
#include "bearing/profile/profile.hpp"
#include "coupling/analysis/tilting_planet.hpp"

namespace orbearing::analysis::crowning {

// Profiles of one kind with two free numbers: how deep, and over how much of the length.

/// Free parameters of a profile.
struct Crown {
  double drop = 0.0;   // [m]  of one roller at profile::kDropPosition
  double share = 1.0;  // [-]  of each half that is relieved; of kinds that have a straight middle only
};

/// Profiles of one kind for one roller.
struct ProfileFamily {
  bearing::profile::Profile shape;  // of any depth
  double length = 0.0;              // [m]
};

/// Kinds that can be given any drop: all but straight and table.
std::vector<std::string> family_names();

/// The family `kind` for rollers of `bearing`. `load` [N] of one roller sets the width of the contact, which
/// rounds the ends of johns-gohar, lundberg and fujiwara-kawase. Throws std::invalid_argument for other
/// kinds.
ProfileFamily family_of(const std::string& kind, const bearing::Bearing& bearing, double load);

/// The family that `made` belongs to, with its own proportions. Throws as above.
ProfileFamily family_like(const bearing::profile::Profile& made, const bearing::Bearing& bearing);

/// Whether the kind has a straight middle whose length is free: chamfer, straight-circular, fujiwara-kawase.
bool has_share(const ProfileFamily& family);

/// Crowned share of the family as it is made; 1 for kinds crowned all along.
double default_share(const ProfileFamily& family);

/// Least and greatest share of any use: the station stays within the crown.
inline constexpr double kLeastShare = 0.1;
inline constexpr double kGreatestShare = 0.95;

/// The profile with this crown.
bearing::profile::Profile profile_of(const ProfileFamily& family, const Crown& crown);

/// Drop [m] at profile::kDropPosition of the reference profile of [ISO16281] on rollers of `bearing`.
double reference_drop(const bearing::Bearing& bearing);

using bearing::life::LaminaRating;
using bearing::rating::LifeMethod;

/// One operating point of a spectrum.
struct Duty {
  double speed = 0.0;               // [rad/s]  of the drivetrain's input
  double share = 1.0;               // [-]      of the time
  bearing::OperatingPoint point;    // of one bearing; tilted by the wind-up only; a study adds its tilts
  double radial_clearance = 0.0;    // [m]  of the bearing at this speed
  double overturning_moment = 0.0;  // [N m]  on the whole planet, of helical teeth
};

/// Problem of a study; immutable, from any thread.
struct CrownProblem {
  bearing::Bearing bearing;  // cut into laminae; its roller profile is what is studied
  bearing::QuasiStaticOptions options;
  std::vector<Duty> duties;
  LaminaRating contacts;  // of Lundberg and Palmgren
  RatedBearing rated;
  bearing::rating::BearingRating rating;                                       // with as many laminae
  bearing::rating::Life governing = bearing::rating::Life::lundberg_palmgren;  // what is made longest
  std::optional<PlanetSeat> seat{};  // where the tilt is computed; none: it is stated
};

/// Tilt of a planet [rad]. If tilts are stated: that of the bore on its pin, along the load and across. If
/// they are computed: inclination of the unloaded pin beyond its seat's own, outward and ahead.
using Lean = Eigen::Vector2d;

/// Tilt by one number, as in grids and pictures: along the load if stated, ahead if computed.
Lean lean_by(const CrownProblem& problem, double angle);

/// One operating point of a spectrum, as input of a drivetrain.
struct SpectrumPoint {
  double speed = 0.0;           // [rad/s]  of the input; 0: at rest, which only takes time
  double share = 1.0;           // [-]      of the time
  std::optional<double> power;  // [W]      none: the drivetrain's own
};

/// The planet bearing of `drivetrain` at the points of `spectrum`, whose shares add up to 1, cut into
/// `laminae`; points without time are left out. The governing life is that of `method`; of iso281, whose life
/// is that of all crowns, Lundberg and Palmgren's. Throws std::invalid_argument where shares do not add up,
/// are negative, or all time passes at rest.
CrownProblem crown_problem(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                           const std::vector<SpectrumPoint>& spectrum, LifeMethod method, int laminae = 40);

/// The same bearing at a single one of its duties.
CrownProblem one_duty(const CrownProblem& problem, std::size_t duty);

/// Loads of the bearings that a study takes at one duty: of a planet whose tilt is computed all, else one.
struct DutyLoads {
  std::vector<bearing::QuasiStaticResult> bearings;
  double tilt = 0.0;        // [rad]  largest of a bore against its pin
  double load_share = 1.0;  // [-]    largest load of a bearing over their mean

  /// [N]  (laminae, positions): loads that do the mean damage of the bearings, as in a sweep.
  Eigen::ArrayXXd inner_lamina_load() const;
  Eigen::ArrayXXd outer_lamina_load() const;
};

/// Loads that do the mean damage of `loads` (bearings)(laminae, positions): (mean of q^4)^(1/4).
Eigen::ArrayXXd mean_by_damage(const std::vector<Eigen::ArrayXXd>& loads);

/// Under `profile`. If the tilt is stated, searches start from `near`, if given: the loads of a profile that
/// is nearly the same. Throws std::runtime_error if there is no static equilibrium.
DutyLoads loads_at(const CrownProblem& problem, const bearing::profile::Profile& profile, const Lean& lean,
                   std::size_t duty, const DutyLoads* near = nullptr);

/// The bearing with `profile` on its rollers and the clearance of a duty, and the point of one with the tilt.
bearing::laminae::LaminaBearing lamina_bearing(const CrownProblem& problem,
                                               const bearing::profile::Profile& profile, std::size_t duty);
bearing::OperatingPoint tilted(const Duty& duty, const Lean& lean);

/// Lives [h] of one bearing at a single duty with known loads; kappa by speed and viscosity.
struct DutyHours {
  double lundberg_palmgren = 0.0;
  bearing::rating::RatedHours rated;
};
DutyHours lives_at(const CrownProblem& problem, const DutyLoads& loads, std::size_t duty);
/// The governing one of them.
double duty_hours(const CrownProblem& problem, const DutyLoads& loads, std::size_t duty);

/// By the standards, of loads [N] (laminae, positions) that include the effects of ends and tilts, without
/// stress riser. The governing life; L10r where that is Lundberg and Palmgren's.
double hours_without_riser(const CrownProblem& problem, const Eigen::ArrayXXd& inner,
                           const Eigen::ArrayXXd& outer, std::size_t duty);

/// The rule of Palmgren and Miner: life [h] of all, given that of each single duty. The remaining time is
/// rest.
double life_of_duties(const CrownProblem& problem, const std::function<double(std::size_t duty)>& hours);
/// Life by life (duties); not a number where one is not.
bearing::rating::RatedHours life_of_duties(const CrownProblem& problem,
                                           const std::vector<bearing::rating::RatedHours>& hours);

/// Life [h] of one bearing over the duties; of one duty, its own.
double life_hours(const CrownProblem& problem, const bearing::profile::Profile& profile, const Lean& lean);

/// ln of the life in hours, and how it follows the crown.
struct CrownLife {
  double log_hours = 0.0;
  double by_drop = 0.0;   // [1/m]
  double by_share = 0.0;  // [-]
};

/// The same life with its derivatives by differences.
CrownLife crown_life(const CrownProblem& problem, const ProfileFamily& family, const Crown& crown,
                     const Lean& lean);

}  // namespace orbearing::analysis::crowning
