#include "coupling/study/crowning/roller_pressure.hpp"

#include "bearing/pressure/strip_contact.hpp"

namespace orbearing::study::crowning {

namespace {

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

}  // namespace orbearing::study::crowning
