// What each duty of a spectrum does to a crown.
#pragma once

#include <vector>

#include "coupling/study/crowning/pressure_life.hpp"

namespace orbearing::study::crowning {

/// One duty under a profile, at the tilt at which all duties together leave the shortest life.
struct DutyRecord {
  double tilt = 0.0;                 // [rad]  largest of a bore against its pin
  double load_share = 1.0;           // [-]    largest load of a bearing of a planet over their mean
  double life_hours = 0.0;           // [h]  at this duty alone
  double pressure_life_hours = 0.0;  // [h]  the same from half-space pressures
  double damage_share = 0.0;         // [-]  of all damage, by the rule of Palmgren and Miner
  PeakPressure pressure;
};

/// Of all duties, in their order, on `jobs` threads (0: all). Throws std::runtime_error where loads do not
/// balance.
std::vector<DutyRecord> duty_records(const CrownProblem& problem, const RollerPressure& pressure,
                                     const bearing::profile::Profile& profile,
                                     const std::vector<double>& tilts, int jobs);

}  // namespace orbearing::study::crowning
