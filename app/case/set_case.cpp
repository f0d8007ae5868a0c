#include "app/case/set_case.hpp"

#include <cmath>

#include "app/case/described_case.hpp"

namespace orbearing::app {

namespace {

double planet_bore_of(const ResolvedCase& in, const gearset::PlanetarySet& set) {
  if (in.has("bearing.outside_diameter")) return in.quantity("bearing.outside_diameter");
  constexpr double feet = 2.5;  // [module]  of two standard teeth
  return in.number("gearset.planet_bore_ratio") * set.module *
         (set.planet_teeth / std::cos(set.helix_angle) - feet);
}

}  // namespace

gearset::PlanetarySet set_of(const ResolvedCase& resolved) {
  auto set = from_case<gearset::PlanetarySet>(resolved);
  set.planet_bore = planet_bore_of(resolved, set);
  set.density = resolved.quantity("material.density");
  return set;
}

}  // namespace orbearing::app
