// Quantities of a bearing that follow from plane kinematics.
#include "bearing/motion/snapshot.hpp"

#include <gtest/gtest.h>

#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::snapshot_test {
namespace {

constexpr double kRoundOff = 1e-12;

// Rollers on their pitch circle between centred rings that turn.
struct CentredRings {
  double orbit = 300.0, spin = -2100.0;  // [rad/s]
  OperatingPoint point = [] {
    OperatingPoint rotating = test::reducer_point(6000.0);
    rotating.inner_speed = 40.0;
    rotating.outer_speed = 700.0;
    return rotating;
  }();
  BearingModel model = bearing_model(test::reducer_bearing(), point, test::reducer_parameters());
  double a = model.geometry.element_radius;

  Snapshot seen() const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(model.layout.size());
    MutableStateViews state = mutable_state_views(model.layout, x.data());
    state.radius = model.geometry.pitch_radius;
    state.angle = Eigen::ArrayXd::LinSpaced(model.layout.rollers, 0.7, 6.5);
    state.orbital_speed = orbit;
    state.spin = spin;
    return snapshot(model, x);
  }
};

TEST(Snapshot, SlidingAndRollingOfCentredRings) {
  const CentredRings rings;
  const Snapshot seen = rings.seen();
  const double own_spin = (rings.spin - rings.orbit) * rings.a;
  const double inner_surface = (40.0 - rings.orbit) * rings.model.geometry.inner_radius;
  const double outer_surface = (700.0 - rings.orbit) * rings.model.geometry.outer_radius;
  const auto entrained = [&](double rolling) {
    return std::hypot(rolling, rings.model.inner.entrainment_scale);
  };
  for (Eigen::Index j = 0; j < rings.model.layout.rollers; ++j) {
    EXPECT_NEAR(seen.inner.sliding[j], inner_surface + own_spin, kRoundOff);
    EXPECT_NEAR(seen.inner.entrainment[j], entrained(0.5 * (inner_surface - own_spin)), kRoundOff);
    EXPECT_NEAR(seen.outer.sliding[j], outer_surface - own_spin, kRoundOff);
    EXPECT_NEAR(seen.outer.entrainment[j], entrained(0.5 * (outer_surface + own_spin)), kRoundOff);
  }
}

TEST(Snapshot, PureRollingDoesNotSlide) {
  CentredRings rings;
  rings.orbit = kinematic_cage_speed(rings.model.geometry, 40.0, 700.0);
  rings.spin = kinematic_roller_spin(rings.model.geometry, 40.0, 700.0);
  const Snapshot seen = rings.seen();
  EXPECT_NEAR(seen.inner.sliding.abs().maxCoeff(), 0.0, kRoundOff);
  EXPECT_NEAR(seen.outer.sliding.abs().maxCoeff(), 0.0, kRoundOff);
}

}  // namespace
}  // namespace orbearing::bearing::motion::snapshot_test
