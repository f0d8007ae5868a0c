// Connections, options, windows, failures of the co-simulation master on the linear pair.
#include "coupling/cosim/coupled_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/linear_halves.hpp"

namespace orbearing::cosim::coupled_run_test {
namespace {

using linear_halves::ForceHalf;
using linear_halves::LinearPair;
using linear_halves::LinearRun;
using linear_halves::MassHalf;

CoupledOptions options(double window, int extrapolation = 1) {
  return {.extrapolation = extrapolation, .window = {.longest = window}};
}

// A participant of ports alone.
class Ports : public MassHalf {
 public:
  explicit Ports(std::vector<Port> ports) : MassHalf({}), own_(std::move(ports)) {}
  const std::vector<Port>& ports() const override { return own_; }

 private:
  std::vector<Port> own_;
};

TEST(Connect, JoinsOneMotionWithAllForcesOfItsName) {
  Ports gears({{"a", PortKind::translation, Gives::motion}, {"b", PortKind::rotation, Gives::motion}});
  Ports first({{"b", PortKind::rotation, Gives::force}, {"a", PortKind::translation, Gives::force}});
  Ports second({{"a", PortKind::translation, Gives::force}});
  const std::vector<Connection> joints = connect_by_name({&first, &gears, &second});
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_EQ(joints[0].motion.participant, 1u);
  EXPECT_EQ(joints[0].motion.port, 0u);
  ASSERT_EQ(joints[0].forces.size(), 2u);
  EXPECT_EQ(joints[0].forces[0].participant, 0u);
  EXPECT_EQ(joints[0].forces[0].port, 1u);
  EXPECT_EQ(joints[0].forces[1].participant, 2u);
  EXPECT_EQ(joints[1].forces.size(), 1u);
}

TEST(Connect, RefusesWhatIsNoJoint) {
  Ports motion({{"a", PortKind::translation, Gives::motion}});
  Ports turning({{"a", PortKind::rotation, Gives::force}});
  Ports force({{"a", PortKind::translation, Gives::force}});
  Ports stray({{"b", PortKind::translation, Gives::force}});
  EXPECT_THROW(connect_by_name({&motion}), std::invalid_argument);
  EXPECT_THROW(connect_by_name({&force}), std::invalid_argument);
  EXPECT_THROW(connect_by_name({&motion, &turning}), std::invalid_argument);
  EXPECT_THROW(connect_by_name({&motion, &motion, &force}), std::invalid_argument);
  EXPECT_THROW(connect_by_name({&motion, &force, &stray}), std::invalid_argument);
}

TEST(CoupledRun, RefusesOptionsWithoutMeaning) {
  const auto refused = [](const CoupledOptions& bad) {
    EXPECT_THROW(LinearRun(LinearPair{}, bad), std::invalid_argument);
  };
  refused(options(0.0));
  refused(options(std::nan("")));
  refused(options(0.1, 3));
  refused(options(0.1, -1));
  CoupledOptions bad = options(0.1);
  bad.iteration.most_passes = 0;
  refused(bad);
  bad = options(0.1);
  bad.window.halvings = 3;  // without a residual
  refused(bad);
  bad.window.allowed_residual = 1.0;
  bad.iteration.most_passes = 5;
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
    const Participants two{&mass, &left, &right};
    CoupledRun run(two, connect_by_name(two), both);
    run.initialize(0.0);
    run.advance(40);
    one.run.advance(40);
    EXPECT_LT((mass.state() - one.mass.state()).norm(), 1e-13);
  }
}

TEST(CoupledRun, IteratesToTheSameByAllAccelerations) {
  std::vector<Eigen::VectorXd> ends;
  std::vector<long> passes;
  for (const Acceleration kind :
       {Acceleration::fixed_point, Acceleration::aitken, Acceleration::quasi_newton}) {
    CoupledOptions iterated = options(0.4);
    iterated.iteration = {.most_passes = 60, .allowed_change = 1e-12, .acceleration = kind};
    LinearRun linear({}, iterated);
    const CoupledReport report = linear.run.advance(20);
    EXPECT_TRUE(report.completed);
    EXPECT_EQ(report.not_converged, 0);
    ends.push_back(linear.mass.state());
    passes.push_back(report.passes);
  }
  EXPECT_LT((ends[1] - ends[0]).norm(), 1e-10);
  EXPECT_LT((ends[2] - ends[0]).norm(), 1e-10);
  EXPECT_LT(passes[2], passes[0]);
}

// A joint far stiffer than the window is long: the plain iteration runs away, quasi-Newton does not.
TEST(CoupledRun, QuasiNewtonConvergesWhereFixedPointDoesNot) {
  LinearPair stiff;
  stiff.joint_stiffness = 60.0;
  CoupledOptions iterated = options(0.5);
  iterated.iteration = {.most_passes = 30, .allowed_change = 1e-9, .acceleration = Acceleration::fixed_point};
  LinearRun plain(stiff, iterated);
  EXPECT_GT(plain.run.advance(10).not_converged, 0);
  iterated.iteration.acceleration = Acceleration::quasi_newton;
  LinearRun secants(stiff, iterated);
  EXPECT_EQ(secants.run.advance(10).not_converged, 0);
}

TEST(CoupledRun, WindowsFollowTheEnergyResidual) {
  CoupledOptions controlled = options(0.4, 0);
  controlled.window.halvings = 10;
  controlled.window.allowed_residual = 1e-3;
  LinearRun linear({}, controlled);
  double end = 0.0;
  const CoupledReport report = linear.run.advance(10, [&](const WindowRecord& record) {
    EXPECT_EQ(record.window.begin, end);  // no gap, to the bit
    end = record.window.end;
    const double ticks = record.window.length() / (0.4 / 1024.0);
    EXPECT_NEAR(ticks, std::exp2(std::round(std::log2(ticks))), 1e-6 * ticks);
    EXPECT_LE(std::abs(record.residual), 1e-3 * record.window.length());
  });
  EXPECT_TRUE(report.completed) << report.message;
  EXPECT_GT(report.rejected, 0);
  EXPECT_LT(report.shortest_window, 0.1);
  EXPECT_EQ(end, 4.0);
  CoupledOptions strict = controlled;
  strict.window.allowed_residual = 1e-4;
  LinearRun finer({}, strict);
  const long windows = finer.run.advance(10).windows;
  EXPECT_GT(windows, 3 * report.windows);
  const Eigen::Vector2d exact = linear_halves::exact({}, 4.0).head<2>();
  EXPECT_LT((finer.mass.state() - exact).norm(), 0.3 * (linear.mass.state() - exact).norm());
}

// One way: the mass hears nothing, the joint follows it.
TEST(CoupledRun, OneWayHandsOverMotionAlone) {
  CoupledOptions one_way = options(0.05);
  one_way.order = ExchangeOrder::one_way;
  LinearRun linear({}, one_way);
  const CoupledReport report = linear.run.advance(40);
  const double w = std::sqrt(0.4);
  EXPECT_NEAR(linear.mass.state()[0], std::cos(2.0 * w), 1e-12);
  EXPECT_GT(std::abs(linear.force.state()[0]), 0.05);
  // All that the joint takes out of the mass is missing there.
  EXPECT_GT(report.absolute_residual, 0.1);
}

// Fails in one window, once the others have moved.
class Failing : public ForceHalf {
 public:
  using ForceHalf::ForceHalf;
  void advance(const Window& window) override {
    if (window.begin > 0.99) throw std::runtime_error("the joint broke");
    ForceHalf::advance(window);
  }
};

TEST(CoupledRun, StandsAtTheLastGoodWindowWhereAParticipantFails) {
  MassHalf mass{LinearPair{}};
  Failing force{LinearPair{}};
  const Participants both{&mass, &force};
  CoupledRun run(both, connect_by_name(both), options(0.1));
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

class Unrestorable : public ForceHalf {
 public:
  using ForceHalf::ForceHalf;
  bool can_restore() const override { return false; }
  void save(SavedState&) const override { throw std::runtime_error("no"); }
  void restore(const SavedState&) override { throw std::runtime_error("no"); }
};

TEST(CoupledRun, NeedsNoRestoreForExplicitExchange) {
  MassHalf mass{LinearPair{}};
  Unrestorable force{LinearPair{}};
  const Participants both{&mass, &force};
  CoupledRun run(both, connect_by_name(both), options(0.1));
  run.initialize(0.0);
  EXPECT_TRUE(run.advance(5).completed);
  CoupledOptions iterated = options(0.1);
  iterated.iteration.most_passes = 3;
  EXPECT_THROW(CoupledRun(both, connect_by_name(both), iterated), std::invalid_argument);
}

}  // namespace
}  // namespace orbearing::cosim::coupled_run_test
