#include "bearing/motion/balls/mixture.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "bearing/geometry.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::balls {

namespace {

using constants::two_pi;

double squared(double speed) {
  return speed * std::abs(speed);
}

// Driving less resisting moment on the mixture [N m].
double unbalanced(const MixtureNumbers& m, double inner, double outer, double cage, double speed) {
  return (m.balls + m.cage) * squared(cage - speed) + wall_torque(m, m.inner_radius, inner - speed) +
         wall_torque(m, m.outer_radius, outer - speed) - m.flow * m.pitch_radius * m.pitch_radius * speed;
}

}  // namespace

double filled_share(double flow, double pitch_diameter, double speed) {
  constexpr double cubic_centimetres_per_minute = 60e6, millimetres = 1e3, rpm = 60.0 / two_pi;
  const double printed = rpm * std::abs(speed) * std::pow(millimetres * pitch_diameter, 1.7);
  return std::min(1.0, 1e5 * std::pow(cubic_centimetres_per_minute * flow, 0.37) / printed);
}

double cylinder_friction(double reynolds) {
  return std::max({10.0 / reynolds, 2.0 * std::pow(reynolds, -0.6), 1.03 * std::pow(reynolds, -0.5),
                   0.065 * std::pow(reynolds, -0.2)});
}

double wall_torque(const MixtureNumbers& m, double radius, double difference) {
  if (difference == 0.0 || m.viscosity <= 0.0) return 0.0;
  const double speed = radius * difference, gap = m.outer_radius - m.inner_radius;
  const double friction =
      cylinder_friction(2.0 * std::abs(speed) * gap / m.viscosity) * std::pow(gap / m.inner_radius, 0.3);
  return two_pi * radius * radius * m.width * m.density * friction * squared(speed);
}

double mixture_speed(const MixtureNumbers& m, double inner, double outer) {
  const double cage = kinematic_cage_speed(m.slenderness, inner, outer);
  const auto balance = [&](double speed) { return unbalanced(m, inner, outer, cage, speed); };
  const auto [least, most] = std::minmax({0.0, inner, outer, cage});
  const double low = balance(least), high = balance(most);
  // Cases without motion or without resistance.
  if (!(low > 0.0)) return least;
  if (!(high < 0.0)) return most;
  std::uintmax_t steps = 100;
  const auto [below, above] = boost::math::tools::toms748_solve(
      balance, least, most, low, high, boost::math::tools::eps_tolerance<double>(48), steps);
  return 0.5 * (below + above);
}

DragNumbers carried_drag(const DragNumbers& drag, double inner, double outer) {
  DragNumbers carried = drag;
  MixtureNumbers& m = carried.mixture;
  if (!m.carried) return carried;
  const double cage = kinematic_cage_speed(m.slenderness, inner, outer);
  m.share = cage != 0.0 ? std::clamp(mixture_speed(m, inner, outer) / cage, 0.0, 1.0) : 0.0;
  const double left = (1.0 - m.share) * (1.0 - m.share), radius = m.pitch_radius;
  carried.translation = left * m.balls / (m.count * radius * radius * radius);
  carried.cage_churning = left * m.cage;
  return carried;
}

WallTorques wall_torques(const MixtureNumbers& m, double inner, double outer) {
  if (!m.carried) return {};
  const double speed = m.share * kinematic_cage_speed(m.slenderness, inner, outer);
  return {wall_torque(m, m.inner_radius, inner - speed), wall_torque(m, m.outer_radius, outer - speed)};
}

}  // namespace orbearing::bearing::balls
