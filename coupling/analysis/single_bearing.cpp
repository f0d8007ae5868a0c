#include "coupling/analysis/single_bearing.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/equilibrium/row_group.hpp"
#include "bearing/motion/starvation.hpp"
#include "coupling/analysis/friction_conditions.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace {

namespace equilibrium = bearing::equilibrium;
namespace rating = bearing::rating;
using mechanics::significant;

// Balls with a contact angle require an axial load of at least the radial load times the tangent of that
// angle. With less there is no equilibrium: the rings separate.
std::string too_little_thrust(const bearing::Bearing& bearing, const equilibrium::RingLoad& load) {
  const double angle = std::abs(bearing.contact_angle()), axial = std::abs(load.axial);
  const double least = std::abs(load.radial) * std::tan(angle);
  if (angle == 0.0 || load.tilt || load.moment != 0.0 || load.moment_across != 0.0 || !(axial < least))
    return "";
  return ". The axial load of " + significant(axial, 4) + " N is too small: at a contact angle of " +
         significant(angle * 180.0 / constants::pi, 3) + " deg a radial load of " +
         significant(std::abs(load.radial), 4) + " N requires at least " + significant(least, 4) +
         " N. Increase load.axial, or use model: duplex-pair for two bearings side by side";
}

// The unbalanced load is informative only where the search for an equilibrium failed.
std::string no_equilibrium_text(const equilibrium::BalanceReport& report, double load) {
  constexpr double found = 1e-6;  // [-]  of the load
  if (report.residual <= found * load) return report.message;
  return report.message + " (" + std::to_string(report.iterations) + " iterations, " +
         significant(report.residual, 2) + " N unbalanced)";
}

}  // namespace

bearing::Bearing rotating_bearing(const LoadedBearing& in) {
  bearing::Bearing bearing = in.bearing;
  bearing.motions = rating::rotating(in.rotation.turning_race);
  return bearing;
}

equilibrium::RowMotion row_motion(const RingRotation& rotation, const BallsOnRaces& balls,
                                  const bearing::Lubricant& lubricant) {
  equilibrium::RowMotion motion{.speeds = rotation.speeds(), .inertia = balls.inertia};
  if (balls.film) motion.film = lubricant;
  return motion;
}

rating::StatedRatings stated_ratings(const RollersUnderLoad& in) {
  rating::StatedRatings ratings = in.loaded.capacities.ratings();
  ratings.reduction_factor = in.life.reduction_factor;
  ratings.stress_riser = in.life.stress_riser;
  return ratings;
}

std::optional<rating::StatedOil> stated_oil(const LoadedBearing& in) {
  const LifeInputs& life = in.life;
  if (!life.contamination_factor && !life.cleanliness && !life.viscosity_ratio && !in.oil.kinematic_viscosity)
    return std::nullopt;
  rating::StatedOil oil{.viscosity_ratio = life.viscosity_ratio,
                        .contamination_factor = life.contamination_factor,
                        .lubrication = life.lubrication};
  if (!life.viscosity_ratio) oil.kinematic_viscosity = in.oil.kinematic_viscosity.value_or(0.0);
  if (life.cleanliness) oil.cleanliness = *life.cleanliness;
  return oil;
}

rating::RatingCondition rating_condition(const LoadedBearing& in) {
  rating::RatingCondition condition{
      .dynamic_load = rating::equivalent_load(in.bearing, in.load.radial, in.load.axial),
      .static_load = rating::static_equivalent_load(in.bearing, in.load.radial, in.load.axial),
      .oil = {},
      .reliability_factor = rating::reliability_factor(in.life.reliability)};
  // A speed and a ratio from which a_ISO is known are checked where the case is read.
  if (const std::optional<rating::StatedOil> oil = stated_oil(in))
    condition.oil = rating::oil_condition(*oil, in.rotation.relative(), in.bearing.pitch_diameter);
  return condition;
}

rating::Life governing_life(const LoadedBearing& in) {
  return rating::governing_life(in.life.method, stated_oil(in).has_value());
}

equilibrium::RingState balanced(const bearing::Bearing& bearing, const equilibrium::RowMotion& motion,
                                const equilibrium::RingLoad& load) {
  equilibrium::RingState state = equilibrium::balance_bearing(bearing, motion, load);
  if (!state.report.converged)
    throw NoResult(no_equilibrium_text(state.report, std::hypot(load.radial, load.axial)) +
                   too_little_thrust(bearing, load));
  return state;
}

namespace {

using mechanics::Conditional;
using mechanics::Otherwise;
using mechanics::Premise;

const RingRotation& rotation(const BallSupport& in) {
  return in.rotation;
}
template <class Inputs>
const RingRotation& rotation(const Inputs& in) {
  return in.loaded.rotation;
}

bool is_nonzero(double value) {
  return value != 0.0;
}

template <class Inputs>
bool is_at_rest(const Inputs& in) {
  return rotation(in).speeds().at_rest() && std::ranges::none_of(in.speeds, is_nonzero);
}

// Rings that rotate against each other.
template <class Inputs>
Premise<Inputs> rings_rotate() {
  return {.on = {"operation.shaft_speed", "operation.outer_speed"},
          .holds = [](const Inputs& in) { return rotation(in).relative() != 0.0; }};
}

template <class Inputs>
Premise<Inputs> oil_has_viscosity() {
  return {.on = {"lubricant.grade", "lubricant.kinematic_viscosity"},
          .holds = [](const Inputs& in) { return in.loaded.oil.kinematic_viscosity.has_value(); }};
}

// a_1 is a result of any load at rest, and a part of the lives with an oil.
template <class Inputs>
Conditional<Inputs> reliability_with_oil() {
  return {.keys = {"life.reliability"},
          .premises = {{.on = {"lubricant.grade", "life.cleanliness", "life.contamination_factor",
                               "life.viscosity_ratio", "lubricant.kinematic_viscosity"},
                        .holds = [](const Inputs& in) { return stated_oil(in.loaded).has_value(); }}}};
}
template <class Inputs>
Conditional<Inputs> reliability_under_load() {
  return {.keys = {"life.reliability"},
          .premises = {{.on = {"load.radial", "load.axial", "load.moment", "load.moment_across"},
                        .holds = [](const Inputs& in) {
                          const bearing::equilibrium::RingLoad& load = in.loaded.load;
                          return is_nonzero(load.radial) || is_nonzero(load.axial) ||
                                 is_nonzero(load.moment) || is_nonzero(load.moment_across);
                        }}}};
}

// For the contamination factor, which a film has.
template <class Inputs>
Conditional<Inputs> lubrication() {
  return {.keys = {"life.lubrication"},
          .premises = {{.on = {"life.contamination_factor"},
                        .holds = [](const Inputs& in) { return !in.loaded.life.contamination_factor; },
                        .text = "where life.contamination_factor is not given"},
                       {.on = {"life.cleanliness", "lubricant.grade", "life.viscosity_ratio",
                               "lubricant.kinematic_viscosity"},
                        .holds = [](const Inputs& in) { return stated_oil(in.loaded).has_value(); }}}};
}

// An oil that is stated by a grade has a kinematic viscosity: for kappa, and for friction.
template <class Inputs>
std::vector<Conditional<Inputs>> conditions_of_grade(const std::vector<Premise<Inputs>>& friction) {
  const std::vector<std::string> keys{"lubricant.grade", "lubricant.temperature"};
  return {{.keys = keys,
           .premises = {{.on = {"life.viscosity_ratio"},
                         .holds = [](const Inputs& in) { return !in.loaded.life.viscosity_ratio; },
                         .text = "where life.viscosity_ratio is not given"}},
           .otherwise = Otherwise::not_modelled},
          {.keys = keys, .premises = friction, .otherwise = Otherwise::not_modelled}};
}

template <class Inputs>
Premise<Inputs> balls_move() {
  return {.on = {"operation.shaft_speed", "operation.outer_speed", "operation.speeds"},
          .holds = [](const Inputs& in) { return !is_at_rest(in); }};
}
template <class Inputs>
Premise<Inputs> balls_have_inertia() {
  return {.on = {"equilibrium.ball_inertia"},
          .holds = [](const Inputs& in) { return in.balls.inertia.enabled; },
          .value = "true"};
}
template <class Inputs>
Premise<Inputs> film_takes_part() {
  return {.on = {"film.enabled"}, .holds = [](const Inputs& in) { return in.balls.film; }, .value = "true"};
}

// The balls in static equilibrium.
template <class Inputs>
std::vector<Conditional<Inputs>> conditions_of_balls() {
  return {{.keys = {"film.enabled", "equilibrium."}, .premises = {balls_move<Inputs>()}},
          {.keys = {"material.density"},
           .premises = {balls_move<Inputs>(), balls_have_inertia<Inputs>()},
           .otherwise = Otherwise::not_modelled},
          {.keys = {"lubricant.viscosity", "lubricant.pressure_viscosity", "lubricant.grade",
                    "lubricant.temperature"},
           .premises = {film_takes_part<Inputs>()},
           .otherwise = Otherwise::not_modelled}};
}

template <class Item>
void append(std::vector<Item> more, std::vector<Item>& all) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

std::vector<Conditional<RollersUnderLoad>> RollersUnderLoad::conditions() {
  using In = RollersUnderLoad;
  const std::vector<Premise<In>> friction{oil_has_viscosity<In>(), rings_rotate<In>()};
  std::vector<Conditional<In>> all{
      {.keys = {"bearing.bore", "bearing.outside_diameter", "bearing.width", "material.density", "heat.",
                "lubricant.flow", "lubricant.share", "traction.starvation"},
       .premises = friction,
       .otherwise = Otherwise::not_modelled},
      {.keys = {"life.stress_riser"},  // with the least number both are one formula
       .premises = {{.on = {"bearing.laminae"},
                     .holds =
                         [](const In& in) {
                           return in.loaded.bearing.rollers().laminae != rating::kLeastRatedLaminae;
                         },
                     .text = "where bearing.laminae is not 30"}}},
      reliability_with_oil<In>(),
      reliability_under_load<In>(),
      lubrication<In>()};
  append(conditions_of_grade<In>({rings_rotate<In>()}), all);
  return all;
}

std::vector<Conditional<BallsUnderLoad>> BallsUnderLoad::conditions() {
  using In = BallsUnderLoad;
  const Premise<In> sized{.on = {"bearing.designation"},
                          .holds = [](const In& in) { return in.loaded.size.has_value(); }};
  std::vector<Conditional<In>> all = conditions_of_balls<In>();
  append({{.keys = {"material.density"},
           .premises = {oil_has_viscosity<In>(), rings_rotate<In>(), sized},
           .otherwise = Otherwise::not_modelled},
          reliability_with_oil<In>(),
          reliability_under_load<In>(),
          lubrication<In>()},
         all);
  append(conditions_of_grade<In>({rings_rotate<In>(), sized}), all);
  return all;
}

std::vector<Conditional<BallSupport>> BallSupport::conditions() {
  using In = BallSupport;
  std::vector<Conditional<In>> all = conditions_of_balls<In>();
  append({{.keys = {"operation.shaft_speed"},
           .premises = {{.on = {"operation.speeds"},
                         .holds = [](const In& in) { return in.speeds.empty(); },
                         .text = "where operation.speeds is not given"}},
           .otherwise = Otherwise::not_modelled},
          {.keys = {"operation.outer_speed"},
           .premises = {{.on = {"equilibrium.ball_inertia", "film.enabled"},
                         .holds = [](const In& in) { return in.balls.inertia.enabled || in.balls.film; },
                         .text = "where equilibrium.ball_inertia or film.enabled is true"}},
           .otherwise = Otherwise::not_modelled}},
         all);
  return all;
}

namespace {

namespace motion = bearing::motion;

Premise<BallsInTime> oil_is_stirred() {
  return {.on = {"drag.enabled"},
          .holds = [](const BallsInTime& in) { return moving_balls(in).drag.on; },
          .value = "true"};
}
Premise<BallsInTime> is_heated() {
  return {.on = {"heat.enabled"},
          .holds = [](const BallsInTime& in) { return in.simulation.heat.on; },
          .value = "true"};
}

std::vector<Conditional<BallsInTime>> conditions_of_oil_flow() {
  using In = BallsInTime;
  using namespace bearing::balls;
  return {
      {.keys = {"lubricant.share"},
       .premises = {{.on = {"lubricant.fill"},
                     .holds = [](const In& in) { return moving_balls(in).mixture.fill == OilFill::stated; },
                     .text = "where lubricant.fill is stated"}}},
      {.keys = {"lubricant.flow"},
       .premises = {{.on = {"drag.mixture"},
                     .holds = [](const In& in) { return moving_balls(in).mixture.motion == OilMotion::carried; },
                     .value = "carried"},
                    oil_is_stirred()}},
      {.keys = {"lubricant.flow"},
       .premises = {{.on = {"lubricant.fill"},
                     .holds = [](const In& in) { return moving_balls(in).mixture.fill == OilFill::parker; },
                     .value = "parker"},
                    oil_is_stirred()}},
      {.keys = {"lubricant.flow"}, .premises = {is_heated()}}};
}

std::vector<Conditional<BallsInTime>> conditions_of_heat() {
  using In = BallsInTime;
  return {
      {.keys = {"heat.inlet"},
       .premises = {{.on = {"lubricant.flow"},
                     .holds = [](const In& in) { return moving_balls(in).mixture.flow > 0.0; }}}},
      {.keys = {"heat.surroundings", "heat.contact_conductance", "heat.oil_conductance",
                "heat.fit_conductance", "heat.housing_conductance", "heat.shaft_conductance",
                "heat.expansion", "heat.sizes_temperature"},
       .premises = {{.on = {"heat.model"},
                     .holds =
                         [](const In& in) { return in.simulation.heat.model == system::HeatModel::network; },
                     .value = "network"}}},
      {.keys = {"bearing.outside_diameter"},  // of a ring that has a mass to be heated
       .premises = {is_heated()},
       .otherwise = Otherwise::not_modelled},
      {.keys = {"bearing.outside_diameter"},
       .premises = {{.on = {"bearing.designation", "bearing.bore"},
                     .holds = [](const In& in) { return in.loaded.bearing.inner.seat_diameter > 0.0; }}},
       .otherwise = Otherwise::not_modelled}};
}

}  // namespace

std::vector<Conditional<BallsInTime>> BallsInTime::conditions() {
  std::vector<Conditional<BallsInTime>> all = conditions_of_ball_friction<BallsInTime>();
  append(conditions_of_oil_flow(), all);
  append(conditions_of_heat(), all);
  append({reliability_with_oil<BallsInTime>(), lubrication<BallsInTime>()}, all);
  return all;
}

namespace {

void find_twice_stated(const equilibrium::RingLoad& load, mechanics::Problems& found) {
  for (const auto& [key, moment] :
       {std::pair{"load.moment", load.moment}, {"load.moment_across", load.moment_across}})
    if (moment != 0.0 && load.tilt)
      found.push_back({"load.tilt", std::string("a tilt together with ") + key +
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
  const char* laminae = "bearing.laminae";
  mechanics::Problems found;
  find_twice_stated(load, found);
  if (machine.laminae < 2) {
    for (const auto& [key, moment] :
         {std::pair{"load.moment", load.moment}, {"load.moment_across", load.moment_across}})
      if (moment != 0.0)
        found.push_back({laminae, std::string("a single lamina, which holds no moment; at least 2 laminae "
                                              "are required with ") +
                                      key});
    if (load.tilt.value_or(0.0) != 0.0)
      found.push_back({laminae,
                       "a single lamina, which is not affected by a tilt; at least 2 laminae are required "
                       "with load.tilt"});
  }
  if (!(load.radial > 0.0))
    found.push_back({"load.radial", "no load; a radial load greater than 0 N is required"});
  return found;
}

mechanics::Problems problems(const OilOfLife& machine) {
  const char *ratio = "life.viscosity_ratio", *viscosity = "lubricant.kinematic_viscosity",
             *factor = "life.contamination_factor", *level = "life.cleanliness";
  const LifeInputs& life = machine.life;
  mechanics::Problems found;
  if (machine.oil.grade) return found;  // a viscosity that is always there
  const bool of_ratio = life.viscosity_ratio.has_value(),
             of_oil = machine.oil.kinematic_viscosity.has_value();
  if (of_ratio && of_oil)
    found.push_back({viscosity, "a value together with life.viscosity_ratio; one of the two is required"});
  for (const auto& [key, stated] :
       {std::pair{factor, life.contamination_factor.has_value()}, {level, life.cleanliness.has_value()}})
    if (stated && !of_ratio && !of_oil)
      found.push_back({key,
                       "cleanliness without a viscosity; life.viscosity_ratio or "
                       "lubricant.kinematic_viscosity is required with it"});
  for (const auto& [key, stated] : {std::pair{ratio, of_ratio}, {viscosity, of_oil}})
    if (stated && !life.contamination_factor && !life.cleanliness)
      found.push_back({key,
                       "a viscosity without cleanliness; life.contamination_factor or life.cleanliness is "
                       "required with it"});
  return found;
}

// From the viscosity and the speed; a_ISO is known from a least value on.
mechanics::Problems problems(const ViscosityRatio& machine) {
  const BearingOil& oil = machine.oil.oil;
  if (machine.oil.life.viscosity_ratio || !oil.kinematic_viscosity) return {};
  const char* key = oil.grade ? "lubricant.grade" : "lubricant.kinematic_viscosity";
  const double speed = machine.rotation.relative(), viscosity = *oil.kinematic_viscosity;
  if (speed == 0.0)
    return {{key,
             "a viscosity for rings that do not rotate; operation.shaft_speed is required, from which the "
             "viscosity ratio follows"}};
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

void find_heat_without_flow(bool heated, system::HeatModel model, double flow, mechanics::Problems& found) {
  if (heated && model == system::HeatModel::oil && !(flow > 0.0))
    found.push_back({"heat.model",
                     "heat that leaves with the oil, without a flow; lubricant.flow greater than 0 L/min is "
                     "required"});
}

}  // namespace

mechanics::Problems problems(const OilOfRollers& machine) {
  const RollerOil& oil = machine.oil;
  mechanics::Problems found;
  find_heat_without_flow(oil.heated, oil.model, oil.flow, found);
  if (oil.heated && oil.model == system::HeatModel::network)
    found.push_back(
        {"heat.model", "a network of bodies for rollers; oil is required: rollers heat the oil alone"});
  append(motion::starvation_problems(oil.starvation, machine.size.has_value()), found);
  return found;
}

mechanics::Problems problems(const BallsInTime& machine) {
  const bearing::Bearing& bearing = machine.loaded.bearing;
  const bearing::balls::MotionParameters& motion = moving_balls(machine);
  const bearing::balls::MixtureParameters& mixture = motion.mixture;
  const system::HeatParameters& heat = machine.simulation.heat;
  const equilibrium::RingLoad& load = machine.loaded.load;
  mechanics::Problems found;
  if (!(motion.inner.mass > 0.0 && motion.inner.across > 0.0) &&
      !(bearing.inner.seat_diameter > 0.0 && bearing.width > 0.0))
    found.push_back({"simulation.duration",
                     "an inner ring in motion whose mass is not known; bearing.bore and bearing.width are "
                     "required, or rotor.mass and rotor.inertia"});
  const bool filled = motion.drag.on && mixture.fill == bearing::balls::OilFill::parker;
  if (filled && !(mixture.flow > 0.0))
    found.push_back({"lubricant.fill",
                     "a share of oil by the flow without a flow; lubricant.flow greater than 0 L/min is "
                     "required"});
  if (filled && machine.loaded.rotation.relative() == 0.0)
    found.push_back({"lubricant.fill",
                     "a share of oil by the speed of rings that do not rotate; operation.shaft_speed is "
                     "required"});
  find_heat_without_flow(heat.on, heat.model, mixture.flow, found);
  append(bearing::motion::starvation_problems(
             motion.race, bearing.inner.seat_diameter > 0.0 && bearing.outer.seat_diameter > 0.0),
         found);
  if (!(load.axial > 0.0 || load.radial > 0.0))
    found.push_back({"load.radial", "no load; a radial or axial load greater than 0 N is required"});
  return found;
}

}  // namespace orbearing::analysis
