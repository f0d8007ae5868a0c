#include "coupling/study/bearing_tangent.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "bearing/equilibrium/aligned_pitch.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/plane.hpp"

namespace orbearing::study {

namespace {

using bearing::vectorised::PitchResults;
using constants::two_pi;
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

// Of whole contacts, as the bearing in motion has them without laminae.
RollerTangent roller_tangent(const PlanetaryDrivetrain& drivetrain, const bearing::BearingGeometry& geometry,
                             bearing::OperatingPoint point) {
  point.bore_tilt.setZero();  // which whole contacts do not feel
  bearing::Bearing whole = of_like_rollers(drivetrain.bearing);
  whole.rollers().laminae = 0;
  const bearing::QuasiStaticOptions options = quasi_static_options(drivetrain);
  const bearing::motion::RaceContactParameters& race = drivetrain.dynamics.race;
  const bool damped = race.damping_law == bearing::motion::DampingLaw::approach_speed;
  const bool filmed = options.film && options.film_approach == bearing::FilmApproach::added;
  const bearing::RollerContacts contacts = rolling_contacts(
      whole, geometry, point.inner_speed, point.outer_speed, filmed ? options.film : std::nullopt);
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
        roller_damping(contacts, pitch, position, static_cast<double>(i) * step, damped ? race.damping : 0.0);
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

}  // namespace orbearing::study
