// Pressure along the most loaded roller of a bearing, from the elastic half-space.
#pragma once

#include "bearing/pressure/strip_contact.hpp"
#include "coupling/study/crowning/crown_problem.hpp"

namespace orbearing::study::crowning {

/// The half-space contacts of a bearing's rollers, laid out once; used from any thread.
class RollerPressure {
 public:
  explicit RollerPressure(const CrownProblem& problem);

  /// Under `load` [N] > 0 at `tilt` [rad] of the roller against the race. Roller profile `profile`.
  bearing::half_space::RollerContactPressure on(bearing::Race race, const bearing::profile::Profile& profile,
                                                double load, double tilt) const;

 private:
  bearing::Bearing bearing_;
  bearing::half_space::StripContact inner_;
  bearing::half_space::StripContact outer_;
};

/// The most loaded roller on one race, over all bearings and cage angles.
struct WorstRoller {
  double load = 0.0;   // [N]
  double tilt = 0.0;   // [rad]  of the roller against the race: the contact closes more at positive places
  double angle = 0.0;  // [rad]
};

WorstRoller worst_roller(const CrownProblem& problem, const DutyLoads& loads, bearing::Race race);

/// Greatest pressure of both races, with the edge ratio of the contact that has it.
struct PeakPressure {
  double peak = 0.0;        // [Pa]
  double edge_ratio = 0.0;  // [-]
  bearing::Race race = bearing::Race::inner;
};

/// Of the most loaded roller on each race, at the duty that loads it most; `loads` are those of the duties,
/// in their order. The roller's tilt is that of its balance on laminae.
PeakPressure peak_pressure(const CrownProblem& problem, const RollerPressure& pressure,
                           const bearing::profile::Profile& profile, const std::vector<DutyLoads>& loads);

}  // namespace orbearing::study::crowning
