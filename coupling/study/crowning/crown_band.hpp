// How closely a drop must be met, and what each duty of a spectrum does to the crown that was found.
#pragma once

#include <vector>

#include "coupling/study/crowning/crown_optimum.hpp"
#include "coupling/study/crowning/roller_pressure.hpp"

namespace orbearing::study::crowning {

/// Share of the longest life that is left at the ends of a band of drops.
inline constexpr double kKeptLife = 0.95;

/// Drops [m] between which the shortest life over the tilts stays at least kKeptLife of that at the best.
struct DropBand {
  double least = 0.0;
  double most = 0.0;
  bool open = false;  // `most` is the greatest drop studied: greater ones may do as well
};

/// The band around `best`, with its share, between no drop and `greatest` [m], to a thousandth of the way to
/// either end: life falls away from the best drop on both sides. Throws std::runtime_error where loads do not
/// balance.
DropBand drop_band(const CrownProblem& problem, const ProfileFamily& family, const Crown& best,
                   const std::vector<double>& tilts, double greatest, int jobs);

/// One duty under a profile, at the tilt at which all duties together leave the shortest life.
struct DutyRecord {
  double tilt = 0.0;          // [rad]
  double life_hours = 0.0;    // [h]  at this duty alone
  double damage_share = 0.0;  // [-]  of all damage, by the rule of Palmgren and Miner
  PeakPressure pressure;
};

/// Of all duties, in their order. Throws as above.
std::vector<DutyRecord> duty_records(const CrownProblem& problem, const RollerPressure& pressure,
                                     const bearing::profile::Profile& profile,
                                     const std::vector<double>& tilts, int jobs);

}  // namespace orbearing::study::crowning
