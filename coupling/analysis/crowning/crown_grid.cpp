#include "coupling/analysis/crowning/crown_grid.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>

#include "bearing/pressure/pressure_measures.hpp"
#include "coupling/analysis/parallel.hpp"

namespace orbearing::analysis::crowning {

namespace {

namespace rating = bearing::rating;
using bearing::QuasiStaticResult;
using bearing::Race;
using bearing::laminae::RollerState;
using bearing::profile::Profile;

void keep_worst(const RollerState& roller, Race race, double half_length, double angle, WorstRoller& worst) {
  const bool inner = race == Race::inner;
  const double load = inner ? roller.inner.load : roller.outer.load;
  if (load <= worst.load) return;
  worst = {load, (inner ? roller.inner_end_displacement : roller.outer_end_displacement) / half_length,
           angle};
}

}  // namespace

RollerPressure::RollerPressure(const CrownProblem& problem)
    : bearing_(problem.bearing),
      inner_(bearing::half_space::contact_of(problem.bearing, Race::inner)),
      outer_(bearing::half_space::contact_of(problem.bearing, Race::outer)) {}

bearing::half_space::RollerContactPressure RollerPressure::on(Race race, const Profile& profile, double load,
                                                              double tilt) const {
  const bearing::half_space::StripContact& strips = race == Race::inner ? inner_ : outer_;
  const Profile& other = race == Race::inner ? bearing_.inner.profile : bearing_.outer.profile;
  return strips.under_load(strips.relief(bearing::half_space::relief_of(profile, other)), load, tilt);
}

WorstRoller worst_roller(const CrownProblem& problem, const DutyLoads& loads, Race race) {
  const double half_length = 0.5 * problem.bearing.rollers().length;
  WorstRoller worst;
  for (const QuasiStaticResult& one : loads.bearings)
    for (const bearing::QuasiStaticState& state : one.states)
      for (std::size_t j = 0; j < state.rollers.size(); ++j)
        keep_worst(state.rollers[j], race, half_length, state.angle[static_cast<Eigen::Index>(j)], worst);
  return worst;
}

PeakPressure peak_pressure(const CrownProblem& problem, const RollerPressure& pressure,
                           const Profile& profile, const std::vector<DutyLoads>& loads) {
  PeakPressure worst;
  for (const Race race : {Race::inner, Race::outer}) {
    WorstRoller roller;
    for (const DutyLoads& duty : loads) {
      const WorstRoller found = worst_roller(problem, duty, race);
      if (found.load > roller.load) roller = found;
    }
    if (roller.load <= 0.0) continue;
    const auto found = pressure.on(race, profile, roller.load, roller.tilt);
    if (found.peak_pressure > worst.peak) worst = {found.peak_pressure, found.edge_ratio, race};
  }
  return worst;
}

namespace {

constexpr double kIdle = 1e-3;  // of the greatest load: less takes nothing from the life

// Pressures [Pa] (laminae, positions) on one race, at some of the cage angles.
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

// Loads of all bearings of a duty on one race.
Eigen::ArrayXXd loads_on(Race race, const CrownProblem& problem, const RollerPressure& pressure,
                         const Profile& profile, const DutyLoads& loads, int angles) {
  const rating::RollerSet set = rating::roller_set(problem.bearing);
  std::vector<Eigen::ArrayXXd> all;
  for (const QuasiStaticResult& one : loads.bearings)
    all.push_back(rating::loads_of_pressures(pressures_on(race, problem, pressure, profile, one, angles), set,
                                             race, problem.bearing.material));
  return mean_by_damage(all);
}

// Life of a single duty with known loads.
double pressure_duty_hours(const CrownProblem& problem, const RollerPressure& pressure,
                           const Profile& profile, const DutyLoads& loads, std::size_t duty, int angles = 2) {
  const auto on = [&](Race race) { return loads_on(race, problem, pressure, profile, loads, angles); };
  return hours_without_riser(problem, on(Race::inner), on(Race::outer), duty);
}

}  // namespace

double pressure_life_hours(const CrownProblem& problem, const RollerPressure& pressure,
                           const Profile& profile, const Lean& lean, int angles) {
  return life_of_duties(problem, [&](std::size_t duty) {
    return pressure_duty_hours(problem, pressure, profile, loads_at(problem, profile, lean, duty), duty,
                               angles);
  });
}

std::vector<double> pressure_lives(const CrownProblem& problem, const RollerPressure& pressure,
                                   const Profile& profile, const std::vector<double>& tilts, int jobs) {
  std::vector<double> lives(tilts.size());
  in_parallel(tilts.size(), jobs, [&](std::size_t i) {
    lives[i] = pressure_life_hours(problem, pressure, profile, lean_by(problem, tilts[i]));
  });
  return lives;
}

std::vector<DutyRecord> duty_records(const CrownProblem& problem, const RollerPressure& pressure,
                                     const bearing::profile::Profile& profile,
                                     const std::vector<double>& tilts, int jobs) {
  std::vector<double> lives(tilts.size());
  in_parallel(tilts.size(), jobs,
              [&](std::size_t i) { lives[i] = life_hours(problem, profile, lean_by(problem, tilts[i])); });
  const auto worst = std::min_element(lives.begin(), lives.end());
  const Lean lean = lean_by(problem, tilts[static_cast<std::size_t>(worst - lives.begin())]);
  std::vector<DutyRecord> records(problem.duties.size());
  in_parallel(records.size(), jobs, [&](std::size_t duty) {
    const DutyLoads loads = loads_at(problem, profile, lean, duty);
    const double hours = duty_hours(problem, loads, duty);
    records[duty] = {loads.tilt,
                     loads.load_share,
                     hours,
                     pressure_duty_hours(problem, pressure, profile, loads, duty),
                     problem.duties[duty].share * *worst / hours,
                     peak_pressure(one_duty(problem, duty), pressure, profile, {loads})};
  });
  return records;
}

namespace {

// Loads are found once, for life and pressure.
void put_duties(const CrownProblem& problem, const RollerPressure& pressure, const Profile& profile,
                CrownPoint& point) {
  std::vector<DutyLoads> loads;
  std::vector<bearing::rating::RatedHours> rated;
  point.lundberg_palmgren_hours = life_of_duties(problem, [&](std::size_t duty) {
    loads.push_back(loads_at(problem, profile, lean_by(problem, point.tilt), duty));
    point.largest_tilt = std::max(point.largest_tilt, loads.back().tilt);
    const DutyHours lives = lives_at(problem, loads.back(), duty);
    rated.push_back(lives.rated);
    return lives.lundberg_palmgren;
  });
  point.rated_hours = life_of_duties(problem, rated);
  point.life_hours =
      bearing::rating::hours_of(problem.governing, point.lundberg_palmgren_hours, point.rated_hours);
  point.pressure = peak_pressure(problem, pressure, profile, loads);
}

CrownPoint point_at(const CrownProblem& problem, const RollerPressure& pressure, const Profile& profile,
                    double drop, double tilt) {
  CrownPoint point{.drop = drop, .tilt = tilt};
  try {
    put_duties(problem, pressure, profile, point);
  } catch (const std::exception& error) {
    point.life_hours = point.lundberg_palmgren_hours = std::numeric_limits<double>::quiet_NaN();
    point.rated_hours = {};
    point.status = error.what();
  }
  return point;
}

bool dominates(const WorstOfTilts& one, const WorstOfTilts& other) {
  return one.life_hours >= other.life_hours && one.peak_pressure <= other.peak_pressure &&
         (one.life_hours > other.life_hours || one.peak_pressure < other.peak_pressure);
}

}  // namespace

std::vector<CrownPoint> crown_grid(const CrownProblem& problem, const RollerPressure& pressure,
                                   const std::vector<Profile>& profiles, const std::vector<double>& drops,
                                   const std::vector<double>& tilts, int jobs, const Progressed& progressed) {
  std::vector<CrownPoint> points(profiles.size() * tilts.size());
  std::atomic<std::size_t> done = 0;
  in_parallel(points.size(), jobs, [&](std::size_t i) {
    const std::size_t drop = i / tilts.size();
    points[i] = point_at(problem, pressure, profiles[drop], drops[drop], tilts[i % tilts.size()]);
    const std::size_t now = ++done;
    if (progressed) progressed(now);
  });
  return points;
}

Eigen::ArrayXXd life_grid(const CrownProblem& problem, const std::vector<Profile>& profiles,
                          const std::vector<double>& tilts, int jobs) {
  Eigen::ArrayXXd lives(profiles.size(), tilts.size());
  in_parallel(profiles.size() * tilts.size(), jobs, [&](std::size_t i) {
    const std::size_t profile = i / tilts.size(), tilt = i % tilts.size();
    lives(static_cast<Eigen::Index>(profile), static_cast<Eigen::Index>(tilt)) =
        life_hours(problem, profiles[profile], lean_by(problem, tilts[tilt]));
  });
  return lives;
}

std::vector<WorstOfTilts> worst_of_tilts(const std::vector<CrownPoint>& points, std::size_t tilts) {
  std::vector<WorstOfTilts> all;
  for (std::size_t first = 0; first < points.size(); first += tilts) {
    WorstOfTilts worst{.drop = points[first].drop, .life_hours = std::numeric_limits<double>::infinity()};
    for (std::size_t i = first; i < first + tilts; ++i) {
      if (!(points[i].life_hours >= worst.life_hours)) worst.life_hours = points[i].life_hours;
      worst.peak_pressure = std::max(worst.peak_pressure, points[i].pressure.peak);
    }
    all.push_back(worst);
  }
  for (WorstOfTilts& one : all)
    one.efficient =
        std::isfinite(one.life_hours) &&
        std::none_of(all.begin(), all.end(), [&](const auto& other) { return dominates(other, one); });
  return all;
}

}  // namespace orbearing::analysis::crowning
