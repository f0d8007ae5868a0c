// All that passes between a roller and a race: load, traction and rolling resistance, balanced on both
// bodies.
#pragma once

#include <optional>

#include "bearing/contact/damping.hpp"
#include "bearing/contact/friction.hpp"
#include "bearing/contact/squeeze_film.hpp"
#include "bearing/motion/contact_motion.hpp"
#include "bearing/motion/form_motion.hpp"
#include "bearing/motion/race_load.hpp"

namespace orbearing::bearing::motion {

/// Oil that is pressed out between roller and race.
struct RaceSqueeze {
  SqueezeFilm<double> law;
  FilmLaw<double> film;  // in the approach or not
};

/// One race with its laws, fixed for a run.
struct RaceModel {
  RaceSide side;
  double roller_radius = 0.0;      // [m]
  double damping = 0.0;            // [s/m]
  double entrainment_scale = 0.0;  // [m/s]
  RaceLoadLaw load;
  std::optional<RaceSqueeze> squeeze;
  FrictionLaws<double> friction;
  std::vector<RaceHarmonic> form;  // none: round
  std::vector<RaceScratch> scratches = {};
};

/// Forces in one race contact.
struct RaceForces {
  Wrench on_roller;
  Wrench on_race;
  double load = 0.0;            // [N]    with damping and squeeze
  double sliding = 0.0;         // [m/s]
  double entrainment = 0.0;     // [m/s]  > 0
  double damping_power = 0.0;   // [W]    dissipated, as are all powers
  double traction_power = 0.0;  // [W]
  double rolling_power = 0.0;   // [W]
  double form_power = 0.0;      // [W]    that what holds an out-of-round race takes from the turning race
};

/// |rolling| [m/s], rounded at zero over `scale` [m/s] so that film and resistance have a slope there.
inline double entrainment_speed(double rolling, double scale) {
  return std::sqrt(rolling * rolling + scale * scale);
}

/// Motion in the contact of a roller with the race of `model`,
/// its form, its scratches and the waves of an elastic race included.
struct FormedContact {
  ContactMotion contact;
  FormSlope form;
};

/// What a roller is like: larger in radius by `larger` [m] than stated, with those of `scratches` that are
/// its own.
struct RollerSurface {
  double larger = 0.0;                                    // [m]
  const std::vector<RollerScratch>* scratches = nullptr;  // of all rollers; null: none
  int number = 0;                                         // of the roller
};

FormedContact race_motion(const RaceModel& model, const BodyMotion& roller, const RollerSurface& surface,
                          const BodyMotion& race, const RaceWaves& waves = {});

/// How far the bodies of a contact yield in the middle, and under which load.
struct ElasticContact {
  double approach = 0.0;  // [m]  zero or negative where they do not touch
  double load = 0.0;      // [N]
};

/// Of a straight contact in the given motion.
inline ElasticContact straight_contact(const RaceModel& model, const ContactMotion& motion) {
  const double approach = model.load.elastic_approach(
      motion.approach, entrainment_speed(motion.rolling, model.entrainment_scale));
  return {approach, model.load.elastic().load(approach)};
}

/// Load of the oil that is pressed out [N], with the sign of the approach speed; `entrainment` [m/s] > 0.
inline double squeeze_load(const RaceModel& model, const ContactMotion& motion, const ElasticContact& elastic,
                           double entrainment) {
  if (!model.squeeze) return 0.0;
  const SqueezeFilm<double>& law = model.squeeze->law;
  const double gap = law.gap(model.load.with_film(), model.squeeze->film, motion.approach, elastic.approach,
                             elastic.load, std::log(entrainment));
  return law.load(elastic.approach, elastic.load, gap, entrainment, motion.approach_speed);
}

/// All forces of a contact in the given motion; `form` is null on a round race. The
/// tangential force of the rolling resistance on the roller makes the moments of both surfaces balance; it is
/// what the tilted oil pressure leaves after the drag at the inlet.
inline RaceForces contact_forces(const RaceModel& model, const ContactMotion& motion,
                                 const ElasticContact& elastic, const FormSlope* form, double race_speed) {
  RaceForces forces;
  forces.sliding = motion.sliding;
  forces.entrainment = entrainment_speed(motion.rolling, model.entrainment_scale);
  const auto normal =
      with_squeeze(damped_load(elastic.load, model.damping, motion.approach_speed), elastic.load,
                   squeeze_load(model, motion, elastic, forces.entrainment), motion.approach_speed);
  forces.damping_power = normal.power;
  if (normal.load <= 0.0) return forces;
  const double log_speed = model.friction.oiled() ? std::log(forces.entrainment) : 0.0;
  const double traction = model.friction.friction(normal.load, motion.sliding, log_speed);
  const double inlet =
      model.friction.rolling_resistance ? model.friction.inlet(normal.load, motion.rolling, log_speed) : 0.0;
  const double form_moment = form ? model.side.side * normal.load * form->all : 0.0;
  const double on_roller = form ? model.side.side * normal.load * form->rolling : 0.0;
  const double tilt = (inlet * (motion.race_arm + motion.roller_arm) + form_moment) / motion.distance;

  forces.load = normal.load;
  forces.on_roller.force =
      -model.side.side * normal.load * motion.normal + (traction + tilt) * motion.tangent;
  forces.on_roller.moment = (traction - inlet) * motion.roller_arm - on_roller;
  forces.on_race.force = -forces.on_roller.force;
  forces.on_race.moment = -(traction + inlet) * motion.race_arm - (form_moment - on_roller);
  forces.traction_power = traction * motion.sliding;
  forces.rolling_power = 2.0 * inlet * motion.rolling;
  if (form)
    forces.form_power =
        model.side.side * normal.load * (form->all - form->turning - form->rolling) * race_speed;
  return forces;
}

/// Forces between a roller and the race of `model`, in full.
RaceForces race_forces(const RaceModel& model, const BodyMotion& roller, const BodyMotion& race,
                       const RollerSurface& surface = {});

/// The same where the race is round and the roller as stated: without branches for what
/// is absent, since most runs are such and spend their time here.
inline RaceForces plain_race_forces(const RaceModel& model, const BodyMotion& roller,
                                    const BodyMotion& race) {
  const ContactMotion motion = contact_motion(roller, model.roller_radius, race, model.side);
  return contact_forces(model, motion, straight_contact(model, motion), nullptr, race.speed);
}

/// The same under a given elastic load, in a motion that is known already.
RaceForces race_forces(const RaceModel& model, const FormedContact& motion, const BodyMotion& race,
                       const ElasticContact& elastic);

/// Energy stored in the contact [J].
double race_energy(const RaceModel& model, const BodyMotion& roller, const BodyMotion& race,
                   const RollerSurface& surface = {}, const RaceWaves& waves = {});

}  // namespace orbearing::bearing::motion
