// Life from the pressures of the elastic half-space, which sees for itself what ends and tilts do.
#pragma once

#include "coupling/study/crowning/roller_pressure.hpp"

namespace orbearing::study::crowning {

/// Life [h] after [ISO16281] with the loads that would press as hard, as line contacts, in place of lamina
/// loads and stress riser; by Miner's rule over the duties. Pressures are found for every loaded roller of
/// all bearings, on both races, at `angles` of the cage angles, about a millisecond each; the loads and tilts
/// of the rollers are those on laminae.
double pressure_life_hours(const CrownProblem& problem, const RollerPressure& pressure,
                           const bearing::profile::Profile& profile, const Lean& lean, int angles = 2);

/// The same of one duty alone, whose loads are known.
double pressure_duty_hours(const CrownProblem& problem, const RollerPressure& pressure,
                           const bearing::profile::Profile& profile, const DutyLoads& loads, std::size_t duty,
                           int angles = 2);

/// The same over the duties for each of `tilts` [rad], as lean_by() takes them, on `jobs` threads (0: all).
std::vector<double> pressure_lives(const CrownProblem& problem, const RollerPressure& pressure,
                                   const bearing::profile::Profile& profile, const std::vector<double>& tilts,
                                   int jobs);

}  // namespace orbearing::study::crowning
