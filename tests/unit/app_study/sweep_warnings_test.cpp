// Which rows a sweep warns of: beyond each limit, and none at it. Issue 44, Build 4 (b) and item 16; words
// and numbers in tests/messages.txt.
#include "app/study/sweep_warnings.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/messages.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::sweep_warnings_test {
namespace {

// Rows at 1000, 2000, ... rpm whose one column holds `values`, and what stands in the last column beside it.
SweepOutcome outcome_of(const std::string& name, const std::vector<double>& values,
                        const std::string& beside = "", double value_beside = 0.0) {
  SweepOutcome outcome;
  outcome.header.fidelity = "dynamic";
  outcome.header.points = values.size();
  outcome.head = head_of(outcome.header);
  const auto position = [&](const std::string& column) {
    const auto found = std::find(outcome.head.names.begin(), outcome.head.names.end(), column);
    EXPECT_NE(found, outcome.head.names.end()) << column;
    return static_cast<std::size_t>(found - outcome.head.names.begin());
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    ResultRow row{std::vector<double>(outcome.head.names.size(), std::numeric_limits<double>::quiet_NaN()),
                  "ok"};
    row.values[position("input_speed_rpm")] = 1000.0 * static_cast<double>(i + 1);
    row.values[position(name)] = values[i];
    if (!beside.empty()) row.values[position(beside)] = value_beside;
    outcome.rows.push_back(row);
  }
  return outcome;
}

// The last warning; that of nothing is one of the gears.
std::string last_warning(const SweepOutcome& outcome) {
  return sweep_warnings(shipped(), outcome, {}).back();
}

TEST(SweepWarnings, OfPressureAreThoseOfRollersThatYield) {
  EXPECT_SAID("sweep yields",
              last_warning(outcome_of("contact_pressure_max_MPa", {3990.0, 4000.0, 4001.0, 5000.0})));
}

TEST(SweepWarnings, OfKappaAreThoseBelowATenth) {
  EXPECT_SAID("sweep starves", last_warning(outcome_of("kappa", {0.0999, 0.1, 0.0, 4.0})));
}

TEST(SweepWarnings, OfDriftAreThoseOfMeansThatDidNotStandStill) {
  EXPECT_SAID("sweep drifts", last_warning(outcome_of("steady", {1.0, 1.0, 0.0})));
}

TEST(SweepWarnings, OfTheOneWayLaw) {
  EXPECT_SAID("one way not accepted", last_warning(outcome_of("one_way_accepted", {1.0, 0.0, 0.0},
                                                              "one_way_load_difference", 0.002)));
  EXPECT_SAID("one way displaced", last_warning(outcome_of("one_way_load_difference", {0.002, 0.0021, 0.3},
                                                           "one_way_accepted", 0.0)));
}

TEST(SweepWarnings, OfBoresWhoseMotionDependsOnTheirMeshes) {
  EXPECT_SAID("one way solved together", last_warning(outcome_of("interface_window_us", {0.0, 4.3})));
  const SweepOutcome light = outcome_of("drag_slip", {0.05, 0.051});
  EXPECT_SAID("one way not followed", last_warning(light));
  EXPECT_SAID("one way free bore",
              sweep_warnings(shipped({"input.acceleration=10 rpm/s"}), light, {}).back());
  const SweepOutcome whirling = outcome_of("drag_slip", {0.5, 0.4, 0.05}, "cage_slip", 0.42);
  const std::string without = "traction.rolling_resistance=false";
  EXPECT_SAID("slip by drag", sweep_warnings(shipped({without}), whirling, {}).end()[-2]);
  EXPECT_SAID("slip by drag of squeezed oil",
              sweep_warnings(shipped({without, "contact.squeeze=true"}), whirling, {}).end()[-2]);
  // With rolling resistance less slip than 0.5 is as it should be; more is not.
  const auto count = [](const SweepOutcome& outcome) {
    return sweep_warnings(shipped(), outcome, {}).size();
  };
  const SweepOutcome slipping = outcome_of("drag_slip", {0.5, 0.4, 0.05}, "cage_slip", 0.6);
  EXPECT_EQ(count(slipping), count(whirling) + 1);
}

}  // namespace
}  // namespace orbearing::app::sweep_warnings_test
