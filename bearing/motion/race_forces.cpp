#include "bearing/motion/race_forces.hpp"

namespace orbearing::bearing::motion {

FormedContact race_motion(const RaceModel& model, const BodyMotion& roller, double larger,
                          const BodyMotion& race) {
  FormedContact motion{contact_motion(roller, model.roller_radius + larger, race, model.side), {}};
  if (!model.form.empty()) motion.form = add_form(model.form, model.side.side, race, motion.contact);
  return motion;
}

RaceForces race_forces(const RaceModel& model, const BodyMotion& roller, const BodyMotion& race,
                       double larger) {
  const FormedContact motion = race_motion(model, roller, larger, race);
  return race_forces(model, motion, race, straight_load(model, motion.contact));
}

RaceForces race_forces(const RaceModel& model, const FormedContact& motion, const BodyMotion& race,
                       double elastic_load) {
  return contact_forces(model, motion.contact, elastic_load, &motion.form, race.speed);
}

double race_energy(const RaceModel& model, const BodyMotion& roller, const BodyMotion& race, double larger) {
  const ContactMotion motion = race_motion(model, roller, larger, race).contact;
  return model.load.energy(motion.approach, entrainment_speed(motion.rolling, model.entrainment_scale));
}

}  // namespace orbearing::bearing::motion
