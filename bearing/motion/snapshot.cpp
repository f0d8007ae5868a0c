#include "bearing/motion/snapshot.hpp"

#include <array>
#include <cmath>

#include "bearing/motion/model_constants.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::motion {

namespace {

using constants::two_pi;

using vectorised::ObservedRoller;
using vectorised::Surroundings;
using Contact = vectorised::ObservedContact<double>;

constexpr double kDifferenceTime =
    1e-9;  // [s]  far below the shortest period, far above round-off in the speeds

// Between a roller and its pocket: touch and, where there is one, film.
struct PocketTouch {
  double load = 0.0;    // [N]  positive where the roller pushes the cage in the sense of rotation
  double power = 0.0;   // [W]  lost
  double energy = 0.0;  // [J]
};

PocketTouch pocket_touch(const PocketLaw& law, double stated_radius, double deviation,
                         const BodyMotion& roller, const BodyMotion& cage, const Vector2& outward) {
  const Vector2 ahead = across(outward), from_cage = roller.position - cage.position;
  const Vector2 velocity = roller.velocity - cage.velocity;
  const PocketMotion motion{from_cage.dot(ahead),  from_cage.dot(outward), velocity.dot(ahead),
                            velocity.dot(outward), roller.speed,           cage.speed};
  const double radius = stated_radius + deviation, bar = std::copysign(1.0, motion.offset);
  PocketTouch all;
  if (const double depth = law.depth(bar, motion.offset, deviation); depth > 0.0) {
    const auto touch = law.touch(bar, radius, deviation, motion);
    all = {-touch.ahead, touch.power + touch.along * touch.sliding, 0.5 * law.stiffness * depth * depth};
  }
  if (law.with_film()) {
    const auto oil = law.oil(radius, deviation, motion);
    all.load -= oil.ahead;
    all.power += oil.power;
  }
  return all;
}

// All bodies in one state, and what can be read off the rollers.
class Instant {
 public:
  Instant(const BearingModel& model, const Surroundings& now, const Eigen::Ref<const Eigen::VectorXd>& x)
      : model_(model),
        state(state_views(model.layout, x.data())),
        frame(now.frame),
        bore{state.bore_position, state.bore_velocity, now.bore.speed, now.bore.turned},
        pin{state.pin_position, state.pin_velocity, now.pin.speed, now.pin.turned},
        seen(vectorised::observed_rollers(model, now, x)) {
    if (!model.layout.caged) return;
    cage = {state.cage_position, state.cage_velocity, state.cage_speed};
    cage_direction_ = direction(state.cage_angle);
    if (!model.land.present) return;
    const Vector2 offset = cage.position - land().position, velocity = cage.velocity - land().velocity;
    guidance = model.land.law.force(
        LandMotion<double>{offset.x(), offset.y(), velocity.x(), velocity.y(), cage.speed}, land().speed);
  }

  Vector2 outward(Eigen::Index j) const { return direction(state.angle[j]); }
  BodyMotion roller(Eigen::Index j) const {
    const Vector2 out = outward(j);
    return {state.radius[j] * out,
            state.radial_speed[j] * out + state.radius[j] * state.orbital_speed[j] * across(out),
            state.spin[j]};
  }
  const ObservedRoller& seen_at(Eigen::Index j) const { return seen[static_cast<std::size_t>(j)]; }

  PocketTouch pocket(Eigen::Index j) const {
    if (!model_.layout.caged) return {};
    const auto i = static_cast<std::size_t>(j);
    const Vector2& own = model_.pocket_direction[i];
    return pocket_touch(model_.pocket, model_.geometry.element_radius, model_.radius_deviation[i], roller(j),
                        cage, own.x() * cage_direction_ + own.y() * across(cage_direction_));
  }
  RollerApproaches stand(Eigen::Index j) const {
    return {seen_at(j).inner.elastic_approach, seen_at(j).outer.elastic_approach,
            model_.layout.tilting ? state.end_displacement[j] : 0.0};
  }
  const BodyMotion& land() const { return model_.land.on_bore ? bore : pin; }

  // Wrench of rollers and land on a ring, about its centre.
  Wrench on_ring(Race race) const {
    const bool inner = race == Race::inner;
    Wrench sum;
    for (Eigen::Index j = 0; j < model_.layout.rollers; ++j) {
      const Contact& contact = inner ? seen_at(j).inner : seen_at(j).outer;
      const Vector2 out = outward(j), force = contact.f_r * out + contact.f_t * across(out);
      const Vector2 arm = state.radius[j] * out - (inner ? pin : bore).position;
      sum += {-force, -contact.moment - cross(arm, force)};
    }
    if (inner != model_.land.on_bore) sum += {{-guidance.x, -guidance.y}, guidance.on_land};
    return sum;
  }

 private:
  const BearingModel& model_;
  Vector2 cage_direction_ = Vector2::UnitX();

 public:
  ConstStateViews state;
  CarrierFrame frame;
  BodyMotion bore, pin;
  BodyMotion cage{Vector2::Zero(), Vector2::Zero()};  // at rest where there is none
  LandForce<double> guidance{};
  std::vector<ObservedRoller> seen;
};

// Power lost by the tilting of a roller, and power that holds the bore's tilt while the roller passes through
// it [W].
struct TiltPower {
  double lost = 0.0;
  double held = 0.0;
};

TiltPower tilt_power(const BearingModel& model, const Instant& now, Eigen::Index j,
                     const double* rate = nullptr) {
  if (!model.layout.tilting) return {};
  const Vector2 outward = now.outward(j);
  const LaminaRaceLoads loads = model.laminae->loads(now.stand(j), outward);
  const double passing =
      model.laminae->bore_end_displacement().dot(across(outward)) * now.state.orbital_speed[j];
  const double resistance = model.laminae->resistance(),
               speed = rate ? rate[j] : loads.excess / resistance;  // [m/s]
  return {resistance * speed * speed, -loads.outer_end_load * passing};
}

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

void record(const Contact& contact, const FilmContact& film, const FilmHeating& heating, Eigen::Index j,
            RaceSnapshot& race) {
  race.load[j] = contact.load;
  race.sliding[j] = contact.sliding;
  race.entrainment[j] = contact.entrainment;
  race.least_film[j] = Film(film, contact.entrainment).least(contact.load) *
                       heating.share(film, contact.load, contact.entrainment, contact.sliding);
}

void put_stand(const RollerApproaches& stand, Eigen::Index j, Snapshot& into) {
  into.inner_approach[j] = stand.inner_approach;
  into.outer_approach[j] = stand.outer_approach;
  into.end_displacement[j] = stand.end_displacement;
}

void add_losses(const BearingModel& model, const Instant& now, Eigen::Index j, const double* tilt_rate,
                PowerLoss& loss) {
  const auto& [inner, outer, neighbour_load, neighbour_energy, neighbour_power] = now.seen_at(j);
  loss.race_damping += inner.damping_power + outer.damping_power + tilt_power(model, now, j, tilt_rate).lost;
  loss.inner_traction += inner.traction_power;
  loss.outer_traction += outer.traction_power;
  loss.rolling += inner.rolling_power + outer.rolling_power;
  loss.neighbours += neighbour_power;
  loss.drag += model.orbit_drag.power(now.state.radius[j] * now.state.orbital_speed[j]) +
               model.spin_drag.power(now.state.spin[j]);
}

double kinetic(const BodyInertia& body, const BodyMotion& motion) {
  return 0.5 * body.mass * motion.velocity.squaredNorm() + 0.5 * body.inertia * motion.speed * motion.speed;
}

double centrifugal(const CarrierFrame& frame, double mass, double orbit_radius, const Vector2& position) {
  return -0.5 * mass * frame.centrifugal * (position + Vector2(orbit_radius, 0.0)).squaredNorm();
}

double elastic_energy(const RaceModel& race, double elastic_approach) {
  return elastic_approach > 0.0 ? LineContact(race.stiffness).energy(elastic_approach) : 0.0;
}

// Both contacts of a roller. The energy of the film is that of the straight contact.
double contact_energy(const BearingModel& model, const Instant& now, Eigen::Index j) {
  const auto stored = [](const RaceModel& race, const Contact& contact) {
    return race_energy(race, contact.elastic_approach, contact.entrainment);
  };
  const double straight =
      stored(model.inner, now.seen_at(j).inner) + stored(model.outer, now.seen_at(j).outer);
  if (!model.laminae) return straight;
  const RollerApproaches stand = now.stand(j);
  return straight - elastic_energy(model.inner, stand.inner_approach) -
         elastic_energy(model.outer, stand.outer_approach) + model.laminae->energy(stand, now.outward(j));
}

double rim_damping(const BearingModel& model, const ConstStateViews& state) {
  double power = 0.0;
  for (Eigen::Index i = 0; i < model.layout.waves; ++i)
    power += model.rim[static_cast<std::size_t>(i)].damping * state.wave_speed[i] * state.wave_speed[i];
  return power;
}

void add_rim_energy(const BearingModel& model, const ConstStateViews& state, double meshes,
                    StoredEnergy& energy) {
  for (Eigen::Index i = 0; i < model.layout.waves; ++i) {
    const vectorised::RimWave& wave = model.rim[static_cast<std::size_t>(i)];
    const double beyond = state.wave[i] - meshes * wave.at_rest;
    energy.rim += 0.5 * wave.stiffness * beyond * beyond;
    energy.kinetic += 0.5 * wave.mass * state.wave_speed[i] * state.wave_speed[i];
  }
}

// Power of teeth whose forces on the waves change at `slope` [1/s] of their means.
double teeth_power(const BearingModel& model, const ConstStateViews& state, double meshes, double slope) {
  double power = 0.0;
  for (Eigen::Index i = 0; i < model.layout.waves; ++i) {
    const vectorised::RimWave& wave = model.rim[static_cast<std::size_t>(i)];
    power -= wave.stiffness * (state.wave[i] - meshes * wave.at_rest) * slope * wave.at_rest;
  }
  return power;
}

// Power that holds forms and a tilted bore while races and rollers turn through them.
double holding_power(const BearingModel& model, const Instant& now) {
  double power = 0.0;
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j)
    power +=
        tilt_power(model, now, j).held - now.seen_at(j).inner.form_power - now.seen_at(j).outer.form_power;
  return power;
}

double euler_power(const BearingModel& model, const Instant& now) {
  CarrierFrame only;
  only.euler = now.frame.euler;
  const auto power_on = [&](double mass, double orbit_radius, const BodyMotion& body) {
    only.orbit_radius = orbit_radius;
    return mass * inertial_acceleration(only, body.position, Vector2::Zero()).dot(body.velocity);
  };
  const double orbit_radius = now.frame.orbit_radius;
  double power = power_on(model.cage.mass, orbit_radius, now.cage) +
                 power_on(model.pin_mass, orbit_radius, now.pin) + power_on(model.bore_mass, 0.0, now.bore) -
                 model.cage.inertia * only.euler * now.cage.speed;
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    const BodyMotion roller = now.roller(j);
    power +=
        power_on(model.roller.mass, orbit_radius, roller) - model.roller.inertia * only.euler * roller.speed;
  }
  return power;
}

double weight_power(const BearingModel& model, const Instant& now, const Vector2& gravity) {
  Vector2 momentum = model.cage.mass * now.cage.velocity + model.pin_mass * now.pin.velocity;
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j)
    momentum += model.roller.mass * now.roller(j).velocity;
  return gravity.dot(momentum);
}

// Prescribed motions and loads shortly before, now and shortly after.
using ThreeTimes = std::array<Surroundings, 3>;

double changing_film_power(const BearingModel& model, const ThreeTimes& times,
                           const Eigen::Ref<const Eigen::VectorXd>& x,
                           const Eigen::Ref<const Eigen::VectorXd>& dx) {
  const auto before = vectorised::observed_rollers(model, times[0], x - kDifferenceTime * dx),
             now = vectorised::observed_rollers(model, times[1], x),
             after = vectorised::observed_rollers(model, times[2], x + kDifferenceTime * dx);
  double power = 0.0;
  for (std::size_t j = 0; j < now.size(); ++j) {
    const auto add = [&](const RaceModel& race, Contact ObservedRoller::*contact) {
      const Contact& here = now[j].*contact;
      const double change = (after[j].*contact).entrainment - (before[j].*contact).entrainment;
      power +=
          race_energy_slope(race, here.elastic_approach, here.entrainment) * change / (2.0 * kDifferenceTime);
    };
    add(model.inner, &ObservedRoller::inner);
    add(model.outer, &ObservedRoller::outer);
  }
  return power;
}

StoredEnergy energy_of(const BearingModel& model, const Instant& now, double meshes) {
  const CarrierFrame& frame = now.frame;
  StoredEnergy energy;
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    const BodyMotion roller = now.roller(j);
    energy.kinetic += kinetic(model.roller, roller);
    energy.centrifugal += centrifugal(frame, model.roller.mass, frame.orbit_radius, roller.position);
    energy.races += contact_energy(model, now, j);
    energy.pockets += now.pocket(j).energy;
    energy.neighbours += now.seen_at(j).neighbour_energy;
  }
  energy.kinetic += kinetic(model.cage, now.cage) + 0.5 * model.bore_mass * now.bore.velocity.squaredNorm() +
                    0.5 * model.pin_mass * now.pin.velocity.squaredNorm();
  energy.centrifugal += centrifugal(frame, model.cage.mass, frame.orbit_radius, now.cage.position) +
                        centrifugal(frame, model.pin_mass, frame.orbit_radius, now.pin.position) +
                        centrifugal(frame, model.bore_mass, 0.0, now.bore.position);
  if (model.land.present)
    energy.guidance = model.land.law.energy((now.cage.position - now.land().position).norm());
  energy.support = model.support.energy(now.pin.position);
  add_rim_energy(model, now.state, meshes, energy);
  return energy;
}

// `growth` [1/s]: of all speeds.
PowerInput power_of(const BearingModel& model, const ThreeTimes& times, const Vector2& load, double growth,
                    const Eigen::Ref<const Eigen::VectorXd>& x, const Eigen::Ref<const Eigen::VectorXd>& dx) {
  const Instant now(model, times[1], x);
  const double meshes = times[1].meshes;
  return {.bore_load = load.dot(now.bore.velocity),
          .rotations = -now.on_ring(Race::outer).moment * now.bore.speed -
                       now.on_ring(Race::inner).moment * now.pin.speed,
          .euler = euler_power(model, now),
          .changing_film = changing_film_power(model, times, x, dx),
          .out_of_roundness = holding_power(model, now),
          .changing_frame = 2.0 * growth * energy_of(model, now, meshes).centrifugal,
          .teeth = teeth_power(model, now.state, meshes, -growth * meshes),
          .weight = weight_power(model, now, {times[1].gravity.x, times[1].gravity.y})};
}

void take(const BearingModel& model, const Surroundings& surroundings,
          const Eigen::Ref<const Eigen::VectorXd>& x, const double* tilt_rate, Snapshot& into) {
  const Instant now(model, surroundings, x);
  const bool caged = model.layout.caged;
  into.laminae = cut_races(model);
  resize(into, model.layout.rollers, into.laminae != nullptr, caged);
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    record(now.seen_at(j).inner, model.inner_film, model.film_heating, j, into.inner);
    record(now.seen_at(j).outer, model.outer_film, model.film_heating, j, into.outer);
    into.angle[j] = wrapped(now.state.angle[j]);
    if (into.laminae) put_stand(now.stand(j), j, into);
    const PocketTouch pocket = now.pocket(j);
    if (caged)
      into.pocket_load[j] = pocket.load;
    else
      into.neighbour_load[j] = now.seen_at(j).neighbour_load;
    into.loss.pockets += pocket.power;
    add_losses(model, now, j, tilt_rate, into.loss);
  }
  into.orbital_speed = now.state.orbital_speed;
  into.spin = now.state.spin;
  into.loss.guidance = now.guidance.power;
  into.loss.drag += model.cage_drag.power(now.cage.speed);
  into.loss.support = model.support.power(now.pin.velocity);
  into.loss.race_damping += rim_damping(model, now.state);
  into.waves = now.state.wave;
  into.race_speeds = race_speeds(model.geometry, now.pin.speed, now.bore.speed);
  into.orbit_angle = caged ? now.state.cage_angle : now.state.angle.mean();
  into.orbit_speed = caged ? now.cage.speed : now.state.orbital_speed.mean();
  into.cage_position = now.cage.position;
  into.cage_eccentricity = now.guidance.eccentricity;
  into.on_bore = now.on_ring(Race::outer);
  into.port = bore_port(into.on_bore, now.bore.speed, now.bore.velocity);
}

Eigen::VectorXd with_bore(const BearingModel& model, const BoreMotion& motion,
                          const Eigen::Ref<const Eigen::VectorXd>& x) {
  Eigen::VectorXd moved = x;
  moved.segment<2>(model.layout.bore()) = motion.position;
  moved.segment<2>(model.layout.bore() + 2) = motion.velocity;
  return moved;
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
                   double time, const double* tilt_rate) {
  take(model, vectorised::surroundings_at(model, time), x, tilt_rate, into);
}

Snapshot driven_snapshot(const BearingModel& model, const BoreMotion& motion,
                         const Eigen::Ref<const Eigen::VectorXd>& x) {
  Snapshot result;
  take(model, vectorised::surroundings_of(model, motion), with_bore(model, motion, x), nullptr, result);
  return result;
}

StoredEnergy stored_energy(const BearingModel& model, const Eigen::Ref<const Eigen::VectorXd>& x,
                           double time) {
  const Surroundings now = vectorised::surroundings_at(model, time);
  return energy_of(model, Instant(model, now, x), now.meshes);
}

StoredEnergy driven_energy(const BearingModel& model, const BoreMotion& motion,
                           const Eigen::Ref<const Eigen::VectorXd>& x) {
  const Surroundings now = vectorised::surroundings_of(model, motion);
  const Eigen::VectorXd moved = with_bore(model, motion, x);
  return energy_of(model, Instant(model, now, moved), now.meshes);
}

PowerInput power_input(const BearingModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                       const Eigen::Ref<const Eigen::VectorXd>& dx) {
  const auto at = [&](double t) { return vectorised::surroundings_at(model, t); };
  return power_of(model, {at(time - kDifferenceTime), at(time), at(time + kDifferenceTime)},
                  bore_load(model, time), model.driving.ramp / speed_ratio(model.driving, time), x, dx);
}

PowerInput driven_power_input(const BearingModel& model, const BoreMotion& motion,
                              const Eigen::Ref<const Eigen::VectorXd>& x,
                              const Eigen::Ref<const Eigen::VectorXd>& dx) {
  const auto in = [&](double seconds) {
    Surroundings now = vectorised::surroundings_of(model, motion);
    now.bore.turned += seconds * now.bore.speed;
    return now;
  };
  return power_of(model, {in(-kDifferenceTime), in(0.0), in(kDifferenceTime)}, Vector2::Zero(), 0.0,
                  with_bore(model, motion, x), dx);
}

}  // namespace orbearing::bearing::motion
