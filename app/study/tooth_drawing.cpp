#include "app/study/tooth_drawing.hpp"

#include <Eigen/Core>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/units.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;
using Eigen::Vector2d;
constexpr double kMillimetre = 1000.0;  // per m
constexpr int kFlankPoints = 40;

// Where a gear's axis stands and which way its teeth point along the line of centres.
struct Axis {
  double centre = 0.0;  // [m]
  double sense = 1.0;
};

// Angle and radius of a point, seen from a gear's axis.
double angle_of(const Axis& axis, const Vector2d& point) {
  return std::atan2(point.x(), axis.sense * (point.y() - axis.centre));
}
double radius_of(const Axis& axis, const Vector2d& point) {
  return std::hypot(point.x(), point.y() - axis.centre);
}

Json flank(const gearset::ExternalTooth& tooth) {
  Json drawn;
  for (const Vector2d& point : gearset::flank_points(tooth, kFlankPoints)) {
    drawn["radius_mm"].push_back(kMillimetre * point.norm());
    drawn["half_angle_deg"].push_back(kDegree * std::atan2(point.x(), point.y()));
  }
  return drawn;
}

Json flank(const gearset::RingTooth& tooth) {
  Json drawn;
  for (int i = 0; i < kFlankPoints; ++i) {
    const double radius = std::lerp(tooth.root_radius, tooth.tip_radius, double(i) / (kFlankPoints - 1));
    drawn["radius_mm"].push_back(kMillimetre * radius);
    drawn["half_angle_deg"].push_back(kDegree * half_thickness_angle(tooth, radius));
  }
  return drawn;
}

// `side`: -1 for the tooth left of the contact, +1 for the one on its right.
template <typename Tooth>
Json gear_json(const char* name, const Tooth& tooth, const Axis& axis, const Vector2d& contact, double side) {
  const double half = half_thickness_angle(tooth, radius_of(axis, contact));
  Json drawn{{"name", name},
             {"teeth", tooth.teeth},
             {"centre_y_mm", kMillimetre * axis.centre},
             {"sense", axis.sense},
             {"axis_deg", kDegree * (angle_of(axis, contact) + side * half)},
             {"base_radius_mm", kMillimetre * tooth.base_radius},
             {"module_mm", kMillimetre * tooth.module}};
  drawn.update(flank(tooth));
  return drawn;
}

Json pair_json(const char* name, double pressure_angle, const Vector2d& contact, const Json& gears) {
  return {{"mesh", name},
          {"working_pressure_angle_deg", kDegree * pressure_angle},
          {"contact_x_mm", kMillimetre * contact.x()},
          {"contact_y_mm", kMillimetre * contact.y()},
          {"gears", gears}};
}

// The force of the tooth on the left: to the right and, as teeth grow thinner outward, outward.
Vector2d force_direction(double pressure_angle) {
  return {std::cos(pressure_angle), std::sin(pressure_angle)};
}

}  // namespace

Json tooth_pairs_json(const gearset::WorkingGeometry& geometry, const gearset::PlanetaryMeshes& meshes) {
  const double base = geometry.planet.base_radius, distance = geometry.centre_distance;
  const double sun_angle = geometry.sun_mesh.working_pressure_angle,
               ring_angle = geometry.ring_mesh.working_pressure_angle;
  const Axis sun{-geometry.sun.base_radius / std::cos(sun_angle), 1.0};
  const Axis above{sun.centre + distance, -1.0};
  const Vector2d in_sun =
      (base * std::tan(sun_angle) - gearset::pitch_point(meshes.sun_gears)) * force_direction(sun_angle);
  const Axis below{-base / std::cos(ring_angle), 1.0};
  const Axis ring{below.centre - distance, 1.0};
  const Vector2d in_ring =
      (gearset::pitch_point(meshes.ring_gears) - base * std::tan(ring_angle)) * force_direction(ring_angle);
  return Json::array({pair_json("sun and planet", sun_angle, in_sun,
                                Json::array({gear_json("sun", geometry.sun, sun, in_sun, -1.0),
                                             gear_json("planet", geometry.planet, above, in_sun, 1.0)})),
                      pair_json("planet and ring", ring_angle, in_ring,
                                Json::array({gear_json("planet", geometry.planet, below, in_ring, -1.0),
                                             gear_json("ring", geometry.ring, ring, in_ring, 1.0)}))});
}

}  // namespace orbearing::app
