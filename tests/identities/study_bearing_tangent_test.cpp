// The planet bearing linear about its mean load: against the load over the displacement, and in series with a
// support of which nothing is left or everything.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "coupling/analysis/planet_stiffness.hpp"
#include "tests/reducer.hpp"

namespace orbearing::analysis {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using example::reducer;

// Displacement of the bore from the pin under so much more load [N] on one bearing.
Vector2d bore_displacement(const PlanetaryDrivetrain& drivetrain, const Vector2d& more) {
  bearing::OperatingPoint point = bearing_duty(drivetrain, derive(drivetrain)).point;
  point.bore_load += more;
  return bearing::quasi_static_bearing(drivetrain.bearing, point, quasi_static_options(drivetrain))
      .displacement;
}

// A roller that just touches is as stiff as the ninth root of its approach, so that the slope over a finite
// step is that of no single position for a few of the 240 rollers and positions. Equilibria are accurate to
// 1e-9 N, a millionth of the step.
constexpr double kSlopeDifference = 1e-4;

TEST(BearingTangent, IsTheSlopeOfLoadOverDisplacement) {
  for (const auto& [clearance, filmed] :
       {std::pair(0.0, false), std::pair(37e-6, false), std::pair(0.0, true)}) {
    PlanetaryDrivetrain drivetrain = reducer();
    drivetrain.bearing.radial_clearance = clearance;
    drivetrain.dynamics.race.film_in_approach = filmed;  // on both races, each at its own speed
    const double step = 1e-3;                            // [N]
    Matrix2d compliance;
    for (const Vector2d& along : {Vector2d(Vector2d::UnitX()), Vector2d(Vector2d::UnitY())})
      compliance.col(along.x() > 0.0 ? 0 : 1) =
          (bore_displacement(drivetrain, step * along) - bore_displacement(drivetrain, -step * along)) /
          (2.0 * step);
    compliance += Matrix2d::Identity() / drivetrain.dynamics.support.stiffness;
    const Matrix2d stiffness = bearing_tangent(drivetrain, derive(drivetrain)).stiffness;
    EXPECT_LT((stiffness * compliance - drivetrain.bearings_per_planet * Matrix2d::Identity()).norm(),
              kSlopeDifference);
  }
}

TEST(BearingTangent, CarriesTheMeanLoadAtTheMeanDisplacement) {
  const PlanetaryDrivetrain drivetrain = reducer();
  const gearset::dynamics::AffineBearing law = bearing_tangent(drivetrain, derive(drivetrain));
  const Vector2d load = bearing_duty(drivetrain, derive(drivetrain)).point.bore_load;
  const Vector2d at =
      bore_displacement(drivetrain, Vector2d::Zero()) + load / drivetrain.dynamics.support.stiffness;
  const Vector2d carried = law.stiffness * at - law.force;
  EXPECT_LT((carried - drivetrain.bearings_per_planet * load).norm(), 1e-9 * load.norm());
}

// With a support a thousand times softer than the rollers only the support counts, its damper too.
TEST(BearingTangent, OnASoftSupportIsThatOfTheSupport) {
  PlanetaryDrivetrain drivetrain = reducer();
  bearing::motion::SupportParameters& support = drivetrain.dynamics.support;
  support = {.stiffness = 3e5, .damping_ratio = 0.05};
  const DrivetrainGeometry geometry = derive(drivetrain);
  const double mass =
      geometry.planet_mass / drivetrain.bearings_per_planet + geometry.bearing.inner_ring_mass;
  const double damping = 2.0 * support.damping_ratio * std::sqrt(support.stiffness * mass);
  const gearset::dynamics::AffineBearing law = bearing_tangent(drivetrain, geometry);
  const double rollers = 2e-3;  // of the support's compliance, and less of its damping
  EXPECT_LT((law.stiffness / (2.0 * support.stiffness) - Matrix2d::Identity()).norm(), rollers);
  EXPECT_LT((law.damping / (2.0 * damping) - Matrix2d::Identity()).norm(), 2.0 * rollers);
}

// On a support that neither yields nor damps, contacts that damp in proportion to their load leave what each
// pair in series passes on: with a = d(approach)/dQ of two equal contacts, lambda Q / 2 of each roller.
TEST(BearingTangent, OnARigidSupportIsThatOfTheRollers) {
  PlanetaryDrivetrain drivetrain = reducer();
  drivetrain.dynamics.support = {.stiffness = 1e15, .damping_ratio = 0.0};
  drivetrain.dynamics.inertia = {
      .own_orbit = false, .coriolis = false, .carrier_centrifugal = false, .euler = false};
  const gearset::dynamics::AffineBearing law = bearing_tangent(drivetrain, derive(drivetrain));
  // Both contacts of a roller carry the same load then, and its pair is as stiff as 10/9 Q over half of the
  // approach of both: damping / stiffness = lambda Q/2 / (dQ/d(2 approach)), equal but for the power 1/10 of
  // the load.
  const bearing::QuasiStaticResult still =
      bearing::quasi_static_bearing(drivetrain.bearing, bearing_duty(drivetrain, derive(drivetrain)).point,
                                    {.inertia = drivetrain.dynamics.inertia});
  Matrix2d damping = Matrix2d::Zero();
  const double share = 1.0 / drivetrain.cage_positions;
  for (Eigen::Index i = 0; i < still.angle.size(); ++i) {
    const Vector2d outward(std::cos(still.angle[i]), std::sin(still.angle[i]));
    damping +=
        share * drivetrain.dynamics.race.damping * 0.5 * still.inner_load[i] * outward * outward.transpose();
  }
  damping *= drivetrain.bearings_per_planet;
  // The mean over places of compliance x damping x compliance is not that of each; rollers are many.
  EXPECT_LT((law.damping - damping).norm(), 0.02 * damping.norm());
}

// Contacts of different slopes a and b, by their films and loads: (Q_i a^2 + Q_o b^2)/(a + b)^2 lambda of
// each roller, at one position of the cage.
TEST(BearingTangent, DampsByTheSlopesOfFilmedContacts) {
  PlanetaryDrivetrain drivetrain = reducer();
  drivetrain.dynamics.support = {.stiffness = 1e15, .damping_ratio = 0.0};
  drivetrain.dynamics.race.film_in_approach = true;
  drivetrain.cage_positions = 1;
  const DrivetrainGeometry geometry = derive(drivetrain);
  const bearing::OperatingPoint point = bearing_duty(drivetrain, geometry).point;
  const bearing::QuasiStaticResult still =
      bearing::quasi_static_bearing(drivetrain.bearing, point, quasi_static_options(drivetrain));
  const bearing::RollerContacts contacts =
      bearing::rolling_contacts(drivetrain.bearing, geometry.bearing, point.inner_speed, point.outer_speed,
                                drivetrain.dynamics.lubricant);
  Matrix2d damping = Matrix2d::Zero();
  for (Eigen::Index i = 0; i < still.angle.size(); ++i) {
    const double inner = still.inner_load[i], outer = still.outer_load[i];
    if (!(inner > 0.0 && outer > 0.0)) continue;
    const double a = contacts.inner.compliance(inner), b = contacts.outer.compliance(outer);
    const Vector2d outward(std::cos(still.angle[i]), std::sin(still.angle[i]));
    damping += drivetrain.dynamics.race.damping * (inner * a * a + outer * b * b) / ((a + b) * (a + b)) *
               outward * outward.transpose();
  }
  damping *= drivetrain.bearings_per_planet;
  const Matrix2d found = bearing_tangent(drivetrain, geometry).damping;
  EXPECT_LT((found - damping).norm(), 1e-6 * damping.norm());
}

}  // namespace
}  // namespace orbearing::analysis
