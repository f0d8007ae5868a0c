#include "bearing/life/ball_capacity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bearing/contact/point_contact.hpp"
#include "bearing/geometry.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "bearing/units.hpp"

namespace orbearing::bearing::rating {

namespace {

constexpr double kWeakerRace = life::point_contacts.damage_exponent();
constexpr double kBothRaces = 1.0 / kWeakerRace;
constexpr double kTableInner = 0.52;  // [-]  osculations up to which the table of [ISO281] holds
constexpr double kTableOuter = 0.53;  // [-]

// Inner race over outer race, as far as their curvatures affect fatigue.
double race_ratio(double gamma, double inner, double outer) {
  const double grooves = inner / outer * (2.0 * outer - 1.0) / (2.0 * inner - 1.0);
  return std::pow((1.0 - gamma) / (1.0 + gamma), 1.72) * std::pow(grooves, 0.41);
}

double race_load_at(const BallSet& set, Race race, double pressure) {
  const double osculation = race == Race::inner ? set.inner_osculation : set.outer_osculation;
  const Material steel{.youngs_modulus = 207e9, .poisson_ratio = 0.3};
  return load_at_pressure(point_contact(ball_race_curvature(race, set.diameter, set.pitch_diameter,
                                                            osculation * set.diameter, set.contact_angle),
                                        steel),
                          pressure);
}

struct AxialRow {
  double relative_load;      // [N/mm^2]  F_a/(i Z D^2)
  AxialFactors at_0, at_15;  // of nominal angles [deg]
};

constexpr std::array<AxialRow, 9> kAxialRows{{{0.172, {0.19, 2.30}, {0.38, 1.47}},
                                              {0.345, {0.22, 1.99}, {0.40, 1.40}},
                                              {0.689, {0.26, 1.71}, {0.43, 1.30}},
                                              {1.03, {0.28, 1.55}, {0.46, 1.23}},
                                              {1.38, {0.30, 1.45}, {0.47, 1.19}},
                                              {2.07, {0.34, 1.31}, {0.50, 1.12}},
                                              {3.45, {0.38, 1.15}, {0.55, 1.02}},
                                              {5.17, {0.42, 1.04}, {0.56, 1.00}},
                                              {6.89, {0.44, 1.00}, {0.56, 1.00}}}};

}  // namespace

BallSet ball_set(const Bearing& bearing) {
  const Balls& balls = bearing.balls();
  return {.balls = balls.count,
          .diameter = balls.diameter,
          .pitch_diameter = bearing.pitch_diameter,
          .contact_angle = balls.contact_angle,
          .inner_osculation = bearing.inner.osculation,
          .outer_osculation = bearing.outer.osculation};
}

double gamma(const BallSet& set) {
  return set.diameter * std::cos(set.contact_angle) / set.pitch_diameter;
}

double ball_capacity_factor(double gamma, double inner_osculation, double outer_osculation,
                            double reduction_factor) {
  const double ratio = 1.04 * race_ratio(gamma, inner_osculation, outer_osculation);
  const double races = std::pow(1.0 + std::pow(ratio, kWeakerRace), -kBothRaces);
  const double groove = std::pow(2.0 * inner_osculation / (2.0 * inner_osculation - 1.0), 0.41);
  const double curvature = std::pow(gamma, 0.3) * std::pow(1.0 - gamma, 1.39) / std::cbrt(1.0 + gamma);
  return 0.41 * 98.0665 * reduction_factor * races * groove * curvature;
}

double ball_capacity_factor(const BallSet& set) {
  if (set.inner_osculation <= kTableInner && set.outer_osculation <= kTableOuter)
    return ball_capacity_factor(gamma(set), kTableInner, kTableInner, set.reduction_factor);
  return ball_capacity_factor(gamma(set), set.inner_osculation, set.outer_osculation, set.reduction_factor);
}

double dynamic_capacity(const BallSet& set) {
  constexpr double inch = 25.4;                         // [mm]  above it capacity grows less with size
  const double diameter = kMillimetres * set.diameter;  // [mm]
  const double size = diameter <= inch ? std::pow(diameter, 1.8) : 3.647 * std::pow(diameter, 1.4);
  return set.material_factor * ball_capacity_factor(set) *
         std::pow(set.rows * std::cos(set.contact_angle), 0.7) * std::pow(set.balls, 2.0 / 3.0) * size;
}

double static_capacity(const BallSet& set) {
  constexpr double permanent = static_pressure(RollingElement::ball);
  constexpr double stribeck = 5.0;  // [-]   largest ball load over F_r/Z
  const double ball_load =
      std::min(race_load_at(set, Race::inner, permanent), race_load_at(set, Race::outer, permanent));
  return set.rows * set.balls * std::cos(set.contact_angle) * ball_load / stribeck;
}

ContactCapacities contact_capacities(const BallSet& set, double dynamic_capacity) {
  const double share = dynamic_capacity / (set.balls * std::cos(set.contact_angle) * std::pow(set.rows, 0.7));
  const double ratio =
      std::pow(1.044 * race_ratio(gamma(set), set.inner_osculation, set.outer_osculation), kWeakerRace);
  return {.inner = share / 0.407 * std::pow(1.0 + ratio, kBothRaces),
          .outer = share / 0.389 * std::pow(1.0 + 1.0 / ratio, kBothRaces)};
}

AxialFactors axial_factors(const BallSet& set, double axial) {
  const double area = kMillimetres * kMillimetres * set.diameter * set.diameter;  // [mm^2]
  const double load = std::clamp(axial / (set.rows * set.balls * area), kAxialRows.front().relative_load,
                                 kAxialRows.back().relative_load);
  std::size_t next = 1;
  while (next + 1 < kAxialRows.size() && kAxialRows[next].relative_load < load) ++next;
  const AxialRow &low = kAxialRows[next - 1], &high = kAxialRows[next];
  const double share = (load - low.relative_load) / (high.relative_load - low.relative_load);
  const auto factors = set.contact_angle == 0.0 ? &AxialRow::at_0 : &AxialRow::at_15;
  return {std::lerp((low.*factors).limit, (high.*factors).limit, share),
          std::lerp((low.*factors).axial, (high.*factors).axial, share)};
}

double deep_groove_equivalent_load(const BallSet& set, double radial, double axial) {
  constexpr double radial_share = 0.56;  // X
  const AxialFactors factors = axial_factors(set, axial);
  const bool counts = axial > factors.limit * radial;
  return counts ? std::max(radial, radial_share * radial + factors.axial * axial) : radial;
}

namespace {

// Revolutions of the bearing that one of its contacts leaves a ball. `side`: -1 inner, +1 outer race.
double life_by(double capacity, double load, double gamma, double balls, double pitch_over_ball,
               double side) {
  if (!(load > 0.0)) return kInfinity;
  const double passed = 0.5 * balls * (1.0 - side * gamma);      // of a point of the race in a revolution
  const double turned = 0.5 * (1.0 - gamma * gamma) / gamma;     // of the ball in it
  const double longer = pitch_over_ball * (1.0 + side * gamma);  // track of the race over that of the ball
  return kMillionRevolutions * std::pow(capacity / load, life::point_contacts.load_exponent) * passed /
         turned * std::pow(longer, 1.0 / life::point_contacts.weibull_slope);
}

}  // namespace

double life_of_balls(const Bearing& bearing, const ContactCapacities& capacities,
                     const EquivalentBallLoads& loads) {
  const Balls& balls = bearing.balls();
  const double gamma = geometry_of(bearing).slenderness, ratio = bearing.pitch_diameter / balls.diameter;
  const double count = balls.count;
  const double inner = life_by(capacities.inner, loads.inner, gamma, count, ratio, -1.0);
  const double outer = life_by(capacities.outer, loads.outer, gamma, count, ratio, 1.0);
  return life_of_both(inner, outer) * std::pow(count, -1.0 / life::point_contacts.weibull_slope);
}

double life_of_both(double races, double balls) {
  return system_life(Eigen::Array2d(races, balls), life::point_contacts.weibull_slope);
}

}  // namespace orbearing::bearing::rating
