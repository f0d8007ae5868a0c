// Rows that a sweep warns of: beyond each limit, and none at it; words and numbers in tests/messages.txt.
#include "app/study/sweep_warnings.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/messages.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::sweep_warnings_test {
namespace {

// Rows at 1000, 2000, ... rpm whose one column holds `values`, and values of other columns in `beside`.
SweepOutcome outcome_of(const std::string& name, const std::vector<double>& values,
                        const std::map<std::string, double>& beside = {}) {
  SweepOutcome outcome;
  outcome.header.fidelity = "dynamic";
  outcome.header.points = values.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::vector<std::pair<std::string, double>> row{
        {"input_speed_rpm", 1000.0 * static_cast<double>(i + 1)}, {"steady", 1.0}, {name, values[i]}};
    row.insert(row.end(), beside.begin(), beside.end());
    outcome.rows.push_back(row_of_numbers(row, outcome.header));
    for (const auto& [column, value] : row)
      EXPECT_EQ(number_named(outcome.header, outcome.rows.back(), column),
                column == name ? values[i] : value);
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
                                                              {{"one_way_load_difference", 0.002}})));
  EXPECT_SAID("one way displaced", last_warning(outcome_of("one_way_load_difference", {0.002, 0.0021, 0.3},
                                                           {{"one_way_accepted", 0.0}})));
}

TEST(SweepWarnings, OfAnExchangeThatMakesPower) {
  EXPECT_SAID("exchange makes power",
              last_warning(outcome_of("interface_energy_residual", {0.0075, 0.01, 0.0101, 0.101})));
}

TEST(SweepWarnings, OfBoresWhoseMotionDependsOnTheirMeshes) {
  EXPECT_SAID("one way solved together", last_warning(outcome_of("interface_window_us", {0.0, 4.3})));
  const SweepOutcome light = outcome_of("drag_over_traction", {1.0, 1.01});
  EXPECT_SAID("one way not followed", last_warning(light));
  EXPECT_SAID("one way free bore",
              sweep_warnings(shipped({"input.acceleration=10 rpm/s"}), light, {}).back());
  const SweepOutcome whirling =
      outcome_of("drag_slip", {0.451, 0.449, 0.391}, {{"cage_slip", 0.42}, {"drag_over_traction", 1.01}});
  EXPECT_SAID("slip by drag", sweep_warnings(shipped(), whirling, {}).end()[-2]);
  EXPECT_SAID("slip by drag of squeezed oil",
              sweep_warnings(shipped({"contact.squeeze=true"}), whirling, {}).end()[-2]);
  const auto count = [](const SweepOutcome& outcome) {
    return sweep_warnings(shipped(), outcome, {}).size();
  };
  // Also of a cage that slips more, and of none that is loaded.
  const std::vector<double> slips{0.451, 0.449, 0.391};
  EXPECT_EQ(count(outcome_of("drag_slip", slips, {{"cage_slip", 0.5}, {"drag_over_traction", 1.01}})),
            count(whirling));
  EXPECT_EQ(count(outcome_of("drag_slip", slips, {{"cage_slip", 0.42}, {"drag_over_traction", 1.0}})),
            count(whirling) - 2);
}

}  // namespace
}  // namespace orbearing::app::sweep_warnings_test
