#include "coupling/study/bearing_tangent.hpp"

#include <Eigen/LU>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <stdexcept>

#include "bearing/equilibrium/race_equilibrium.hpp"
#include "mechanics/plane.hpp"

namespace orbearing::study {

namespace {

using boost::math::double_constants::two_pi;
using Eigen::Matrix2d;
using Eigen::Vector2d;

// Of one bearing, without its support; the displacement is that of the bore from the pin ring.
struct RollerTangent {
  Vector2d displacement = Vector2d::Zero();  // [m]
  Matrix2d compliance = Matrix2d::Zero();    // [m/N]
  Matrix2d retardation =
      Matrix2d::Zero();  // [m s/N]  displacement that damping holds back for a rate of load
};

// Damping of both contacts of each roller as its series of springs passes it on [N s/m].
Matrix2d roller_damping(const bearing::RaceEquilibrium& problem, const bearing::QuasiStaticState& balance,
                        double damping) {
  Matrix2d sum = Matrix2d::Zero();
  for (Eigen::Index j = 0; j < balance.angle.size(); ++j) {
    const double inner = balance.inner_load[j], outer = balance.outer_load[j];
    if (!(inner > 0.0 && outer > 0.0)) continue;
    const double a = problem.contacts.inner.compliance(inner), b = problem.contacts.outer.compliance(outer);
    const Vector2d outward = mechanics::direction(balance.angle[j]);
    sum += damping * (inner * a * a + outer * b * b) / ((a + b) * (a + b)) * outward * outward.transpose();
  }
  return sum;
}

RollerTangent roller_tangent(const PlanetaryDrivetrain& drivetrain, const bearing::BearingGeometry& geometry,
                             const bearing::OperatingPoint& point) {
  const bearing::Bearing like = of_like_rollers(drivetrain.bearing);
  const bearing::QuasiStaticOptions options = quasi_static_options(drivetrain);
  const bearing::motion::RaceContactParameters& race = drivetrain.dynamics.race;
  const bool damped = race.damping_law == bearing::motion::DampingLaw::approach_speed;
  const double share = 1.0 / options.cage_positions;
  const double pitch = two_pi / like.rollers().count;
  RollerTangent mean;
  for (int i = 0; i < options.cage_positions; ++i) {
    const bearing::RaceEquilibrium problem =
        bearing::quasi_static_problem(like, geometry, point, options, share * i * pitch);
    const bearing::QuasiStaticState balance = bearing::solve(problem);
    if (!balance.report.converged) throw std::runtime_error(balance.report.message);
    const Matrix2d compliance = stiffness_at(problem, balance).inverse();
    const Matrix2d damping = roller_damping(problem, balance, damped ? race.damping : 0.0);
    mean.displacement += share * balance.displacement;
    mean.compliance += share * compliance;
    mean.retardation += share * compliance * damping * compliance;
  }
  return mean;
}

}  // namespace

bearing::Bearing of_like_rollers(bearing::Bearing like) {
  like.rollers().diameter_deviation.clear();
  for (std::vector<bearing::RaceHarmonic>* form : {&like.inner.form, &like.outer.form})
    std::erase_if(*form, [](const bearing::RaceHarmonic& wave) { return wave.turning; });
  return like;
}

gearset::dynamics::AffineBearing bearing_tangent(const PlanetaryDrivetrain& drivetrain,
                                                 const DrivetrainGeometry& geometry) {
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const RollerTangent rollers = roller_tangent(drivetrain, geometry.bearing, duty.point);
  const bearing::motion::BearingModel model =
      bearing_model(drivetrain.bearing, duty.point, bearing_dynamics(drivetrain, geometry));
  const double pin = model.support.stiffness;
  const Vector2d mean = rollers.displacement + duty.point.bore_load / pin;
  const Matrix2d unit = Matrix2d::Identity();
  const Matrix2d stiffness = (rollers.compliance + unit / pin).inverse();
  const Matrix2d damping =
      stiffness * (rollers.retardation + unit * model.support.damping / (pin * pin)) * stiffness;
  const double number = drivetrain.bearings_per_planet;
  return {.force = number * (stiffness * mean - duty.point.bore_load),
          .stiffness = number * stiffness,
          .damping = number * damping};
}

double planet_bearing_stiffness(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  const Vector2d along = bearing_duty(drivetrain, geometry).point.bore_load.normalized();
  return 1.0 / along.dot(bearing_tangent(drivetrain, geometry).stiffness.inverse() * along);
}

}  // namespace orbearing::study
