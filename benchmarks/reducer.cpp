#include "benchmarks/reducer.hpp"

#include <cmath>

#include "app/case/case_file.hpp"
#include "app/study/planetary_case.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bench {

using constants::two_pi;

double Duty::cage_revolution() const {
  const double speed =
      bearing::kinematic_cage_speed(bearing::geometry_of(bearing), point.inner_speed, point.outer_speed);
  return two_pi / std::abs(speed);
}

analysis::PlanetaryDrivetrain shipped_reducer(MeshForces meshes, Squeeze squeeze) {
  const std::string file = ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml";
  const std::string varying = meshes == MeshForces::varying ? "true" : "false";
  const std::string squeezed = squeeze == Squeeze::off ? "false" : "true";
  const std::string pockets = squeeze == Squeeze::races_and_pockets ? "hydrodynamic" : "none";
  return app::drivetrain_of(
      app::read_case(file, {"film.enabled=true", "contact.squeeze=" + squeezed,
                            "bearing.cage.pocket_film=" + pockets, "gearset.mesh_variation=" + varying,
                            "traction.rolling_law=goksem-hargreaves"}));  // that of the frozen equations
}

Duty duty_at(analysis::PlanetaryDrivetrain drivetrain, double rpm, double clearance) {
  drivetrain.drive.speed = rpm * two_pi / 60.0;
  drivetrain.bearing.radial_clearance = 1e-6 * clearance;
  const analysis::DrivetrainGeometry geometry = analysis::derive(drivetrain);
  const analysis::BearingDuty duty = analysis::bearing_duty(drivetrain, geometry);
  return {drivetrain.bearing, duty.point,
          analysis::dynamics_parameters(drivetrain, geometry, duty,
                                        analysis::gears_on_tangent(drivetrain, geometry)),
          drivetrain.steady_state.allowed_length_error};
}

Duty with_laminae(Duty duty, int laminae) {
  const double length = duty.bearing.rollers().length;
  duty.bearing.rollers().laminae = laminae;
  duty.bearing.rollers().profile = bearing::profile::Iso16281{length, duty.bearing.rollers().diameter, 1.0};
  return duty;
}

Duty with_more_rollers(const Duty& duty, int factor) {
  Duty larger = duty;
  larger.bearing.rollers().count *= factor;
  const double growth = (factor - 1) * duty.bearing.pitch_diameter;
  for (double* diameter : {&larger.bearing.pitch_diameter, &larger.bearing.inner.seat_diameter,
                           &larger.bearing.outer.seat_diameter, &larger.bearing.cage.inner_diameter,
                           &larger.bearing.cage.outer_diameter, &larger.parameters.cage.guide_diameter})
    *diameter += growth;
  larger.point.bore_load *= factor;
  return larger;
}

}  // namespace orbearing::bench
