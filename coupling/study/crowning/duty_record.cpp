#include "coupling/study/crowning/duty_record.hpp"

#include <algorithm>

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

}  // namespace orbearing::study::crowning
