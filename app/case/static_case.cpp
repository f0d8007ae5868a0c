#include "app/case/static_case.hpp"

#include "app/case/described_case.hpp"
#include "app/case/profile_case.hpp"

namespace orbearing::app {

bearing::CylindricalRollerBearing lamina_bearing_of(const ResolvedCase& in) {
  auto bearing = from_case<bearing::CylindricalRollerBearing>(in);
  if (bearing.laminae == 0) bearing.laminae = default_laminae;
  bearing.roller_profile = roller_profile_of(in);
  return bearing;
}

bearing::BallBearing ball_bearing_of(const ResolvedCase& in) {
  return from_case<bearing::BallBearing>(in);
}

bearing::equilibrium::RingLoad ring_load_of(const ResolvedCase& in) {
  return from_case<bearing::equilibrium::RingLoad>(in);
}

bearing::rating::RollerSet roller_set_of(const ResolvedCase& in) {
  bearing::rating::RollerSet set =
      bearing::rating::roller_set(from_case<bearing::CylindricalRollerBearing>(in));
  set.lambda = in.number("life.lambda");
  return set;
}

bearing::rating::RaceMotions race_motions_of(const ResolvedCase& in) {
  return bearing::rating::turning(in.choice("operation.turning_race") == "outer" ? bearing::Race::outer
                                                                                 : bearing::Race::inner);
}

}  // namespace orbearing::app
