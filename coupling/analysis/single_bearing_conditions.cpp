// Conditions under which inputs of a single bearing have an effect (single_bearing.hpp).
#include <algorithm>

#include "coupling/analysis/friction_conditions.hpp"
#include "coupling/analysis/single_bearing.hpp"
#include "mechanics/append.hpp"

namespace orbearing::analysis {

namespace rating = bearing::rating;

namespace {

using mechanics::append;
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
                     .holds =
                         [](const In& in) { return moving_balls(in).mixture.motion == OilMotion::carried; },
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

}  // namespace orbearing::analysis
