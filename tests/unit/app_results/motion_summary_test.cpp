// Lines about slip, losses and skidding that a terminal shows of a row.
#include "app/results/motion_summary.hpp"

#include <gtest/gtest.h>

namespace orbearing::app::motion_summary_test {
namespace {

using analysis::PointRow;

void put_load(double load, double capacity, analysis::RatingRecord& rating) {
  rating.lives.dynamic_load = load;
  rating.lives.dynamic_capacity = capacity;
}

PointRow moving() {
  PointRow point;
  point.cage_slip = 0.0123;
  point.power_loss = 12.34;
  point.motion = analysis::MotionNumbers{
      .roller_slip = 0.2,
      .loss = {.inner_traction = 10.0, .rolling = -3.0, .drag = 2.0, .support = PointRow::kNone}};
  put_load(500.0, 25000.0, point.rating);
  return point;
}

TEST(MotionSummary, TellsSlipLossesByCauseAndSkidding) {
  EXPECT_EQ(motion_summary_text(moving(), skid_risk_of(moving(), 0.01)),
            "slip: cage 1.23 %, rollers 20 %\n"
            "power loss of one bearing: 12.34 W: inner traction 10, rolling -3, drag 2\n"
            "skid risk: no: P/C 0.02, minimum load 0.01\n");
}

TEST(MotionSummary, RiskIsThatOfTheLeastLoadedBearing) {
  PointRow point;
  point.sets.resize(3);
  put_load(300.0, 1000.0, point.sets[0].rating);
  put_load(100.0, 1000.0, point.sets[1].rating);
  put_load(200.0, 1000.0, point.sets[2].rating);
  EXPECT_DOUBLE_EQ(skid_risk_of(point)->load_ratio, 0.1);
  EXPECT_EQ(motion_summary_text(point, skid_risk_of(point, 0.2)),
            "skid risk: yes: P/C 0.1, minimum load 0.2\n");
  point.sets[1].rating.lives.dynamic_load = PointRow::kNone;
  EXPECT_FALSE(skid_risk_of(point));
}

TEST(MotionSummary, ARowThatFailedHasNone) {
  PointRow point = moving();
  point.status = "no equilibrium";
  EXPECT_EQ(motion_summary_text(point, std::nullopt), "");
}

}  // namespace
}  // namespace orbearing::app::motion_summary_test
