#include "coupling/study/ablation.hpp"

#include <tbb/parallel_for.h>

#include <exception>

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

std::vector<Ablation> dynamic_ablations() {
  using Drivetrain = PlanetaryDrivetrain;
  using bearing::dynamics::TractionLaw;
  const std::string group = "dynamic";
  return {
      {"all effects", group, [](Drivetrain&) {}},
      {"no Coriolis", group, [](Drivetrain& d) { d.inertia.coriolis = false; }},
      {"no carrier centrifugal", group, [](Drivetrain& d) { d.inertia.carrier_centrifugal = false; }},
      {"constant mesh stiffness", group, [](Drivetrain& d) { d.gear_set = nullptr; }},
      {"film in the approach", group, [](Drivetrain& d) { d.film_in_approach = true; }},
      {"limiting-shear traction", group,
       [](Drivetrain& d) { d.dynamics.race.traction = TractionLaw::limiting_shear; }},
  };
}

std::vector<PointResult> evaluate_all(const PlanetaryDrivetrain& drivetrain,
                                      const std::vector<Ablation>& ablations,
                                      const std::vector<double>& speeds, Fidelity fidelity) {
  std::vector<PointResult> points(ablations.size() * speeds.size());
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    PlanetaryDrivetrain changed = drivetrain;
    ablations[i / speeds.size()].change(changed);
    changed.drive.speed = speeds[i % speeds.size()];
    try {
      points[i] = evaluate(changed, derive(changed), fidelity);
    } catch (const std::exception& error) {
      points[i].status = error.what();
    }
  });
  return points;
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
