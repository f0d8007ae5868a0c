#include "bearing/static_load/ball_bearing.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace orbearing::bearing::static_load {

namespace {

using Place = Eigen::Vector<double, 5>;

[[noreturn]] void refuse(const std::string& what, double found, const std::string& required) {
  std::ostringstream text;
  text << what << ": found " << found << "; required: " << required;
  throw std::invalid_argument(text.str());
}

double angle_of(const BallBearing& bearing, int ball) {
  return boost::math::double_constants::two_pi * ball / bearing.balls;
}

// Where the groove centres of one ball stand to each other, and how the ring's coordinates move them.
struct BallPlace {
  double radial;    // [m]
  double axial;     // [m]
  double length;    // [m]
  double approach;  // [m]  positive in contact
  double cosine;    // of the ball's place
  double sine;
};

BallPlace ball_place(const BallBearingGeometry& geometry, double angle, const Place& place) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const double radial = geometry.radial_distance + place[0] * cosine + place[1] * sine;
  const double axial = geometry.axial_distance + place[2] + place[3] * cosine + place[4] * sine;
  const double length = std::hypot(radial, axial);
  return {radial, axial, length, length - geometry.groove_distance, cosine, sine};
}

// Two loaded balls share any load, each up to all of it: the approach this asks is the scale of the solution.
double reach_of(const BallBearingGeometry& geometry, const Place& load) {
  const double elastic = std::pow(load.norm() / geometry.constant, 2.0 / 3.0);
  const double play = std::sqrt(2.0 * geometry.groove_distance *
                                std::abs(geometry.groove_distance - geometry.radial_distance));
  return 4.0 * elastic + play + 1e-3 * geometry.groove_distance;
}

}  // namespace

rating::BallSet ball_set(const BallBearing& bearing) {
  return {.balls = bearing.balls,
          .diameter = bearing.ball_diameter,
          .pitch_diameter = bearing.pitch_diameter,
          .contact_angle = bearing.contact_angle,
          .inner_osculation = bearing.inner_osculation,
          .outer_osculation = bearing.outer_osculation};
}

BallBearingGeometry geometry_of(const BallBearing& bearing) {
  const double diameter = bearing.ball_diameter;
  const double openness = bearing.inner_osculation + bearing.outer_osculation - 1.0;
  for (const double osculation : {bearing.inner_osculation, bearing.outer_osculation})
    if (!(osculation > 0.5)) refuse("osculation", osculation, "groove radius over ball diameter above 0.5");
  BallBearingGeometry geometry{.groove_distance = openness * diameter, .lever = 0.5 * bearing.pitch_diameter};
  geometry.radial_distance =
      geometry.groove_distance * std::cos(bearing.contact_angle) - 0.5 * bearing.radial_clearance;
  geometry.axial_distance = geometry.groove_distance * std::sin(bearing.contact_angle);
  if (!(geometry.radial_distance > 0.0))
    refuse("radial clearance [m]", bearing.radial_clearance,
           "less than twice the distance of groove centres");
  const auto contact = [&](Race race, double osculation) {
    return point_contact(ball_race_curvature(race, diameter, bearing.pitch_diameter, osculation * diameter,
                                             bearing.contact_angle),
                         bearing.material);
  };
  geometry.inner = contact(Race::inner, bearing.inner_osculation);
  geometry.outer = contact(Race::outer, bearing.outer_osculation);
  geometry.constant = in_series(geometry.inner, geometry.outer);
  return geometry;
}

RingForces<5> ring_forces(const BallBearing& bearing, const BallBearingGeometry& geometry,
                          const Place& place) {
  RingForces<5> sum;
  for (int j = 0; j < bearing.balls; ++j) {
    const BallPlace at = ball_place(geometry, angle_of(bearing, j), place);
    if (at.approach <= 0.0) continue;
    const double root = std::sqrt(at.approach);
    const double load = geometry.constant * at.approach * root;
    const double stiffness = 1.5 * geometry.constant * root;
    const double cosine = at.radial / at.length, sine = at.axial / at.length;
    const Place radial = (Place() << at.cosine, at.sine, 0.0, 0.0, 0.0).finished();
    const Place axial = (Place() << 0.0, 0.0, 1.0, at.cosine, at.sine).finished();
    const Place along = cosine * radial + sine * axial;
    const Place across = cosine * axial - sine * radial;
    sum.contact_load += load;
    sum.force += load * along;
    sum.stiffness += stiffness * along * along.transpose() + load / at.length * across * across.transpose();
  }
  return sum;
}

double stored_energy(const BallBearing& bearing, const BallBearingGeometry& geometry, const Place& place) {
  double energy = 0.0;
  for (int j = 0; j < bearing.balls; ++j) {
    const double approach = ball_place(geometry, angle_of(bearing, j), place).approach;
    if (approach > 0.0) energy += 0.4 * geometry.constant * std::pow(approach, 2.5);
  }
  return energy;
}

BallBearingState static_state(const BallBearing& bearing, const BallBearingLoad& load) {
  const BallBearingGeometry geometry = geometry_of(bearing);
  BalanceProblem<5> problem;
  problem.load << load.radial, 0.0, load.axial, load.tilt ? 0.0 : load.moment / geometry.lever, 0.0;
  problem.reach = reach_of(geometry, problem.load);
  problem.held = {false, false, false, load.tilt.has_value(), load.tilt.has_value()};
  if (load.tilt) problem.start[3] = geometry.lever * *load.tilt;
  const RingBalance<5> found =
      balance(problem, [&](const Place& place) { return ring_forces(bearing, geometry, place); });
  const Place& place = found.place;
  BallBearingState state{.radial = place[0],
                         .lateral = place[1],
                         .axial = place[2],
                         .tilt = place[3] / geometry.lever,
                         .lateral_tilt = place[4] / geometry.lever};
  state.report = found.report;
  state.moment = ring_forces(bearing, geometry, place).force[3] * geometry.lever;
  state.ball_load = Eigen::ArrayXd::Zero(bearing.balls);
  state.contact_angle = Eigen::ArrayXd::Zero(bearing.balls);
  for (int j = 0; j < bearing.balls; ++j) {
    const BallPlace at = ball_place(geometry, angle_of(bearing, j), place);
    if (at.approach > 0.0) state.ball_load[j] = geometry.constant * std::pow(at.approach, 1.5);
    state.contact_angle[j] = std::atan2(at.axial, at.radial);
  }
  return state;
}

}  // namespace orbearing::bearing::static_load
