#include "bearing/equilibrium/balls.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/checks.hpp"

namespace orbearing::bearing::equilibrium {

namespace {

PointContact groove_contact(const Bearing& bearing, Race race) {
  const Balls& balls = bearing.balls();
  return point_contact(
      ball_race_curvature(race, balls.diameter, bearing.pitch_diameter,
                          bearing.ring(race).osculation * balls.diameter, balls.contact_angle),
      bearing.material);
}

}  // namespace

BallRow::BallRow(const Bearing& bearing) {
  const Balls& balls = bearing.balls();
  const double openness = bearing.inner.osculation + bearing.outer.osculation - 1.0;
  for (const double osculation : {bearing.inner.osculation, bearing.outer.osculation})
    if (!(osculation > 0.5))
      mechanics::refuse("osculation", osculation, "groove radius over ball diameter above 0.5");
  // A tilt acts where the centres of the inner groove lie: R_i of [ISO16281].
  lever_ = 0.5 * bearing.pitch_diameter +
           (bearing.inner.osculation - 0.5) * balls.diameter * std::cos(balls.contact_angle);
  groove_distance_ = openness * balls.diameter;
  radial_distance_ = groove_distance_ * std::cos(balls.contact_angle) - 0.5 * bearing.radial_clearance;
  axial_distance_ = groove_distance_ * std::sin(balls.contact_angle);
  if (!(radial_distance_ > 0.0))
    mechanics::refuse("radial clearance [m]", bearing.radial_clearance,
                      "less than twice the distance of groove centres");
  inner_ = groove_contact(bearing, Race::inner);
  outer_ = groove_contact(bearing, Race::outer);
  constant_ = in_series(inner_, outer_);
  const Eigen::ArrayXd angle = element_angles(bearing);
  cosine_ = angle.cos();
  sine_ = angle.sin();
}

double BallRow::free_angle() const {
  return std::acos(std::min(1.0, radial_distance_ / groove_distance_));
}

Eigen::Vector2d BallRow::coordinates(Eigen::Index ball, const RingPosition& position) const {
  return {radial_distance_ + position[0] * cosine_[ball] + position[1] * sine_[ball],
          axial_distance_ + position[2] + position[3] * cosine_[ball] + position[4] * sine_[ball]};
}

Eigen::Matrix<double, 5, 2> BallRow::moves(Eigen::Index ball) const {
  Eigen::Matrix<double, 5, 2> all = Eigen::Matrix<double, 5, 2>::Zero();
  all.col(0).head<2>() << cosine_[ball], sine_[ball];
  all.col(1).tail<3>() << 1.0, cosine_[ball], sine_[ball];
  return all;
}

BallRow::BallPosition BallRow::position_of(Eigen::Index ball, const RingPosition& position) const {
  const Eigen::Vector2d at = coordinates(ball, position);
  const double length = std::hypot(at[0], at[1]);
  return {at[0], at[1], length, length - groove_distance_};
}

// A single loaded ball may carry the whole load: the approach under it, and the play, are the scale of the
// position.
double BallRow::reach(double load) const {
  const double elastic = std::pow(load / constant_, 2.0 / 3.0);
  const double play = std::sqrt(2.0 * groove_distance_ * std::abs(groove_distance_ - radial_distance_));
  return 4.0 * elastic + play + 1e-3 * groove_distance_;
}

void BallRow::add_forces(const RingPosition& position, RingImbalance& sum) const {
  for (Eigen::Index j = 0; j < cosine_.size(); ++j) {
    const BallPosition at = position_of(j, position);
    if (at.approach <= 0.0) continue;
    const double root = std::sqrt(at.approach);
    const double load = constant_ * at.approach * root;
    const double stiffness = 1.5 * constant_ * root;
    const double cosine = at.radial / at.length, sine = at.axial / at.length;
    const Eigen::Matrix<double, 5, 2> by = moves(j);
    const RingPosition along = cosine * by.col(0) + sine * by.col(1);
    const RingPosition across = cosine * by.col(1) - sine * by.col(0);
    sum.scale += load;
    sum.force -= load * along;
    sum.stiffness += stiffness * along * along.transpose() + load / at.length * across * across.transpose();
  }
}

void BallRow::put_loads(const RingPosition& position, RingState& state) const {
  state.contact_load = Eigen::ArrayXd::Zero(cosine_.size());
  state.contact_angle = Eigen::ArrayXd::Zero(cosine_.size());
  for (Eigen::Index j = 0; j < cosine_.size(); ++j) {
    const BallPosition at = position_of(j, position);
    if (at.approach > 0.0) state.contact_load[j] = constant_ * std::pow(at.approach, 1.5);
    state.contact_angle[j] = std::atan2(at.axial, at.radial);
  }
  const double most = state.contact_load.maxCoeff();
  state.largest_pressure =
      std::max(point_pressure(inner_, most).pressure, point_pressure(outer_, most).pressure);
}

}  // namespace orbearing::bearing::equilibrium
