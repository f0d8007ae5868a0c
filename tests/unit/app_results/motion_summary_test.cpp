// Lines about slip, losses and skidding that a terminal shows of a row.
#include "app/results/motion_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace orbearing::app::motion_summary_test {
namespace {

struct Shown {
  TableHead head;
  ResultRow row{.values = {}, .status = "ok"};

  void add(const std::string& name, double value) {
    head.names.push_back(name);
    row.values.push_back(value);
  }
};

Shown moving(const std::string& prefix = "") {
  Shown shown;
  shown.add(prefix + "cage_slip", 0.0123);
  shown.add(prefix + "roller_slip", 0.2);
  shown.add(prefix + "power_loss_W", 12.34);
  shown.add(prefix + "power_loss_churning_W", 2.0);
  shown.add(prefix + "power_loss_inner_traction_W", 10.0);
  shown.add(prefix + "power_loss_cage_W", 0.0);
  shown.add(prefix + "power_loss_support_W", std::numeric_limits<double>::quiet_NaN());
  shown.add(prefix + "power_loss_port_W", -3.0);
  shown.add(prefix + "P_N", 500.0);
  shown.add(prefix + "C_N", 25000.0);
  return shown;
}

TEST(MotionSummary, TellsSlipLossesByCauseAndSkidding) {
  const Shown shown = moving();
  const auto risk = skid_risk_of(shown.head, {}, shown.row, 0.01);
  EXPECT_EQ(motion_summary_text(shown.head, {}, shown.row, risk),
            "slip: cage 1.23 %, rollers 20 %\n"
            "power loss of one bearing: 12.34 W: inner traction 10, port -3, churning 2\n"
            "skid risk: no: P/C 0.02, minimum load 0.01\n");
}

TEST(MotionSummary, OfSeveralSetsIsEachWithItsName) {
  const Shown shown = moving("sets.first.");
  const auto risk = skid_risk_of(shown.head, {"first"}, shown.row, 0.05);
  EXPECT_EQ(motion_summary_text(shown.head, {"first"}, shown.row, risk),
            "sets.first. slip: cage 1.23 %, rollers 20 %\n"
            "sets.first. power loss of one bearing: 12.34 W: inner traction 10, port -3, churning 2\n"
            "skid risk: yes: P/C 0.02, minimum load 0.05\n");
}

TEST(MotionSummary, RiskIsThatOfTheLeastLoadedBearing) {
  Shown shown;
  for (const auto& [set, load] : {std::pair{"one", 300.0}, std::pair{"two", 100.0}, std::pair{"three", 200.0}}) {
    shown.add(std::string("sets.") + set + ".P_N", load);
    shown.add(std::string("sets.") + set + ".C_N", 1000.0);
  }
  EXPECT_DOUBLE_EQ(skid_risk_of(shown.head, {"one", "two", "three"}, shown.row)->load_ratio, 0.1);
  shown.row.values[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(skid_risk_of(shown.head, {"one", "two", "three"}, shown.row));
}

TEST(MotionSummary, ARowThatFailedHasNone) {
  Shown shown = moving();
  shown.row.status = "no equilibrium";
  EXPECT_EQ(motion_summary_text(shown.head, {}, shown.row, std::nullopt), "");
}

}  // namespace
}  // namespace orbearing::app::motion_summary_test
