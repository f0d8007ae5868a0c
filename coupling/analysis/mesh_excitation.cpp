#include "coupling/analysis/mesh_excitation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "bearing/carrier_frame.hpp"
#include "coupling/analysis/planet_stiffness.hpp"
#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/model.hpp"
#include "gearset/dynamics/static_state.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::analysis {

namespace {

using constants::two_pi;
using Complex = std::complex<double>;
using Eigen::Matrix2cd;
using Eigen::Vector2cd;
using gearset::dynamics::AffineBearing;

constexpr double kLeastShare = 1e-3;  // of the mean load: smaller harmonics move no result
constexpr double kHighest = 3.0;      // of the frequency of a planet on its bearings
constexpr int kLeastOrders = 12, kMostOrders = 48;

// Harmonic of the bearings' force on a planet: the real part of it times e^(i order angle).
Vector2cd force_at(const PlanetStatistics& planet, std::size_t order) {
  const auto coefficient = [order](const SignalStatistics& signal) {
    return Complex(signal.cosines[order - 1], -signal.sines[order - 1]);
  };
  return {coefficient(planet.radial_force), coefficient(planet.tangential_force)};
}

// Force that moves a bore with its share of the planet's mass at the angular frequency `w` [rad/s]: mass x
// acceleration in the carrier's frame.
Matrix2cd inertia_of(double mass, const bearing::CarrierFrame& frame, double w) {
  Matrix2cd matrix;
  for (Eigen::Index i = 0; i < 2; ++i) {
    const Eigen::Vector2d unit = Eigen::Vector2d::Unit(i), none = Eigen::Vector2d::Zero();
    const Eigen::Vector2d by_position = bearing::inertial_acceleration(frame, unit, none);
    const Eigen::Vector2d by_speed = bearing::inertial_acceleration(frame, none, unit);
    matrix.col(i) = -mass * (w * w * unit.cast<Complex>() + by_position.cast<Complex>() +
                             Complex(0.0, w) * by_speed.cast<Complex>());
  }
  return matrix;
}

// From the harmonic of the bearings' force on the planet at `w` [rad/s] to that of the load on one bore.
Matrix2cd load_over_force(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty,
                          const AffineBearing& law, double bore_mass, double w) {
  const double number = drivetrain.bearings_per_planet;
  bearing::CarrierFrame frame = bearing::carrier_frame(duty.point.carrier, drivetrain.dynamics.inertia);
  frame.orbit_radius = 0.0;  // the planet's inertial load in its nominal position is part of the mean load
  const Matrix2cd force_over_motion =
      -(law.stiffness.cast<Complex>() + Complex(0.0, w) * law.damping.cast<Complex>());
  return inertia_of(bore_mass, frame, w) * force_over_motion.inverse() - Matrix2cd::Identity() / number;
}

bool shakes(const PlanetaryDrivetrain& drivetrain) {
  return drivetrain.gear_set && drivetrain.mesh_variation;
}

gearset::dynamics::SetModel gear_model_on(const PlanetaryDrivetrain& drivetrain, const AffineBearing& law) {
  gearset::dynamics::SetParameters set = drivetrain.gear_set();
  set.planet.affine_bearing = law;
  return gearset::dynamics::set_model(std::move(set),
                                      gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive));
}

}  // namespace

GearsOnLaw::GearsOnLaw(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                       const AffineBearing& law)
    : model_(gear_model_on(drivetrain, law)), map_(model_) {
  options_.harmonics = excitation_orders(drivetrain, geometry, law);
}

GearRunResult GearsOnLaw::run(const std::optional<Eigen::VectorXd>& start) const {
  return run_gears_repeating(start ? *start : static_state(model_), model_, map_, options_);
}

GearsOnTangent gears_on_tangent(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  if (!shakes(drivetrain)) return {};
  const AffineBearing tangent = bearing_tangent(drivetrain, geometry);
  GearsOnTangent gears{tangent, GearsOnLaw(drivetrain, geometry, tangent).run()};
  if (!gears.run.completed) throw std::runtime_error("gears: " + gears.run.message);
  return gears;
}

std::optional<Eigen::Vector2d> bearing_force_at_rest(const PlanetaryDrivetrain& drivetrain,
                                                     const DrivetrainGeometry& geometry, int planet) {
  if (!drivetrain.gear_set || drivetrain.in_arrangement) return std::nullopt;
  const gearset::dynamics::SetModel model =
      averaged(gear_model_on(drivetrain, bearing_tangent(drivetrain, geometry)));
  const Eigen::VectorXd rest = static_state(model);
  return bearing_force(model.parameters.planet, model.bearings[static_cast<std::size_t>(planet)], rest,
                       Eigen::VectorXd::Zero(rest.size()));
}

bearing::motion::MeshExcitation excitation_of(const GearRunResult& run, const PlanetaryDrivetrain& drivetrain,
                                              const BearingDuty& duty, const AffineBearing& law,
                                              double bore_mass) {
  bearing::motion::MeshExcitation excitation;
  if (run.planets.empty()) return excitation;
  const PlanetStatistics& planet = run.planets[static_cast<std::size_t>(duty.planet)];
  excitation.angular_frequency = two_pi * run.mesh_frequency;
  const Eigen::Vector2d meshes(duty.gears.radial_force, duty.gears.tangential_force);
  const double least = kLeastShare * meshes.norm() / drivetrain.bearings_per_planet;
  for (int order = 1; order <= static_cast<int>(planet.radial_force.cosines.size()); ++order) {
    const double w = order * excitation.angular_frequency;
    const Vector2cd load = duty.share * load_over_force(drivetrain, duty, law, bore_mass, w) *
                           force_at(planet, static_cast<std::size_t>(order));
    if (load.norm() > least) excitation.harmonics.push_back({order, load.real(), -load.imag()});
  }
  return excitation;
}

int excitation_orders(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                      const AffineBearing& law) {
  const double own = std::sqrt(law.stiffness.norm() / geometry.planet_mass) / two_pi;
  const double meshes = gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive).mesh_frequency;
  return std::clamp(static_cast<int>(std::ceil(kHighest * own / meshes)), kLeastOrders, kMostOrders);
}

}  // namespace orbearing::analysis
