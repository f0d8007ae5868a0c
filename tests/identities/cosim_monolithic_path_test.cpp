// Gears and bearings as one system: against the equations of both put together plainly, its order, its
// energy.
#include "coupling/system/monolithic.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "bearing/motion/vector_bearing.hpp"
#include "coupling/integration/integrate_pieces.hpp"
#include "coupling/integration/rosenbrock2.hpp"
#include "coupling/integration/rosenbrock4.hpp"
#include "coupling/integration/window.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/coupled_steps.hpp"
#include "gearset/dynamics/energy.hpp"
#include "tests/unit/cosim/coupled_reducer.hpp"

namespace orbearing::cosim::cosim_monolithic_path_test {
namespace {

using bearing::motion::BearingModel;
using bearing::motion::BoreMotion;

// The coupled equations from the readable side: [ gears | bearing | bearing | ... ].
class ReadableSystem {
 public:
  explicit ReadableSystem(const system::CoupledModel& model)
      : model_(model), gears_(model.gears), bearing_(model.bearing) {}

  Eigen::Index gear_size() const { return model_.gears.layout.size(); }
  Eigen::Index bearing_size() const { return model_.bearing.layout.size(); }

  Eigen::VectorXd flat(const system::CoupledStart& start) const {
    Eigen::VectorXd x(gear_size() + model_.bearings() * bearing_size());
    x.head(gear_size()) = start.gears;
    for (int b = 0; b < model_.bearings(); ++b)
      x.segment(gear_size() + b * bearing_size(), bearing_size()) =
          start.bearings[static_cast<std::size_t>(b)];
    return x;
  }

  BoreMotion motion(int b, double time, const Eigen::Ref<const Eigen::VectorXd>& x) const {
    const Eigen::Index n = gear_size() / 2;
    return bore_motion(model_, model_.port_of(b), time, x.head(n), x.segment(n, n));
  }

  void operator()(double time, const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> dx) {
    gearset::dynamics::PortLoads loads{Eigen::Matrix2Xd::Zero(2, model_.gears.layout.planets),
                                       Eigen::VectorXd::Zero(model_.gears.layout.planets)};
    for (int b = 0; b < model_.bearings(); ++b) {
      const Eigen::Index from = gear_size() + b * bearing_size();
      const auto reaction = bearing_.derivative(motion(b, time, x), x.segment(from, bearing_size()),
                                                dx.segment(from, bearing_size()));
      loads.force.col(b / model_.per_planet) += reaction.force;
      loads.moment[b / model_.per_planet] += reaction.moment;
    }
    gears_.derivative(time, x.head(gear_size()), loads, dx.head(gear_size()));
  }

 private:
  const system::CoupledModel& model_;
  gearset::dynamics::PlanetarySetEquations gears_;
  bearing::vectorised::VectorBearing bearing_;
};

Eigen::VectorXd allowed_errors(const system::CoupledSetup& setup, const system::CoupledModel& model) {
  const ReadableSystem readable(model);
  Eigen::VectorXd allowed(readable.gear_size() + model.bearings() * readable.bearing_size());
  allowed.head(readable.gear_size()) =
      integration::gear_allowed_errors(model.gears, setup.gears.allowed_share);
  const Eigen::VectorXd bearing = system::allowed_errors(model.bearing, setup.bearing.allowed_length_error);
  for (int b = 0; b < model.bearings(); ++b)
    allowed.segment(readable.gear_size() + b * readable.bearing_size(), readable.bearing_size()) = bearing;
  return allowed;
}

// Everything but the bores, which the readable system does not carry along.
double distance(const system::CoupledModel& model, const Eigen::VectorXd& one, const Eigen::VectorXd& other,
                const Eigen::VectorXd& allowed) {
  const ReadableSystem readable(model);
  Eigen::VectorXd share = (one - other).cwiseQuotient(allowed).cwiseAbs();
  for (int b = 0; b < model.bearings(); ++b)
    share.segment<4>(readable.gear_size() + b * readable.bearing_size() + model.bearing.layout.bore())
        .setZero();
  return share.maxCoeff();
}

class MonolithicPath : public testing::Test {
 protected:
  system::CoupledSetup setup = test::coupled_reducer();
  system::CoupledModel model = system::coupled_model(setup);

  // From the same start by dopri5, tighter by `share`.
  Eigen::VectorXd reference(double length, double share) {
    ReadableSystem readable(model);
    Eigen::VectorXd x = readable.flat(system::coupled_start(setup, model, 0.0));
    integration::IntegrationOptions options;
    options.allowed_error = share * allowed_errors(setup, model);
    options.step = 1e-8;
    const auto report =
        integration::integrate_pieces([&](double t, const Eigen::Ref<const Eigen::VectorXd>& s,
                                          Eigen::Ref<Eigen::VectorXd> r) { readable(t, s, r); },
                                      x, {0.0, length, 1}, integration::jumps_of(model.gears), options, {});
    EXPECT_TRUE(report.completed) << report.message;
    return x;
  }

  // By linearly implicit steps of length `h` at most.
  template <class Stepper, class System>
  Eigen::VectorXd fixed_steps(double length, double h) {
    System system(model);
    const system::CoupledStart start = system::coupled_start(setup, model, 0.0);
    std::vector<double> x(system.size(), 0.0);
    std::copy(start.gears.begin(), start.gears.end(), x.begin());
    for (int b = 0; b < system.bearings(); ++b) {
      const auto padded = system.bearing(b).padded(start.bearings[static_cast<std::size_t>(b)]);
      std::copy(padded.begin(), padded.end(), system.of_bearing(x.data(), b));
    }
    Stepper stepper(std::vector<double>(x.size(), 0.0), h);
    const auto jumps = integration::jumps_of(model.gears);
    double step = h;
    for (double begin = 0.0; begin < length;) {
      long jump = 0;
      while (jumps.time(jump) <= begin + 1e-15) ++jump;
      const double end = std::min(length, jumps.time(jump));
      system.set_piece(begin, begin + jumps.margin, end - jumps.margin);
      integration::through_window(stepper, system, x, end - begin, {}, step);
      begin = end;
    }
    system::CoupledStart out{Eigen::Map<const Eigen::VectorXd>(x.data(), model.gears.layout.size()), {}};
    for (int b = 0; b < system.bearings(); ++b) {
      Eigen::VectorXd flat(model.bearing.layout.size());
      system.bearing(b).flatten(system.of_bearing(x.data(), b), flat);
      out.bearings.push_back(flat);
    }
    return ReadableSystem(model).flat(out);
  }
};

TEST_F(MonolithicPath, ConvergesToTheReadableEquationsWithOrderTwo) {
  constexpr double kLength = 30e-6;  // [s]
  const Eigen::VectorXd exact = reference(kLength, 1e-7), allowed = allowed_errors(setup, model);
  std::vector<double> errors;
  for (const double h : {0.4e-6, 0.2e-6, 0.1e-6, 0.05e-6})
    errors.push_back(distance(model, fixed_steps<integration::Rosenbrock2, system::CoupledSystem>(kLength, h),
                              exact, allowed));
  for (std::size_t i = 1; i < errors.size(); ++i) {
    const double order = std::log2(errors[i - 1] / errors[i]);
    RecordProperty("order_" + std::to_string(i), std::to_string(order));
    EXPECT_GT(order, 1.8);
    EXPECT_LT(order, 2.3);
  }
}

// Steps of order 4 with oil in the pockets: a twelfth to two thirds of the error of ROS2. The error of the
// reference is 0.02.
TEST_F(MonolithicPath, ConvergesInStepsOfOrderFourWithOil) {
  constexpr double kLength = 30e-6;  // [s]
  setup = test::oiled_reducer();
  model = system::coupled_model(setup);
  const Eigen::VectorXd exact = reference(kLength, 1e-7), allowed = allowed_errors(setup, model);
  std::vector<double> errors;
  for (const double h : {3.2e-6, 1.6e-6, 0.8e-6, 0.4e-6}) {
    errors.push_back(distance(model, fixed_steps<integration::Rosenbrock4, system::WithAllSlopes>(kLength, h),
                              exact, allowed));
    const double other = distance(
        model, fixed_steps<integration::Rosenbrock2, system::CoupledSystem>(kLength, h), exact, allowed);
    RecordProperty("over_order_two_" + std::to_string(h * 1e6) + "_us",
                   std::to_string(errors.back() / other));
    EXPECT_LT(errors.back(), 0.8 * other) << h;
  }
  EXPECT_GT(std::log2(errors[1] / errors[3]) / 2.0, 2.8);
}

// Whether none, the worst two or all bearings may be substepped.
TEST_F(MonolithicPath, FollowsTheReadableEquations) {
  constexpr double kLength = 0.2e-3;  // [s]
  const Eigen::VectorXd exact = reference(kLength, 1e-5);
  const Eigen::Index n = model.gears.layout.freedoms();
  const ReadableSystem readable(model);
  // Hundreds of steps together stay below what one of them may err, with bearings substepped or without.
  const double one_step = system::kLinearlyImplicitErrorFactor * setup.bearing.allowed_length_error;  // [m]
  for (const int substepped : {0, 2, 8}) {
    std::vector<double> planets, all;  // [m], [-] of what dopri5 is allowed
    for (const double tighter : {1.0, 1e-2, 1e-4}) {
      system::CoupledSetup finer = setup;
      finer.bearing.allowed_length_error *= tighter;
      finer.gears.allowed_share *= tighter;
      finer.most_substepped = substepped;
      system::Monolithic system(finer);
      system.initialize(0.0);
      system.advance({0.0, kLength});
      EXPECT_EQ(system.substepped() > 0, substepped > 0);
      double worst = 0.0;
      for (const system::PlanetPort& port : model.ports)
        worst = std::max(worst, port.along(system.state().gears.head(n) - exact.head(n)).norm());
      planets.push_back(worst);
      all.push_back(distance(model, readable.flat(system.state()), exact, allowed_errors(setup, model)));
      const std::string at = std::to_string(substepped) + "_at_" + std::to_string(tighter);
      RecordProperty("planets_" + at, std::to_string(planets.back() * 1e9) + " nm");
      RecordProperty("all_" + at, std::to_string(all.back()));
    }
    EXPECT_LT(planets[0], 100e-9);  // found 14e-9 to 25e-9
    EXPECT_LT(planets[1], 0.1 * planets[0]);
    EXPECT_LT(planets[2], 0.1 * planets[1]);
    EXPECT_LT(all[2], 0.1 * all[1]);
    EXPECT_LT(planets[0], 0.5 * one_step);
    EXPECT_LT(planets[1], 0.5e-2 * one_step);
    EXPECT_LT(planets[2], 0.5e-4 * one_step);
  }
}

// Meshes of constant stiffness, so that no energy jumps. The work of the moments of the bearings at the
// nominal rotations comes from outside, since the motion of the gears is relative to these.
TEST_F(MonolithicPath, KeepsItsEnergy) {
  for (gearset::dynamics::Mesh* mesh : {&setup.gears.set.sun_mesh, &setup.gears.set.ring_mesh})
    mesh->stiffness = gearset::PeriodicCurve::constant(4e8);
  setup.bearing.allowed_length_error = 1e-14;
  setup.gears.allowed_share = 1e-8;
  setup.gears.operation.load_yields = false;
  system::Monolithic system(setup);
  system.initialize(0.0);
  system::CoupledModel here = system::coupled_model(setup);
  BearingModel massless = here.bearing;
  massless.bore_mass = 0.0;  // it belongs to the gears
  bearing::vectorised::VectorBearing alone(massless);
  ReadableSystem readable(here);
  const Eigen::Index n = here.gears.layout.freedoms();

  struct Balance {
    double energy, power, turnover;
  };
  const auto balance = [&](double time) {
    const system::CoupledStart now = system.state();
    const Eigen::VectorXd x = readable.flat(now);
    Eigen::VectorXd rate(x.size());
    readable(time, x, rate);
    const auto gears = power_flow(here.gears, time, now.gears);
    Balance sum{energy(here.gears, time, now.gears).total(), gears.input() - gears.loss(),
                std::abs(gears.input()) + gears.loss()};
    for (int b = 0; b < here.bearings(); ++b) {
      const BoreMotion motion = readable.motion(b, time, x);
      const Eigen::VectorXd& state = now.bearings[static_cast<std::size_t>(b)];
      Eigen::VectorXd dx(state.size());
      BoreMotion moving = motion;
      moving.acceleration = here.port_of(b).along(rate.segment(n, n));
      const auto reaction = alone.derivative(moving, state, dx);
      const auto input = driven_power_input(massless, motion, state, dx);
      const double nominal = motion.speed - here.port_of(b).turn(now.gears.tail(n));
      const double loss = driven_snapshot(massless, motion, state).loss.total();
      const double power = input.changing_film + input.euler - reaction.moment * nominal - loss;
      sum.energy += driven_energy(massless, motion, state).total();
      sum.power += power;
      sum.turnover += std::abs(power) + loss;
    }
    return sum;
  };
  constexpr double kStep = 0.25e-6;  // [s]
  Balance before = balance(0.0);
  const double start = before.energy;
  double work = 0.0, turnover = 0.0, swing = 0.0;
  for (int k = 0; k < 400; ++k) {
    system.advance({k * kStep, (k + 1) * kStep});
    const Balance now = balance((k + 1) * kStep);
    work += 0.5 * kStep * (before.power + now.power);
    turnover += 0.5 * kStep * (before.turnover + now.turnover);
    swing = std::max(swing, std::abs(now.energy - start));
    before = now;
  }
  RecordProperty("missing_share", std::to_string((before.energy - start - work) / (turnover + swing)));
  EXPECT_NEAR(before.energy - start, work, 1e-4 * (turnover + swing));  // found 4e-6
}

}  // namespace
}  // namespace orbearing::cosim::cosim_monolithic_path_test
