#include "coupling/analysis/planet_stiffness.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "bearing/equilibrium/aligned_pitch.hpp"
#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/equilibrium/race_equilibrium.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/linear_algebra.hpp"
#include "mechanics/plane.hpp"

namespace orbearing::analysis {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Compliances without rollers: of meshes (sun, ring) and waves of the race.
struct RimCompliance {
  Eigen::Matrix2d meshes;  // [m/N]
  MatrixXd waves_by_mesh;  // [m/N]  (waves, 2)
  Eigen::VectorXd waves;   // [m/N]  each by its own force
};

RimCompliance rim_compliance(const gearset::rim::RimInfluence& rim, const gearset::MeanLoads& gears,
                             double sun_mesh, double ring_mesh) {
  const double sense = gears.tangential_force < 0.0 ? -1.0 : 1.0;
  const auto waves_by = [&](const gearset::rim::RaceForm& form) {
    return bearing::waves_at_rest({rim.race, form.cosine, sense * form.sine});
  };
  RimCompliance compliance{rim.meshes, {}, bearing::wave_stiffness({rim.race, {}, {}}).cwiseInverse()};
  compliance.meshes.diagonal() += Eigen::Vector2d(1.0 / sun_mesh, 1.0 / ring_mesh);
  compliance.waves_by_mesh.resize(compliance.waves.size(), 2);
  compliance.waves_by_mesh << waves_by(rim.by_sun), waves_by(rim.by_ring);
  return compliance;
}

// Loaded rollers at one position of the cage.
struct LoadedRollers {
  Eigen::Matrix2Xd outward;   // [-]
  MatrixXd shapes;            // [-]    (waves, rollers)
  Eigen::VectorXd stiffness;  // [N/m]
};

LoadedRollers loaded_rollers(const bearing::RaceEquilibrium& problem) {
  const bearing::QuasiStaticState balance = bearing::solve(problem);
  if (!balance.report.converged) throw std::runtime_error(balance.report.message);
  const auto stiffness = [&](Index j) { return balance.rollers[static_cast<std::size_t>(j)].stiffness; };
  std::vector<Index> loaded;
  for (Index j = 0; j < problem.angle.size(); ++j)
    if (stiffness(j) > 0.0) loaded.push_back(j);
  const auto count = static_cast<Index>(loaded.size());
  LoadedRollers rollers{Eigen::Matrix2Xd(2, count), MatrixXd(bearing::wave_count(problem.outer_race), count),
                        Eigen::VectorXd(count)};
  for (Index i = 0; i < count; ++i) {
    const double angle = problem.angle[loaded[static_cast<std::size_t>(i)]];
    rollers.outward.col(i) = mechanics::direction(angle);
    rollers.shapes.col(i) = bearing::wave_shapes(problem.outer_race, angle);
    rollers.stiffness[i] = stiffness(loaded[static_cast<std::size_t>(i)]);
  }
  return rollers;
}

// By deflections of both meshes and displacement of the bore against its pins: from the displacements by each
// mesh force and by each roller's load, the same in all bearings, since rollers deflect far more than short
// waves of the race.
Eigen::Matrix4d against_pins(const RimCompliance& rim, const LoadedRollers& rollers, int bearings) {
  const Index count = rollers.stiffness.size();
  MatrixXd moved(2 + count, 2 + count);
  moved.topLeftCorner<2, 2>() = rim.meshes;
  moved.bottomLeftCorner(count, 2) = bearings * rollers.shapes.transpose() * rim.waves_by_mesh;
  moved.topRightCorner(2, count) = moved.bottomLeftCorner(count, 2).transpose();
  moved.bottomRightCorner(count, count) =
      bearings * bearings * rollers.shapes.transpose() * rim.waves.asDiagonal() * rollers.shapes;
  moved.bottomRightCorner(count, count).diagonal() += bearings * rollers.stiffness.cwiseInverse();
  MatrixXd by_position = MatrixXd::Zero(2 + count, 4);
  by_position.topLeftCorner<2, 2>().setIdentity();
  by_position.bottomRightCorner(count, 2) = -bearings * rollers.outward.transpose();
  const auto borne = mechanics::definite_solution(moved, by_position);
  if (!borne)
    throw std::runtime_error("elastic rim: found teeth, rim and rollers that deflect against their forces");
  return by_position.transpose() * *borne;
}

// With the supports of the pins in series.
Eigen::Matrix4d on_supports(const Eigen::Matrix4d& planet, double support) {
  Eigen::Matrix<double, 6, 6> all = Eigen::Matrix<double, 6, 6>::Zero();  // meshes, planet, pins
  all.topLeftCorner<4, 4>() = planet;
  all.bottomRightCorner<2, 2>() = planet.bottomRightCorner<2, 2>() + support * Eigen::Matrix2d::Identity();
  all.bottomLeftCorner<2, 4>() = -planet.bottomRows<2>();
  all.topRightCorner<4, 2>() = all.bottomLeftCorner<2, 4>().transpose();
  return bearing::without_waves(all, 4);
}

}  // namespace

Eigen::Matrix4d planet_stiffness(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                 double sun_mesh, double ring_mesh) {
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const bearing::Bearing like = of_like_rollers(drivetrain.bearing);
  const bearing::QuasiStaticOptions options = quasi_static_options(drivetrain);
  const RimCompliance rim = rim_compliance(*geometry.rim, duty.gears, sun_mesh, ring_mesh);
  const double support = drivetrain.bearings_per_planet * drivetrain.dynamics.support.stiffness;
  const double pitch = constants::two_pi / like.rollers().count;
  Eigen::Matrix4d compliance = Eigen::Matrix4d::Zero();
  for (int i = 0; i < options.cage_positions; ++i) {
    const LoadedRollers rollers = loaded_rollers(bearing::quasi_static_problem(
        like, geometry.bearing, duty.point, options, i * pitch / options.cage_positions));
    const Eigen::Matrix4d planet = against_pins(rim, rollers, drivetrain.bearings_per_planet);
    compliance += on_supports(planet, support).inverse() / options.cage_positions;
  }
  // The deflection of the bearing is that of the pin from the planet.
  const Eigen::Vector4d sign(1.0, 1.0, -1.0, -1.0);
  return sign.asDiagonal() * Eigen::Matrix4d(compliance.inverse()) * sign.asDiagonal();
}

namespace {

using bearing::vectorised::PitchResults;
using constants::two_pi;
using Eigen::Matrix2d;
using Eigen::Vector2d;

// Tangent of one bearing, without its support; the displacement is that of the bore from the pin ring.
struct RollerTangent {
  Vector2d displacement = Vector2d::Zero();  // [m]
  Matrix2d compliance = Matrix2d::Zero();    // [m/N]
  Matrix2d retardation =
      Matrix2d::Zero();  // [m s/N]  displacement that damping holds back for a rate of load
};

// Damping of both contacts of each roller as its series of springs passes it on [N s/m].
Matrix2d roller_damping(const bearing::RollerContacts& contacts, const PitchResults& pitch,
                        Eigen::Index position, double first_roller, double damping) {
  Matrix2d sum = Matrix2d::Zero();
  const Eigen::Index rollers = pitch.inner_load.cols();
  for (Eigen::Index j = 0; j < rollers; ++j) {
    const double inner = pitch.inner_load(position, j), outer = pitch.outer_load(position, j);
    if (!(inner > 0.0 && outer > 0.0)) continue;
    const double a = contacts.inner.compliance(inner), b = contacts.outer.compliance(outer);
    const Vector2d outward =
        mechanics::direction(first_roller + two_pi * static_cast<double>(j) / static_cast<double>(rollers));
    sum += damping * (inner * a * a + outer * b * b) / ((a + b) * (a + b)) * outward * outward.transpose();
  }
  return sum;
}

// Tangent of whole contacts, as the bearing in motion has them without laminae.
RollerTangent roller_tangent(const PlanetaryDrivetrain& drivetrain, const bearing::BearingGeometry& geometry,
                             bearing::OperatingPoint point) {
  point.bore_tilt.setZero();  // which has no effect on whole contacts
  bearing::Bearing whole = of_like_rollers(drivetrain.bearing);
  whole.rollers().laminae = 0;
  const bearing::QuasiStaticOptions options = quasi_static_options(drivetrain);
  const bearing::motion::RaceContactParameters& race = drivetrain.dynamics.race;
  const bearing::RollerContacts contacts =
      rolling_contacts(whole, geometry, point.inner_speed, point.outer_speed, options.film);
  const double share = 1.0 / options.cage_positions;
  const double step = share * two_pi / whole.rollers().count;
  PitchResults pitch;
  bearing::vectorised::PitchSearch(whole, options).solve(point, pitch);
  RollerTangent mean;
  for (std::size_t i = 0; i < pitch.reports.size(); ++i) {
    if (!pitch.reports[i].converged) throw std::runtime_error(pitch.reports[i].message);
    const auto position = static_cast<Eigen::Index>(i);
    const Matrix2d compliance = pitch.stiffness[i].inverse();
    const Matrix2d damping =
        roller_damping(contacts, pitch, position, static_cast<double>(i) * step, race.damping);
    mean.displacement += share * pitch.displacement.col(position).matrix();
    mean.compliance += share * compliance;
    mean.retardation += share * compliance * damping * compliance;
  }
  return mean;
}

}  // namespace

bearing::Bearing of_like_rollers(bearing::Bearing like) {
  like.rollers().diameter_deviation.clear();
  for (std::vector<bearing::RaceHarmonic>* form : {&like.inner.form, &like.outer.form})
    std::erase_if(*form, [](const bearing::RaceHarmonic& wave) { return wave.rotating; });
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

}  // namespace orbearing::analysis
