#include "gearset/planet_body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/messages.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::planet_body_test {
namespace {

using Point = Eigen::Vector2d;

// Area and polar second moment of the triangle (origin, p, q): the shoelace formula. Negative where the flank
// leans back over an undercut root.
SectionMoments triangle(const Point& p, const Point& q) {
  const double twice_area = p.x() * q.y() - p.y() * q.x();
  return {0.5 * twice_area, twice_area / 12.0 * (p.dot(p) + p.dot(q) + q.dot(q))};
}

SectionMoments half_tooth(const ExternalTooth& tooth, int points) {
  SectionMoments sum;
  const auto add = [&sum](const SectionMoments& part) {
    sum.area += part.area;
    sum.polar_second_moment += part.polar_second_moment;
  };
  const auto flank = flank_points(tooth, points);
  for (std::size_t i = 1; i < flank.size(); ++i) add(triangle(flank[i - 1], flank[i]));
  const double tip = half_thickness_angle(tooth, tooth.tip_radius);
  const double root = std::numbers::pi / tooth.teeth - trochoid_point(tooth, 0.0).half_angle;
  add({0.5 * tip * std::pow(tooth.tip_radius, 2), 0.25 * tip * std::pow(tooth.tip_radius, 4)});
  add({0.5 * root * std::pow(tooth.root_radius, 2), 0.25 * root * std::pow(tooth.root_radius, 4)});
  return sum;
}

TEST(SectionMoments, AgreeWithAPolygonThroughTheFlankPoints) {
  // The polygon's error falls with the square of its 2000 steps: below a millionth of the tooth.
  constexpr double polygon_error = 1e-6;
  for (const double shift : {-0.4594, -0.1661, 0.0, 0.6}) {
    const ExternalTooth tooth = make_external_tooth(22, shift, 3e-3, {});
    const SectionMoments polygon = half_tooth(tooth, 2000);
    const SectionMoments ours = section_moments(tooth, 0.0);
    EXPECT_NEAR(ours.area / (44.0 * polygon.area), 1.0, polygon_error);
    EXPECT_NEAR(ours.polar_second_moment / (44.0 * polygon.polar_second_moment), 1.0, polygon_error);
  }
}

TEST(SectionMoments, LoseTheBore) {
  const ExternalTooth tooth = make_external_tooth(22, 0.0, 3e-3, {});
  const double bore = 20e-3;
  const double hole = std::numbers::pi * bore * bore;
  EXPECT_NEAR(section_moments(tooth, 0.0).area - section_moments(tooth, bore).area, hole, 1e-12 * hole);
}

TEST(PlanetBody, ScalesWithDensityAndWidth) {
  PlanetarySet set = reducer();
  const WorkingGeometry geometry = working_geometry(set);
  const PlanetBody body = planet_body(set, geometry);
  EXPECT_DOUBLE_EQ(body.mass, 7850.0 * 28e-3 * body.area);
  set.density *= 2.0;
  set.face_width *= 3.0;
  EXPECT_DOUBLE_EQ(planet_body(set, geometry).mass, 6.0 * body.mass);
  EXPECT_DOUBLE_EQ(planet_body(set, geometry).inertia, 6.0 * body.inertia);
}

TEST(PlanetBody, InertiaLiesBetweenThoseOfThinRingsAtBoreAndTip) {
  const PlanetarySet set = reducer();
  const WorkingGeometry geometry = working_geometry(set);
  const PlanetBody body = planet_body(set, geometry);
  EXPECT_GT(body.inertia, body.mass * std::pow(0.5 * set.planet_bore, 2));
  EXPECT_LT(body.inertia, body.mass * std::pow(geometry.planet.tip_radius, 2));
}

TEST(PlanetBody, RefusesABoreThatLeavesNoRim) {
  PlanetarySet set = reducer();
  const WorkingGeometry geometry = working_geometry(set);
  set.planet_bore = 2.0 * geometry.planet.root_radius;
  EXPECT_REFUSED(std::domain_error, "planet_body 1", planet_body(set, geometry));
}

}  // namespace
}  // namespace orbearing::gearset::planet_body_test
