#include "bearing/equilibrium/quasi_static.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "bearing/carrier_frame.hpp"
#include "bearing/contact/race_contact.hpp"
#include "bearing/contact/race_form.hpp"
#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/equilibrium/lamina_bearing.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing {

namespace {

using constants::two_pi;

// Rigid rollers at pure rolling on circles of the pitch radius: what the quasi-static model takes from
// kinematics.
double roller_inertial_load(const BearingGeometry& geometry, const CarrierFrame& frame, double cage_speed,
                            double angle) {
  return geometry.element_mass *
         radial_inertial_acceleration(frame, geometry.pitch_radius, angle, cage_speed);
}

Eigen::ArrayXd roller_angles(int rollers, double first_roller) {
  return first_roller + Eigen::ArrayXd::LinSpaced(rollers, 0.0, two_pi * (rollers - 1) / rollers);
}

std::string not_finite_text(const OperatingPoint& point) {
  std::ostringstream text;
  text << "operating point of a bearing: found load (" << point.bore_load.transpose() << ") N, carrier "
       << point.carrier.speed << " rad/s, " << point.carrier.acceleration << " rad/s^2 at "
       << point.carrier.orbit_radius << " m, races " << point.inner_speed << " and " << point.outer_speed
       << " rad/s, tilt (" << point.bore_tilt.transpose()
       << ") rad. All must be finite numbers: check the inputs of this operating point";
  return text.str();
}

// Approach of the races caused by waves of the races and by unequal rollers; empty where there are none.
Eigen::ArrayXd extra_approach(const Bearing& bearing, const Eigen::ArrayXd& angle) {
  if (is_round(bearing)) return {};
  Eigen::ArrayXd extra(angle.size());
  for (Eigen::Index j = 0; j < angle.size(); ++j)
    extra[j] = form_at(bearing.inner.form, angle[j], 0.0).height -
               form_at(bearing.outer.form, angle[j], 0.0).height +
               diameter_deviation(bearing, static_cast<std::size_t>(j));
  return extra;
}

}  // namespace

void require_finite(const OperatingPoint& point) {
  const CarrierMotion& carrier = point.carrier;
  const bool finite = point.bore_load.allFinite() && std::isfinite(carrier.speed) &&
                      std::isfinite(carrier.acceleration) && std::isfinite(carrier.orbit_radius) &&
                      std::isfinite(point.inner_speed) && std::isfinite(point.outer_speed) &&
                      point.bore_tilt.allFinite();
  if (!finite) throw std::invalid_argument(not_finite_text(point));
}

Eigen::Vector2d load_through_cage(const Bearing& bearing, const BearingGeometry& geometry,
                                  const CarrierMotion& carrier, const InertiaSwitches& inertia) {
  const CarrierFrame frame = carrier_frame(carrier, inertia);
  const double mass = geometry.cage_mass + 0.5 * bearing.rollers().count * geometry.element_mass;
  return mass * inertial_acceleration(frame, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
}

Eigen::Vector2d total_bore_load(const Bearing& bearing, const BearingGeometry& geometry,
                                const OperatingPoint& point, const InertiaSwitches& inertia) {
  if (bearing.cage.guidance != Race::outer) return point.bore_load;
  return point.bore_load + load_through_cage(bearing, geometry, point.carrier, inertia);
}

void require_equal_pitches(const Bearing& bearing) {
  if (every_pitch_alike(bearing)) return;
  throw std::invalid_argument(
      "bearing: found unequal rollers or waves that turn with a race; required by the means over one pitch: "
      "equal rollers and out-of-roundness alone. Compute the motion in time instead");
}

void keep_worst(const SolverReport& one, SolverReport& all) {
  all.iterations = std::max(all.iterations, one.iterations);
  all.residual = std::max(all.residual, one.residual);
  if (!one.converged && all.converged) all.message = one.message;
  all.converged = all.converged && one.converged;
}

RaceEquilibrium quasi_static_problem(const Bearing& bearing, const BearingGeometry& geometry,
                                     const OperatingPoint& point, const QuasiStaticOptions& options,
                                     double first_roller) {
  require_finite(point);
  const CarrierFrame frame = carrier_frame(point.carrier, options.inertia);
  const double cage_speed = kinematic_cage_speed(geometry, point.inner_speed, point.outer_speed);

  RaceEquilibrium problem{
      rolling_contacts(bearing, geometry, point.inner_speed, point.outer_speed, options.film)};
  problem.clearance = bearing.radial_clearance;
  problem.load = total_bore_load(bearing, geometry, point, options.inertia);
  problem.outer_race = point.outer_race;
  problem.angle = roller_angles(bearing.rollers().count, first_roller);
  problem.extra_approach = extra_approach(bearing, problem.angle);
  problem.inertial_load = problem.angle.unaryExpr(
      [&](double angle) { return roller_inertial_load(geometry, frame, cage_speed, angle); });
  return problem;
}

RaceEquilibrium quasi_static_problem(const laminae::LaminaBearing& bearing, const OperatingPoint& point,
                                     const QuasiStaticOptions& options, double first_roller) {
  RaceEquilibrium problem =
      quasi_static_problem(bearing.bearing(), bearing.geometry(), point, options, first_roller);
  if (!bearing.is_cut()) return problem;
  problem.cut = &bearing;
  problem.end_displacement = bearing.half_length() * (problem.angle.cos() * point.bore_tilt.x() +
                                                      problem.angle.sin() * point.bore_tilt.y());
  return problem;
}

QuasiStaticState quasi_static_state(const laminae::LaminaBearing& bearing, const OperatingPoint& point,
                                    const QuasiStaticOptions& options, double first_roller,
                                    const QuasiStaticState* near) {
  return solve(quasi_static_problem(bearing, point, options, first_roller), near);
}

QuasiStaticState quasi_static_state(const Bearing& bearing, const OperatingPoint& point,
                                    const QuasiStaticOptions& options, double first_roller) {
  return solve(quasi_static_problem(bearing, geometry_of(bearing), point, options, first_roller));
}

QuasiStaticResult empty_result(const laminae::LaminaBearing& bearing, const OperatingPoint& point,
                               const QuasiStaticOptions& options) {
  const Bearing& b = bearing.bearing();
  const int positions = options.cage_positions * b.rollers().count;
  QuasiStaticResult result;
  result.angle =
      options.first_roller + Eigen::ArrayXd::LinSpaced(positions, 0.0, two_pi * (positions - 1) / positions);
  result.resize(b.rollers().laminae, positions);
  result.total_bore_load = total_bore_load(b, bearing.geometry(), point, options.inertia);
  result.race_form = Eigen::ArrayXd::Zero(positions);
  result.report.converged = true;
  return result;
}

void put_position(const laminae::LaminaBearing& bearing, QuasiStaticState state, Eigen::Index position,
                  Eigen::Index positions, QuasiStaticResult& result) {
  const double part = 1.0 / static_cast<double>(positions);
  result.displacement += part * state.displacement;
  add_form(state.waves, part, result.angle, result.race_form);
  result.moment += part * state.moment;
  keep_worst(state.report, result.report);
  for (Eigen::Index j = 0; j < state.angle.size(); ++j) {
    const Eigen::Index column = position + j * positions;
    result.inner_load[column] = state.inner_load[j];
    result.outer_load[column] = state.outer_load[j];
    if (bearing.is_cut())
      result.put_laminae(bearing.contact(Race::inner), bearing.contact(Race::outer),
                         state.rollers[static_cast<std::size_t>(j)], column);
  }
  result.states.push_back(std::move(state));
}

QuasiStaticResult quasi_static_bearing(const laminae::LaminaBearing& bearing, const OperatingPoint& point,
                                       const QuasiStaticOptions& options) {
  require_equal_pitches(bearing.bearing());
  QuasiStaticResult result = empty_result(bearing, point, options);
  const int positions = options.cage_positions;
  for (int position = 0; position < positions; ++position) {
    const QuasiStaticState* near = result.states.empty() ? nullptr : &result.states.back();
    put_position(bearing, quasi_static_state(bearing, point, options, result.angle[position], near), position,
                 positions, result);
  }
  return result;
}

QuasiStaticResult quasi_static_bearing(const Bearing& bearing, const OperatingPoint& point,
                                       const QuasiStaticOptions& options) {
  Bearing whole = bearing;
  whole.rollers().laminae = 0;
  return quasi_static_bearing(laminae::LaminaBearing(whole), point, options);
}

}  // namespace orbearing::bearing
