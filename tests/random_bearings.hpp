// Roller bearings, loads and motions drawn at random, the same in every run, for tests of what must always
// hold.
#pragma once

#include <cmath>
#include <cstdint>
#include <ostream>
#include <random>

#include "bearing/equilibrium/quasi_static.hpp"

namespace orbearing::bearing {

inline constexpr unsigned kSeed = 20260101;

struct Draw {
  Bearing bearing;
  OperatingPoint point;
  QuasiStaticOptions options;
};

inline std::ostream& operator<<(std::ostream& out, const Draw& draw) {
  const Bearing& b = draw.bearing;
  const CylindricalRollers& rollers = b.rollers();
  return out << rollers.count << " rollers of " << rollers.diameter << " x " << rollers.length << " m on "
             << b.pitch_diameter << " m, clearance " << b.radial_clearance << " m, load "
             << draw.point.bore_load.transpose() << " N, carrier " << draw.point.carrier.speed << " rad/s at "
             << draw.point.carrier.orbit_radius << " m, bore " << draw.point.outer_speed << " rad/s, film "
             << draw.options.film.has_value();
}

class RandomBearings {
 public:
  explicit RandomBearings(std::uint64_t seed = kSeed) : engine_(seed) {}

  Draw next() {
    Draw draw;
    draw.bearing = bearing();
    draw.point = point();
    draw.options.cage_positions = 1;
    draw.options.first_roller = between(0.0, 6.0);
    if (between(0.0, 1.0) < 0.5) draw.options.film = Lubricant{between(0.003, 0.2), 1.5e-8};
    return draw;
  }

 private:
  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }

  Bearing bearing() {
    Bearing bearing;
    bearing.rollers().count = std::uniform_int_distribution<int>(6, 30)(engine_);
    bearing.rollers().diameter = between(2e-3, 30e-3);
    bearing.rollers().length = bearing.rollers().diameter * between(0.8, 3.0);
    const double touching =
        bearing.rollers().diameter / std::sin(3.141592653589793 / bearing.rollers().count);
    bearing.pitch_diameter = touching * between(1.02, 1.5);
    bearing.radial_clearance = between(-20e-6, 100e-6);
    bearing.inner.seat_diameter = 0.8 * (bearing.pitch_diameter - bearing.rollers().diameter);
    bearing.outer.seat_diameter = 1.2 * (bearing.pitch_diameter + bearing.rollers().diameter);
    bearing.width = 1.2 * bearing.rollers().length;
    bearing.cage = {.inner_diameter = bearing.pitch_diameter - 0.3 * bearing.rollers().diameter,
                    .outer_diameter = bearing.pitch_diameter + 0.3 * bearing.rollers().diameter,
                    .width = bearing.width,
                    .density = 7850.0};
    return bearing;
  }

  OperatingPoint point() {
    OperatingPoint point;
    const double load = std::pow(10.0, between(-2.0, 6.0));
    const double angle = between(0.0, 6.3);
    point.bore_load = load * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    point.carrier = {
        .speed = between(0.0, 600.0), .acceleration = between(-1e3, 1e3), .orbit_radius = between(0.0, 0.5)};
    point.outer_speed = between(-1500.0, 1500.0);
    return point;
  }

  std::mt19937_64 engine_;
};

}  // namespace orbearing::bearing
