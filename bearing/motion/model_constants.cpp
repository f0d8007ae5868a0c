#include "bearing/motion/model_constants.hpp"

#include <algorithm>
#include <cassert>

namespace orbearing::bearing::vectorised {

namespace {

template <class T>
Listed<T> listed(const std::vector<T>& all) {
  return {all.data(), static_cast<int>(all.size())};
}

RaceConstants race_constants(const motion::RaceModel& race) {
  RaceConstants c;
  static_cast<RaceLaws&>(c) = race;
  c.form = listed(race.form);
  c.scratches = listed(race.scratches);
  return c;
}

LaminaConstants lamina_constants(const motion::LaminaRaces& races) {
  return {.count = races.inner().laminae(),
          .position = races.inner().positions().data(),
          .inner_drop = races.inner().drops().data(),
          .outer_drop = races.outer().drops().data(),
          .bore_end_displacement_x = races.bore_end_displacement().x(),
          .bore_end_displacement_y = races.bore_end_displacement().y(),
          .resistance = races.resistance(),
          .upright = races.upright()};
}

PlaneAcceleration plane_gravity(const motion::BearingModel& model, double angle) {
  if (!model.gravity.acts()) return {0.0, 0.0};
  const Vector2 gravity = gravity_at(model, angle);
  return {gravity.x(), gravity.y()};
}

Constants constants_of(const motion::BearingModel& model) {
  Constants c;
  c.rollers = static_cast<int>(model.layout.rollers);
  c.followed = static_cast<int>(model.layout.followed);
  c.roller_radius = model.geometry.element_radius;
  c.roller_mass = model.roller.mass;
  c.roller_inertia = model.roller.inertia;
  c.orbit_drag = model.orbit_drag.coefficient;
  c.spin_drag = model.spin_drag.coefficient;
  c.cage_drag = model.cage_drag.coefficient;
  c.inner = race_constants(model.inner);
  c.outer = race_constants(model.outer);
  if (model.laminae) c.laminae = lamina_constants(*model.laminae);
  c.rim = listed(model.rim);
  c.caged = model.layout.caged;
  c.pocket = model.pocket;
  c.neighbours = model.neighbours;
  c.roller_scratches = listed(model.roller_scratches);
  c.cage_mass = model.cage.mass;
  c.cage_inertia = model.cage.inertia;
  c.bore_mass = model.bore_mass;
  c.pin_mass = model.pin_mass;
  c.support_stiffness = model.support.stiffness;
  c.support_damping = model.support.damping;
  c.land = model.land;
  put_surroundings(surroundings_at(model, 0.0), c);
  return c;
}

}  // namespace

bool turns_unevenly(const motion::RaceModel& race) {
  return !race.scratches.empty() || std::any_of(race.form.begin(), race.form.end(),
                                                [](const RaceHarmonic& wave) { return wave.rotating; });
}

Surroundings surroundings_at(const motion::BearingModel& model, double time) {
  const double ratio = speed_ratio(model.driving, time), turned = equivalent_time(model.driving, time);
  return {.frame = frame_at(model, time),
          .pin = {model.point.inner_speed * ratio, model.point.inner_speed * turned},
          .bore = {model.point.outer_speed * ratio, model.point.outer_speed * turned},
          .meshes = mesh_ratio(model.driving, time),
          .gravity = plane_gravity(model, carrier_angle(model, time))};
}

Surroundings surroundings_of(const motion::BearingModel& model, const motion::BoreMotion& motion) {
  return {.frame = carrier_frame(
              {motion.carrier_speed, motion.carrier_acceleration, model.frame.orbit_radius}, model.inertia),
          .pin = {},
          .bore = {motion.speed, motion.angle},
          .gravity = plane_gravity(model, motion.carrier_angle)};
}

bool surroundings_change(const motion::BearingModel& model) {
  const bool gravity_turns = model.gravity.acts() && model.point.carrier.speed != 0.0;
  return model.driving.ramp != 0.0 || gravity_turns || turns_unevenly(model.inner) ||
         turns_unevenly(model.outer);
}

ModelConstants::ModelConstants(const motion::BearingModel& model)
    : constants_(constants_of(model)),
      layout_(layout_of(constants_)),
      pitch_radius_(0.5 * (model.geometry.inner_radius + model.geometry.outer_radius)) {
  assert(layout_.followed <= PaddedLayout::kMostFollowed);
  const auto lanes = static_cast<std::size_t>(layout_.lanes());
  pocket_cosine_.assign(lanes, 1.0);
  pocket_sine_.assign(lanes, 0.0);
  roller_radius_.assign(lanes, model.geometry.element_radius);
  for (std::size_t j = 0; j < model.pocket_direction.size(); ++j) {
    pocket_cosine_[j] = model.pocket_direction[j].x();
    pocket_sine_[j] = model.pocket_direction[j].y();
  }
  for (std::size_t j = 0; j < model.radius_deviation.size(); ++j)
    roller_radius_[j] += model.radius_deviation[j];
}

std::vector<double> ModelConstants::padded(const Eigen::Ref<const Eigen::VectorXd>& flat) const {
  std::vector<double> x(static_cast<std::size_t>(layout_.size()));
  pad(flat, x.data());
  return x;
}

void ModelConstants::pad(const Eigen::Ref<const Eigen::VectorXd>& flat, double* padded) const {
  const int z = layout_.rollers, lanes = layout_.lanes();
  assert(flat.size() == layout_.groups() * z + layout_.end() - layout_.cage());
  std::fill_n(padded, layout_.size(), 0.0);
  std::fill_n(padded, lanes, pitch_radius_);
  for (int group = 0; group < layout_.groups(); ++group)
    std::copy_n(flat.data() + group * z, z, padded + group * lanes);
  std::copy(flat.data() + layout_.groups() * z, flat.data() + flat.size(), padded + layout_.cage());
}

void ModelConstants::flatten(const double* padded, Eigen::Ref<Eigen::VectorXd> flat) const {
  const int z = layout_.rollers, lanes = layout_.lanes();
  for (int group = 0; group < layout_.groups(); ++group)
    std::copy_n(padded + group * lanes, z, flat.data() + group * z);
  std::copy(padded + layout_.cage(), padded + layout_.end(), flat.data() + layout_.groups() * z);
}

std::vector<ObservedRoller> observed_rollers(const motion::BearingModel& model, const Surroundings& now,
                                             const Eigen::Ref<const Eigen::VectorXd>& x) {
  const ModelConstants given(model);
  Constants constants = given.constants();
  put_surroundings(now, constants);
  std::vector<ObservedRoller> seen(static_cast<std::size_t>(constants.rollers));
  observe(constants, given.rollers(), given.padded(x).data(), seen.data());
  return seen;
}

}  // namespace orbearing::bearing::vectorised
