// Helical teeth, geometry and loads in closed form.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "gearset/gear_pair.hpp"
#include "gearset/mean_loads.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::helical_gears_test {
namespace {

using Eigen::Vector3d;
constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;
constexpr double round_off = 1e-12;      // relative
constexpr double root_round_off = 1e-9;  // relative; the centre distance comes from a root finder

TEST(HelicalGears, HaveTheTransverseSectionOfTheStandard) {
  const double helix = 25.0 * degree, normal = 20.0 * degree;
  const ExternalTooth tooth = make_external_tooth(30, 0.2, 2e-3, {}, -helix);
  EXPECT_NEAR(tooth.pitch_radius, 30e-3 / std::cos(helix), round_off);
  EXPECT_NEAR(std::tan(tooth.pressure_angle), std::tan(normal) / std::cos(helix), round_off);
  EXPECT_NEAR(tooth.tip_radius - tooth.pitch_radius, 2e-3 * 1.2, round_off);
  EXPECT_NEAR(tooth.pitch_radius - tooth.root_radius, 2e-3 * 1.05, round_off);
  const double thickness = 2.0 * tooth.pitch_radius * half_thickness_angle(tooth, tooth.pitch_radius);
  EXPECT_NEAR(thickness * std::cos(helix), 2e-3 * (pi / 2.0 + 0.4 * std::tan(normal)), round_off);
  // Both ways to the helix at the base cylinder: by the normal angle, and by the lead.
  EXPECT_NEAR(std::tan(base_helix_angle(normal, helix)), std::tan(helix) * std::cos(tooth.pressure_angle),
              round_off);
  EXPECT_NEAR(overlap_ratio(40e-3, 2e-3, -helix), 40e-3 * std::sin(helix) / (pi * 2e-3), round_off);
}

// Trochoid and involute meet with one tangent where the fillet of the rack meets its flank.
TEST(HelicalGears, HaveRootsThatMeetTheirFlanks) {
  for (const double helix : {0.15, 0.5}) {
    const ExternalTooth tooth = make_external_tooth(40, 0.2, 2e-3, {}, helix);
    ASSERT_FALSE(tooth.undercut);
    const TrochoidPoint end = trochoid_point(tooth, tooth.fillet.end_angle);
    EXPECT_NEAR(end.radius / tooth.form_radius, 1.0, round_off);
    EXPECT_NEAR(end.half_angle, half_thickness_angle(tooth, tooth.form_radius), round_off);
    constexpr double step = 1e-6;
    for (const double normal : {0.3, 0.8, 1.1}) {
      const TrochoidPoint point = trochoid_point(tooth, normal);
      const TrochoidPoint after = trochoid_point(tooth, normal + step),
                          before = trochoid_point(tooth, normal - step);
      EXPECT_NEAR(point.radius_slope, (after.radius - before.radius) / (2.0 * step), 1e-9);
      EXPECT_NEAR(point.half_angle_slope, (after.half_angle - before.half_angle) / (2.0 * step), 1e-8);
    }
  }
}

TEST(HelicalGears, MeshAtTheReferenceDistanceWithoutShifts) {
  PlanetarySet set = with_helix(standard_set(), 15.0 * degree);
  const WorkingGeometry g = working_geometry(set);
  EXPECT_NEAR(g.centre_distance, 60e-3 / std::cos(set.helix_angle), root_round_off);
  EXPECT_NEAR(g.sun_mesh.working_pressure_angle, g.sun.pressure_angle, 1e-6);
  // Tips of equal gears: g_alpha = 2 (sqrt(r_a^2 - r_b^2) - r sin alpha_t), over the transverse base pitch.
  const double reach =
      std::sqrt(g.sun.tip_radius * g.sun.tip_radius - g.sun.base_radius * g.sun.base_radius) -
      g.sun.pitch_radius * std::sin(g.sun.pressure_angle);
  const double pitch = pi * 2e-3 / std::cos(set.helix_angle) * std::cos(g.sun.pressure_angle);
  EXPECT_NEAR(g.sun_mesh.contact_ratio, 2.0 * reach / pitch, 1e-6);
}

// Shifts of the wind turbine's stage from its root diameters, d_f = d -+ 2 m (h_f - x) with one depth h_f of
// the roots; carrier radius 308.000 +- 0.010 mm.
TEST(HelicalGears, OfTheWindTurbineHaveTheirRootsAndTheirDistance) {
  const PlanetarySet set = wind_stage();
  const WorkingGeometry g = working_geometry(set);
  EXPECT_NEAR(g.centre_distance, 308e-3, 0.01e-3);
  EXPECT_NEAR(g.planet_shift, 0.3987, 1e-4);
  EXPECT_NEAR(g.sun_mesh.contact_ratio, 1.5236, 1e-4);
  EXPECT_NEAR(overlap_ratio(set.face_width, set.module, set.helix_angle), 0.9141, 1e-4);
  constexpr double depth = 1.4669;  // in modules
  const auto root = [&](int teeth, double shift) {
    return 1e3 * set.module * (teeth / std::cos(set.helix_angle) - 2.0 * (depth - shift));
  };
  EXPECT_NEAR(root(set.sun_teeth, set.sun_shift), 186.0, 0.1);
  EXPECT_NEAR(root(set.planet_teeth, g.planet_shift), 372.0, 0.1);
}

// A pair whose helix goes to zero goes to the spur pair, and hands do not matter in the transverse section.
TEST(HelicalGears, GoToSpurGears) {
  const PlanetarySet spur = reducer();
  const WorkingGeometry straight = working_geometry(spur);
  for (const double helix : {-1e-6, 1e-6}) {
    const WorkingGeometry slight = working_geometry(with_helix(spur, helix));
    EXPECT_NEAR(slight.centre_distance / straight.centre_distance, 1.0, 1e-9);
    EXPECT_NEAR(slight.planet_shift, straight.planet_shift, 1e-9);
    EXPECT_NEAR(slight.planet.form_radius / straight.planet.form_radius, 1.0, 1e-9);
    EXPECT_NEAR(slight.ring_mesh.contact_ratio / straight.ring_mesh.contact_ratio, 1.0, 1e-9);
  }
  const Drive drive{Member::sun, 150e3, 600.0};
  const MeanLoads slight =
      mean_loads(with_helix(spur, 1e-6), working_geometry(with_helix(spur, 1e-6)), drive);
  const MeanLoads loads = mean_loads(spur, straight, drive);
  EXPECT_NEAR(slight.radial_force / loads.radial_force, 1.0, 1e-9);
  EXPECT_EQ(loads.axial_force, 0.0);
  EXPECT_EQ(loads.sun_thrust, 0.0);
  EXPECT_EQ(loads.tooth_force, loads.normal_force);
}

// Force of the sun on the planet at (a, 0): normal of the sun's right-handed flank at the pitch point, which
// is the cross product of its tangents along the helix and along the involute, scaled to the torque.
Vector3d by_the_flank(const PlanetarySet& set, const WorkingGeometry& g, double torque) {
  const double alpha = g.sun_mesh.working_pressure_angle, radius = g.sun.base_radius / std::cos(alpha);
  const double lead = g.sun.pitch_radius / std::tan(set.helix_angle);  // [m/rad]
  const double side =
      torque > 0.0 ? 1.0 : -1.0;  // the flank that faces the way the sun is turned, or the other
  const Vector3d along_helix(0.0, radius,
                             lead);  // a point of the flank that goes round climbs, if right-handed
  const Vector3d along_flank(std::cos(alpha), -side * std::sin(alpha),
                             0.0);  // outward, the tooth grows thinner
  Vector3d normal = along_helix.cross(along_flank).normalized();
  if (side * normal.y() < 0.0) normal = -normal;
  return normal * std::abs(torque) / (set.planets * radius * std::abs(normal.y()));
}

TEST(HelicalGears, PushAlongTheNormalOfTheirFlanks) {
  for (const double helix : {-0.3, 0.13}) {
    for (const Member driven : {Member::sun, Member::carrier}) {  // the sun's torque changes sign
      const PlanetarySet set = with_helix(reducer(), helix);
      const WorkingGeometry g = working_geometry(set);
      const MeanLoads loads = mean_loads(set, g, {driven, 150e3, 600.0});
      const Vector3d force = by_the_flank(set, g, loads.sun_torque);
      EXPECT_NEAR(loads.tooth_force / force.norm(), 1.0, round_off);
      EXPECT_NEAR(loads.axial_force / force.z(), 1.0, round_off);
      EXPECT_NEAR(force.x(), loads.normal_force * std::sin(g.sun_mesh.working_pressure_angle),
                  round_off * force.norm());
      EXPECT_NEAR(loads.sun_thrust, loads.sun_torque * std::tan(helix) / g.sun.pitch_radius,
                  round_off * loads.tooth_force);
    }
  }
}

// All forces and moments on one planet as vectors: what is left is what its bearings hold.
TEST(HelicalGears, OverturnThePlanetByBothAxialForces) {
  for (const PlanetarySet& set : {wind_stage(), with_helix(reducer(), -0.3)}) {
    const WorkingGeometry g = working_geometry(set);
    const MeanLoads loads = mean_loads(set, g, {Member::sun, 150e3, 600.0});
    const double at_sun = -planet_working_radius(g, g.sun_mesh),
                 at_ring = planet_working_radius(g, g.ring_mesh);
    EXPECT_NEAR(-at_sun + g.sun.base_radius / std::cos(g.sun_mesh.working_pressure_angle), g.centre_distance,
                root_round_off);
    const Vector3d sun(loads.normal_force * std::sin(g.sun_mesh.working_pressure_angle),
                       loads.normal_force * std::cos(g.sun_mesh.working_pressure_angle), loads.axial_force);
    const Vector3d ring(-loads.normal_force * std::sin(g.ring_mesh.working_pressure_angle),
                        loads.normal_force * std::cos(g.ring_mesh.working_pressure_angle),
                        -loads.axial_force);
    const Vector3d force = sun + ring;
    const Vector3d moment = Vector3d(at_sun, 0, 0).cross(sun) + Vector3d(at_ring, 0, 0).cross(ring);
    EXPECT_NEAR(force.x(), loads.radial_force, round_off * loads.tooth_force);
    EXPECT_NEAR(force.y(), loads.tangential_force, round_off * loads.tooth_force);
    EXPECT_EQ(force.z(), 0.0);
    EXPECT_NEAR(moment.x(), 0.0, round_off * loads.tooth_force);
    EXPECT_NEAR(moment.y(), loads.overturning_moment, round_off * std::abs(loads.overturning_moment));
    EXPECT_NEAR(moment.z(), 0.0, round_off * loads.tooth_force);
  }
}

TEST(HelicalGears, HoldTheirThrustWhereTheCaseSays) {
  PlanetarySet set = wind_stage();
  const MeanLoads loads = mean_loads(set, working_geometry(set), {Member::carrier, 750e3, 2.3});
  for (const SunThrust where : {SunThrust::housing, SunThrust::carrier}) {
    set.sun_thrust = where;
    const AxialReactions held = axial_reactions(set, loads);
    const bool carrier = where == SunThrust::carrier;
    EXPECT_EQ(held.sun, carrier ? 0.0 : -loads.sun_thrust);
    EXPECT_EQ(held.carrier, carrier ? -loads.sun_thrust : 0.0);
    EXPECT_EQ(held.sun + held.carrier + held.ring, 0.0);
  }
  EXPECT_GT(std::abs(loads.sun_thrust), 1e3);
}

TEST(HelicalGears, OfAPairFollowTheSameRules) {
  GearPair pair{{30, 40}, {0.1, -0.2}, 2e-3, 20e-3, 25e-3, {}};
  pair.helix_angle = -15.0 * degree;
  const PairGeometry g = pair_geometry(pair);
  // Thicknesses at the working circles fill a pitch.
  double filled = 0.0;
  for (const ExternalTooth& tooth : g.gears) {
    const double radius = tooth.base_radius / std::cos(g.working_pressure_angle);
    filled += radius * half_thickness_angle(tooth, radius);
  }
  EXPECT_NEAR(filled, pi * g.centre_distance / 70.0, root_round_off * g.centre_distance);
  EXPECT_LT(g.base_helix_angle, 0.0);
  EXPECT_NEAR(g.overlap_ratio, 20e-3 * std::sin(15.0 * degree) / (pi * 2e-3), round_off);
}

}  // namespace
}  // namespace orbearing::gearset::helical_gears_test
