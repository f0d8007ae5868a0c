// Races that are not round and unequal rollers, where another description of the same bearing is known.
#include <gtest/gtest.h>

#include "bearing/contact/race_contact.hpp"
#include "bearing/contact/race_form.hpp"
#include "bearing/motion/snapshot.hpp"
#include "tests/messages.hpp"
#include "tests/unit/bearing/example_bearings.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::bearing_form_test {
namespace {

constexpr double kBalance = 1e-7;  // relative to the largest load: the solver's residual of 1e-9 and
                                   // round-off of micrometres in approaches

const OperatingPoint kPoint = test::reducer_point(6000.0);

double scale_of(const QuasiStaticResult& result) {
  return result.outer_load.maxCoeff();
}

// A form of one wave is a race moved aside: the loads are the same, the rest shows in the displacement.
TEST(RaceForm, OneWaveIsAShiftedRace) {
  const Bearing round = test::reducer_bearing();
  const QuasiStaticResult expected = quasi_static_bearing(round, kPoint, {});
  for (const bool outer : {false, true}) {
    Bearing shifted = round;
    (outer ? shifted.outer.form : shifted.inner.form) = {{1, 6e-6, -0.4, false}};
    const QuasiStaticResult found = quasi_static_bearing(shifted, kPoint, {});
    const double scale = scale_of(expected);
    EXPECT_LT((found.outer_load - expected.outer_load).abs().maxCoeff(), kBalance * scale);
    const Eigen::Vector2d shift = (outer ? -6e-6 : 6e-6) * Eigen::Vector2d(std::cos(0.4), std::sin(0.4));
    EXPECT_LT((found.displacement - expected.displacement - shift).norm(), 1e-12);
  }
}

TEST(RaceForm, RollersAllLargerTakeClearance) {
  const Bearing nominal = test::reducer_bearing();
  Bearing larger = nominal, tighter = nominal;
  larger.rollers().diameter_deviation.assign(15, 3e-6);
  tighter.radial_clearance -= 2.0 * 3e-6;
  const QuasiStaticState found = quasi_static_state(larger, kPoint, {}, 0.1);
  const QuasiStaticState expected = quasi_static_state(tighter, kPoint, {}, 0.1);
  EXPECT_LT((found.inner_load - expected.inner_load).abs().maxCoeff(), 1e-6 * expected.inner_load.maxCoeff())
      << "but for inertial loads, of the relative order 3e-6";
}

// An oval bore, longer along its load, takes load from the middle of the load zone to its ends.
TEST(RaceForm, OvalBoreSpreadsTheLoad) {
  Bearing oval = test::reducer_bearing();
  oval.radial_clearance = 20e-6;  // so that its waist does not pinch the rollers at the sides
  const QuasiStaticResult round = quasi_static_bearing(oval, kPoint, {});
  const double direction = std::atan2(kPoint.bore_load.y(), kPoint.bore_load.x());
  oval.outer.form = {{2, 5e-6, -2.0 * direction, false}};
  EXPECT_LT(scale_of(quasi_static_bearing(oval, kPoint, {})), 0.95 * scale_of(round));
  oval.outer.form[0].amplitude = -5e-6;
  EXPECT_GT(scale_of(quasi_static_bearing(oval, kPoint, {})), 1.05 * scale_of(round));
}

TEST(RaceForm, MeansOverOnePitchRefuseWhatDiffersFromPitchToPitch) {
  Bearing bearing = test::reducer_bearing();
  bearing.rollers().diameter_deviation = {1e-6};
  EXPECT_REFUSED(std::invalid_argument, "bearing_form 1", quasi_static_bearing(bearing, kPoint, {}));
  bearing.rollers().diameter_deviation.clear();
  bearing.inner.form = {{2, 1e-6, 0.0, true}};
  EXPECT_REFUSED(std::invalid_argument, "bearing_form 2", quasi_static_bearing(bearing, kPoint, {}));
  bearing.inner.form[0].rotating = false;
  EXPECT_NO_THROW(quasi_static_bearing(bearing, kPoint, {}));
}

// One wave that turns with the race is a race whose centre circles: the same forces, to the second order in
// the shift over the radius.
TEST(RaceForm, OneTurningWaveIsACirclingRace) {
  constexpr double kShift = 1e-6, kPitchRadius = 17.82e-3;  // [m]
  Bearing bearing = test::reducer_bearing();
  bearing.rollers().count = 3;
  bearing.cage = {};
  const motion::BearingModel round = bearing_model(bearing, kPoint, test::reducer_parameters());
  bearing.outer.form = {{1, kShift, 0.0, true}};
  const motion::BearingModel waved = bearing_model(bearing, kPoint, test::reducer_parameters());
  const double angle = 0.7, position = 0.2;
  const mechanics::Vector2 to_mark(std::cos(angle), std::sin(angle));
  motion::BoreMotion rotating, circling;
  rotating.speed = circling.speed = -900.0;
  rotating.angle = angle;
  circling.position = kShift * to_mark;
  circling.velocity = kShift * circling.speed * mechanics::across(to_mark);
  // One roller pressed into the outer race, the others far from it.
  Eigen::VectorXd x = Eigen::VectorXd::Zero(round.layout.size());
  motion::MutableStateViews state = motion::mutable_state_views(round.layout, x.data());
  state.radius << kPitchRadius + 4e-6, kPitchRadius - 1e-3, kPitchRadius - 1e-3;
  state.angle << position, position + 2.0, position + 4.0;
  state.spin[0] = -4000.0;
  const motion::Snapshot found = driven_snapshot(waved, rotating, x);
  const motion::Snapshot expected = driven_snapshot(round, circling, x);
  const double second_order = kShift * kShift / kPitchRadius / 4e-6 * 10.0 / 9.0;
  EXPECT_NEAR(found.outer.load[0], expected.outer.load[0], 2.0 * second_order * expected.outer.load[0]);
  EXPECT_LT((found.on_bore.force - expected.on_bore.force).norm(), 1e-5 * expected.outer.load[0]);
  const double first_order =
      kShift / kPitchRadius;  // of the line's turning on the approach speed, which is squared
  EXPECT_NEAR(found.loss.race_damping, expected.loss.race_damping,
              4.0 * first_order * expected.loss.race_damping);
}

}  // namespace
}  // namespace orbearing::bearing::bearing_form_test
