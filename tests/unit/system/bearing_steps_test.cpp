#include "coupling/system/bearing_steps.hpp"

#include <gtest/gtest.h>

#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::system::bearing_steps_test {
namespace {

using bearing::motion::BearingModel;

class OutOfPlace : public testing::Test {
 protected:
  const bearing::Bearing bearing = test::reducer_bearing();
  const BearingModel model = bearing_model(bearing, test::reducer_point(6000.0), test::reducer_parameters());
  Eigen::VectorXd x = initial_state(bearing, model, test::reducer_parameters(), 0.3).x;
  bearing::motion::MutableStateViews now = bearing::motion::mutable_state_views(model.layout, x.data());
  const double limit = 2.62e-3;  // [m]  half of a roller
};

TEST_F(OutOfPlace, IsSilentInsideTheBearing) {
  EXPECT_EQ(out_of_place(model, x), "");
  now.cage_position.x() += 0.9 * limit;
  now.radius[3] += 0.9 * limit;
  EXPECT_EQ(out_of_place(model, x), "");
}

TEST_F(OutOfPlace, NamesACageThatCameOut) {
  now.cage_position.y() -= 1.1 * limit;
  EXPECT_EQ(out_of_place(model, x).rfind("the cage left the bearing", 0), 0u) << out_of_place(model, x);
}

TEST_F(OutOfPlace, NamesARollerThatCameOut) {
  now.radius[7] -= 1.1 * limit;
  EXPECT_EQ(out_of_place(model, x).rfind("a roller left the bearing", 0), 0u) << out_of_place(model, x);
}

TEST_F(OutOfPlace, LetsPinAndBoreMoveTogether) {
  now.pin_position.x() += 5.0 * limit;
  now.bore_position.x() += 5.0 * limit;
  now.cage_position.x() += 5.0 * limit;
  now.radius[0] += 5.0 * limit;
  EXPECT_EQ(out_of_place(model, x), "");
}

// Rollers are between both: they may follow the one that is further off.
TEST_F(OutOfPlace, LetsPinOrBoreMoveAlone) {
  now.pin_position.x() += 5.0 * limit;
  now.cage_position.x() += 5.0 * limit;
  now.radius[0] += 5.0 * limit;
  EXPECT_EQ(out_of_place(model, x), "");
  now.pin_position.setZero();
  now.cage_position.setZero();
  now.bore_position.y() += 5.0 * limit;
  EXPECT_EQ(out_of_place(model, x), "");
}

TEST(AllowedErrors, FollowTheKindOfEachVariable) {
  const bearing::motion::StateLayout layout{2};
  const Eigen::VectorXd allowed = allowed_errors(layout, 1e-9, 0.02, 1e5);
  EXPECT_DOUBLE_EQ(allowed[0], 1e-9);               // radius
  EXPECT_DOUBLE_EQ(allowed[2], 1e-9 / 0.02);        // angle
  EXPECT_DOUBLE_EQ(allowed[4], 1e-9 * 1e5);         // radial speed
  EXPECT_DOUBLE_EQ(allowed[8], 1e-9 / 0.02 * 1e5);  // spin
}

// Loads depend most on the bore, next on radial motion, least on motion along the pitch circle.
TEST(ThirdOrderSteps, WeighWhatLoadsHangOnWhereOilIsInThePockets) {
  bearing::motion::DynamicsParameters parameters = test::reducer_parameters();
  parameters.race.squeeze = true;
  const auto shares = [&](int variable) {
    const BearingModel model =
        bearing_model(test::reducer_bearing(), test::reducer_point(6000.0), parameters);
    const bearing::vectorised::VectorBearing vectorised(model);
    const Eigen::VectorXd allowed = allowed_errors(model, 1e-10);
    const auto position = static_cast<std::size_t>(variable);
    return third_order_steps(vectorised, allowed).allowed[position] /
           linearly_implicit_errors(vectorised, allowed)[position];
  };
  const bearing::vectorised::PaddedLayout layout{15};
  const int lanes = layout.lanes();
  EXPECT_DOUBLE_EQ(shares(0), 0.5) << "blows on dry bars: all alike";
  EXPECT_DOUBLE_EQ(shares(lanes), 0.5);
  parameters.cage.pocket_film = bearing::motion::PocketFilm::hydrodynamic;
  const double radial = shares(0);
  EXPECT_DOUBLE_EQ(shares(2 * lanes), radial) << "radial speed";
  EXPECT_LT(shares(layout.bore()), radial);
  for (const int along : {lanes, 3 * lanes, 4 * lanes, layout.cage(), layout.cage() + 5})
    EXPECT_GT(shares(along), radial) << along;
}

TEST(ThirdOrderSteps, AreBoundByTheRingWhereOilIsInThePockets) {
  bearing::motion::DynamicsParameters parameters = test::reducer_parameters();
  parameters.race.squeeze = true;
  parameters.cage.pocket_film = bearing::motion::PocketFilm::hydrodynamic;
  const auto longest = [&](double pocket_stiffness) {
    parameters.cage.pocket_stiffness = pocket_stiffness;
    const BearingModel model =
        bearing_model(test::reducer_bearing(), test::reducer_point(6000.0), parameters);
    return third_order_steps(bearing::vectorised::VectorBearing(model), allowed_errors(model, 1e-10)).longest;
  };
  EXPECT_DOUBLE_EQ(longest(3e7), longest(3e8)) << "whatever the bars";
  parameters.cage.pocket_film = bearing::motion::PocketFilm::none;
  EXPECT_GT(longest(3e7), longest(3e8));
}

// All variables equally, and no weight for those that bounce.
TEST(FourthOrderSteps, WeighAllVariablesAlike) {
  bearing::motion::DynamicsParameters parameters = test::reducer_parameters();
  parameters.race.squeeze = true;
  parameters.cage.pocket_film = bearing::motion::PocketFilm::hydrodynamic;
  const BearingModel model = bearing_model(test::reducer_bearing(), test::reducer_point(6000.0), parameters);
  const bearing::vectorised::VectorBearing vectorised(model);
  const Eigen::VectorXd allowed = allowed_errors(model, 1e-10);
  const StepBounds bounds = fourth_order_steps(vectorised, allowed);
  const std::vector<double> of_order_two = linearly_implicit_errors(vectorised, allowed);
  for (std::size_t i = 0; i < bounds.allowed.size(); ++i)
    EXPECT_NEAR(bounds.allowed[i], 3.0 * of_order_two[i], 1e-12 * of_order_two[i]) << i;
  EXPECT_DOUBLE_EQ(bounds.longest, third_order_steps(vectorised, allowed).longest) << "that of the ring";
}

}  // namespace
}  // namespace orbearing::system::bearing_steps_test
