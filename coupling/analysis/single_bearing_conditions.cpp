// Conditions under which inputs of a single bearing have an effect (single_bearing.hpp).
#include <algorithm>

#include "coupling/analysis/friction_conditions.hpp"
#include "coupling/analysis/single_bearing.hpp"
#include "mechanics/append.hpp"
#include "mechanics/member_keys.hpp"

namespace orbearing::analysis {

namespace rating = bearing::rating;

namespace {

using mechanics::append;
using mechanics::Conditional;
template <class Inputs>
using Keys = mechanics::MemberKeys<Inputs>;
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
Premise<Inputs> rings_rotate(const Inputs& m, const Keys<Inputs>& key) {
  return {.on = {key(rotation(m).shaft_speed), key(rotation(m).outer_speed)},
          .holds = [](const Inputs& in) { return rotation(in).relative() != 0.0; }};
}

template <class Inputs>
Premise<Inputs> oil_has_viscosity(const Inputs& m, const Keys<Inputs>& key) {
  return {.on = {key(m.loaded.oil.stated.grade), key(m.loaded.oil.kinematic_viscosity)},
          .holds = [](const Inputs& in) { return in.loaded.oil.kinematic_viscosity.has_value(); }};
}

// a_1 is a result of any load at rest, and a part of the lives with an oil.
template <class Inputs>
Conditional<Inputs> reliability_with_oil(const Inputs& m, const Keys<Inputs>& key) {
  const LifeInputs& life = m.loaded.life;
  const BearingOil& oil = m.loaded.oil;
  return {.keys = {key(life.reliability)},
          .premises = {{.on = {key(oil.stated.grade), key(life.cleanliness), key(life.contamination_factor),
                               key(life.viscosity_ratio), key(oil.kinematic_viscosity)},
                        .holds = [](const Inputs& in) { return stated_oil(in.loaded).has_value(); }}}};
}
template <class Inputs>
Conditional<Inputs> reliability_under_load(const Inputs& m, const Keys<Inputs>& key) {
  const bearing::equilibrium::RingLoad& of = m.loaded.load;
  return {.keys = {key(m.loaded.life.reliability)},
          .premises = {
              {.on = key.of(of.radial, of.axial, of.moment, of.moment_across), .holds = [](const Inputs& in) {
                 const bearing::equilibrium::RingLoad& load = in.loaded.load;
                 return is_nonzero(load.radial) || is_nonzero(load.axial) || is_nonzero(load.moment) ||
                        is_nonzero(load.moment_across);
               }}}};
}

// For the contamination factor, which a film has.
template <class Inputs>
Conditional<Inputs> lubrication(const Inputs& m, const Keys<Inputs>& key) {
  const LifeInputs& life = m.loaded.life;
  const BearingOil& oil = m.loaded.oil;
  return {.keys = {key(life.lubrication)},
          .premises = {{.on = {key(life.contamination_factor)},
                        .holds = [](const Inputs& in) { return !in.loaded.life.contamination_factor; },
                        .text = "where " + key(life.contamination_factor) + " is not given"},
                       {.on = {key(life.cleanliness), key(oil.stated.grade), key(life.viscosity_ratio),
                               key(oil.kinematic_viscosity)},
                        .holds = [](const Inputs& in) { return stated_oil(in.loaded).has_value(); }}}};
}

// An oil that is stated by a grade has a kinematic viscosity: for kappa, and for friction.
template <class Inputs>
std::vector<Conditional<Inputs>> conditions_of_grade(const Inputs& m, const Keys<Inputs>& key,
                                                     const std::vector<Premise<Inputs>>& friction) {
  const std::vector<std::string> keys{key(m.loaded.oil.stated.grade), key(m.loaded.oil.stated.temperature)};
  const std::string& ratio = key(m.loaded.life.viscosity_ratio);
  return {{.keys = keys,
           .premises = {{.on = {ratio},
                         .holds = [](const Inputs& in) { return !in.loaded.life.viscosity_ratio; },
                         .text = "where " + ratio + " is not given"}},
           .otherwise = Otherwise::not_modelled},
          {.keys = keys, .premises = friction, .otherwise = Otherwise::not_modelled}};
}

template <class Inputs>
Premise<Inputs> balls_move(const Inputs& m, const Keys<Inputs>& key) {
  return {.on = {key(rotation(m).shaft_speed), key(rotation(m).outer_speed), key(m.speeds)},
          .holds = [](const Inputs& in) { return !is_at_rest(in); }};
}
template <class Inputs>
Premise<Inputs> balls_have_inertia(const Inputs& m, const Keys<Inputs>& key) {
  return {.on = {key(m.balls.inertia.enabled)},
          .holds = [](const Inputs& in) { return in.balls.inertia.enabled; },
          .value = "true"};
}
template <class Inputs>
Premise<Inputs> film_takes_part(const Inputs& m, const Keys<Inputs>& key) {
  return {
      .on = {key(m.balls.film)}, .holds = [](const Inputs& in) { return in.balls.film; }, .value = "true"};
}

const BearingOil& oil_of(const BallSupport& in) {
  return in.oil;
}
const BearingOil& oil_of(const BallsUnderLoad& in) {
  return in.loaded.oil;
}
const bearing::Bearing& bearing_of(const BallSupport& in) {
  return in.bearing;
}
const bearing::Bearing& bearing_of(const BallsUnderLoad& in) {
  return in.loaded.bearing;
}

// The balls in static equilibrium.
template <class Inputs>
std::vector<Conditional<Inputs>> conditions_of_balls(const Inputs& m, const Keys<Inputs>& key) {
  const BearingOil& oil = oil_of(m);
  return {{.keys = key.within(m.balls), .premises = {balls_move(m, key)}},
          {.keys = {key(bearing_of(m).material.density)},
           .premises = {balls_move(m, key), balls_have_inertia(m, key)},
           .otherwise = Otherwise::not_modelled},
          {.keys = {key(oil.lubricant.viscosity), key(oil.lubricant.pressure_viscosity),
                    key(oil.stated.grade), key(oil.stated.temperature)},
           .premises = {film_takes_part(m, key)},
           .otherwise = Otherwise::not_modelled}};
}

}  // namespace

std::vector<Conditional<RollersUnderLoad>> RollersUnderLoad::conditions() {
  using In = RollersUnderLoad;
  const In m;
  const Keys<In> key(m);
  const bearing::Bearing& of = m.loaded.bearing;
  const std::vector<Premise<In>> friction{oil_has_viscosity(m, key), rings_rotate(m, key)};
  std::vector<std::string> of_friction = key.within(m.oil);
  append({key(of.inner.seat_diameter), key(of.outer.seat_diameter), key(of.width), key(of.material.density)},
         of_friction);
  std::vector<Conditional<In>> all{
      {.keys = of_friction, .premises = friction, .otherwise = Otherwise::not_modelled},
      {.keys = {key(m.life.stress_riser)},  // with the least number both are one formula
       .premises = {{.on = {key(of.rollers().laminae)},
                     .holds =
                         [](const In& in) {
                           return in.loaded.bearing.rollers().laminae != rating::kLeastRatedLaminae;
                         },
                     .text = "where " + key(of.rollers().laminae) + " is not 30"}}},
      reliability_with_oil(m, key),
      reliability_under_load(m, key),
      lubrication(m, key)};
  append(conditions_of_grade(m, key, {rings_rotate(m, key)}), all);
  return all;
}

std::vector<Conditional<BallsUnderLoad>> BallsUnderLoad::conditions() {
  using In = BallsUnderLoad;
  const In m;
  const Keys<In> key(m);
  const bearing::Bearing& of = m.loaded.bearing;
  const std::vector<std::string> sizes{key(of.inner.seat_diameter), key(of.outer.seat_diameter),
                                       key(of.width)};
  const std::string& designation = key(m.loaded.catalogue.designation);
  Premise<In> sized{.on = sizes,
                    .holds = [](const In& in) { return in.loaded.size.has_value(); },
                    .text = "where " + designation + ", or " + sizes[0] + ", " + sizes[1] + " and " +
                            sizes[2] + " are given"};
  sized.on.push_back(designation);
  std::vector<Conditional<In>> all = conditions_of_balls(m, key);
  append({{.keys = sizes,
           .premises = {oil_has_viscosity(m, key), rings_rotate(m, key), sized},
           .otherwise = Otherwise::not_modelled},
          {.keys = {key(m.loaded.bearing.material.density)},
           .premises = {oil_has_viscosity(m, key), rings_rotate(m, key), sized},
           .otherwise = Otherwise::not_modelled},
          reliability_with_oil(m, key),
          reliability_under_load(m, key),
          lubrication(m, key)},
         all);
  append(conditions_of_grade(m, key, {rings_rotate(m, key), sized}), all);
  return all;
}

std::vector<Conditional<BallSupport>> BallSupport::conditions() {
  using In = BallSupport;
  const In m;
  const Keys<In> key(m);
  const std::string &inertia = key(m.balls.inertia.enabled), &film = key(m.balls.film);
  std::vector<Conditional<In>> all = conditions_of_balls(m, key);
  append({{.keys = {key(m.rotation.shaft_speed)},
           .premises = {{.on = {key(m.speeds)},
                         .holds = [](const In& in) { return in.speeds.empty(); },
                         .text = "where " + key(m.speeds) + " is not given"}},
           .otherwise = Otherwise::not_modelled},
          {.keys = {key(m.rotation.outer_speed)},
           .premises = {{.on = {inertia, film},
                         .holds = [](const In& in) { return in.balls.inertia.enabled || in.balls.film; },
                         .text = "where " + inertia + " or " + film + " is true"}},
           .otherwise = Otherwise::not_modelled}},
         all);
  return all;
}

namespace {

namespace motion = bearing::motion;

using KeysInTime = Keys<BallsInTime>;

Premise<BallsInTime> oil_is_stirred(const BallsInTime& m, const KeysInTime& key) {
  return {.on = {key(moving_balls(m).drag.on)},
          .holds = [](const BallsInTime& in) { return moving_balls(in).drag.on; },
          .value = "true"};
}
Premise<BallsInTime> is_heated(const BallsInTime& m, const KeysInTime& key) {
  return {.on = {key(m.simulation.heat.on)},
          .holds = [](const BallsInTime& in) { return in.simulation.heat.on; },
          .value = "true"};
}

std::vector<Conditional<BallsInTime>> conditions_of_oil_flow(const BallsInTime& m, const KeysInTime& key) {
  using In = BallsInTime;
  using namespace bearing::balls;
  const MixtureParameters& mixture = moving_balls(m).mixture;
  const std::string &fill = key(mixture.fill), &flow = key(mixture.flow);
  return {
      {.keys = {key(moving_balls(m).drag.oil_share)},
       .premises = {{.on = {fill},
                     .holds = [](const In& in) { return moving_balls(in).mixture.fill == OilFill::stated; },
                     .text = "where " + fill + " is stated"}}},
      {.keys = {flow},
       .premises = {{.on = {key(mixture.motion)},
                     .holds =
                         [](const In& in) { return moving_balls(in).mixture.motion == OilMotion::carried; },
                     .value = "carried"},
                    oil_is_stirred(m, key)}},
      {.keys = {flow},
       .premises = {{.on = {fill},
                     .holds = [](const In& in) { return moving_balls(in).mixture.fill == OilFill::parker; },
                     .value = "parker"},
                    oil_is_stirred(m, key)}},
      {.keys = {flow}, .premises = {is_heated(m, key)}}};
}

std::vector<Conditional<BallsInTime>> conditions_of_heat(const BallsInTime& m, const KeysInTime& key) {
  using In = BallsInTime;
  const system::HeatParameters& heat = m.simulation.heat;
  const bearing::Bearing& of = m.loaded.bearing;
  return {
      {.keys = {key(heat.inlet)},
       .premises = {{.on = {key(moving_balls(m).mixture.flow)},
                     .holds = [](const In& in) { return moving_balls(in).mixture.flow > 0.0; }}}},
      {.keys = {key(heat.surroundings), key(heat.contact), key(heat.to_oil), key(heat.fit), key(heat.housing),
                key(heat.shaft), key(heat.expansion), key(heat.sizes_at)},
       .premises = {{.on = {key(heat.model)},
                     .holds =
                         [](const In& in) { return in.simulation.heat.model == system::HeatModel::network; },
                     .value = "network"}}},
      {.keys = {key(of.outer.seat_diameter)},  // of a ring that has a mass to be heated
       .premises = {is_heated(m, key)},
       .otherwise = Otherwise::not_modelled},
      {.keys = {key(of.outer.seat_diameter)},
       .premises = {{.on = {key(m.loaded.catalogue.designation), key(of.inner.seat_diameter)},
                     .holds = [](const In& in) { return in.loaded.bearing.inner.seat_diameter > 0.0; }}},
       .otherwise = Otherwise::not_modelled}};
}

}  // namespace

std::vector<std::string> BallsInTime::refused() {
  const BallsInTime m;
  return {KeysInTime(m)(m.loaded.load.tilt)};
}

std::vector<Conditional<BallsInTime>> BallsInTime::conditions() {
  const BallsInTime m;
  const KeysInTime key(m);
  std::vector<Conditional<BallsInTime>> all = conditions_of_ball_friction(m, key);
  append(conditions_of_oil_flow(m, key), all);
  append(conditions_of_heat(m, key), all);
  append({reliability_with_oil(m, key), lubrication(m, key)}, all);
  return all;
}

}  // namespace orbearing::analysis
