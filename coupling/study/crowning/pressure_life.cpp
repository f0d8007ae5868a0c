#include "coupling/study/crowning/pressure_life.hpp"

#include <algorithm>

#include "bearing/pressure/pressure_measures.hpp"
#include "coupling/study/parallel.hpp"

namespace orbearing::study::crowning {

namespace {

namespace rating = bearing::rating;
using bearing::QuasiStaticResult;
using bearing::Race;
using bearing::laminae::RollerState;
using bearing::profile::Profile;

constexpr double kIdle = 1e-3;  // of the greatest load: less takes nothing from the life

// Pressures [Pa] (laminae, places) on one race, at some of the cage angles.
Eigen::ArrayXXd pressures_on(Race race, const CrownProblem& problem, const RollerPressure& pressure,
                             const Profile& profile, const QuasiStaticResult& loads, int angles) {
  const bool inner = race == Race::inner;
  const double half = 0.5 * problem.bearing.rollers().length;
  const double idle = kIdle * (inner ? loads.inner_load : loads.outer_load).maxCoeff();
  const auto states = static_cast<int>(loads.states.size());
  const int taken = std::min(angles, states);
  Eigen::ArrayXXd found =
      Eigen::ArrayXXd::Zero(problem.bearing.rollers().laminae, taken * problem.bearing.rollers().count);
  Eigen::Index position = 0;
  for (int i = 0; i < taken; ++i)
    for (const RollerState& roller : loads.states[static_cast<std::size_t>(i * states / taken)].rollers) {
      const double load = inner ? roller.inner.load : roller.outer.load;
      const double tilt = (inner ? roller.inner_end_displacement : roller.outer_end_displacement) / half;
      if (load > idle)
        found.col(position) = bearing::half_space::fatigue_pressures(pressure.on(race, profile, load, tilt),
                                                                     problem.bearing.rollers().laminae);
      ++position;
    }
  return found;
}

// Of all bearings of a duty on one race.
Eigen::ArrayXXd loads_on(Race race, const CrownProblem& problem, const RollerPressure& pressure,
                         const Profile& profile, const DutyLoads& loads, int angles) {
  const rating::RollerSet set = rating::roller_set(problem.bearing);
  std::vector<Eigen::ArrayXXd> all;
  for (const QuasiStaticResult& one : loads.bearings)
    all.push_back(rating::loads_of_pressures(pressures_on(race, problem, pressure, profile, one, angles), set,
                                             race, problem.bearing.material));
  return mean_by_damage(all);
}

double revolutions(const CrownProblem& problem, const RollerPressure& pressure, const Profile& profile,
                   const DutyLoads& loads, const bearing::RaceMotions& motions, int angles) {
  const rating::RollerSet set = rating::roller_set(problem.bearing);
  const auto equivalent = [&](Race race, bearing::RaceMotion motion) {
    return rating::equivalent_lamina_loads(loads_on(race, problem, pressure, profile, loads, angles), motion);
  };
  return rating::lamina_reference_life(
             rating::contact_capacities(set, rating::dynamic_capacity(set)),
             {equivalent(Race::inner, motions.inner), equivalent(Race::outer, motions.outer)})
      .bearing;
}

}  // namespace

double pressure_duty_hours(const CrownProblem& problem, const RollerPressure& pressure,
                           const Profile& profile, const DutyLoads& loads, std::size_t duty, int angles) {
  return bearing::hours(revolutions(problem, pressure, profile, loads, problem.ratings[duty].motions, angles),
                        rotating_speed(problem.bearing, problem.duties[duty].point));
}

double pressure_life_hours(const CrownProblem& problem, const RollerPressure& pressure,
                           const Profile& profile, const Lean& lean, int angles) {
  Eigen::ArrayXd hours(static_cast<Eigen::Index>(problem.duties.size()));
  for (std::size_t duty = 0; duty < problem.duties.size(); ++duty)
    hours[static_cast<Eigen::Index>(duty)] =
        pressure_duty_hours(problem, pressure, profile, loads_at(problem, profile, lean, duty), duty, angles);
  return life_of_duties(problem, hours);
}

std::vector<double> pressure_lives(const CrownProblem& problem, const RollerPressure& pressure,
                                   const Profile& profile, const std::vector<double>& tilts, int jobs) {
  std::vector<double> lives(tilts.size());
  in_parallel(tilts.size(), jobs, [&](std::size_t i) {
    lives[i] = pressure_life_hours(problem, pressure, profile, lean_by(problem, tilts[i]));
  });
  return lives;
}

}  // namespace orbearing::study::crowning
