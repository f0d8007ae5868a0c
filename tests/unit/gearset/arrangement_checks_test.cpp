#include "gearset/drivetrain/arrangement_checks.hpp"

#include <gmock/gmock.h>

#include "gearset/drivetrain/power_flow.hpp"
#include "tests/unit/gearset/arrangements.hpp"

namespace orbearing::gearset::arrangement_checks_test {
namespace {

using namespace gearset::example_sets;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

ArrangementProblem only_problem(const Arrangement& arrangement) {
  const std::vector<ArrangementProblem> problems = arrangement_problems(arrangement);
  EXPECT_EQ(problems.size(), 1U);
  return problems.empty() ? ArrangementProblem{} : problems.front();
}

std::size_t shaft_named(const Arrangement& arrangement, const std::string& name) {
  std::size_t position = 0;
  while (arrangement.shafts[position].name != name) ++position;
  return position;
}

TEST(ArrangementProblems, AreNoneForSoundOnes) {
  for (const Arrangement& sound : {reducer_alone(), three_in_series(), simpson_low(), circulating()})
    EXPECT_THAT(arrangement_problems(sound), IsEmpty());
}

// The second set, from the same input to the load, has no part in the contradiction.
TEST(ArrangementProblems, NameTwoGroundsOnOneSet) {
  const Arrangement faulty{{arranged("brake", 37, 22, 79), arranged("gear", 30, 19, 66)},
                           {motor({{0, sun}, {1, sun}}),
                            ground({{0, ring}, {1, ring}}),
                            load({{1, carrier}}),
                            {"bracket", {{0, carrier}}, false, false, true}}};
  const ArrangementProblem problem = only_problem(faulty);
  EXPECT_THAT(problem.members, ElementsAre(SetMember{0, sun}, SetMember{0, ring}, SetMember{0, carrier}));
  EXPECT_THAT(problem.shafts, ElementsAre(1, 3, 0));  // grounds first
  EXPECT_THAT(problem.found, HasSubstr("brake.carrier (on 'bracket')"));
}

TEST(ArrangementProblems, NameFloatingMembers) {
  Arrangement alone = three_in_series();
  alone.shafts[4].members.pop_back();
  alone.shafts.push_back(shaft("loose", {{2, ring}}));
  EXPECT_THAT(only_problem(alone).members, ElementsAre(SetMember{2, ring}));
  EXPECT_THAT(only_problem(alone).found, HasSubstr("transmission.ring alone, so that it floats"));
  EXPECT_EQ(only_problem(alone).shafts.front(), shaft_named(alone, "loose"));
  Arrangement nowhere = three_in_series();
  nowhere.shafts[4].members.pop_back();
  EXPECT_THAT(only_problem(nowhere).found, HasSubstr("transmission.ring on no shaft"));
}

// A ring that nothing holds leaves its set without torque; the rest continues as without that set.
TEST(ArrangementProblems, AreNoneForAnIdleSet) {
  Arrangement idle = reducer_alone();
  idle.sets.push_back(arranged("brake", 37, 22, 79));
  idle.shafts[0].members.push_back({1, sun});
  idle.shafts[2].members.push_back({1, carrier});
  idle.shafts.push_back(shaft("open", {{1, ring}}));
  EXPECT_THAT(arrangement_problems(idle), IsEmpty());
  const PowerFlow flow = power_flow(idle);
  EXPECT_THAT(idle_sets(flow), ElementsAre(1));
  EXPECT_THAT(idle_sets(power_flow(reducer_alone())), IsEmpty());
  EXPECT_EQ(flow.sets[1].torque.carrier, 0.0);
  EXPECT_NEAR(flow.sets[1].speed.ring, 0.0, 1e-14);  // as the equal set beside it, whose ring is stationary
  EXPECT_NEAR(flow.sets[1].speed.planet_relative, flow.sets[0].speed.planet_relative, 1e-14);
}

// A set with carrier and ring on one shaft turns as a block: no planet turns, not even by round-off.
TEST(ArrangementProblems, ABlockHasPlanetsThatStand) {
  Arrangement block = three_in_series();
  block.shafts[4].members.pop_back();
  block.shafts[2].members.push_back({2, ring});
  ASSERT_THAT(arrangement_problems(block), IsEmpty());
  EXPECT_EQ(power_flow(block).sets[2].speed.planet_relative, 0.0);
}

TEST(ArrangementProblems, NameAMemberOnTwoShafts) {
  Arrangement twice = reducer_alone();
  twice.shafts[2].members.push_back({0, ring});
  EXPECT_THAT(only_problem(twice).found, HasSubstr("reduction.ring on 'housing' and 'output'"));
}

// A locked set rotates as one, so its ring cannot be stationary while the motor runs.
TEST(ArrangementProblems, NameContradictoryShafts) {
  const Arrangement locked{
      {arranged("first", 30, 30, 90), arranged("second", 37, 22, 79)},
      {motor({{0, sun}, {0, carrier}}), ground({{0, ring}, {1, ring}}), load({{1, carrier}, {1, sun}})}};
  const auto problems = arrangement_problems(locked);
  ASSERT_FALSE(problems.empty());
  EXPECT_THAT(problems.front().found, HasSubstr("contradict each other"));
  EXPECT_THAT(problems.front().members,
              ElementsAre(SetMember{0, sun}, SetMember{0, ring}, SetMember{0, carrier}));
}

TEST(ArrangementProblems, NameOpenSpeeds) {
  Arrangement open = three_in_series();
  open.shafts[4].members = {{0, ring}, {1, ring}};
  open.shafts.push_back({"second output", {{2, ring}}, false, true, false});
  const ArrangementProblem problem = only_problem(open);
  EXPECT_THAT(problem.found, HasSubstr("speeds undetermined"));
  EXPECT_THAT(problem.members, UnorderedElementsAre(SetMember{2, carrier}, SetMember{2, ring}));
}

// Two equal sets side by side: the speeds agree, but how they share the torque does not follow.
TEST(ArrangementProblems, NameOpenTorques) {
  const Arrangement parallel{
      {arranged("left", 30, 30, 90), arranged("right", 30, 30, 90)},
      {motor({{0, sun}, {1, sun}}), ground({{0, ring}, {1, ring}}), load({{0, carrier}, {1, carrier}})}};
  EXPECT_THAT(only_problem(parallel).found, HasSubstr("torques undetermined"));
  EXPECT_EQ(only_problem(parallel).members.size(), 6U);
  Arrangement two_loads = three_in_series();
  two_loads.shafts[2].load = true;
  EXPECT_THAT(only_problem(two_loads).found, HasSubstr("the loads on 'second' and 'output' share the power"));
}

TEST(ArrangementProblems, NameALoadThatStandsStill) {
  // w_c = (30 w_s + 90 w_r)/120 = 0 at w_r = -w_s/3, which the control set gives: a geared neutral.
  const Arrangement neutral{{arranged("main", 30, 30, 90), arranged("control", 20, 20, 60)},
                            {motor({{0, sun}, {1, sun}}), shaft("rings", {{0, ring}, {1, ring}}),
                             load({{0, carrier}}), ground({{1, carrier}})}};
  const auto problems = arrangement_problems(neutral);
  ASSERT_FALSE(problems.empty());
  EXPECT_THAT(problems.front().found, HasSubstr("is stationary"));
  EXPECT_THAT(problems.front().members, ElementsAre(SetMember{0, carrier}));
}

TEST(ArrangementProblems, NameMissingAndSuperfluousPorts) {
  Arrangement no_motor = reducer_alone();
  no_motor.shafts[0].motor = false;
  const auto problems = arrangement_problems(no_motor);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_THAT(problems[0].found, HasSubstr("no motor"));
  EXPECT_THAT(problems[1].found, HasSubstr("reduction.sun alone"));
  Arrangement no_load = reducer_alone();
  no_load.shafts[2].load = false;
  EXPECT_THAT(arrangement_problems(no_load).front().found, HasSubstr("no load"));
  Arrangement two_motors = reducer_alone();
  two_motors.shafts[2].motor = true;
  EXPECT_THAT(only_problem(two_motors).found, HasSubstr("motors on 'input' and 'output'"));
  Arrangement braked = reducer_alone();
  braked.shafts[2].ground = true;
  EXPECT_THAT(only_problem(braked).found, HasSubstr("the ground together with the load"));
  Arrangement empty = reducer_alone();
  empty.shafts.push_back(ground({}));
  EXPECT_THAT(only_problem(empty).found, HasSubstr("no member"));
}

}  // namespace
}  // namespace orbearing::gearset::arrangement_checks_test
