#include "bearing/motion/initial_state.hpp"

#include <cmath>

#include "bearing/contact/race_form.hpp"
#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/equilibrium/race_equilibrium.hpp"
#include "bearing/motion/model_constants.hpp"

namespace orbearing::bearing::motion {

namespace {

// The support carries what the rollers press on the pin ring, and the ring's own inertial load.
Vector2 pin_displacement(const BearingModel& model, const QuasiStaticState& balance) {
  Vector2 force = model.pin_mass * inertial_acceleration(model.frame, Vector2::Zero(), Vector2::Zero());
  for (Eigen::Index j = 0; j < balance.angle.size(); ++j)
    force -= balance.inner_load[j] * direction(balance.angle[j]);
  return force / model.support.stiffness;
}

// Radius of a race at `angle`, as at t = 0, film and form included.
double race_radius(const RaceModel& race, double angle) {
  return race.radius + form_at(race.form, angle, 0.0).height;
}

// Centre of a roller on the ray `outward` from the pin: on the inner race where it carries, else on the
// outer.
Vector2 roller_centre(const BearingModel& model, const bearing::RollerContacts& contacts,
                      const QuasiStaticState& balance, Eigen::Index j, const Vector2& pin,
                      const Vector2& bore) {
  const double roller = model.geometry.element_radius + model.radius_deviation[static_cast<std::size_t>(j)];
  const double angle = balance.angle[j];
  const Vector2 outward = direction(angle);
  const double bent =
      model.layout.waves > 0 ? balance.waves.dot(wave_shapes(model.point.outer_race, angle)) : 0.0;
  if (balance.inner_load[j] > 0.0)
    return pin + (race_radius(model.inner, angle) + roller - contacts.inner.approach(balance.inner_load[j])) *
                     outward;
  return bore +
         (race_radius(model.outer, angle) + bent - roller + contacts.outer.approach(balance.outer_load[j])) *
             outward;
}

void set_roller(const Vector2& centre, double angle, double cage_speed, double spin, Eigen::Index j,
                MutableStateViews& state) {
  const double off = cross(direction(angle), centre) / centre.norm();
  state.radius[j] = centre.norm();
  state.angle[j] = angle + std::asin(off);
  state.orbital_speed[j] = cage_speed;
  state.spin[j] = spin;
}

// Each roller at the tilt of its equilibrium.
void tilt_rollers(const BearingModel& model, Eigen::Ref<Eigen::VectorXd> x) {
  if (!model.layout.tilting) return;
  const auto seen = vectorised::observed_rollers(model, vectorised::surroundings_at(model, 0.0), x);
  MutableStateViews state = mutable_state_views(model.layout, x.data());
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    const vectorised::ObservedRoller& roller = seen[static_cast<std::size_t>(j)];
    state.end_displacement[j] = model.laminae->balanced_end_displacement(
        roller.inner.elastic_approach, roller.outer.elastic_approach, direction(state.angle[j]));
  }
}

}  // namespace

QuasiStaticOptions start_options(const DynamicsParameters& parameters) {
  QuasiStaticOptions options;
  options.inertia = parameters.inertia;
  if (parameters.race.film_in_approach) options.film = parameters.lubricant;
  return options;
}

void place_bodies(const BearingModel& model, const bearing::RollerContacts& contacts,
                  const QuasiStaticState& balance, const StartMotion& start, double first_roller,
                  Eigen::Ref<Eigen::VectorXd> x) {
  MutableStateViews state = mutable_state_views(model.layout, x.data());
  state.pin_position = start.pin;
  state.bore_position = start.bore;
  if (model.layout.caged) {
    state.cage_position = model.land.on_bore ? start.bore : start.pin;
    state.cage_angle = first_roller;
    state.cage_speed = start.cage_speed;
  }
  if (model.layout.waves > 0) state.wave = balance.waves;
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j)
    set_roller(roller_centre(model, contacts, balance, j, start.pin, start.bore), balance.angle[j],
               start.cage_speed, start.spin, j, state);
  tilt_rollers(model, x);
}

InitialState initial_state(const Bearing& bearing, const BearingModel& model,
                           const DynamicsParameters& parameters, double first_roller) {
  OperatingPoint point = model.point;
  if (model.driving.ramp != 0.0) point.carrier.acceleration = 0.0;  // the load on the bore lacks its share
  if (model.gravity.acts()) point.bore_load += weight_on_bore(model, 0.0);
  const QuasiStaticOptions options = start_options(parameters);
  const QuasiStaticState balance = quasi_static_state(bearing, point, options, first_roller);
  const double cage_speed = model.kinematic_cage_speed;
  const double spin = kinematic_roller_spin(model.geometry, point.inner_speed, point.outer_speed);

  InitialState start{Eigen::VectorXd::Zero(model.layout.size()), balance.report};
  const Vector2 pin = balance.report.converged ? pin_displacement(model, balance) : Vector2::Zero();
  const Vector2 bore = balance.report.converged ? Vector2(pin + balance.displacement) : Vector2::Zero();
  place_bodies(model,
               rolling_contacts(bearing, model.geometry, point.inner_speed, point.outer_speed, options.film),
               balance, {pin, bore, cage_speed, spin}, first_roller, start.x);
  return start;
}

}  // namespace orbearing::bearing::motion
