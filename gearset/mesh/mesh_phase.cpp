#include "gearset/mesh/mesh_phase.hpp"
#include "mechanics/constants.hpp"

#include <cmath>

namespace orbearing::gearset {

namespace {

using constants::pi;

}  // namespace

MeshMotion mesh_motion(double sun_torque, double sun_speed_relative) {
  return {.sun_drives = sun_torque * sun_speed_relative > 0.0, .sun_anticlockwise = sun_speed_relative > 0.0};
}

double whole_periods_off(double periods) {
  constexpr double round_off = 1e-12;
  const double fraction = periods - std::floor(periods);
  return fraction > 1.0 - round_off || fraction < round_off ? 0.0 : fraction;
}

double sun_mesh_lag(int sun_teeth, double planet_angle, const MeshMotion& motion) {
  const double teeth = sun_teeth * planet_angle / (2.0 * pi);
  return whole_periods_off(motion.sun_anticlockwise ? teeth : -teeth);
}

double ring_mesh_lag(int ring_teeth, double planet_angle, const MeshMotion& motion) {
  const double teeth = ring_teeth * planet_angle / (2.0 * pi);
  return whole_periods_off(motion.sun_anticlockwise ? -teeth : teeth);
}

double ring_to_sun_lag(const MeshingGears& sun_mesh, const MeshingGears& ring_mesh, double sun_working_angle,
                       double ring_working_angle) {
  const ExternalTooth& planet = std::get<ExternalTooth>(sun_mesh.second.tooth);
  // From the tooth that touches at the sun's tangent point to one that touches at the ring's, opposite
  // flanks.
  const double between = planet.teeth / (2.0 * pi) *
                         (2.0 * base_half_angle(planet) + sun_working_angle + ring_working_angle - pi);
  const double begins = (contact_begin(sun_mesh) + contact_begin(ring_mesh)) / sun_mesh.base_pitch;
  const double lead = between - begins;
  return whole_periods_off(sun_mesh.first_drives ? -lead : lead);
}

}  // namespace orbearing::gearset
