#include "bearing/motion/form_motion.hpp"

#include <cmath>

namespace orbearing::bearing::motion {

FormSlope add_form(const std::vector<RaceHarmonic>& form, double side, const BodyMotion& race,
                   ContactMotion& motion) {
  const FormAt here = form_at(form, std::atan2(motion.normal.y(), motion.normal.x()), race.angle);
  motion.approach -= side * here.height;
  motion.approach_speed -= side * (here.slope * motion.line_speed - here.turning_slope * race.speed);
  return {here.slope, here.turning_slope};
}

}  // namespace orbearing::bearing::motion
