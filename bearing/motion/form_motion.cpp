#include "bearing/motion/form_motion.hpp"

#include <cmath>

namespace orbearing::bearing::motion {

FormSlope add_form(const std::vector<RaceHarmonic>& form, double side, const BodyMotion& race,
                   ContactMotion& motion) {
  const FormAt here = form_at(form, std::atan2(motion.normal.y(), motion.normal.x()), race.angle);
  motion.approach -= side * here.height;
  motion.approach_speed -= side * (here.slope * motion.line_speed - here.turning_slope * race.speed);
  return {here.slope, here.turning_slope, 0.0};
}

void add_scratches(const std::vector<RaceScratch>& scratches, double side, const BodyMotion& race,
                   ContactMotion& motion, FormSlope& slope) {
  for (const RaceScratch& scratch : scratches) {
    const TrackSinking<double> sunk = sinking_at(scratch.law, scratch.radius, scratch.angle + race.angle,
                                                 motion.normal.x(), motion.normal.y());
    motion.approach -= sunk.depth;
    motion.approach_speed -= sunk.by_angle * (motion.line_speed - race.speed);
    slope.all += side * sunk.by_angle;
    slope.turning += side * sunk.by_angle;
  }
}

void add_scratches(const std::vector<RollerScratch>& scratches, int roller, const BodyMotion& body, double side,
                   ContactMotion& motion, FormSlope& slope) {
  for (const RollerScratch& scratch : scratches) {
    if (scratch.roller != roller) continue;
    // From the roller's centre the contact lies along side n.
    const TrackSinking<double> sunk =
        sinking_at(side < 0.0 ? scratch.on_inner : scratch.on_outer, scratch.radius, scratch.angle + body.angle,
                   side * motion.normal.x(), side * motion.normal.y());
    motion.approach -= sunk.depth;
    motion.approach_speed -= sunk.by_angle * (motion.line_speed - body.speed);
    slope.all += side * sunk.by_angle;
    slope.rolling += side * sunk.by_angle;
  }
}

}  // namespace orbearing::bearing::motion
