#include "app/study/planet_defect_case.hpp"

#include <cmath>

#include "app/case/described_case.hpp"
#include "app/study/planetary_case.hpp"

namespace orbearing::app {

using bearing::defect::Scratch;
using bearing::defect::Scratched;

Eigen::Vector2d load_zone_of(const ResolvedCase& in) {
  const study::PlanetaryDrivetrain drivetrain = drivetrain_of(in);
  const Eigen::Vector2d load = bearing_duty(drivetrain, derive(drivetrain)).point.bore_load;
  return -load.normalized();  // the bore is pushed one way and meets the rollers on the other side of the pin
}

std::vector<system::ScratchedPlanet> scratched_planets_of(const ResolvedCase& in) {
  const auto place = from_case<study::ScratchedPlace>(in);
  Scratch first = from_case<Scratch>(in);
  if (first.race == Scratched::none) return {};
  const Eigen::Vector2d zone = load_zone_of(in);
  const double middle = std::atan2(zone.y(), zone.x());
  const auto turned = [&](Scratch scratch) {
    if (of_element(scratch.race)) return scratch;
    scratch.angle += middle;
    for (double& angle : scratch.more_angles) angle += middle;
    return scratch;
  };
  system::ScratchedPlanet planet{
      .planet = place.planet - 1, .bearing = place.bearing - 1, .scratches = {turned(first)}};
  if (place.also != Scratched::none) {
    first.race = place.also;
    first.angle = place.also_angle;
    first.more_angles.clear();
    planet.scratches.push_back(turned(first));
  }
  return {planet};
}

study::PlanetSampling planet_sampling_of(const ResolvedCase& in) {
  return from_case<study::PlanetSampling>(in);
}

}  // namespace orbearing::app
