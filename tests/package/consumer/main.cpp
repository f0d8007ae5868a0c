// Uses one function of each library through the installed headers.
#include <cmath>
#include <cstdlib>

#include "bearing/geometry.hpp"
#include "coupling/study/operating_point.hpp"
#include "gearset/kinematics.hpp"

namespace {

bool equal(double value, double expected) {
  const double round_off = 1e-12;
  return std::abs(value - expected) <= round_off * std::abs(expected);
}

/// Willis' equation with the ring fixed: carrier / sun = sun_teeth / (sun_teeth + ring_teeth).
bool gearset_works() {
  orbearing::gearset::PlanetarySet set;
  set.sun_teeth = 20;
  set.planet_teeth = 20;
  set.ring_teeth = 60;
  set.planets = 3;
  const orbearing::gearset::Drive drive{orbearing::gearset::Member::sun, 1000.0, 100.0};
  return equal(orbearing::gearset::member_speeds(set, drive).carrier, 25.0);
}

/// Pure rolling under a turning outer race: half its speed, times one plus roller / pitch diameter.
bool bearing_works() {
  orbearing::bearing::Bearing bearing;
  bearing.rollers().count = 10;
  bearing.rollers().diameter = 5e-3;
  bearing.rollers().length = 5e-3;
  bearing.pitch_diameter = 40e-3;
  const auto geometry = orbearing::bearing::geometry_of(bearing);
  return equal(orbearing::bearing::kinematic_cage_speed(geometry, 0.0, 80.0), 40.0 * (1.0 + 5.0 / 40.0));
}

bool coupling_works() {
  return orbearing::study::PointResult().status == "ok";
}

}  // namespace

int main() {
  return gearset_works() && bearing_works() && coupling_works() ? EXIT_SUCCESS : EXIT_FAILURE;
}
