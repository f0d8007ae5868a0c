#include "coupling/study/ablation.hpp"

namespace orbearing::study {

std::vector<Ablation> ablations() {
  using Drivetrain = PlanetaryDrivetrain;
  const std::string inertia = "inertia";
  const std::string fit = "clearance";
  return {
      {"all effects", inertia, [](Drivetrain&) {}},
      {"no carrier centrifugal", inertia, [](Drivetrain& d) { d.inertia.carrier_centrifugal = false; }},
      {"no Coriolis", inertia, [](Drivetrain& d) { d.inertia.coriolis = false; }},
      {"no own orbit", inertia, [](Drivetrain& d) { d.inertia.own_orbit = false; }},
      {"cage without mass", inertia, [](Drivetrain& d) { d.bearing.cage.density = 0.0; }},
      {"clearance 0 um", fit, [](Drivetrain& d) { d.bearing.radial_clearance = 0.0; }},
      {"clearance 10 um", fit, [](Drivetrain& d) { d.bearing.radial_clearance = 10e-6; }},
      {"clearance 37 um", fit, [](Drivetrain& d) { d.bearing.radial_clearance = 37e-6; }},
      {"film in the approach", fit, [](Drivetrain& d) { d.film_in_approach = true; }},
  };
}

std::vector<double> life_over_speed(const PlanetaryDrivetrain& drivetrain, const Ablation& ablation,
                                    const std::vector<double>& speeds) {
  PlanetaryDrivetrain changed = drivetrain;
  ablation.change(changed);
  const DrivetrainGeometry geometry = derive(changed);
  std::vector<double> lives;
  for (const double speed : speeds) {
    changed.drive.speed = speed;
    lives.push_back(evaluate(changed, geometry).life_hours);
  }
  return lives;
}

}  // namespace orbearing::study
