#include "app/case/drivetrain_analyses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "app/case/machine_rows.hpp"

namespace orbearing::app {
namespace {

using analysis::Physics;
using testing::IsEmpty;
using testing::Not;

TEST(DrivetrainAnalyses, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const AnalysisId analysis : drivetrain_analyses()) {
    EXPECT_THAT(analysis_name(analysis), Not(IsEmpty()));
    EXPECT_TRUE(names.insert(analysis_name(analysis)).second) << analysis_name(analysis);
  }
  EXPECT_EQ(analysis_name(id_of_machine_analysis(0)), "run of a single bearing");
}

// What no analysis holds would be an input that changes nothing: there is one such, in the flow of power
// alone.
TEST(DrivetrainAnalyses, HoldThePhysicsOfEveryInput) {
  std::set<Physics> of_inputs;
  for (const auto& [key, physics] : analysis::physics_of_inputs()) {
    EXPECT_EQ(analyses_with(physics).is_empty(), physics == Physics::output) << key;
    of_inputs.insert(physics);
  }
  for (int i = 0; i < static_cast<int>(Physics::equilibrium); ++i)
    EXPECT_TRUE(of_inputs.contains(static_cast<Physics>(i))) << i;
}

TEST(DrivetrainAnalyses, DoNotLeaveOutWhatTheyHold) {
  for (const AnalysisId analysis : drivetrain_analyses()) {
    const DrivetrainAnalysis& row = drivetrain_analysis(analysis);
    EXPECT_FALSE(row.holds.has_some_of(row.leaves_out)) << row.name;
  }
}

TEST(DrivetrainAnalyses, AreGroupedByTheirPhysics) {
  using enum AnalysisId;
  EXPECT_EQ(analyses_with_lives(),
            (AnalysisSet{quasi_static, dynamic, dynamic_of_sets, co_simulated, monolithic, crown}));
  EXPECT_EQ(analyses_of_one_set_in_time(), (AnalysisSet{dynamic, co_simulated, monolithic}));
  EXPECT_EQ(analyses_with(Physics::exchange), AnalysisSet(co_simulated));
  EXPECT_EQ(analyses_leaving_out(Physics::gear_motion), AnalysisSet(dynamic_of_sets));
}

}  // namespace
}  // namespace orbearing::app
