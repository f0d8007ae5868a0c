#include "coupling/study/mesh_ripple.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <stdexcept>

#include "coupling/study/gear_dynamics.hpp"

namespace orbearing::study {

namespace {

using boost::math::double_constants::two_pi;

constexpr double kLeastShare = 1e-3;  // of the mean load: smaller harmonics move nothing that is told

// Load of the meshes on one bearing at each sample. (2, samples)
Eigen::Array2Xd loads_of(const GearSeries& series, const PlanetaryDrivetrain& drivetrain,
                         const DrivetrainGeometry& geometry, const BearingDuty& duty) {
  const double sun = geometry.gears.sun_mesh.working_pressure_angle,
               ring = geometry.gears.ring_mesh.working_pressure_angle;
  const double sense = duty.gears.tangential_force < 0.0 ? -1.0 : 1.0;
  const auto of_sun = series.sun_mesh_force.row(0), of_ring = series.ring_mesh_force.row(0);
  Eigen::Array2Xd loads(2, series.time.size());
  loads.row(0) = std::sin(sun) * of_sun - std::sin(ring) * of_ring;
  loads.row(1) = sense * (std::cos(sun) * of_sun + std::cos(ring) * of_ring);
  return loads / drivetrain.bearings_per_planet;
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
  const Eigen::Array2Xd loads = loads_of(run.series, drivetrain, geometry, duty);
  ripple.angular_frequency = two_pi * run.mesh_frequency;
  const double least = kLeastShare * loads.rowwise().mean().matrix().norm();
  const double samples = static_cast<double>(run.series.time.size());
  for (int order = 1; order <= options.harmonics; ++order) {
    const Eigen::ArrayXd angle = order * ripple.angular_frequency * run.series.time;
    bearing::dynamics::LoadHarmonic harmonic{.order = order};
    harmonic.cosine = 2.0 / samples * (loads.matrix() * angle.cos().matrix());
    harmonic.sine = 2.0 / samples * (loads.matrix() * angle.sin().matrix());
    if (std::hypot(harmonic.cosine.norm(), harmonic.sine.norm()) > least)
      ripple.harmonics.push_back(harmonic);
  }
  return ripple;
}

}  // namespace orbearing::study
