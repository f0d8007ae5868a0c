#include "coupling/study/mesh_ripple.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <stdexcept>

#include "coupling/study/gear_dynamics.hpp"

namespace orbearing::study {

namespace {

using boost::math::double_constants::two_pi;

constexpr double kLeastShare = 1e-3;  // of the mean load: smaller harmonics move nothing that is told

// Load of the meshes on one bearing by their forces, along x and y.
Eigen::Vector2d load_of(double sun_force, double ring_force, const PlanetaryDrivetrain& drivetrain,
                        const DrivetrainGeometry& geometry, const BearingDuty& duty) {
  const double sun = geometry.gears.sun_mesh.working_pressure_angle,
               ring = geometry.gears.ring_mesh.working_pressure_angle;
  const double sense = duty.gears.tangential_force < 0.0 ? -1.0 : 1.0;
  return Eigen::Vector2d(std::sin(sun) * sun_force - std::sin(ring) * ring_force,
                         sense * (std::cos(sun) * sun_force + std::cos(ring) * ring_force)) /
         drivetrain.bearings_per_planet;
}

}  // namespace

bearing::dynamics::MeshRipple mesh_ripple(const PlanetaryDrivetrain& drivetrain,
                                          const DrivetrainGeometry& geometry, const BearingDuty& duty) {
  bearing::dynamics::MeshRipple ripple;
  if (!drivetrain.gear_set || !drivetrain.mesh_variation) return ripple;
  const gearset::dynamics::SetModel model = gearset::dynamics::set_model(
      drivetrain.gear_set(), gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive));
  const GearRunOptions options;
  const GearRunResult run = run_gears(model, options);
  if (!run.completed) throw std::runtime_error("gears: " + run.message);
  const SignalStatistics& sun = run.planets[static_cast<std::size_t>(duty.planet)].sun_mesh_force;
  const SignalStatistics& ring = run.planets[static_cast<std::size_t>(duty.planet)].ring_mesh_force;
  const auto load = [&](double sun_force, double ring_force) {
    return load_of(sun_force, ring_force, drivetrain, geometry, duty);
  };
  ripple.angular_frequency = two_pi * run.mesh_frequency;
  const double least = kLeastShare * load(sun.mean, ring.mean).norm();
  for (std::size_t i = 0; i < sun.amplitudes.size(); ++i) {
    const bearing::dynamics::LoadHarmonic harmonic{.order = static_cast<int>(i) + 1,
                                                   .cosine = load(sun.cosines[i], ring.cosines[i]),
                                                   .sine = load(sun.sines[i], ring.sines[i])};
    if (std::hypot(harmonic.cosine.norm(), harmonic.sine.norm()) > least)
      ripple.harmonics.push_back(harmonic);
  }
  return ripple;
}

}  // namespace orbearing::study
