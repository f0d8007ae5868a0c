#include <gtest/gtest.h>

#include <cmath>

#include "bearing/contact/line_contact.hpp"
#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/equilibrium/row_group.hpp"
#include "tests/messages.hpp"
#include "tests/unit/defect/scratched_bearings.hpp"

namespace orbearing::bearing::defect::scratched_motion_test {
namespace {

using Eigen::VectorXd;

void take_form(ScratchedMotion& motion, double time, const VectorXd& x) {
  Eigen::ArrayXd values(motion.switches());
  motion.switch_values(time, x, values);
  for (Eigen::Index i = 0; i < values.size(); ++i) motion.set_switch(i, values[i] > 0.0);
}

VectorXd at_rest(const ScratchedMotion& motion) {
  VectorXd x = VectorXd::Zero(4);
  x.head<2>() = motion.static_position().position;
  return x;
}

// The ring of five freedoms finds the same place: nothing tilts it or moves it along the axis.
TEST(ScratchedMotion, RestsWhereTheStaticBearingDoes) {
  const ScratchedMotion motion(nine_balls());
  const auto state =
      equilibrium::balance_bearing(nine_balls().bearing, {.radial = nine_balls().load + motion.weight()});
  constexpr double searches = 1e-9;  // relative, what two searches leave
  EXPECT_NEAR(motion.static_position().position[0], state.radial, searches * state.radial);
  EXPECT_NEAR(motion.static_position().position[1], 0.0, searches * state.radial);
  for (Eigen::Index j = 0; j < motion.elements(); ++j)
    EXPECT_NEAR(motion.static_position().load[j], state.contact_load[j],
                searches * state.contact_load.maxCoeff());
}

TEST(ScratchedMotion, StandsStillAtRest) {
  ScratchedBearing in = nine_balls();
  in.shaft_speed = 1e-9;  // the cage moves balls and with them the equilibrium
  ScratchedMotion motion(in);
  const VectorXd x = at_rest(motion);
  take_form(motion, 0.0, x);
  VectorXd dx(4);
  motion.rates(0.0, x, dx);
  EXPECT_LT(dx.tail<2>().norm() * in.ring.mass, 1e-9 * in.load);
}

// Pushed a little along the load it resists by the stiffness stated and is held back by its share of 2 sqrt(k
// m).
TEST(ScratchedMotion, StiffnessAndDampingAreThoseAlongTheLoad) {
  for (const auto& law : names_of(DampingLaw{})) {
    ScratchedBearing in = nine_balls();
    in.shaft_speed = 1e-9;
    in.ring.damping_law = law.value;
    in.ring.damping_ratio = 0.07;
    ScratchedMotion motion(in);
    VectorXd x = at_rest(motion), dx(4);
    take_form(motion, 0.0, x);
    const double k = motion.static_position().stiffness, m = in.ring.mass;
    constexpr double small = 1e-11;  // [m]
    x[0] += small;
    motion.rates(0.0, x, dx);
    EXPECT_NEAR(-dx[2] * m / small, k, 1e-4 * k) << law.text;
    x[0] -= small;
    x[2] = 1e-7;  // [m/s]
    motion.rates(0.0, x, dx);
    const double critical = 2.0 * std::sqrt(k * m);
    EXPECT_NEAR(-dx[2] * m / x[2], 0.07 * critical, 1e-6 * critical) << law.text;
  }
}

TEST(ScratchedMotion, RollersGoByTheirPower) {
  ScratchedBearing in = nine_balls();
  in.bearing.elements = CylindricalRollers{.count = 11, .diameter = 8e-3, .length = 9e-3};
  const ScratchedMotion motion(in);
  const LineContact one = roller_race_contact(in.bearing.contact_law, 9e-3);
  const double approach = motion.static_position().position[0] - 0.5 * in.bearing.radial_clearance;
  const double load = one.load(0.5 * approach);  // two equal ones, one behind the other
  EXPECT_NEAR(motion.static_position().load[0], load, 1e-9 * load);
}

// Positions and frequency of contacts with a scratch: the middle of each passing is a whole number of passes
// on.
TEST(ScratchedMotion, ScratchesAreMetAtTheirPassingFrequency) {
  for (const Scratched race : {Scratched::outer, Scratched::inner, Scratched::ball}) {
    const ScratchedBearing in = scratched(race);
    ScratchedMotion motion(in);
    const PassingFrequencies passing = passing_frequencies(in.bearing, in.shaft_speed);
    const double frequency = race == Scratched::outer   ? passing.outer_pass
                             : race == Scratched::inner ? passing.inner_pass
                                                        : passing.element_pass;
    const VectorXd x = at_rest(motion);
    Eigen::ArrayXd values(motion.switches());
    for (int pass = 0; pass < 5; ++pass) {
      motion.switch_values(pass / frequency, x, values);
      EXPECT_NEAR(values.tail(motion.elements()).maxCoeff(), 0.5 * in.scratch.width, 1e-9 * in.scratch.width)
          << static_cast<int>(race) << " " << pass;
      motion.switch_values((pass + 0.5) / frequency, x, values);
      EXPECT_LT(values.tail(motion.elements()).maxCoeff(), 0.0);
    }
  }
}

// The speed of approach is the rate of the approach, along the motion and through a scratch.
TEST(ScratchedMotion, SpeedOfApproachIsItsRate) {
  for (const Scratched race : {Scratched::none, Scratched::outer, Scratched::inner, Scratched::ball}) {
    ScratchedMotion motion(scratched(race));
    VectorXd x = at_rest(motion);
    x.tail<2>() << 3e-3, -2e-3;
    const double time = race == Scratched::none ? 0.01 : 0.2 * motion.passing_time(), step = 1e-8;
    take_form(motion, time, x);
    VectorXd later = x, before = x;
    later.head<2>() += step * x.tail<2>();
    before.head<2>() -= step * x.tail<2>();
    for (Eigen::Index j = 0; j < motion.elements(); ++j) {
      const double rate =
          (motion.contact(j, time + step, later).approach - motion.contact(j, time - step, before).approach) /
          (2.0 * step);
      EXPECT_NEAR(motion.contact(j, time, x).approach_speed, rate, 1e-6 * (std::abs(rate) + 1e-3)) << j;
    }
  }
}

TEST(ScratchedMotion, RefusesWhatCannotBe) {
  ScratchedBearing light = nine_balls();
  light.ring.mass = 0.0;
  EXPECT_REFUSED(std::invalid_argument, "scratched_motion 1", ScratchedMotion{light});
  ScratchedBearing narrow = scratched(Scratched::inner);
  narrow.scratch.width = 0.0;
  EXPECT_REFUSED(std::invalid_argument, "scratched_motion 2", ScratchedMotion{narrow});
}

}  // namespace
}  // namespace orbearing::bearing::defect::scratched_motion_test
