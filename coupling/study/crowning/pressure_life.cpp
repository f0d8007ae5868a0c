#include "coupling/study/crowning/pressure_life.hpp"

#include <algorithm>

#include "bearing/pressure/pressure_measures.hpp"
#include "coupling/study/parallel.hpp"

namespace orbearing::study::crowning {

namespace {

namespace rating = bearing::rating;
using bearing::Race;
using bearing::laminae::LaminaResult;
using bearing::laminae::RollerState;
using bearing::profile::Profile;

constexpr double kIdle = 1e-3;  // of the greatest load: less takes nothing from the life

// Pressures [Pa] (laminae, places) on one race, at some of the cage angles.
Eigen::ArrayXXd pressures_on(Race race, const CrownProblem& problem, const RollerPressure& pressure,
                             const Profile& profile, const LaminaResult& loads, int angles) {
  const bool inner = race == Race::inner;
  const double half = 0.5 * problem.bearing.rollers().length;
  const double idle = kIdle * (inner ? loads.inner_load : loads.outer_load).maxCoeff();
  const auto states = static_cast<int>(loads.states.size());
  const int taken = std::min(angles, states);
  Eigen::ArrayXXd found =
      Eigen::ArrayXXd::Zero(problem.bearing.rollers().laminae, taken * problem.bearing.rollers().count);
  Eigen::Index place = 0;
  for (int i = 0; i < taken; ++i)
    for (const RollerState& roller : loads.states[static_cast<std::size_t>(i * states / taken)].rollers) {
      const double load = inner ? roller.inner.load : roller.outer.load;
      const double tilt = (inner ? roller.inner_tip : roller.outer_tip) / half;
      if (load > idle)
        found.col(place) = bearing::half_space::lamina_pressures(pressure.on(race, profile, load, tilt),
                                                                 problem.bearing.rollers().laminae);
      ++place;
    }
  return found;
}

double revolutions(const CrownProblem& problem, const RollerPressure& pressure, const Profile& profile,
                   const LaminaResult& loads, const bearing::RaceMotions& motions, int angles) {
  const rating::RollerSet set = rating::roller_set(problem.bearing);
  const auto equivalent = [&](Race race, bearing::RaceMotion motion) {
    const Eigen::ArrayXXd found = pressures_on(race, problem, pressure, profile, loads, angles);
    return rating::equivalent_lamina_loads(
        rating::loads_of_pressures(found, set, race, problem.bearing.material), motion);
  };
  return rating::lamina_reference_life(
             rating::contact_capacities(set, rating::dynamic_capacity(set)),
             {equivalent(Race::inner, motions.inner), equivalent(Race::outer, motions.outer)})
      .bearing;
}

}  // namespace

double pressure_life_hours(const CrownProblem& problem, const RollerPressure& pressure,
                           const Profile& profile, double tilt, int angles) {
  Eigen::ArrayXd hours(static_cast<Eigen::Index>(problem.duties.size()));
  for (std::size_t i = 0; i < problem.duties.size(); ++i) {
    const Duty& duty = problem.duties[i];
    const LaminaResult loads = loads_at(problem, profile, tilt, i);
    const double turns = revolutions(problem, pressure, profile, loads, problem.ratings[i].motions, angles);
    hours[static_cast<Eigen::Index>(i)] = bearing::hours(turns, turning_speed(problem.bearing, duty.point));
  }
  return life_of_duties(problem, hours);
}

std::vector<double> pressure_lives(const CrownProblem& problem, const RollerPressure& pressure,
                                   const Profile& profile, const std::vector<double>& tilts, int jobs) {
  std::vector<double> lives(tilts.size());
  in_parallel(tilts.size(), jobs,
              [&](std::size_t i) { lives[i] = pressure_life_hours(problem, pressure, profile, tilts[i]); });
  return lives;
}

}  // namespace orbearing::study::crowning
