#include "coupling/study/crowning/crown_grid.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>

#include "coupling/study/parallel.hpp"

namespace orbearing::study::crowning {

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

using bearing::profile::Profile;

// Loads are found once, for life and pressure.
void put_duties(const CrownProblem& problem, const RollerPressure& pressure, const Profile& profile,
                CrownPoint& point) {
  std::vector<DutyLoads> loads;
  Eigen::ArrayXd hours(static_cast<Eigen::Index>(problem.duties.size()));
  std::vector<bearing::rating::RatedHours> rated;
  for (std::size_t duty = 0; duty < problem.duties.size(); ++duty) {
    loads.push_back(loads_at(problem, profile, lean_by(problem, point.tilt), duty));
    point.largest_tilt = std::max(point.largest_tilt, loads.back().tilt);
    hours[static_cast<Eigen::Index>(duty)] = duty_hours(problem, loads.back(), duty);
    rated.push_back(rated_duty_hours(problem, loads.back(), duty));
  }
  point.life_hours = life_of_duties(problem, hours);
  point.rated_hours = life_of_duties(problem, rated);
  point.pressure = peak_pressure(problem, pressure, profile, loads);
}

CrownPoint point_at(const CrownProblem& problem, const RollerPressure& pressure, const Profile& profile,
                    double drop, double tilt) {
  CrownPoint point{.drop = drop, .tilt = tilt};
  try {
    put_duties(problem, pressure, profile, point);
  } catch (const std::exception& error) {
    point.life_hours = std::numeric_limits<double>::quiet_NaN();
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

}  // namespace orbearing::study::crowning
