// Influence functions of a planet's rim.
#include "gearset/rim/rim_influence.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>

#include "gearset/planet_body.hpp"
#include "mechanics/constants.hpp"
#include "tests/messages.hpp"

namespace orbearing::gearset::rim::rim_influence_test {
namespace {

using constants::pi;

PlanetarySet reducer() {
  PlanetarySet set;
  set.sun_teeth = 37;
  set.planet_teeth = 22;
  set.ring_teeth = 79;
  set.planets = 4;
  set.module = 3e-3;
  set.sun_shift = 0.2618;
  set.ring_shift = 0.4146;
  set.face_width = 0.028;
  set.planet_bore = 0.047;
  return set;
}

constexpr double kRaceRadius = 0.02044, kRingWidth = 0.0238;  // [m]

struct Planet {
  PlanetarySet set = reducer();
  WorkingGeometry geometry = working_geometry(set);
  RimSection section = rim_section(set, geometry, kRaceRadius, kRingWidth);
};

double area_of(const SectorMesh& mesh, double width) {
  double sum = 0.0;  // of the polygon of all eight nodes
  for (std::size_t e = 0; e < mesh.element.size(); ++e) {
    if (mesh.width[e] != width) continue;
    constexpr std::array<std::size_t, 8> around{0, 4, 1, 5, 2, 6, 3, 7};
    for (std::size_t i = 0; i < 8; ++i) {
      const Eigen::Vector2d a = mesh.node[static_cast<std::size_t>(mesh.element[e][around[i]])];
      const Eigen::Vector2d b = mesh.node[static_cast<std::size_t>(mesh.element[e][around[(i + 1) % 8]])];
      sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
  }
  return sum;
}

TEST(SectorMesh, HasTheAreaOfToothAndRim) {
  const Planet planet;
  const SectorMesh mesh = sector_mesh(planet.section, 3 * Fineness{});
  const double gear = section_moments(planet.geometry.planet, planet.section.seat_radius).area / 22.0;
  const double ring = pi * (std::pow(planet.section.seat_radius, 2) - std::pow(kRaceRadius, 2)) / 22.0;
  EXPECT_NEAR(area_of(mesh, planet.section.face_width) / gear, 1.0, 1e-4);
  EXPECT_NEAR(area_of(mesh, kRingWidth) / ring, 1.0, 1e-4);
}

TEST(SectorMesh, RefusesARaceOutsideItsSeat) {
  Planet planet;
  planet.section.race_radius = 0.024;
  EXPECT_REFUSED(std::invalid_argument, "rim_influence 1", sector_mesh(planet.section, {}));
  planet.section.race_radius = kRaceRadius;
  planet.section.seat_radius = planet.geometry.planet.root_radius;
  EXPECT_REFUSED(std::invalid_argument, "rim_influence 2", sector_mesh(planet.section, {}));
}

TEST(RimInfluence, DoesNotDependOnTheElements) {
  const Planet planet;
  const RimInfluence shipped = rim_influence(planet.section, planet.geometry, {});
  const RimInfluence fine = rim_influence(planet.section, planet.geometry, {}, 12, 3 * Fineness{});
  const double size = fine.race.maxCoeff();
  EXPECT_LT((shipped.race - fine.race).abs().maxCoeff(), 2e-3 * size);
  for (const auto form : {&RimInfluence::by_sun, &RimInfluence::by_ring}) {
    const double largest = (fine.*form).cosine.abs().maxCoeff();
    EXPECT_LT(((shipped.*form).cosine - (fine.*form).cosine).abs().maxCoeff(), 3e-3 * largest);
    EXPECT_LT(((shipped.*form).sine - (fine.*form).sine).abs().maxCoeff(), 3e-3 * largest);
  }
  EXPECT_LT((shipped.meshes - fine.meshes).norm(), 3e-3 * fine.meshes.norm());
}

// The forces of both meshes press the planet together from the sun's side and the ring's: an oval, wide
// across.
TEST(RimInfluence, MeshesPressThePlanetTogether) {
  const Planet planet;
  const RimInfluence rim = rim_influence(planet.section, planet.geometry, {});
  EXPECT_LT(rim.by_sun.cosine[2], 0.0);
  EXPECT_LT(rim.by_ring.cosine[2], 0.0);
  EXPECT_EQ(rim.by_sun.cosine[1], 0.0);
  EXPECT_TRUE((rim.race.tail(11) > 0.0).all());
  EXPECT_LT(rim.race[12], 1e-4 * rim.race[2]);  // what is left out beyond
}

// Energy of both meshes is positive whatever their forces, and the same read either way.
TEST(RimInfluence, MeshesAreReciprocal) {
  const Planet planet;
  const RimInfluence rim = rim_influence(planet.section, planet.geometry, {});
  EXPECT_NEAR(rim.meshes(0, 1), rim.meshes(1, 0), 1e-9 * rim.meshes.norm());
  EXPECT_GT(rim.meshes.determinant(), 0.0);
  EXPECT_GT(rim.meshes.trace(), 0.0);
}

TEST(RimInfluence, FallsWithTheModulus) {
  const Planet planet;
  const mechanics::Material stiff{.youngs_modulus = 206e15};
  const RimInfluence soft = rim_influence(planet.section, planet.geometry, {});
  const RimInfluence rigid = rim_influence(planet.section, planet.geometry, stiff);
  EXPECT_LT((1e6 * rigid.race - soft.race).abs().maxCoeff(), 1e-9 * soft.race.maxCoeff());
}

// A single narrow bearing under a wide face: no wave has a negative compliance.
TEST(RimInfluence, OfANarrowRingIsPositive) {
  Planet planet;
  planet.section.ring_width = 0.3 * kRingWidth;
  const RimInfluence narrow = rim_influence(planet.section, planet.geometry, {});
  EXPECT_GT(narrow.race.head<1>()[0], 0.0);
  EXPECT_TRUE((narrow.race.tail(11) > 0.0).all());
}

// Without an outer ring the rollers run in the gear's own bore.
TEST(RimInfluence, ServesABoreWithoutRings) {
  Planet planet;
  planet.section.seat_radius = planet.section.race_radius;
  planet.section.ring_width = 0.0;
  const RimInfluence one_piece = rim_influence(planet.section, planet.geometry, {});
  EXPECT_NEAR(one_piece.race[2] / rim_influence(Planet().section, planet.geometry, {}).race[2], 0.95, 0.05);
}

}  // namespace
}  // namespace orbearing::gearset::rim::rim_influence_test
