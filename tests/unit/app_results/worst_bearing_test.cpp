#include "app/results/worst_bearing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace orbearing::app::worst_bearing_test {
namespace {

using Columns = std::map<std::string, double>;

WorstBearing worst(const std::string& key, const std::vector<std::string>& sets, const Columns& columns) {
  return worst_bearing(key, sets, [&](const std::string& name) {
    const auto found = columns.find(name);
    return found == columns.end() ? described::kAbsent : found->second;
  });
}

TEST(WorstBearing, OfOneSetGoesByTheCarrierThenTheShortestThenAny) {
  Columns columns{{"L10h", 5.0}};
  EXPECT_EQ(worst("L10h", {}, columns).value, 5.0);
  columns["shortest_L10h"] = 4.0;
  EXPECT_EQ(worst("L10h", {}, columns).value, 4.0);
  columns["carrier_L10h"] = 6.0;
  EXPECT_EQ(worst("L10h", {}, columns).value, 6.0);
  EXPECT_EQ(worst("L10h", {}, columns).column(), "carrier_L10h");
}

// The set with the shortest mean life need not be that with the worst bearing.
TEST(WorstBearing, OfSeveralSetsIsTheWorstBearingOfAll) {
  const Columns columns{
      {"sets.one.L10mrh", 50.0}, {"sets.two.L10mrh", 90.0}, {"sets.two.shortest_L10mrh", 40.0}};
  const WorstBearing found = worst("L10mrh", {"one", "two"}, columns);
  EXPECT_EQ(found.value, 40.0);
  EXPECT_EQ(found.column(), "sets.two.shortest_L10mrh");
  EXPECT_EQ(found.set, "two");
}

TEST(WorstBearing, TheLargestPressureAndLoadShareAreTheWorst) {
  const Columns columns{{"sets.one.contact_pressure_max_MPa", 900.0},
                        {"sets.two.contact_pressure_max_MPa", 1200.0},
                        {"sets.one.S0", 3.0},
                        {"sets.two.S0", 2.0},
                        {"sets.one.largest_load_share", 1.2}};
  const std::vector<std::string> sets{"one", "two"};
  EXPECT_EQ(worst("contact_pressure_max_MPa", sets, columns).set, "two");
  EXPECT_EQ(worst("S0", sets, columns).value, 2.0);
  EXPECT_EQ(worst("largest_load_share", sets, columns).value, 1.2);  // planets of the other carry equal loads
  EXPECT_TRUE(std::isnan(worst("largest_load_share", sets, {}).value));
}

TEST(WorstBearing, IsUnknownWhereASetHasNoneAndInfiniteWithoutLoad) {
  const double none = std::numeric_limits<double>::infinity();
  const WorstBearing unknown = worst("L10mh", {"one", "two"}, {{"sets.one.L10mh", 5.0}});
  EXPECT_TRUE(std::isnan(unknown.value));
  EXPECT_EQ(unknown.set, "two");
  EXPECT_EQ(worst("L10h", {"one", "two"}, {{"sets.one.L10h", none}, {"sets.two.L10h", 7.0}}).value, 7.0);
  EXPECT_EQ(worst("L10h", {"one"}, {{"sets.one.L10h", none}}).value, none);
}

}  // namespace
}  // namespace orbearing::app::worst_bearing_test
