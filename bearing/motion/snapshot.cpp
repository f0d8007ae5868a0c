#include "bearing/motion/snapshot.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "bearing/motion/instant.hpp"

namespace orbearing::bearing::motion {

namespace {

using boost::math::double_constants::two_pi;

constexpr double kDifferenceTime =
    1e-9;  // [s]  far below the shortest period, far above round-off in the speeds

double wrapped(double angle) {
  return angle - two_pi * std::floor(angle / two_pi);
}

void resize(RaceSnapshot& race, Eigen::Index rollers) {
  race.load.resize(rollers);
  race.sliding.resize(rollers);
  race.entrainment.resize(rollers);
  race.least_film.resize(rollers);
}

void resize(Snapshot& into, Eigen::Index rollers, bool cut, bool caged) {
  resize(into.inner, rollers);
  resize(into.outer, rollers);
  into.angle.resize(rollers);
  for (Eigen::ArrayXd* stand : {&into.inner_approach, &into.outer_approach, &into.end_displacement})
    stand->resize(cut ? rollers : 0);
  into.orbital_speed.resize(rollers);
  into.spin.resize(rollers);
  into.caged = caged;
  into.pocket_load.resize(caged ? rollers : 0);
  into.neighbour_load.resize(caged ? 0 : rollers);
  into.loss = {};
}

void record(const RaceForces& forces, const FilmContact& film, Eigen::Index j, RaceSnapshot& race) {
  race.load[j] = forces.load;
  race.sliding[j] = forces.sliding;
  race.entrainment[j] = forces.entrainment;
  race.least_film[j] = Film(film, forces.entrainment).least(forces.load);
}

void put_stand(const LaminaStand& stand, Eigen::Index j, Snapshot& into) {
  into.inner_approach[j] = stand.inner_approach;
  into.outer_approach[j] = stand.outer_approach;
  into.end_displacement[j] = stand.end_displacement;
}

void add_neighbour(const NeighbourTouch& ahead, Eigen::Index j, Snapshot& into) {
  into.neighbour_load[j] = ahead.load;
  into.loss.neighbours += ahead.damping_power + ahead.friction_power;
}

void add_losses(const BearingModel& model, const RollerBody& roller, const RollerForces& forces,
                PowerLoss& loss) {
  loss.race_damping += forces.inner.damping_power + forces.outer.damping_power + forces.tilt_power;
  loss.inner_traction += forces.inner.traction_power;
  loss.outer_traction += forces.outer.traction_power;
  loss.rolling += forces.inner.rolling_power + forces.outer.rolling_power;
  loss.pockets += forces.pocket.damping_power + forces.pocket.friction_power + forces.pocket.film_power;
  loss.drag += model.orbit_drag.power(roller.radius * roller.orbital_speed) +
               model.spin_drag.power(roller.motion.speed);
}

double kinetic(const BodyInertia& body, const BodyMotion& motion) {
  return 0.5 * body.mass * motion.velocity.squaredNorm() + 0.5 * body.inertia * motion.speed * motion.speed;
}

double centrifugal(const CarrierFrame& frame, double mass, double orbit_radius, const Vector2& position) {
  return -0.5 * mass * frame.centrifugal * (position + Vector2(orbit_radius, 0.0)).squaredNorm();
}

double elastic_energy(const RaceModel& model, double elastic_approach) {
  return elastic_approach > 0.0 ? model.load.elastic().energy(elastic_approach) : 0.0;
}

// Both contacts of a roller. What the film holds is that of the straight contact.
double contact_energy(const BearingModel& model, const RingBodies& rings, const RollerBody& roller,
                      Eigen::Index j) {
  const RollerSurface surface = surface_of(model, j);
  const double straight = race_energy(model.inner, roller.motion, rings.pin, surface) +
                          race_energy(model.outer, roller.motion, rings.bore, surface, rings.waves);
  if (!model.laminae) return straight;
  const LaminaStand stand = roller_contacts(model, rings, roller, j).stand;
  return straight - elastic_energy(model.inner, stand.inner_approach) -
         elastic_energy(model.outer, stand.outer_approach) + model.laminae->energy(stand, roller.outward);
}

void add_roller_energy(const BearingModel& model, const CarrierFrame& frame, const RingBodies& rings,
                       const RollerBody& roller, Eigen::Index j, StoredEnergy& energy) {
  const double larger = model.radius_deviation[static_cast<std::size_t>(j)];
  const BodyMotion& motion = roller.motion;
  energy.kinetic += kinetic(model.roller, motion);
  energy.centrifugal += centrifugal(frame, model.roller.mass, frame.orbit_radius, motion.position);
  energy.races += contact_energy(model, rings, roller, j);
  if (model.layout.caged)
    energy.pockets += pocket_energy(model.pocket, motion.position, rings.cage.position,
                                    pocket_direction(model, rings, j), larger);
}

double rim_damping(const BearingModel& model, const ConstStateViews& state) {
  double power = 0.0;
  for (Eigen::Index i = 0; i < model.layout.waves; ++i)
    power += model.rim.damping[i] * state.wave_speed[i] * state.wave_speed[i];
  return power;
}

void add_rim_energy(const BearingModel& model, const ConstStateViews& state, double time,
                    StoredEnergy& energy) {
  const double meshes = mesh_ratio(model.driving, time);
  for (Eigen::Index i = 0; i < model.layout.waves; ++i) {
    const double beyond = state.wave[i] - meshes * model.rim.at_rest[i];
    energy.rim += 0.5 * model.rim.stiffness[i] * beyond * beyond;
    energy.kinetic += 0.5 * model.rim.mass[i] * state.wave_speed[i] * state.wave_speed[i];
  }
}

// Of teeth whose forces on the waves fall in a run-up.
double teeth_power(const BearingModel& model, const ConstStateViews& state, double time) {
  const double meshes = mesh_ratio(model.driving, time), slope = -model.driving.ramp * meshes * meshes;
  double power = 0.0;
  for (Eigen::Index i = 0; i < model.layout.waves; ++i)
    power -= model.rim.stiffness[i] * (state.wave[i] - meshes * model.rim.at_rest[i]) * slope *
             model.rim.at_rest[i];
  return power;
}

// Wrenches on the rings alone, without what is reported per roller, and the power that out-of-round races
// give.
RingWrenches ring_wrenches(const BearingModel& model, const ConstStateViews& state, const RingBodies& rings,
                           double& out_of_roundness) {
  RingWrenches sum;
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    const RollerForces forces = roller_forces(model, rings, roller_body(model, state, j), j);
    out_of_roundness += forces.held_tilt - forces.inner.form_power - forces.outer.form_power;
    sum.add(forces);
  }
  sum.add(guidance_forces(model.guidance, rings.cage, land_body(model, rings)), model.guiding_race);
  return sum;
}

double euler_power(const BearingModel& model, const ConstStateViews& state, const RingBodies& rings) {
  CarrierFrame only;
  only.euler = model.frame.euler;
  const auto power_on = [&](double mass, double orbit_radius, const BodyMotion& body) {
    only.orbit_radius = orbit_radius;
    return mass * inertial_acceleration(only, body.position, Vector2::Zero()).dot(body.velocity);
  };
  const double orbit_radius = model.frame.orbit_radius;
  double power = power_on(model.cage.mass, orbit_radius, rings.cage) +
                 power_on(model.pin_mass, orbit_radius, rings.pin) +
                 power_on(model.bore_mass, 0.0, rings.bore) -
                 model.cage.inertia * only.euler * rings.cage.speed;
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    const BodyMotion roller = roller_body(model, state, j).motion;
    power +=
        power_on(model.roller.mass, orbit_radius, roller) - model.roller.inertia * only.euler * roller.speed;
  }
  return power;
}

double entrainment(const RaceModel& race, const BodyMotion& roller, const RollerSurface& surface,
                   const BodyMotion& ring) {
  return entrainment_speed(race_motion(race, roller, surface, ring).contact.rolling, race.entrainment_scale);
}

double changing_film_power(const BearingModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                           const Eigen::Ref<const Eigen::VectorXd>& dx) {
  const Eigen::VectorXd before = x - kDifferenceTime * dx;
  const Eigen::VectorXd after = x + kDifferenceTime * dx;
  const ConstStateViews views[] = {state_views(model.layout, before.data()),
                                   state_views(model.layout, x.data()),
                                   state_views(model.layout, after.data())};
  const RingBodies rings[] = {ring_bodies(model, views[0], time - kDifferenceTime),
                              ring_bodies(model, views[1], time),
                              ring_bodies(model, views[2], time + kDifferenceTime)};
  double power = 0.0;
  const auto add = [&](const RaceModel& race, const BodyMotion RingBodies::*ring, Eigen::Index j) {
    const RollerSurface surface = surface_of(model, j);
    const BodyMotion now = roller_body(model, views[1], j).motion;
    const double speed = entrainment(race, now, surface, rings[1].*ring);
    const double change = entrainment(race, roller_body(model, views[2], j).motion, surface, rings[2].*ring) -
                          entrainment(race, roller_body(model, views[0], j).motion, surface, rings[0].*ring);
    const RaceWaves waves = &race == &model.outer ? rings[1].waves : RaceWaves{};
    const double approach = race_motion(race, now, surface, rings[1].*ring, waves).contact.approach;
    power += race.load.energy_slope(approach, speed) * change / (2.0 * kDifferenceTime);
  };
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    add(model.inner, &RingBodies::pin, j);
    add(model.outer, &RingBodies::bore, j);
  }
  return power;
}

}  // namespace

RollerLoads loads_of(const Snapshot& snapshot) {
  return {snapshot.angle.data(),          snapshot.orbital_speed.data(),  snapshot.inner.load.data(),
          snapshot.outer.load.data(),     snapshot.race_speeds,           snapshot.laminae,
          snapshot.inner_approach.data(), snapshot.outer_approach.data(), snapshot.end_displacement.data()};
}

Snapshot snapshot(const BearingModel& model, const Eigen::Ref<const Eigen::VectorXd>& x, double time) {
  Snapshot result;
  take_snapshot(model, x, result, time);
  return result;
}

void take_snapshot(const BearingModel& model, const Eigen::Ref<const Eigen::VectorXd>& x, Snapshot& into,
                   double time) {
  const ConstStateViews state = state_views(model.layout, x.data());
  const RingBodies rings = ring_bodies(model, state, time);
  RingWrenches on_rings;
  into.laminae = cut_races(model);
  resize(into, model.layout.rollers, into.laminae != nullptr, model.layout.caged);
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    const RollerBody roller = roller_body(model, state, j);
    const RollerForces forces = roller_forces(model, rings, roller, j);
    record(forces.inner, model.inner_film, j, into.inner);
    record(forces.outer, model.outer_film, j, into.outer);
    into.angle[j] = wrapped(roller.angle);
    into.orbital_speed[j] = roller.orbital_speed;
    into.spin[j] = roller.motion.speed;
    if (into.laminae) put_stand(forces.stand, j, into);
    if (model.layout.caged)
      into.pocket_load[j] = forces.pocket.load;
    else
      add_neighbour(neighbour_forces(model, state, roller, j).ahead, j, into);
    add_losses(model, roller, forces, into.loss);
    on_rings.add(forces);
  }
  const GuidanceForces guidance = guidance_forces(model.guidance, rings.cage, land_body(model, rings));
  on_rings.add(guidance, model.guiding_race);
  into.loss.guidance = guidance.film_power + guidance.touch_down_power;
  into.loss.drag += model.cage_drag.power(rings.cage.speed);
  into.loss.support = model.support.power(rings.pin.velocity);
  into.loss.race_damping += rim_damping(model, state);
  into.waves = state.wave;
  into.race_speeds = race_speeds(model.geometry, rings.pin.speed, rings.bore.speed);
  into.orbit_angle = model.layout.caged ? state.cage_angle : state.angle.mean();
  into.orbit_speed = model.layout.caged ? rings.cage.speed : state.orbital_speed.mean();
  into.cage_position = rings.cage.position;
  into.cage_eccentricity = guidance.eccentricity;
  into.bore_friction_moment = on_rings.bore.moment;
}

StoredEnergy stored_energy(const BearingModel& model, const Eigen::Ref<const Eigen::VectorXd>& x,
                           double time) {
  const ConstStateViews state = state_views(model.layout, x.data());
  const CarrierFrame frame = frame_at(model, time);
  const RingBodies rings = ring_bodies(model, state, time);
  StoredEnergy energy;
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    const RollerBody roller = roller_body(model, state, j);
    add_roller_energy(model, frame, rings, roller, j, energy);
    energy.neighbours += neighbour_forces(model, state, roller, j).ahead.energy;
  }
  energy.kinetic += kinetic(model.cage, rings.cage) +
                    0.5 * model.bore_mass * rings.bore.velocity.squaredNorm() +
                    0.5 * model.pin_mass * rings.pin.velocity.squaredNorm();
  energy.centrifugal += centrifugal(frame, model.cage.mass, frame.orbit_radius, rings.cage.position) +
                        centrifugal(frame, model.pin_mass, frame.orbit_radius, rings.pin.position) +
                        centrifugal(frame, model.bore_mass, 0.0, rings.bore.position);
  energy.guidance = guidance_energy(model.guidance, rings.cage.position, land_body(model, rings).position);
  energy.support = model.support.energy(rings.pin.position);
  add_rim_energy(model, state, time, energy);
  return energy;
}

PowerInput power_input(const BearingModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                       const Eigen::Ref<const Eigen::VectorXd>& dx) {
  const ConstStateViews state = state_views(model.layout, x.data());
  const RingBodies rings = ring_bodies(model, state, time);
  double out_of_roundness = 0.0;
  const RingWrenches on_rings = ring_wrenches(model, state, rings, out_of_roundness);
  const double ramp = model.driving.ramp / speed_ratio(model.driving, time);
  return {.bore_load = bore_load(model, time).dot(rings.bore.velocity),
          .rotations = -on_rings.bore.moment * rings.bore.speed - on_rings.pin.moment * rings.pin.speed,
          .euler = euler_power(model, state, rings),
          .changing_film = changing_film_power(model, time, x, dx),
          .out_of_roundness = out_of_roundness,
          .changing_frame = 2.0 * ramp * stored_energy(model, x, time).centrifugal,
          .teeth = teeth_power(model, state, time)};
}

}  // namespace orbearing::bearing::motion
