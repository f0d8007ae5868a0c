#include "gearset/stepped_planet.hpp"

#include <algorithm>
#include <numeric>

namespace orbearing::gearset {

WillisTeeth willis_teeth(const PlanetarySet& set) {
  if (!set.stepped.present()) return {set.sun_teeth, set.planet_teeth, set.ring_teeth};
  const int second = set.stepped.teeth;
  return {set.sun_teeth * second, set.planet_teeth * second, set.ring_teeth * set.planet_teeth,
          std::gcd(set.planet_teeth, second)};
}

double ring_module(const PlanetarySet& set) {
  return set.stepped.present() ? set.stepped.module.value_or(set.module) : set.module;
}

double ring_face(const PlanetarySet& set) {
  return set.stepped.present() ? set.stepped.face_width.value_or(set.face_width) : set.face_width;
}

GearPlanes gear_planes(const PlanetarySet& set) {
  if (!set.stepped.present()) return {0.0, 0.0, set.face_width};
  const double half = 0.5 * set.face_width, other = 0.5 * ring_face(set), offset = set.stepped.offset;
  const double begin = std::min(-half, offset - other), end = std::max(half, offset + other);
  const double middle = 0.5 * (begin + end);
  return {-middle, offset - middle, end - begin};
}

}  // namespace orbearing::gearset
