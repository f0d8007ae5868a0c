// Loads of a bearing that are kept from the beginning of a step.
#include "coupling/system/loads_at_step.hpp"

#include <gtest/gtest.h>

#include "bearing/profile/profile.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::system::loads_at_step_test {
namespace {

using bearing::vectorised::ContactLoads;
using bearing::vectorised::VectorBearing;

// Each list is that of the bearing, and no two of them are alike where the bore is tilted.
TEST(LoadsAtStep, AreThoseOfTheBearing) {
  bearing::Bearing bearing = test::reducer_bearing();
  bearing.rollers().laminae = 12;
  bearing.rollers().profile = bearing::profile::CircularCrown{bearing.rollers().length, 2e-6};
  bearing::OperatingPoint point = test::reducer_point(6000.0);
  point.bore_tilt = {1e-3, -0.5e-3};
  const auto parameters = test::reducer_parameters();
  const auto model = bearing_model(bearing, point, parameters);
  VectorBearing moving(model);
  const std::vector<double> x = moving.padded(initial_state(bearing, model, parameters, 0.0).x);
  std::vector<double> rate(x.size());
  moving.derivative(0.0, x.data(), rate.data());
  const auto rollers = static_cast<std::size_t>(model.layout.rollers);
  LoadsAtStep kept(static_cast<int>(rollers));
  kept.take(moving, x.data());
  const bearing::motion::RollerLoads found = kept.loads();
  const ContactLoads expected = moving.loads();
  ASSERT_NE(found.laminae, nullptr);
  double apart = 0.0;
  for (std::size_t j = 0; j < rollers; ++j) {
    EXPECT_EQ(found.inner[j], expected.inner[j]);
    EXPECT_EQ(found.outer[j], expected.outer[j]);
    EXPECT_EQ(found.inner_approach[j], expected.inner_approach[j]);
    EXPECT_EQ(found.outer_approach[j], expected.outer_approach[j]);
    EXPECT_EQ(found.end_displacement[j], expected.end_displacement[j]);
    EXPECT_EQ(found.angle[j], x[static_cast<std::size_t>(moving.layout().lanes()) + j]);
    apart = std::max(apart, std::abs(found.inner_approach[j] - found.outer_approach[j]));
  }
  EXPECT_GT(apart, 1e-9);
}

}  // namespace
}  // namespace orbearing::system::loads_at_step_test
