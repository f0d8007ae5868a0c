#include "bearing/motion/equations.hpp"

#include <cassert>

#include "bearing/motion/rates.hpp"

namespace orbearing::bearing::motion {

using namespace rates;

namespace {

// The load on the bore holds the planet's inertial load at the origin: here only what its displacement adds.
void set_bore(const BearingModel& model, const CarrierFrame& frame, const BodyMotion& bore,
              const Vector2& force, MutableStateViews& rate) {
  CarrierFrame centred = frame;
  centred.orbit_radius = 0.0;
  rate.bore_velocity = force / model.bore_mass + inertial_acceleration(centred, bore.position, bore.velocity);
}

}  // namespace

void PlanetBearingEquations::derivative(double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                                        Eigen::Ref<Eigen::VectorXd> dx) const {
  assert(x.size() == model_.layout.size() && dx.size() == x.size());
  const ConstStateViews state = state_views(model_.layout, x.data());
  MutableStateViews rate = mutable_state_views(model_.layout, dx.data());
  const CarrierFrame frame = frame_at(model_, time);
  const RingBodies rings = ring_bodies(model_, state, time);
  RingWrenches on_rings;

  set_kinematics(model_, state, rate);
  set_turning(model_, state, rate);
  if (model_.plain)
    set_rollers<plain_roller_forces>(model_, frame, state, rings, on_rings, rate);
  else
    set_rollers<roller_forces>(model_, frame, state, rings, on_rings, rate);
  on_rings.add(guidance_forces(model_.guidance, rings.cage, land_body(model_, rings)), model_.guiding_race);
  set_waves(model_, state, mesh_ratio(model_.driving, time), rate);
  set_cage(model_, frame, rings.cage, on_rings.cage, rate);
  set_bore(model_, frame, rings.bore, on_rings.bore.force + bore_load(model_, time), rate);
  set_pin(model_, frame, rings.pin, on_rings.pin.force, rate);
}

}  // namespace orbearing::bearing::motion
