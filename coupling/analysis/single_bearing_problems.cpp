// Inputs of a single bearing that do not fit together (single_bearing.hpp).
#include <utility>

#include "bearing/motion/starvation.hpp"
#include "coupling/analysis/single_bearing.hpp"
#include "mechanics/append.hpp"
#include "mechanics/member_keys.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace equilibrium = bearing::equilibrium;
namespace motion = bearing::motion;
namespace rating = bearing::rating;
using mechanics::append;
using mechanics::significant;

namespace {

void find_twice_stated(const equilibrium::RingLoad& load, mechanics::Problems& found) {
  const mechanics::MemberKeys key(load);
  for (const double* moment : {&load.moment, &load.moment_across})
    if (*moment != 0.0 && load.tilt)
      found.push_back({key(load.tilt), "a tilt together with " + key(*moment) +
                                           "; either the moment, with the tilt that follows, or the tilt is "
                                           "required"});
}

}  // namespace

mechanics::Problems problems(const LoadOnRing& machine) {
  mechanics::Problems found;
  find_twice_stated(machine.load, found);
  return found;
}

mechanics::Problems problems(const LoadOnRollers& machine) {
  const equilibrium::RingLoad& load = machine.load;
  const mechanics::MemberKeys key(machine);
  const std::string& laminae = key(machine.laminae);
  mechanics::Problems found;
  find_twice_stated(load, found);
  if (machine.laminae < 2) {
    for (const double* moment : {&load.moment, &load.moment_across})
      if (*moment != 0.0)
        found.push_back(
            {laminae,
             "a single lamina, which holds no moment; at least 2 laminae are required with " + key(*moment)});
    if (load.tilt.value_or(0.0) != 0.0)
      found.push_back(
          {laminae,
           "a single lamina, which is not affected by a tilt; at least 2 laminae are required with " +
               key(load.tilt)});
  }
  if (!(load.radial > 0.0))
    found.push_back({key(load.radial), "no load; a radial load greater than 0 N is required"});
  return found;
}

mechanics::Problems problems(const LifeInputs& life) {
  mechanics::Problems found;
  if (!life.cleanliness) return found;
  const mechanics::MemberKeys key(life);
  const std::string& level = key(life.cleanliness);
  if (life.contamination_factor)
    found.push_back(
        {level, "a value together with " + key(life.contamination_factor) + "; one of the two is required"});
  if (*life.cleanliness == rating::Cleanliness::lowest &&
      life.lubrication == rating::Lubrication::circulating_oil)
    found.push_back({level, "'" + mechanics::as_written(level) +
                                "' for circulating oil; one of highest, high, medium, low is required with a "
                                "filter"});
  return found;
}

mechanics::Problems problems(const OilOfLife& machine) {
  const LifeInputs& life = machine.life;
  const mechanics::MemberKeys key_of(machine);
  const std::string &ratio = key_of(life.viscosity_ratio),
                    &viscosity = key_of(machine.oil.kinematic_viscosity),
                    &factor = key_of(life.contamination_factor), &level = key_of(life.cleanliness);
  mechanics::Problems found;
  if (machine.oil.stated.grade) return found;  // a viscosity that is always there
  const bool of_ratio = life.viscosity_ratio.has_value(),
             of_oil = machine.oil.kinematic_viscosity.has_value();
  if (of_ratio && of_oil)
    found.push_back({viscosity, "a value together with " + ratio + "; one of the two is required"});
  for (const auto& [key, stated] :
       {std::pair{factor, life.contamination_factor.has_value()}, {level, life.cleanliness.has_value()}})
    if (stated && !of_ratio && !of_oil)
      found.push_back(
          {key, "cleanliness without a viscosity; " + ratio + " or " + viscosity + " is required with it"});
  for (const auto& [key, stated] : {std::pair{ratio, of_ratio}, {viscosity, of_oil}})
    if (stated && !life.contamination_factor && !life.cleanliness)
      found.push_back(
          {key, "a viscosity without cleanliness; " + factor + " or " + level + " is required with it"});
  return found;
}

// From the viscosity and the speed; a_ISO is known from a least value on.
mechanics::Problems problems(const ViscosityRatio& machine) {
  const BearingOil& oil = machine.oil.oil;
  if (machine.oil.life.viscosity_ratio || !oil.kinematic_viscosity) return {};
  const mechanics::MemberKeys key_of(machine);
  const std::string& key = oil.stated.grade ? key_of(oil.stated.grade) : key_of(oil.kinematic_viscosity);
  const double speed = machine.rotation.relative(), viscosity = *oil.kinematic_viscosity;
  if (speed == 0.0)
    return {{key, "a viscosity for rings that do not rotate; " + key_of(machine.rotation.shaft_speed) +
                      " is required, from which the viscosity ratio follows"}};
  if (!(machine.pitch_diameter > 0.0)) return {};  // not known
  const double kappa = viscosity / rating::required_viscosity(speed, machine.pitch_diameter);
  if (kappa >= rating::kLeastViscosityRatio) return {};
  return {
      {key, "a viscosity ratio kappa of " + significant(kappa, 3) + " by a viscosity of " +
                significant(1e6 * viscosity, 3) + " mm2/s; at least " +
                significant(rating::kLeastViscosityRatio, 6) +
                " is required, where a_ISO begins: a thicker oil, a lower temperature or a higher speed"}};
}

namespace {

template <class Machine>
void find_heat_without_flow(bool heated, const system::HeatModel& model, const double& flow,
                            const mechanics::MemberKeys<Machine>& key, mechanics::Problems& found) {
  if (heated && model == system::HeatModel::oil && !(flow > 0.0))
    found.push_back({key(model), "heat that leaves with the oil, without a flow; " + key(flow) +
                                     " greater than 0 L/min is required"});
}

}  // namespace

mechanics::Problems problems(const OilOfRollers& machine) {
  const RollerOil& oil = machine.oil;
  mechanics::Problems found;
  const mechanics::MemberKeys key(machine);
  find_heat_without_flow(oil.heated, oil.model, oil.flow, key, found);
  if (oil.heated && oil.model == system::HeatModel::network)
    found.push_back(
        {key(oil.model), "a network of bodies for rollers; oil is required: rollers heat the oil alone"});
  append(motion::starvation_problems(oil.starvation, machine.size.has_value()), found);
  return found;
}

mechanics::Problems problems(const BallsInTime& machine) {
  const bearing::Bearing& bearing = machine.loaded.bearing;
  const bearing::balls::MotionParameters& motion = moving_balls(machine);
  const bearing::balls::MixtureParameters& mixture = motion.mixture;
  const system::HeatParameters& heat = machine.simulation.heat;
  const equilibrium::RingLoad& load = machine.loaded.load;
  const mechanics::MemberKeys key(machine);
  mechanics::Problems found;
  if (!(motion.inner.mass > 0.0 && motion.inner.across > 0.0) &&
      !(bearing.inner.seat_diameter > 0.0 && bearing.width > 0.0))
    found.push_back({key(machine.simulation.options.duration),
                     "an inner ring in motion whose mass is not known; " + key(bearing.inner.seat_diameter) +
                         " and " + key(bearing.width) + " are required, or rotor.mass and rotor.inertia"});
  const bool filled = motion.drag.on && mixture.fill == bearing::balls::OilFill::parker;
  if (filled && !(mixture.flow > 0.0))
    found.push_back({key(mixture.fill), "a share of oil by the flow without a flow; " + key(mixture.flow) +
                                            " greater than 0 L/min is required"});
  if (filled && machine.loaded.rotation.relative() == 0.0)
    found.push_back({key(mixture.fill), "a share of oil by the speed of rings that do not rotate; " +
                                            key(machine.loaded.rotation.shaft_speed) + " is required"});
  find_heat_without_flow(heat.on, heat.model, mixture.flow, key, found);
  append(bearing::motion::starvation_problems(
             motion.race, bearing.inner.seat_diameter > 0.0 && bearing.outer.seat_diameter > 0.0),
         found);
  if (!(load.axial > 0.0 || load.radial > 0.0))
    found.push_back({key(load.radial), "no load; a radial or axial load greater than 0 N is required"});
  return found;
}

}  // namespace orbearing::analysis
