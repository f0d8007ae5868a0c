// Life and pressure over drops and tilts, computed in parallel, and efficient designs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bearing/pressure/strip_contact.hpp"
#include "coupling/analysis/crowning/crown_problem.hpp"

namespace orbearing::analysis::crowning {

// Pressure along the most loaded roller of a bearing, from the elastic half-space.

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
  double tilt = 0.0;   // [rad]  of the roller against the race: the contact closes more at positive positions
  double angle = 0.0;  // [rad]
};

WorstRoller worst_roller(const CrownProblem& problem, const DutyLoads& loads, bearing::Race race);

/// Greatest pressure of both races, with the edge ratio of the contact that has it.
struct PeakPressure {
  double peak = 0.0;        // [Pa]
  double edge_ratio = 0.0;  // [-]
  bearing::Race race = bearing::Race::inner;
};

/// Peak pressure of the most loaded roller on each race, at the duty that loads it most; `loads` are those of
/// the duties, in their order. The roller's tilt is that of its equilibrium on laminae.
PeakPressure peak_pressure(const CrownProblem& problem, const RollerPressure& pressure,
                           const bearing::profile::Profile& profile, const std::vector<DutyLoads>& loads);

// Life from the pressures of the elastic half-space, which include the effects of ends and tilts.

/// Life [h] by hours_without_riser() of the loads that would press as hard, as line contacts, instead of
/// lamina loads and stress riser; by Miner's rule over the duties. Pressures are found for every loaded
/// roller of all bearings, on both races, at `angles` of the cage angles, about a millisecond each; the loads
/// and tilts of the rollers are those on laminae.
double pressure_life_hours(const CrownProblem& problem, const RollerPressure& pressure,
                           const bearing::profile::Profile& profile, const Lean& lean, int angles = 2);

/// The same over the duties for each of `tilts` [rad], as lean_by() takes them, on `jobs` threads (0: all).
std::vector<double> pressure_lives(const CrownProblem& problem, const RollerPressure& pressure,
                                   const bearing::profile::Profile& profile, const std::vector<double>& tilts,
                                   int jobs);

// Results of a crown for each duty of a spectrum.

/// One duty under a profile, at the tilt at which all duties together leave the shortest life.
struct DutyRecord {
  double tilt = 0.0;                 // [rad]  largest of a bore against its pin
  double load_share = 1.0;           // [-]    largest load of a bearing of a planet over their mean
  double life_hours = 0.0;           // [h]  at this duty only
  double pressure_life_hours = 0.0;  // [h]  the same from half-space pressures
  double damage_share = 0.0;         // [-]  of all damage, by the rule of Palmgren and Miner
  PeakPressure pressure;
};

/// Records of all duties, in their order, on `jobs` threads (0: all). Throws std::runtime_error if there is
/// no static equilibrium.
std::vector<DutyRecord> duty_records(const CrownProblem& problem, const RollerPressure& pressure,
                                     const bearing::profile::Profile& profile,
                                     const std::vector<double>& tilts, int jobs);

/// One profile at one tilt, under the whole spectrum.
struct CrownPoint {
  double drop = 0.0;                     // [m]    of one roller at profile::kDropPosition
  double tilt = 0.0;                     // [rad]  as stated, of the bore on its pin, or as lean_by() takes it
  double largest_tilt = 0.0;             // [rad]  largest of a bore against its pin over bearings and duties
  double life_hours = 0.0;               // [h]  the governing one
  double lundberg_palmgren_hours = 0.0;  // [h]
  bearing::rating::RatedHours rated_hours{};  // by the standards
  PeakPressure pressure;                      // greatest over the spectrum
  std::string status = "ok";                  // "ok" or why there is no equilibrium
};

/// Called as points finish, from several threads, with how many are done.
using Progressed = std::function<void(std::size_t done)>;

/// Points for `profiles`, drop by drop and within each over `tilts` [rad]; `jobs` threads (0: all). Results
/// do not depend on `jobs`. `drops` [m] name the profiles.
std::vector<CrownPoint> crown_grid(const CrownProblem& problem, const RollerPressure& pressure,
                                   const std::vector<bearing::profile::Profile>& profiles,
                                   const std::vector<double>& drops, const std::vector<double>& tilts,
                                   int jobs, const Progressed& progressed);

/// Lives only, [h] (profiles, tilts), for a wide study.
Eigen::ArrayXXd life_grid(const CrownProblem& problem, const std::vector<bearing::profile::Profile>& profiles,
                          const std::vector<double>& tilts, int jobs);

/// The worst over tilts of each drop.
struct WorstOfTilts {
  double drop = 0.0;           // [m]
  double life_hours = 0.0;     // [h]   shortest; NaN where a point failed
  double peak_pressure = 0.0;  // [Pa]  greatest
  bool efficient = false;      // no other drop has a longer life at a lower or equal pressure
};

/// Worst points of a grid with `tilts` tilts; `efficient`: on the front of life against pressure.
std::vector<WorstOfTilts> worst_of_tilts(const std::vector<CrownPoint>& points, std::size_t tilts);

}  // namespace orbearing::analysis::crowning
