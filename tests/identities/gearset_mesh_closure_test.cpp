// The teeth of both meshes fill their working circles without backlash, and the rack neither cuts into a
// finished tooth nor leaves metal on it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gearset/working_geometry.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::gearset_mesh_closure_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double root_round_off = 1e-10;  // [rad] the centre distance comes from a root finder

// Helical teeth too, in the transverse section.
std::vector<PlanetarySet> straight_and_helical() {
  std::vector<PlanetarySet> sets = all_sets();
  sets.push_back(wind_stage());
  for (const PlanetarySet& set : all_sets())
    for (const double helix : {-0.2, 0.5}) sets.push_back(with_helix(set, helix));
  return sets;
}

TEST(MeshClosure, SunAndPlanetTeethFillOnePitch) {
  for (const PlanetarySet& set : straight_and_helical()) {
    const WorkingGeometry g = working_geometry(set);
    const double cosine = std::cos(g.sun_mesh.working_pressure_angle);
    const double sun_radius = g.sun.base_radius / cosine;
    const double planet_radius = g.planet.base_radius / cosine;
    EXPECT_NEAR(sun_radius + planet_radius, g.centre_distance, root_round_off);
    const double filled = sun_radius * half_thickness_angle(g.sun, sun_radius) +
                          planet_radius * half_thickness_angle(g.planet, planet_radius);
    EXPECT_NEAR(filled, pi * planet_radius / set.planet_teeth, root_round_off * planet_radius);
  }
}

TEST(MeshClosure, RingAndPlanetTeethFillOnePitch) {
  for (const PlanetarySet& set : straight_and_helical()) {
    const WorkingGeometry g = working_geometry(set);
    const double cosine = std::cos(g.ring_mesh.working_pressure_angle);
    const double ring_radius = g.ring.base_radius / cosine;
    const double planet_radius = g.planet.base_radius / cosine;
    EXPECT_NEAR(ring_radius - planet_radius, g.centre_distance, root_round_off);
    const double filled = ring_radius * half_thickness_angle(g.ring, ring_radius) +
                          planet_radius * half_thickness_angle(g.planet, planet_radius);
    EXPECT_NEAR(filled, pi * planet_radius / set.planet_teeth, root_round_off * planet_radius);
  }
}

struct RackPoint {
  double across;  // [m] from the middle of the rack tooth
  double height;  // [m] above the rolling line
};

// One side of the rack tooth: straight flank and fillet, from the basic rack's own dimensions. A rack whose
// teeth are inclined by the helix angle to the gear's axis is cut by the transverse plane at that angle,
// which leaves heights and stretches what lies across.
std::vector<RackPoint> rack_outline(double shift, double module, const BasicRack& rack, double helix_angle) {
  const double tangent = std::tan(rack.pressure_angle);
  const double centre_depth = rack.addendum + rack.clearance - rack.root_fillet_radius;
  const double centre_across =
      pi / 4.0 - centre_depth * tangent - rack.root_fillet_radius / std::cos(rack.pressure_angle);
  const double flank_end = centre_depth + rack.root_fillet_radius * std::sin(rack.pressure_angle);
  std::vector<RackPoint> outline;
  constexpr int points = 300;
  for (int i = 0; i <= points; ++i) {
    const double depth = std::lerp(-1.5, flank_end, double(i) / points);
    outline.push_back({module * (pi / 4.0 - depth * tangent), module * (shift - depth)});
    const double normal = (pi / 2.0 - rack.pressure_angle) * i / points;
    outline.push_back({module * (centre_across + rack.root_fillet_radius * std::sin(normal)),
                       module * (shift - centre_depth - rack.root_fillet_radius * std::cos(normal))});
  }
  for (RackPoint& point : outline) point.across /= std::cos(helix_angle);
  return outline;
}

// Least gap [rad] between rack and tooth at equal radius in each of `bands` bands of radius, over the whole
// cut.
std::vector<double> least_gaps(const ExternalTooth& tooth, const BasicRack& rack, std::size_t bands) {
  std::vector<double> gaps(bands, 1.0);
  const auto outline = rack_outline(tooth.shift, tooth.module, rack, tooth.helix_angle);
  constexpr int positions = 600;
  for (int i = -positions; i <= positions; ++i) {
    const double roll = 4.0 * tooth.module / std::cos(tooth.helix_angle) * i / positions;
    for (const RackPoint& point : outline) {
      const double x = roll + point.across;
      const double y = tooth.pitch_radius + point.height;
      const double depth = (std::hypot(x, y) - tooth.root_radius) / (tooth.tip_radius - tooth.root_radius);
      if (depth < 0.0 || depth >= 1.0) continue;
      const double angle = pi / tooth.teeth - (std::atan2(x, y) - roll / tooth.pitch_radius);
      double& gap = gaps[static_cast<std::size_t>(depth * static_cast<double>(bands))];
      gap = std::min(gap, angle - half_thickness_angle(tooth, std::hypot(x, y)));
    }
  }
  return gaps;
}

TEST(RackCutting, TouchesTheToothEverywhereAndEntersItNowhere) {
  constexpr double round_off = 1e-10;  // [rad]
  constexpr double sampling = 2e-4;  // [rad] rack steps of module/150 leave gaps of their square over module
  for (const double helix : {0.0, 0.15, 0.5}) {
    for (const double shift : {-0.4594, -0.1661, 0.3}) {
      const ExternalTooth tooth = make_external_tooth(22, shift, 3e-3, {}, helix);
      for (const double gap : least_gaps(tooth, {}, 20)) {
        EXPECT_GT(gap, -round_off) << "shift " << shift << ", helix " << helix;
        EXPECT_LT(gap, sampling) << "shift " << shift << ", helix " << helix;
      }
    }
  }
}

}  // namespace
}  // namespace orbearing::gearset::gearset_mesh_closure_test
