#include "coupling/study/planet_stiffness.hpp"

#include <Eigen/LU>
#include <boost/math/constants/constants.hpp>
#include <stdexcept>

#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/equilibrium/race_equilibrium.hpp"
#include "coupling/study/bearing_tangent.hpp"

namespace orbearing::study {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Of rim and teeth: forces by deflections of both meshes and by the waves of the race, without rollers.
MatrixXd rim_stiffness(const DrivetrainGeometry& geometry, const gearset::MeanLoads& gears, double sun_mesh,
                       double ring_mesh) {
  const gearset::rim::RimInfluence& rim = *geometry.rim;
  const double sense = gears.tangential_force < 0.0 ? -1.0 : 1.0;
  const auto waves_by = [&](const gearset::rim::RaceForm& form) {
    return bearing::waves_at_rest({rim.race, form.cosine, sense * form.sine});
  };
  const Eigen::VectorXd own = bearing::wave_stiffness({rim.race, {}, {}}).cwiseInverse();
  MatrixXd compliance = MatrixXd::Zero(2 + own.size(), 2 + own.size());
  compliance.topLeftCorner<2, 2>() = rim.meshes;
  compliance.diagonal().head<2>() += Eigen::Vector2d(1.0 / sun_mesh, 1.0 / ring_mesh);
  compliance.col(0).tail(own.size()) = waves_by(rim.by_sun);
  compliance.col(1).tail(own.size()) = waves_by(rim.by_ring);
  compliance.topRows(2).rightCols(own.size()) = compliance.leftCols(2).bottomRows(own.size()).transpose();
  compliance.diagonal().tail(own.size()) = own;
  return compliance.inverse();
}

// Of the rollers of all bearings, by displacement of the bore against the pins and by the waves of the race.
MatrixXd roller_stiffness(const PlanetaryDrivetrain& drivetrain, const bearing::RaceEquilibrium& problem) {
  const bearing::QuasiStaticState balance = bearing::solve(problem);
  if (!balance.report.converged) throw std::runtime_error(balance.report.message);
  MatrixXd stiffness = bearing::ring_stiffness(problem, balance);
  stiffness.diagonal().tail(stiffness.rows() - 2) -= bearing::wave_stiffness(problem.outer_race);
  return drivetrain.bearings_per_planet * stiffness;
}

// With the waves and the pins free to follow. Coordinates: both meshes, planet, pins, waves.
Eigen::Matrix4d condensed(const MatrixXd& rim, const MatrixXd& rollers, double support) {
  constexpr Index kPlanet = 2, kPin = 4, kWaves = 6;
  const Index waves = rim.rows() - 2;
  MatrixXd of_rim = MatrixXd::Zero(2 + waves, kWaves + waves), of_rollers = of_rim;
  of_rim.leftCols(2).topRows(2).setIdentity();
  of_rim.bottomRightCorner(waves, waves).setIdentity();
  of_rollers.block<2, 2>(0, kPlanet).setIdentity();
  of_rollers.block<2, 2>(0, kPin) = -Eigen::Matrix2d::Identity();
  of_rollers.bottomRightCorner(waves, waves).setIdentity();
  MatrixXd all = of_rim.transpose() * rim * of_rim + of_rollers.transpose() * rollers * of_rollers;
  all.diagonal().segment<2>(kPin).array() += support;
  return bearing::without_waves<4>(all);
}

}  // namespace

Eigen::Matrix4d planet_stiffness(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                 double sun_mesh, double ring_mesh) {
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const bearing::Bearing like = of_like_rollers(drivetrain.bearing);
  const bearing::QuasiStaticOptions options = quasi_static_options(drivetrain);
  const MatrixXd rim = rim_stiffness(geometry, duty.gears, sun_mesh, ring_mesh);
  const double support = drivetrain.bearings_per_planet * drivetrain.dynamics.support.stiffness;
  const double pitch = boost::math::double_constants::two_pi / like.rollers().count;
  Eigen::Matrix4d compliance = Eigen::Matrix4d::Zero();
  for (int i = 0; i < options.cage_positions; ++i) {
    const MatrixXd rollers = roller_stiffness(
        drivetrain, bearing::quasi_static_problem(like, geometry.bearing, duty.point, options,
                                                  i * pitch / options.cage_positions));
    compliance += condensed(rim, rollers, support).inverse() / options.cage_positions;
  }
  // The deflection of the bearing is that of the pin from the planet.
  const Eigen::Vector4d sign(1.0, 1.0, -1.0, -1.0);
  return sign.asDiagonal() * Eigen::Matrix4d(compliance.inverse()) * sign.asDiagonal();
}

}  // namespace orbearing::study
