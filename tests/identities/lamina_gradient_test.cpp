// Adjoint derivatives of measures of the lamina loads against central differences.
#include <gtest/gtest.h>

#include <cmath>

#include "bearing/equilibrium/drop_gradient.hpp"
#include "bearing/profile/design.hpp"

namespace orbearing::bearing::laminae::lamina_gradient_test {
namespace {

constexpr double kAgreement = 1e-6;  // relative, of the adjoint and of central differences
constexpr double kPower = 4.5;       // a measure like those of fatigue life

struct Study {
  Bearing bearing;
  OperatingPoint point;
  QuasiStaticOptions options;
};

Study study(bool film) {
  Study s;
  s.bearing = {
      .inner = {.seat_diameter = 25e-3},
      .outer = {.seat_diameter = 47e-3},
      .elements = CylindricalRollers{.count = 15, .diameter = 5.24e-3, .length = 5.7e-3, .laminae = 40},
      .pitch_diameter = 35.64e-3,
      .width = 11.9e-3};
  s.bearing.rollers().profile = profile::Iso16281{5.7e-3, 5.24e-3, 1.0};
  s.bearing.outer.profile = profile::CircularCrown{5.7e-3, 2e-6};
  s.point.carrier = {.speed = 200.0, .orbit_radius = 87.9e-3};
  s.point.outer_speed = -720.0;
  s.point.bore_load = {900.0, 1600.0};
  s.point.bore_tilt = {0.5e-3, 0.9e-3};
  s.options.cage_positions = 3;
  s.options.first_roller = 0.137;
  if (film) s.options.film = Lubricant{0.01, 1.5e-8};
  return s;
}

QuasiStaticResult solved(const Study& s) {
  QuasiStaticResult result = quasi_static_bearing(LaminaBearing(s.bearing), s.point, s.options);
  EXPECT_TRUE(result.report.converged);
  return result;
}

// Sum over all laminae and places of (q/100 N)^4.5, the outer ones counting twice.
double measure(const QuasiStaticResult& result) {
  return (result.inner_lamina_load / 100.0).pow(kPower).sum() +
         2.0 * (result.outer_lamina_load / 100.0).pow(kPower).sum();
}

DropGradient adjoint(const Study& s) {
  const QuasiStaticResult result = solved(s);
  const Eigen::ArrayXXd inner = kPower / 100.0 * (result.inner_lamina_load / 100.0).pow(kPower - 1.0);
  const Eigen::ArrayXXd outer = 2.0 * kPower / 100.0 * (result.outer_lamina_load / 100.0).pow(kPower - 1.0);
  return drop_gradient(LaminaBearing(s.bearing), s.point, s.options, result, inner, outer);
}

// By a number of the rollers' profile, which lies in both contacts; `by_number` is that of a drop at x [m].
template <class ByNumber>
double by_rollers(const Study& s, const ByNumber& by_number) {
  const LaminaBearing bearing(s.bearing);
  const DropGradient gradient = adjoint(s);
  const Eigen::ArrayXd x = bearing.half_length() * bearing.contact(Race::inner).places();
  double sum = 0.0;
  for (Eigen::Index k = 0; k < x.size(); ++k)
    sum += (gradient.inner[k] + gradient.outer[k]) * by_number(x[k]);
  return sum;
}

double by_parameter(const Study& s) {
  return by_rollers(s, [&](double x) { return profile::drop_per_parameter(s.bearing.rollers().profile, x); });
}

template <class Change>
double difference(Study s, double step, Change&& change) {
  Study up = s, down = s;
  change(up, step);
  change(down, -step);
  return (measure(solved(up)) - measure(solved(down))) / (2.0 * step);
}

void change_parameter(Study& s, double by) {
  const double value = profile::leading_parameter(s.bearing.rollers().profile);
  s.bearing.rollers().profile = profile::with_parameter(s.bearing.rollers().profile, value + by);
}

TEST(DropGradient, ByTheRollersParameterIsItsDifference) {
  for (const bool film : {false, true}) {
    const Study s = study(film);
    const double expected = difference(s, 1e-5, change_parameter);
    EXPECT_NEAR(by_parameter(s), expected, kAgreement * std::abs(expected)) << "film " << film;
  }
}

// Issue 16, Build 1: the waves of the race follow too.
TEST(DropGradient, OnARaceThatBends) {
  Study s = study(true);
  s.point.outer_race = {.compliance = Eigen::ArrayXd::Zero(5),
                        .cosine = Eigen::ArrayXd::Zero(5),
                        .sine = Eigen::ArrayXd::Zero(5)};
  s.point.outer_race.compliance << 2e-10, 0.0, 4.5e-9, 6e-10, 2e-10;
  s.point.outer_race.cosine << 0.0, 0.0, -2e-6, 1e-7, 0.0;
  s.point.outer_race.sine << 0.0, 0.0, 4e-7, 0.0, 1e-7;
  const double expected = difference(s, 1e-5, change_parameter);
  EXPECT_NEAR(by_parameter(s), expected, kAgreement * std::abs(expected));
}

TEST(DropGradient, OfEveryKindOfProfile) {
  const double l = 5.7e-3;
  const profile::DesignLoad design{600.0, l, 2.2e-3, Material{}};
  const std::vector<profile::Profile> profiles{
      profile::Chamfer{l, 0.5e-3, 5e-6},
      profile::CircularCrown{l, 6e-6},
      profile::StraightCircular{l, 2e-3, 6e-6},
      profile::lundberg_for(design),
      profile::johns_gohar_for(design),
      profile::fujiwara_kawase_for(design, 1.5, 0.6, 8e-6),
      profile::Table{{-0.5 * l, 0.0, 0.5 * l}, {6e-6, 0.0, 3e-6}, 1.0}};
  for (const profile::Profile& profile : profiles) {
    Study s = study(false);
    s.bearing.rollers().profile = profile;
    const double expected = difference(s, 2e-5 * profile::leading_parameter(profile), change_parameter);
    EXPECT_NEAR(by_parameter(s), expected, kAgreement * std::abs(expected)) << profile::kind(profile);
  }
}

TEST(DropGradient, ByTheDropAtAStationIsItsDifference) {
  const Study s = study(false);
  const double station = 0.975 * 0.5 * s.bearing.rollers().length;
  const double depth = profile::drop(s.bearing.rollers().profile, station);
  const double expected = difference(s, 1e-10, [&](Study& changed, double by) {
    changed.bearing.rollers().profile = profile::with_drop(s.bearing.rollers().profile, station, depth + by);
  });
  const double found = by_rollers(
      s, [&](double x) { return profile::drop_per_drop(s.bearing.rollers().profile, x, station); });
  EXPECT_NEAR(found, expected, kAgreement * std::abs(expected));
}

// A deeper drop at one lamina of one contact, stated as a table with a tooth there.
TEST(DropGradient, BySingleDropsAreTheirDifferences) {
  const Study s = study(false);
  const DropGradient gradient = adjoint(s);
  for (const int lamina : {4, 19, 31}) {
    const double expected = difference(s, 1e-11, [&](Study& changed, double by) {
      const std::vector<double> places = lamina_places(40);
      profile::Table table;
      for (int k = 0; k < 40; ++k) {
        const double x = 0.5 * s.bearing.rollers().length * places[static_cast<std::size_t>(k)];
        table.x.push_back(x);
        table.drop.push_back(profile::drop(s.bearing.outer.profile, x) + (k == lamina ? by : 0.0));
      }
      changed.bearing.outer.profile = table;
    });
    EXPECT_NEAR(gradient.outer[lamina], expected, kAgreement * std::abs(expected)) << "lamina " << lamina;
  }
}

}  // namespace
}  // namespace orbearing::bearing::laminae::lamina_gradient_test
