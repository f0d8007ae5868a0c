#include "coupling/fmu/shown_members.hpp"

namespace orbearing::fmu {

using mechanics::Extents;

ShownMembers shown_members(const system::DrivenBearingSetup& m) {
  const bearing::Bearing& bearing = m.bearing;
  const bearing::Cage& cage = bearing.cage;
  const bearing::CylindricalRollers& rollers = bearing.rollers();
  const bearing::motion::RaceContactParameters& race = m.dynamics.race;
  const bearing::motion::CageParameters& motion = m.dynamics.cage;
  const bearing::motion::OilDragParameters& drag = m.dynamics.drag;
  return {.parameters = Extents(
              bearing.material, rollers.diameter, rollers.length, bearing.pitch_diameter,
              bearing.radial_clearance, bearing.inner.seat_diameter, bearing.outer.seat_diameter,
              bearing.width, cage.inner_diameter, cage.outer_diameter, cage.width, cage.density,
              m.dynamics.lubricant, race.damping, race.friction, race.sliding_scale, race.limiting_friction,
              race.roughness, race.boundary_friction, motion.pocket_clearance, motion.pocket_stiffness,
              motion.pocket_damping, motion.pocket_friction, motion.guide_diameter,
              motion.largest_eccentricity, motion.touch_down_stiffness, m.dynamics.neighbours,
              drag.oil_density, drag.oil_share, m.dynamics.support, m.dynamics.bore_mass, m.orbit_radius,
              m.first_roller, m.bore_tilt, m.start_load, m.reduction_factor, m.allowed_length_error),
          .constants = Extents(rollers.count)};
}

ShownMembers shown_members(const system::DrivenGearsSetup& m) {
  const gearset::dynamics::SetParameters& set = m.set;
  const gearset::dynamics::Support &sun = set.sun.support, &ring = set.ring.support,
                                   &carrier = set.carrier.support;
  return {.parameters = Extents(
              set.sun.mass, set.sun.inertia, sun.stiffness, sun.damping, sun.torsional_stiffness,
              sun.torsional_damping, set.ring.mass, set.ring.inertia, ring.stiffness, ring.damping,
              ring.torsional_stiffness, ring.torsional_damping, set.carrier.mass, set.carrier.inertia,
              carrier.stiffness, carrier.damping, carrier.torsional_stiffness, carrier.torsional_damping,
              set.planet.mass, set.planet.inertia, set.planet.bearing_stiffness, set.sun_mesh.damping,
              set.sun_mesh.backlash, set.ring_mesh.damping, set.ring_mesh.backlash, m.allowed_share),
          .constants = Extents(set.planets)};
}

}  // namespace orbearing::fmu
