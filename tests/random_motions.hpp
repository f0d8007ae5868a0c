// Roller bearings with all that their motion in time can be given, drawn at random. Each draw has a number of
// its own, so that any of them can be run again by itself.
#pragma once

#include <algorithm>
#include <vector>

#include "bearing/motion/parameters.hpp"
#include "tests/random_bearings.hpp"

namespace orbearing::bearing {

struct MotionDraw {
  Bearing bearing;
  OperatingPoint point;
  motion::DynamicsParameters parameters;
  double first_roller = 0.0;  // [rad]
  double pitch_speed = 0.0;   // [m/s]  of the turning race at the pitch circle
};

inline std::ostream& operator<<(std::ostream& out, const MotionDraw& draw) {
  const auto& race = draw.parameters.race;
  return out << Draw{draw.bearing, draw.point, {}} << " in the approach " << race.film_in_approach
             << ", limiting shear " << (race.traction == TractionLaw::limiting_shear) << ", mixed "
             << (race.lubrication == motion::Lubrication::mixed) << ", waves "
             << draw.bearing.inner.form.size() << " and " << draw.bearing.outer.form.size()
             << ", unequal rollers " << draw.bearing.rollers().diameter_deviation.size() << ", land of "
             << draw.parameters.cage.guide_diameter << " m, excitation "
             << draw.parameters.excitation.harmonics.size();
}

class RandomMotion {
 public:
  explicit RandomMotion(unsigned number) : seed_{kSeed, number}, engine_(seed_) {}

  MotionDraw draw() {
    MotionDraw draw;
    draw.bearing = RandomBearings(engine_()).next().bearing;
    draw_clearance(draw.bearing);
    draw_form(draw.bearing);
    draw_speeds(draw);
    draw_load(draw);
    draw_oil(draw.parameters);
    draw_cage(draw);
    draw_surroundings(draw);
    draw.first_roller = between(0.0, 6.28);
    return draw;
  }

 private:
  // Loads in time are limited by the strength of the races: a pressure of some 4 GPa over the projected area
  // of a roller.
  static constexpr double kLargestLoadPerArea = 2e8;  // [Pa]  of roller diameter times length
  static constexpr double kFastest = 100.0;     // [m/s]  of the pitch circle: 1.9 million rpm mm, beyond what
                                                //        is sold
  static constexpr double kSteepest = 30000.0;  // [m/s^2]  at the pin: 3000 times gravity, a geared turbofan

  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }
  double decades(double least, double most) {
    return std::pow(10.0, between(std::log10(least), std::log10(most)));
  }
  bool chance(double share) { return between(0.0, 1.0) < share; }

  void draw_clearance(Bearing& bearing) {
    bearing.radial_clearance = chance(0.2) ? 0.0 : between(-5e-6, 100e-6);
    bearing.contact_law = chance(0.5) ? ContactLaw::palmgren : ContactLaw::iso16281;
  }

  std::vector<RaceHarmonic> form() {
    std::vector<RaceHarmonic> waves;
    for (int n = std::uniform_int_distribution<int>(1, 3)(engine_); n > 0; --n) {
      const int order = std::uniform_int_distribution<int>(2, 25)(engine_);
      waves.push_back({order, decades(1e-8, 2e-5 / order), between(0.0, 6.28), chance(0.5)});
    }
    return waves;
  }

  void draw_form(Bearing& bearing) {
    if (chance(0.3)) bearing.inner.form = form();
    if (chance(0.3)) bearing.outer.form = form();
    if (chance(0.3))
      for (int j = 0; j < bearing.rollers().count; ++j)
        bearing.rollers().diameter_deviation.push_back(between(-5e-6, 5e-6));
  }

  // Mostly a planet's bearing, else one in a stationary housing with either race rotating.
  void draw_speeds(MotionDraw& draw) {
    draw.pitch_speed = chance(0.05) ? decades(0.2, 1.0) : decades(1.0, kFastest);
    const double speed = (chance(0.5) ? 1.0 : -1.0) * draw.pitch_speed / (0.5 * draw.bearing.pitch_diameter);
    const bool planet = chance(0.8);
    (planet || chance(0.5) ? draw.point.outer_speed : draw.point.inner_speed) = speed;
    if (!planet) return;
    const double radius = draw.bearing.pitch_diameter * between(0.5, 5.0);
    const double fastest = std::min(600.0, std::sqrt(kSteepest / radius));
    draw.point.carrier = {.speed = between(0.0, fastest),
                          .acceleration = chance(0.3) ? between(-1e3, 1e3) : 0.0,
                          .orbit_radius = radius};
  }

  void draw_load(MotionDraw& draw) {
    const double area = draw.bearing.rollers().diameter * draw.bearing.rollers().length;
    const double load = decades(1e-4, 1.0) * kLargestLoadPerArea * area * draw.bearing.rollers().count / 4.0;
    const double angle = between(0.0, 6.28);
    draw.point.bore_load = load * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    if (!chance(0.5)) return;
    draw.parameters.excitation.angular_frequency =
        between(15.0, 100.0) * std::abs(draw.point.outer_speed + draw.point.inner_speed);
    for (int order = 1; order <= 5; ++order)
      draw.parameters.excitation.harmonics.push_back(
          {order, {between(-0.1, 0.1) * load / order, 0.0}, {0.0, between(-0.1, 0.1) * load / order}});
  }

  void draw_oil(motion::DynamicsParameters& parameters) {
    parameters.lubricant = {decades(0.002, 0.3), between(1e-8, 2.5e-8)};
    parameters.race.film_in_approach = chance(0.5);
    chance(0.05);  // of a choice that is no more: each number stays the bearing that it was
    if (chance(0.5)) parameters.race.traction = TractionLaw::limiting_shear;
    if (chance(0.4)) parameters.race.lubrication = motion::Lubrication::mixed;
    parameters.race.roughness = decades(0.05e-6, 2e-6);
    parameters.race.damping = decades(0.01, 0.5);
    parameters.race.friction = between(0.01, 0.12);
    parameters.race.rolling_resistance = chance(0.8);
    parameters.drag.on = chance(0.8);
    parameters.drag.oil_share = decades(0.001, 0.5);
  }

  void draw_cage(MotionDraw& draw) {
    Bearing& bearing = draw.bearing;
    const double spacing = bearing.pitch_diameter * std::sin(3.141592653589793 / bearing.rollers().count);
    motion::CageParameters& cage = draw.parameters.cage;
    cage.pocket_clearance = std::min(0.5e-3, between(0.1, 0.6) * (spacing - bearing.rollers().diameter));
    cage.pocket_stiffness = decades(3e6, 3e8);
    bearing.cage.density = chance(0.5) ? 1310.0 : 7850.0;
    if (chance(0.15)) return;
    const double clearance = decades(0.05e-3, 1e-3);
    bearing.cage.guidance = chance(0.5) ? Race::outer : Race::inner;
    cage.guide_diameter = bearing.cage.guidance == Race::outer ? bearing.cage.outer_diameter + clearance
                                                               : bearing.cage.inner_diameter - clearance;
    chance(0.05);  // likewise
  }

  void draw_surroundings(MotionDraw& draw) {
    draw.parameters.support.stiffness = decades(3e7, 1e10);
    draw.parameters.bore_mass = geometry_of(draw.bearing).outer_ring_mass * decades(1.0, 10.0);
    const auto on = [this] { return chance(0.85); };
    draw.parameters.inertia = {on(), on(), on(), on()};
    if (chance(0.3)) draw.parameters.race.rolling_law = motion::RollingLaw::goksem_hargreaves;
  }

  std::seed_seq seed_;
  std::mt19937_64 engine_;
};

}  // namespace orbearing::bearing
