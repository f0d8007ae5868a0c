// Planetary sets with dynamics that tests of several kinds share.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "gearset/dynamics/bodies.hpp"
#include "gearset/dynamics/model.hpp"
#include "gearset/mesh/loaded/tooth_pairs.hpp"
#include "gearset/mesh/planetary_meshes.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::dynamics::test {

/// The set of [LinParker1999] with a stationary carrier: table of parameters of that paper.
inline SetParameters lin_parker(int planets) {
  const Support elastic{.stiffness = 1e8};
  const double angle = 24.6 * std::numbers::pi / 180.0;
  const Mesh mesh{.pressure_angle = angle, .stiffness = PeriodicCurve::constant(5e8)};
  SetParameters set{.planets = planets,
                    .sun = {0.40, 0.39, 1.0, elastic},
                    .ring = {2.35, 3.00, 1.0, {.stiffness = 1e8, .torsional_stiffness = 1e9}},
                    .carrier = {5.43, 6.29, 1.0, elastic},
                    .planet = {.mass = 0.66, .inertia = 0.61, .radius = 1.0, .bearing_stiffness = 1e8},
                    .sun_mesh = mesh,
                    .ring_mesh = mesh};
  set.sun_phase.assign(static_cast<std::size_t>(planets), 0.0);
  set.ring_phase.assign(static_cast<std::size_t>(planets), 0.0);
  return set;
}

inline SetModel lin_parker_model(int planets) {
  return set_model(lin_parker(planets), {});
}

/// Two pairs of teeth in contact for `share` of the period from 0 on, then one.
inline PeriodicCurve stepped_stiffness(double mean, double share) {
  const double low = mean / (1.0 + 0.7 * share), high = 1.7 * low;
  return PeriodicCurve(
      [=](double f) {
        return f < share ? high * (1.0 - 0.1 * std::pow(2.0 * f / share - 1.0, 2)) : low * (1.0 + 0.02 * f);
      },
      {0.0, share}, 60);
}

/// The reduction set of [Gai2025] with derived bodies, invented supports and a stepped stiffness.
/// @param ratio planets' phase step: tooth numbers decide it
inline SetParameters reducer_dynamics() {
  const PlanetarySet set = reducer();
  const WorkingGeometry geometry = working_geometry(set);
  const SetBodies bodies = set_bodies(set, geometry,
                                      {.sun_bore = 50e-3,
                                       .ring_outside = 280e-3,
                                       .planet_bore = 47e-3,
                                       .carrier_plates = 14e-3,
                                       .extra_planet_mass = 0.08});
  const auto central = [](const Body& body, const Support& support) {
    return CentralMember{body.mass, body.inertia, body.radius, support};
  };
  const Support elastic{.stiffness = 2e8, .damping = 2e3};
  SetParameters out{
      .planets = set.planets,
      .sun = central(bodies.sun, {.stiffness = 1e8, .damping = 1e3}),
      .ring =
          central(bodies.ring,
                  {.stiffness = 1e9, .damping = 5e3, .torsional_stiffness = 1e9, .torsional_damping = 5e3}),
      .carrier = central(bodies.carrier, elastic),
      .planet = {bodies.planet.mass, bodies.planet.inertia, bodies.planet.radius, 3e8, 1e3},
      .sun_mesh = {.pressure_angle = geometry.sun_mesh.working_pressure_angle,
                   .stiffness = stepped_stiffness(4e8, 0.45),
                   .damping = 2e3,
                   .backlash = 100e-6},
      .ring_mesh = {.pressure_angle = geometry.ring_mesh.working_pressure_angle,
                    .stiffness = stepped_stiffness(5e8, 0.6),
                    .damping = 2e3,
                    .backlash = 100e-6}};
  for (int n = 0; n < set.planets; ++n) {
    const auto share = [&](int teeth) {
      return std::fmod(static_cast<double>(teeth * n) / set.planets, 1.0);
    };
    out.sun_phase.push_back(share(set.sun_teeth));
    out.ring_phase.push_back(0.3 - share(set.ring_teeth));
  }
  return out;
}

/// Teeth of the reducer that touch under load, with relief and crown.
inline void load_teeth(SetParameters& parameters) {
  PlanetarySet set = reducer();
  set.flanks = {.sun_relief = 5e-6, .planet_relief = 8e-6, .ring_crown = 6e-6, .sun_slope = 4e-6};
  const PlanetaryMeshes meshes =
      planetary_meshes(set, working_geometry(set), {}, {}, {});
  constexpr int slices = 4;
  parameters.sun_mesh.loaded = std::make_shared<const LoadedTeeth>(
      tooth_pairs(meshes.sun_gears, sun_mesh_modifications(set.flanks, set.module), slices).teeth);
  parameters.ring_mesh.loaded = std::make_shared<const LoadedTeeth>(
      tooth_pairs(meshes.ring_gears, ring_mesh_modifications(set.flanks, set.module), slices).teeth);
}

inline Operation reducer_operation(double sun_speed) {
  return operation_of(reducer(), {Member::sun, 150e3, sun_speed});
}

/// Numbers between -1 and 1.
class Random {
 public:
  explicit Random(unsigned seed = 1) : engine_(seed) {}
  double operator()() { return distribution_(engine_); }
  Eigen::VectorXd vector(Eigen::Index size) {
    return Eigen::VectorXd::NullaryExpr(size, [this] { return (*this)(); });
  }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> distribution_{-1.0, 1.0};
};

/// The same with all that can be left out: transmission error, misplaced pins, a sun held against turning.
inline SetParameters full_set() {
  SetParameters set = reducer_dynamics();
  set.sun_mesh.error =
      PeriodicCurve([](double f) { return 5e-6 * std::sin(6.0 * f) * f * (1.0 - f); }, {0.0}, 40);
  set.pin_error.resize(2, 4);
  set.pin_error << 1e-5, -2e-5, 0.0, 1e-5, 2e-5, 0.0, 1e-5, -1e-5;
  set.sun.support.torsional_stiffness = 1e6;
  return set;
}

}  // namespace orbearing::gearset::dynamics::test
