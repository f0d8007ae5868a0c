// Life from the pressures of the elastic half-space, which sees for itself what ends and tilts do.
#pragma once

#include "coupling/study/crowning/roller_pressure.hpp"

namespace orbearing::study::crowning {

/// Life [h] after [ISO16281] with the loads that would press as hard, as line contacts, in place of lamina
/// loads and stress riser; by Miner's rule over the duties. Pressures are found for every loaded roller at
/// `angles` of the cage angles, about a millisecond each; the loads and tilts of the rollers are those on
/// laminae.
double pressure_life_hours(const CrownProblem& problem, const RollerPressure& pressure,
                           const bearing::profile::Profile& profile, double tilt, int angles = 2);

/// The same for each of `tilts` [rad], on `jobs` threads (0: all).
std::vector<double> pressure_lives(const CrownProblem& problem, const RollerPressure& pressure,
                                   const bearing::profile::Profile& profile, const std::vector<double>& tilts,
                                   int jobs);

}  // namespace orbearing::study::crowning
