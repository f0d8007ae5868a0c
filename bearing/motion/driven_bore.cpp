#include "bearing/motion/driven_bore.hpp"

#include <cassert>

#include "bearing/motion/rates.hpp"

namespace orbearing::bearing::motion {

namespace {

RingBodies driven_rings(const BearingModel& model, const ConstStateViews& state, const BoreMotion& motion) {
  return {.cage = cage_body(model, state),
          .bore = {motion.position, motion.velocity, motion.speed, motion.angle},
          .pin = {state.pin_position, state.pin_velocity, 0.0, 0.0},
          .cage_direction = cage_direction(model, state),
          .waves = waves_of(state)};
}

}  // namespace

CarrierFrame frame_of(const BearingModel& model, const BoreMotion& motion) {
  return carrier_frame({motion.carrier_speed, motion.carrier_acceleration, model.frame.orbit_radius},
                       model.inertia);
}

BoreReaction driven_derivative(const BearingModel& model, const BoreMotion& motion,
                               const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> dx) {
  assert(x.size() == model.layout.size() && dx.size() == x.size());
  const ConstStateViews state = state_views(model.layout, x.data());
  MutableStateViews rate = mutable_state_views(model.layout, dx.data());
  const CarrierFrame frame = frame_of(model, motion);
  const RingBodies rings = driven_rings(model, state, motion);
  RingWrenches on_rings;

  rates::set_kinematics(model, state, rate);
  rates::set_turning(model, state, rate);
  if (model.plain)
    rates::set_rollers<plain_roller_forces>(model, frame, state, rings, on_rings, rate);
  else
    rates::set_rollers<roller_forces>(model, frame, state, rings, on_rings, rate);
  on_rings.add(guidance_forces(model.guidance, rings.cage, land_body(model, rings)), model.guiding_race);
  rates::set_waves(model, state, 1.0, rate);
  rates::set_cage(model, frame, rings.cage, on_rings.cage, rate);
  rates::set_pin(model, frame, rings.pin, on_rings.pin.force, rate);
  rate.bore_position = motion.velocity;
  rate.bore_velocity = motion.acceleration;
  return on_rings.bore;
}

BoreReaction reaction(const BearingModel& model, const BoreMotion& motion,
                      const Eigen::Ref<const Eigen::VectorXd>& x) {
  const ConstStateViews state = state_views(model.layout, x.data());
  const RingBodies rings = driven_rings(model, state, motion);
  RingWrenches on_rings;
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j)
    on_rings.add(roller_forces(model, rings, roller_body(model, state, j), j));
  on_rings.add(guidance_forces(model.guidance, rings.cage, land_body(model, rings)), model.guiding_race);
  return on_rings.bore;
}

BearingModel model_at(const BearingModel& model, const BoreMotion& motion) {
  BearingModel now = model;
  now.point.inner_speed = 0.0;
  now.point.outer_speed = motion.speed;
  now.point.bore_load = Vector2::Zero();
  now.point.carrier = {motion.carrier_speed, motion.carrier_acceleration, model.frame.orbit_radius};
  now.frame = frame_of(model, motion);
  now.excitation = {};
  now.driving = {};
  now.kinematic_cage_speed = kinematic_cage_speed(model.geometry, 0.0, motion.speed);
  for (RaceHarmonic& wave : now.outer.form)
    if (wave.turning) wave.phase -= wave.order * motion.angle;
  for (RaceScratch& scratch : now.outer.scratches) scratch.angle += motion.angle;
  return now;
}

Eigen::VectorXd state_at(const BearingModel& model, const BoreMotion& motion,
                         const Eigen::Ref<const Eigen::VectorXd>& x) {
  Eigen::VectorXd now = x;
  now.segment<2>(model.layout.bore()) = motion.position;
  now.segment<2>(model.layout.bore() + 2) = motion.velocity;
  return now;
}

Snapshot driven_snapshot(const BearingModel& model, const BoreMotion& motion,
                         const Eigen::Ref<const Eigen::VectorXd>& x) {
  Snapshot now = snapshot(model_at(model, motion), state_at(model, motion, x));
  now.laminae = cut_races(model);  // those of the instant are gone
  return now;
}

}  // namespace orbearing::bearing::motion
