// The planet bearing of the 150 kW reducer [Gai2025], with the loads its gears give at 150 kW, for tests of
// dynamics.
#pragma once

#include <Eigen/Core>
#include <random>

#include "bearing/motion/initial_state.hpp"
#include "bearing/motion/model.hpp"

namespace orbearing::test {

inline bearing::Bearing reducer_bearing() {
  bearing::Bearing bearing;
  bearing.rollers().count = 15;
  bearing.rollers().diameter = 5.24e-3;
  bearing.rollers().length = 5.7e-3;
  bearing.pitch_diameter = 35.64e-3;
  bearing.inner.seat_diameter = 25e-3;
  bearing.outer.seat_diameter = 47e-3;
  bearing.width = 11.9e-3;
  bearing.cage = {33.44e-3, 38.54e-3, 9e-3, 1310.0, bearing::Race::outer};
  return bearing;
}

/// The same without a cage: as many rollers as go in, somewhat thicker, so that 3 um are left between two of
/// them on the pitch circle.
inline bearing::Bearing full_complement_bearing() {
  bearing::Bearing bearing = reducer_bearing();
  bearing.cage = {};
  bearing.rollers().count = 21;
  bearing.rollers().diameter = bearing.pitch_diameter * std::sin(M_PI / 21.0) - 3e-6;
  return bearing;
}

/// Carrier, bore and load [N] of one of two bearings of a planet at `sun_rpm` revolutions per minute of the
/// sun.
inline bearing::OperatingPoint reducer_point(double sun_rpm) {
  const double sun_speed = sun_rpm * 2.0 * M_PI / 60.0;
  const double carrier_speed = sun_speed / (1.0 + 79.0 / 37.0);
  const double arm = 87.891e-3;
  const double tooth_force = 150e3 / sun_speed / (4.0 * 0.5 * 3e-3 * 37.0 * std::cos(M_PI / 9.0));
  const double sun_angle = 18.879 * M_PI / 180.0;
  const double ring_angle = 23.918 * M_PI / 180.0;
  const double planet_mass = 0.372;
  bearing::OperatingPoint point;
  point.carrier = {carrier_speed, 0.0, arm};
  point.outer_speed = -(sun_speed - carrier_speed) * 37.0 / 22.0;
  point.bore_load = {0.5 * (tooth_force * (std::sin(sun_angle) - std::sin(ring_angle)) +
                            planet_mass * carrier_speed * carrier_speed * arm),
                     0.5 * tooth_force * (std::cos(sun_angle) + std::cos(ring_angle))};
  return point;
}

/// The outer race of one of two bearings of its planet, which bends: compliances as `orbearing mesh` prints them,
/// forms by a mean force of 1200 N of each mesh, masses of a thin ring.
inline bearing::ElasticRace bending_race() {
  bearing::ElasticRace race;
  const Eigen::ArrayXd orders = Eigen::ArrayXd::LinSpaced(7, 0.0, 6.0);
  race.compliance.resize(7);
  race.compliance << 1.96e-10, 0.0, 4.51e-9, 6.45e-10, 1.82e-10, 6.8e-11, 2.9e-11;
  race.cosine.resize(7);
  race.sine.resize(7);
  race.cosine << -5.1e-11, 0.0, -1.44e-9, -3.5e-11, -2.8e-11, -5.9e-12, 6.8e-12;
  race.sine << 0.0, 0.0, -1.5e-10, -3.6e-10, -1.2e-11, -1.08e-10, -5.0e-12;
  race.cosine *= 1200.0;
  race.sine *= 1200.0;
  race.mass = 0.186 * 0.5 * (1.0 + orders.max(1.0).square().inverse());
  return race;
}

inline bearing::motion::DynamicsParameters reducer_parameters() {
  bearing::motion::DynamicsParameters parameters;
  parameters.cage.guide_diameter = 38.88e-3;
  parameters.bore_mass = 0.186;
  return parameters;
}

/// Uniform numbers between -1 and 1, the same in every run.
class Random {
 public:
  double operator()() { return distribution_(engine_); }

 private:
  std::mt19937 engine_{20250909};
  std::uniform_real_distribution<double> distribution_{-1.0, 1.0};
};

/// The start of a run, with every length shaken by `length` [m] and every speed by the share `speed` of the
/// kinematic ones, so that contacts open and close, slide and bounce.
inline Eigen::VectorXd shaken_state(const bearing::motion::BearingModel& model,
                                    const bearing::Bearing& bearing,
                                    const bearing::motion::DynamicsParameters& parameters, double length,
                                    double speed, Random& random) {
  Eigen::VectorXd x = bearing::motion::initial_state(bearing, model, parameters, 0.3).x;
  const auto kinds = bearing::motion::variable_kinds(model.layout);
  const double pitch_radius = model.geometry.pitch_radius;
  const double rotating = 500.0;  // [rad/s]
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    using bearing::motion::VariableKind;
    switch (kinds[static_cast<std::size_t>(i)]) {
      case VariableKind::length:
        x[i] += length * random();
        break;
      case VariableKind::angle:
        x[i] += 20.0 * length / pitch_radius * random();
        break;
      case VariableKind::velocity:
        x[i] += speed * rotating * pitch_radius * random();
        break;
      case VariableKind::angular_speed:
        x[i] += speed * rotating * random();
        break;
    }
  }
  return x;
}

}  // namespace orbearing::test
