#include "coupling/integration/integrate_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/gear_sets.hpp"

namespace orbearing::integration::gear_steps_test {
namespace {

// The planet of [LinParker1999] swings between its meshes with sqrt((k_s + k_r)/m); a sun torque T bends each
// of its n meshes by T/(n r k).
TEST(GearSteps, AllowedErrorsAreAShareOfTheDeflectionAndThatTimesAFrequency) {
  constexpr double share = 1e-3, torque = 1500.0;  // [-], [N m]
  gearset::dynamics::SetModel model = gearset::dynamics::test::lin_parker_model(3);
  model.operation.torques.sun = torque;
  const double deflection = torque / (3 * 1.0 * 5e8), frequency = std::sqrt((5e8 + 5e8) / 0.66);
  const Eigen::VectorXd allowed = gear_allowed_errors(model, share);
  const Eigen::Index n = model.layout.freedoms();
  EXPECT_NEAR(allowed.head(n).minCoeff(), share * deflection, 1e-12 * deflection);
  EXPECT_NEAR(allowed.head(n).maxCoeff(), share * deflection, 1e-12 * deflection);
  EXPECT_NEAR(allowed.tail(n).minCoeff(), share * deflection * frequency, 1e-12 * deflection * frequency);
  EXPECT_NEAR(allowed.tail(n).maxCoeff(), share * deflection * frequency, 1e-12 * deflection * frequency);
}

// The softer mesh bends most, be it that of the sun or of the ring.
TEST(GearSteps, AllowedErrorsAreThoseOfTheSofterMesh) {
  constexpr double share = 1e-3, torque = 1500.0, soft = 2e8, hard = 5e8;  // [-], [N m], [N/m]
  for (const bool ring_is_soft : {true, false}) {
    gearset::dynamics::SetParameters set = gearset::dynamics::test::lin_parker(3);
    (ring_is_soft ? set.ring_mesh : set.sun_mesh).stiffness =
        gearset::PeriodicCurve::constant(soft);
    gearset::dynamics::SetModel model = gearset::dynamics::set_model(set, {});
    model.operation.torques.sun = torque;
    const double deflection = torque / (3 * 1.0 * soft), frequency = std::sqrt((soft + hard) / 0.66);
    const Eigen::VectorXd allowed = gear_allowed_errors(model, share);
    const Eigen::Index n = model.layout.freedoms();
    EXPECT_NEAR(allowed[0], share * deflection, 1e-12 * deflection);
    EXPECT_NEAR(allowed[n], share * deflection * frequency, 1e-12 * deflection * frequency);
  }
}

}  // namespace
}  // namespace orbearing::integration::gear_steps_test
