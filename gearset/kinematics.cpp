#include "gearset/kinematics.hpp"

#include <cassert>
#include <cmath>
#include <stdexcept>

#include "gearset/stepped_planet.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::gearset {

namespace {

// Willis' equation is teeth-weighted: z_s w_s + z_r w_r - (z_s + z_r) w_c = 0. The same weights are the
// ratios of the torques, since the power vanishes for every motion that the equation allows. Eqs. (15) and
// (17).
struct Weights {
  double sun, ring, carrier;

  double of(Member member) const {
    return member == Member::sun ? sun : member == Member::ring ? ring : carrier;
  }
};

Weights willis_weights(const PlanetarySet& set) {
  assert(set.sun_teeth > 0 && set.planet_teeth > 0 && set.ring_teeth > 0);
  const WillisTeeth teeth = willis_teeth(set);
  const double sun = teeth.sun;
  const double ring = teeth.ring;
  return {sun, ring, -(sun + ring)};
}

Member delivering_member(Member fixed, Member driven) {
  for (const Member member : {Member::sun, Member::ring}) {
    if (member != fixed && member != driven) return member;
  }
  return Member::carrier;
}

void require_sound(const PlanetarySet& set, const Drive& drive) {
  if (drive.member == set.fixed_member) {
    throw std::invalid_argument(
        "the driven member is the fixed one; drive another member or fix another one");
  }
  mechanics::require_positive(drive.motor_speed(), "speed of the driven member");
}

}  // namespace

Speeds member_speeds(const PlanetarySet& set, const Drive& drive) {
  require_sound(set, drive);
  const Weights weights = willis_weights(set);
  const Member output = delivering_member(set.fixed_member, drive.member);
  const double driven = drive.driven_speed();
  const double output_speed = -driven * weights.of(drive.member) / weights.of(output);
  const auto speed = [&](Member member) {
    if (member == set.fixed_member) return 0.0;
    return member == drive.member ? driven : output_speed;
  };
  Speeds speeds{speed(Member::sun), speed(Member::ring), speed(Member::carrier), 0.0};
  speeds.planet_relative = -(speeds.sun - speeds.carrier) * set.sun_teeth / set.planet_teeth;
  // With one member at rest the carrier follows the others' sense, so a positive input never turns it
  // backwards.
  assert(speeds.carrier >= 0.0);
  return speeds;
}

Torques member_torques(const PlanetarySet& set, const Drive& drive) {
  require_sound(set, drive);
  mechanics::require_positive(drive.power, "power that enters the set");
  const Weights weights = willis_weights(set);
  const double scale = drive.load_power() / (drive.driven_speed() * weights.of(drive.member));
  return {scale * weights.sun, scale * weights.ring, scale * weights.carrier};
}

}  // namespace orbearing::gearset
