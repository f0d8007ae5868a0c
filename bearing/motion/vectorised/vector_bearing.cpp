#include "bearing/motion/vectorised/vector_bearing.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "bearing/motion/driven_bore.hpp"
#include "bearing/motion/vectorised/engines.hpp"

namespace orbearing::bearing::vectorised {

namespace {

std::unique_ptr<Engine> make_engine([[maybe_unused]] mechanics::InstructionSet set,
                                    const Constants& constants, const RollerConstants& rollers) {
#if defined(__x86_64__) && !defined(_WIN32)
  if (set == mechanics::InstructionSet::avx512)
    return std::unique_ptr<Engine>(avx512_engine(constants, rollers));
  if (set == mechanics::InstructionSet::avx2) return std::unique_ptr<Engine>(avx2_engine(constants, rollers));
#endif
  return std::unique_ptr<Engine>(baseline_engine(constants, rollers));
}

RaceConstants race_constants(const motion::RaceModel& race, double speed) {
  RaceConstants c;
  c.side = race.side.side;
  c.radius = race.side.radius;
  c.speed = speed;
  c.stiffness = race.load.elastic().constant();
  c.log_stiffness = std::log(c.stiffness);
  c.damping = race.damping;
  c.entrainment_scale = race.entrainment_scale;
  c.film = race.load.with_film();
  c.film_law = race.load.film();
  c.squeezed = race.squeeze.has_value();
  if (race.squeeze) {
    c.film_law = race.squeeze->film;
    c.squeeze = race.squeeze->law;
  }
  set_film_powers(c);
  c.friction = race.friction;
  return c;
}

LandConstants land_constants(const motion::BearingModel& model) {
  if (!model.guidance.present) return {};
  const bool on_bore = model.guiding_race == Race::outer;
  return {.present = true,
          .on_bore = on_bore,
          .speed = on_bore ? model.point.outer_speed : model.point.inner_speed,
          .law = motion::land_law(model.guidance)};
}

// Plain numbers of `model`.
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
  c.coriolis_speed = model.frame.coriolis_speed;
  c.centrifugal = model.frame.centrifugal;
  c.euler = model.frame.euler;
  c.own_orbit = model.frame.own_orbit;
  c.orbit_radius = model.frame.orbit_radius;
  c.inner = race_constants(model.inner, model.point.inner_speed);
  c.outer = race_constants(model.outer, model.point.outer_speed);
  c.caged = model.layout.caged;
  c.pocket = motion::pocket_law(model.pocket);
  c.neighbours = {model.neighbours.elastic.constant(), model.neighbours.damping, model.neighbours.friction};
  c.cage_mass = model.cage.mass;
  c.cage_inertia = model.cage.inertia;
  c.bore_mass = model.bore_mass;
  c.pin_mass = model.pin_mass;
  c.support_stiffness = model.support.stiffness;
  c.support_damping = model.support.damping;
  c.land = land_constants(model);
  return c;
}

std::vector<WaveConstants> waves_of(const std::vector<RaceHarmonic>& form) {
  std::vector<WaveConstants> waves;
  for (const RaceHarmonic& wave : form)
    waves.push_back({.order = static_cast<int>(wave.order),
                     .amplitude = wave.amplitude,
                     .phase = wave.phase,
                     .turning = wave.turning});
  return waves;
}

void put_waves(const std::vector<WaveConstants>& waves, RaceConstants& race) {
  race.waves = static_cast<int>(waves.size());
  race.wave = waves.data();
}

// The constants point into `races`.
void put_laminae(const motion::LaminaRaces& races, LaminaConstants& constants) {
  constants = {.count = races.inner().laminae(),
               .place = races.inner().places().data(),
               .inner_drop = races.inner().drops().data(),
               .outer_drop = races.outer().drops().data(),
               .bore_end_displacement_x = races.bore_end_displacement().x(),
               .bore_end_displacement_y = races.bore_end_displacement().y(),
               .resistance = races.resistance(),
               .upright = races.upright()};
}

void turn_waves(const std::vector<RaceHarmonic>& form, double race_angle, std::vector<WaveConstants>& waves) {
  for (std::size_t i = 0; i < waves.size(); ++i)
    if (waves[i].turning) waves[i].phase = form[i].phase - form[i].order * race_angle;
}

void turn_scratches(const std::vector<RaceScratch>& given, double race_angle, std::vector<RaceScratch>& now) {
  for (std::size_t i = 0; i < now.size(); ++i) now[i].angle = given[i].angle + race_angle;
}

void put_scratches(const std::vector<RaceScratch>& scratches, RaceConstants& race) {
  race.scratches = static_cast<int>(scratches.size());
  race.scratch = scratches.data();
}

}  // namespace

bool supports(const motion::BearingModel& model) {
  return model.driving.ramp == 0.0;
}

VectorBearing::VectorBearing(const motion::BearingModel& model, mechanics::InstructionSet set)
    : model_(model),
      layout_{static_cast<int>(model.layout.rollers), static_cast<int>(model.layout.followed),
              model.layout.tilting, static_cast<int>(model.layout.waves), model.layout.caged},
      set_(set),
      inner_scratches_(model.inner.scratches),
      outer_scratches_(model.outer.scratches) {
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
  inner_waves_ = waves_of(model.inner.form);
  outer_waves_ = waves_of(model.outer.form);
  for (const auto* waves : {&inner_waves_, &outer_waves_})
    for (const WaveConstants& wave : *waves) turning_forms_ = turning_forms_ || wave.turning;
  turning_forms_ = turning_forms_ || !inner_scratches_.empty() || !outer_scratches_.empty();
  Constants constants = constants_of(model);
  put_waves(inner_waves_, constants.inner);
  put_waves(outer_waves_, constants.outer);
  put_scratches(inner_scratches_, constants.inner);
  put_scratches(outer_scratches_, constants.outer);
  constants.roller_scratches = static_cast<int>(model_.roller_scratches.size());
  constants.roller_scratch = model_.roller_scratches.data();
  if (model_.laminae) put_laminae(*model_.laminae, constants.laminae);
  constants.rim = {.waves = layout_.waves,
                   .stiffness = model_.rim.stiffness.data(),
                   .mass = model_.rim.mass.data(),
                   .damping = model_.rim.damping.data(),
                   .at_rest = model_.rim.at_rest.data()};
  engine_ = make_engine(set, constants, {pocket_cosine_.data(), pocket_sine_.data(), roller_radius_.data()});
}

void VectorBearing::set_time(double time) {
  if (!turning_forms_) return;
  turn_waves(model_.inner.form, model_.point.inner_speed * time, inner_waves_);
  turn_waves(model_.outer.form, model_.point.outer_speed * time, outer_waves_);
  turn_scratches(model_.inner.scratches, model_.point.inner_speed * time, inner_scratches_);
  turn_scratches(model_.outer.scratches, model_.point.outer_speed * time, outer_scratches_);
}

void VectorBearing::derivative(double time, const double* x, double* dx) {
  const mechanics::Vector2 load = motion::bore_load(model_, time);
  set_time(time);
  engine_->derivative(x, load.x(), load.y(), dx);
}

void VectorBearing::linearise(double time, const double* x, double* dx) {
  const mechanics::Vector2 load = motion::bore_load(model_, time);
  set_time(time);
  engine_->linearise(x, load.x(), load.y(), dx);
}

void VectorBearing::time_slope(double time, double* rate) {
  std::fill(rate, rate + layout_.size(), 0.0);
  const mechanics::Vector2 slope = motion::bore_load_slope(model_, time);
  rate[layout_.bore() + 2] = slope.x() / model_.bore_mass;
  rate[layout_.bore() + 3] = slope.y() / model_.bore_mass;
}

void VectorBearing::set_motion(const motion::BoreMotion& motion) {
  const CarrierFrame frame = motion::frame_of(model_, motion);
  engine_->set_surroundings({frame.coriolis_speed, frame.centrifugal, frame.euler, motion.speed});
  if (!turning_forms_) return;
  turn_waves(model_.outer.form, motion.angle, outer_waves_);
  turn_scratches(model_.outer.scratches, motion.angle, outer_scratches_);
}

void VectorBearing::derivative(const motion::BoreMotion& motion, const double* x, double* dx) {
  set_motion(motion);
  engine_->derivative(x, 0.0, 0.0, dx);
  std::copy_n(motion.acceleration.data(), 2, dx + layout_.bore() + 2);
}

void VectorBearing::linearise(const motion::BoreMotion& motion, const double* x, double* dx) {
  set_motion(motion);
  engine_->linearise(x, 0.0, 0.0, dx);
  std::copy_n(motion.acceleration.data(), 2, dx + layout_.bore() + 2);
}

motion::BoreReaction VectorBearing::reaction() const {
  const BoreForces forces = engine_->bore_forces();
  return {{forces.x, forces.y}, forces.moment};
}

std::vector<double> VectorBearing::padded(const Eigen::Ref<const Eigen::VectorXd>& flat) const {
  assert(flat.size() == model_.layout.size());
  std::vector<double> x(static_cast<std::size_t>(layout_.size()), 0.0);
  const int z = layout_.rollers, lanes = layout_.lanes();
  const double pitch_radius = 0.5 * (model_.geometry.inner_radius + model_.geometry.outer_radius);
  std::fill(x.begin(), x.begin() + lanes, pitch_radius);
  for (int group = 0; group < layout_.groups(); ++group)
    std::copy(flat.data() + group * z, flat.data() + (group + 1) * z, x.begin() + group * lanes);
  std::copy(flat.data() + layout_.groups() * z, flat.data() + flat.size(), x.begin() + layout_.cage());
  return x;
}

void VectorBearing::flatten(const double* padded, Eigen::Ref<Eigen::VectorXd> flat) const {
  const int z = layout_.rollers, lanes = layout_.lanes();
  for (int group = 0; group < layout_.groups(); ++group)
    std::copy(padded + group * lanes, padded + group * lanes + z, flat.data() + group * z);
  std::copy(padded + layout_.cage(), padded + layout_.end(), flat.data() + layout_.groups() * z);
}

}  // namespace orbearing::bearing::vectorised
