// Connections, options, windows, failures of the co-simulation master on the linear pair.
#include "coupling/cosim/coupled_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/messages.hpp"
#include "tests/linear_halves.hpp"

namespace orbearing::cosim::coupled_run_test {
namespace {

using linear_halves::ForceHalf;
using linear_halves::LinearPair;
using linear_halves::LinearRun;
using linear_halves::MassHalf;

CoupledOptions options(double window, int extrapolation = 1) {
  return {.extrapolation = extrapolation, .window = window};
}

Side side(std::vector<Port> ports) {
  for (Port& port : ports) port.displacement = port.velocity = port.force = 0;
  return {nullptr, std::move(ports)};
}

TEST(Connect, JoinsOneMotionWithAllForcesOfItsName) {
  const Side gears =
      side({{"a", PortKind::translation, PortOutput::motion}, {"b", PortKind::rotation, PortOutput::motion}});
  const Side first =
      side({{"b", PortKind::rotation, PortOutput::force}, {"a", PortKind::translation, PortOutput::force}});
  const Side second = side({{"a", PortKind::translation, PortOutput::force}});
  const std::vector<Connection> joints = connect_by_name({first, gears, second});
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_EQ(joints[0].motion.side, 1u);
  EXPECT_EQ(joints[0].motion.port, 0u);
  ASSERT_EQ(joints[0].forces.size(), 2u);
  EXPECT_EQ(joints[0].forces[0].side, 0u);
  EXPECT_EQ(joints[0].forces[0].port, 1u);
  EXPECT_EQ(joints[0].forces[1].side, 2u);
  EXPECT_EQ(joints[1].forces.size(), 1u);
}

TEST(Connect, RefusesWhatIsNoJoint) {
  const Side motion = side({{"a", PortKind::translation, PortOutput::motion}});
  const Side rotating = side({{"a", PortKind::rotation, PortOutput::force}});
  const Side force = side({{"a", PortKind::translation, PortOutput::force}});
  const Side stray = side({{"b", PortKind::translation, PortOutput::force}});
  EXPECT_NO_THROW(connect_by_name({motion, force}));
  EXPECT_REFUSED(std::invalid_argument, "coupled_run 1", connect_by_name({motion}));
  EXPECT_REFUSED(std::invalid_argument, "coupled_run 2", connect_by_name({force}));
  EXPECT_REFUSED(std::invalid_argument, "coupled_run 3", connect_by_name({motion, rotating}));
  EXPECT_REFUSED(std::invalid_argument, "coupled_run 4", connect_by_name({motion, motion, force}));
  EXPECT_REFUSED(std::invalid_argument, "coupled_run 5", connect_by_name({motion, force, stray}));
  Side without = force;
  without.ports[0].velocity = kNone;
  EXPECT_REFUSED(std::invalid_argument, "coupled_run 6", connect_by_name({motion, without}));
}

TEST(CoupledRun, RefusesOptionsWithoutMeaning) {
  const auto refused = [](const CoupledOptions& bad) {
    EXPECT_REFUSED(std::invalid_argument, "coupled_run 7", LinearRun(LinearPair{}, bad));
  };
  refused(options(0.0));
  refused(options(std::nan("")));
  refused(options(0.1, 3));
  refused(options(0.1, -1));
  CoupledOptions bad = options(0.1);
  bad.iteration.most_passes = 0;
  refused(bad);
}

TEST(CoupledRun, GoesOnWhereItStoodToTheBit) {
  LinearRun whole({}, options(0.05)), parts({}, options(0.05));
  EXPECT_EQ(whole.run.advance(40).windows, 40);
  for (int k = 0; k < 8; ++k) EXPECT_TRUE(parts.run.advance(5).completed);
  EXPECT_EQ(whole.mass.state(), parts.mass.state());
  EXPECT_EQ(whole.run.values().time, 40 * 0.05);
}

// Two givers of half the force are one of the whole, in any order of participants.
TEST(CoupledRun, AddsUpForces) {
  LinearPair pair, half;
  half.joint_stiffness = 0.5 * pair.joint_stiffness;
  half.joint_damping = 0.5 * pair.joint_damping;
  half.behind = 0.5 * pair.behind;
  half.behind_stiffness = 0.5 * pair.behind_stiffness;
  for (const ExchangeOrder order : {ExchangeOrder::jacobi, ExchangeOrder::gauss_seidel}) {
    CoupledOptions both = options(0.05);
    both.order = order;
    LinearRun one(pair, both);
    MassHalf mass(pair);
    ForceHalf left(half), right(half);
    CoupledRun run({mass.side(), left.side(), right.side()}, both);
    run.initialize(0.0);
    run.advance(40);
    one.run.advance(40);
    EXPECT_LT((mass.state() - one.mass.state()).norm(), 1e-13);
  }
}

// A joint far stiffer than the window is long: an iteration that took the answers themselves would diverge.
TEST(CoupledRun, IteratesStiffJoints) {
  LinearPair stiff;
  stiff.joint_stiffness = 60.0;
  CoupledOptions iterated = options(0.5);
  iterated.iteration = {.most_passes = 30, .allowed_change = 1e-9};
  LinearRun secants(stiff, iterated);
  EXPECT_EQ(secants.run.advance(10).not_converged, 0);
}

// Fails in one window, once the others have moved.
class Failing : public ForceHalf {
 public:
  using ForceHalf::ForceHalf;
  void advance(const Window& window, const std::vector<InputPolynomial>& motion) override {
    if (window.begin > 0.99) throw std::runtime_error("the joint broke");
    ForceHalf::advance(window, motion);
  }
};

TEST(CoupledRun, StandsAtTheLastGoodWindowWhereAParticipantFails) {
  MassHalf mass{LinearPair{}};
  Failing force{LinearPair{}};
  CoupledRun run({mass.side(), force.side()}, options(0.1));
  run.initialize(0.0);
  const CoupledReport report = run.advance(20);
  EXPECT_FALSE(report.completed);
  EXPECT_EQ(report.windows, 10);
  EXPECT_NE(report.message.find("the joint broke"), std::string::npos);
  EXPECT_NE(report.message.find("t = 1 s"), std::string::npos);
  LinearRun good({}, options(0.1));
  good.run.advance(10);
  EXPECT_EQ(mass.state(), good.mass.state());
}

}  // namespace
}  // namespace orbearing::cosim::coupled_run_test
