#include "bearing/motion/cage_and_oil.hpp"

#include <gtest/gtest.h>

#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::cage_guidance_test {
namespace {

constexpr double kRoundOff = 1e-11;
constexpr double kQuadrature = 1e-6;  // relative, of the midpoint rule with 1e5 points on a smooth integrand

// The defining integral of u u^T / (1 - eps cos)^3 over the half circle towards the squeeze velocity.
FilmResistance<double> by_quadrature(double eccentricity, double direction) {
  constexpr int kPoints = 100000;
  FilmResistance<double> sum{};
  for (int i = 0; i < kPoints; ++i) {
    const double angle = direction + M_PI * ((i + 0.5) / kPoints - 0.5);
    const double weight = M_PI / kPoints / std::pow(1.0 - eccentricity * std::cos(angle), 3.0);
    sum.along += weight * std::cos(angle) * std::cos(angle);
    sum.mixed += weight * std::sin(angle) * std::cos(angle);
    sum.across += weight * std::sin(angle) * std::sin(angle);
  }
  return sum;
}

// In rational terms and one arc tangent.
TEST(CageGuidance, ClosedFormIsTheIntegralOverTheHalfFilm) {
  for (double eccentricity : {0.0, 0.1, 0.6, 0.95})
    for (double direction = -3.1; direction < 3.2; direction += 0.4) {
      const FilmResistance<double> closed =
          half_film_resistance(eccentricity, std::cos(direction), std::sin(direction));
      const FilmResistance<double> integral = by_quadrature(eccentricity, direction);
      const double scale = kQuadrature * (integral.along + integral.across);
      EXPECT_NEAR(closed.along, integral.along, scale) << eccentricity << " " << direction;
      EXPECT_NEAR(closed.mixed, integral.mixed, scale) << eccentricity << " " << direction;
      EXPECT_NEAR(closed.across, integral.across, scale) << eccentricity << " " << direction;
    }
}

struct Case {
  double clearance = 0.17e-3, cage_radius = 19.27e-3, land_width = 1.65e-3, viscosity = 0.01;
  double largest_eccentricity = 0.98, stiffness = 1e7;
};
constexpr Case model;

LandLaw land() {
  Bearing bearing;
  bearing.cage.guidance = Race::outer;
  bearing.cage.outer_diameter = 2.0 * model.cage_radius;
  CageParameters cage;
  cage.guide_diameter = 2.0 * (model.cage_radius + model.clearance);
  cage.land_width = model.land_width;
  cage.largest_eccentricity = model.largest_eccentricity;
  cage.touch_down_stiffness = model.stiffness;
  return guiding_lands(bearing, cage, 2, model.viscosity, 0.1)->law;
}

LandForce<double> force(const LandLaw& law, const BodyMotion& cage, const BodyMotion& ring) {
  const Vector2 offset = cage.position - ring.position, velocity = cage.velocity - ring.velocity;
  return law.force(LandMotion<double>{offset.x(), offset.y(), velocity.x(), velocity.y(), cage.speed},
                   ring.speed);
}

Vector2 vector_of(const LandForce<double>& force) {
  return {force.x, force.y};
}

// Steady state: Eqs. (24), (25) and (26) of [Gai2025], pressure force back along the eccentricity and ahead
// across it.
TEST(CageGuidance, SteadyStateIsThePublishedShortBearing) {
  const double eps = 0.7, cage_speed = 400.0, land_speed = 700.0;
  const BodyMotion cage{Vector2(eps * model.clearance, 0.0), Vector2::Zero(), cage_speed};
  const BodyMotion ring{Vector2::Zero(), Vector2::Zero(), land_speed};
  const LandForce<double> forces = force(land(), cage, ring);
  const double u1 = model.cage_radius * (cage_speed + land_speed);
  const double factor =
      2.0 * model.viscosity * u1 * std::pow(model.land_width, 3.0) / std::pow(model.clearance, 2.0);
  const double root = std::sqrt(1.0 - eps * eps);
  const double along = -factor * eps * eps / std::pow(root, 4.0);
  const double ahead = factor * M_PI * eps / (4.0 * std::pow(root, 3.0));
  EXPECT_NEAR(forces.x, along, kRoundOff * std::abs(along));
  EXPECT_NEAR(forces.y, ahead, kRoundOff * ahead);
  const double shear = 2.0 * 2.0 * M_PI * model.viscosity * model.cage_radius * (land_speed - cage_speed) *
                       std::pow(model.cage_radius, 2.0) * model.land_width / (model.clearance * root);
  EXPECT_NEAR(forces.on_cage, shear - 0.5 * eps * model.clearance * ahead, kRoundOff * shear);
}

// A cage that whirls at half the sum of both rotations squeezes nothing.
TEST(CageGuidance, HalfSpeedWhirlCarriesNothing) {
  const double eccentricity = 0.5 * model.clearance;
  const BodyMotion cage{Vector2(eccentricity, 0.0), Vector2(0.0, 550.0 * eccentricity), 400.0};
  const BodyMotion ring{Vector2::Zero(), Vector2::Zero(), 700.0};
  EXPECT_NEAR(vector_of(force(land(), cage, ring)).norm(), 0.0, kRoundOff);
}

// Seen from a frame that turns, all rotations and the velocity across change together and the force does not.
TEST(CageGuidance, ForceDoesNotDependOnTheFrame) {
  test::Random random;
  for (int i = 0; i < 100; ++i) {
    const Vector2 position = 0.6 * model.clearance * Vector2(random(), random());
    const Vector2 velocity(0.05 * random(), 0.05 * random());
    const double cage_speed = 500.0 * random(), land_speed = 500.0 * random(), rotating = 300.0 * random();
    const BodyMotion at_rest{Vector2::Zero(), Vector2::Zero(), land_speed};
    const BodyMotion turned{Vector2::Zero(), Vector2::Zero(), land_speed - rotating};
    const Vector2 first = vector_of(force(land(), {position, velocity, cage_speed}, at_rest));
    const BodyMotion seen{position, velocity - rotating * across(position), cage_speed - rotating};
    const Vector2 same = vector_of(force(land(), seen, turned));
    EXPECT_NEAR((first - same).norm(), 0.0, kRoundOff * first.norm());
  }
}

TEST(CageGuidance, TouchesDownBeyondTheLargestEccentricity) {
  const BodyMotion ring{Vector2::Zero(), Vector2::Zero(), 0.0};
  const double beyond = 1e-6;
  const BodyMotion cage{Vector2(0.0, 0.98 * model.clearance + beyond), Vector2::Zero(), 0.0};
  EXPECT_NEAR(force(land(), cage, ring).y, -model.stiffness * beyond, 1e-9 * model.stiffness * beyond);
}

TEST(CageGuidance, NoLandWithoutItsDiameter) {
  EXPECT_FALSE(guiding_lands(Bearing{}, CageParameters{}, 2, 0.01, 0.1));
}

}  // namespace
}  // namespace orbearing::bearing::motion::cage_guidance_test
