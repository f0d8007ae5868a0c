#include "bearing/motion/race_forces.hpp"

namespace orbearing::bearing::motion {

FormedContact race_motion(const RaceModel& model, const BodyMotion& roller, const RollerSurface& surface,
                          const BodyMotion& race, const RaceWaves& waves) {
  FormedContact motion{contact_motion(roller, model.roller_radius + surface.larger, race, model.side), {}};
  const double side = model.side.side;
  if (!model.form.empty()) motion.form = add_form(model.form, side, race, motion.contact);
  add_waves(waves, side, motion.contact, motion.form);
  add_scratches(model.scratches, side, race, motion.contact, motion.form);
  if (surface.scratches)
    add_scratches(*surface.scratches, surface.number, roller, side, motion.contact, motion.form);
  return motion;
}

RaceForces race_forces(const RaceModel& model, const BodyMotion& roller, const BodyMotion& race,
                       const RollerSurface& surface) {
  const FormedContact motion = race_motion(model, roller, surface, race);
  return race_forces(model, motion, race, straight_contact(model, motion.contact));
}

RaceForces race_forces(const RaceModel& model, const FormedContact& motion, const BodyMotion& race,
                       const ElasticContact& elastic) {
  return contact_forces(model, motion.contact, elastic, &motion.form, race.speed);
}

double race_energy(const RaceModel& model, const BodyMotion& roller, const BodyMotion& race,
                   const RollerSurface& surface, const RaceWaves& waves) {
  const ContactMotion motion = race_motion(model, roller, surface, race, waves).contact;
  return model.load.energy(motion.approach, entrainment_speed(motion.rolling, model.entrainment_scale));
}

}  // namespace orbearing::bearing::motion
