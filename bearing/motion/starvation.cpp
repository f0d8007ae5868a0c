#include "bearing/motion/starvation.hpp"

namespace orbearing::bearing::motion {

namespace {

constexpr const char* kKey = "traction.starvation";

}  // namespace

mechanics::Problems starvation_problems(Starvation starvation, bool sized) {
  if (starvation != Starvation::skf || sized) return {};
  return {{kKey,
           "starvation of a bearing whose size is not known; bearing.bore and bearing.outside_diameter are "
           "required"}};
}

mechanics::Problems starvation_problems(const RaceContactParameters& race, bool sized) {
  if (race.starvation == Starvation::replenished)
    return {{kKey,
             "oil that returns to the tracks of a bearing in motion; none or skf is required: it is known of "
             "rollers at rest alone"}};
  return race.rolling_resistance ? starvation_problems(race.starvation, sized) : mechanics::Problems{};
}

}  // namespace orbearing::bearing::motion
