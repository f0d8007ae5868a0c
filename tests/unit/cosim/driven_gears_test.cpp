// The gear set as a machine: windows, restarts, ports, and its agreement with the set on springs.
#include "coupling/system/driven_gears.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "coupling/integration/integrate_pieces.hpp"
#include "gearset/dynamics/energy.hpp"
#include "gearset/dynamics/equations.hpp"
#include "gearset/dynamics/static_state.hpp"
#include "tests/gear_sets.hpp"
#include "tests/messages.hpp"

namespace orbearing::system::driven_gears_test {
namespace {

using gearset::dynamics::BearingPorts;
using gearset::dynamics::SetModel;
using gearset::dynamics::SetParameters;

constexpr double kPeriod = 1.0 / 2519.0;  // [s]  of the mesh, about

DrivenGearsSetup setup(double share = 1e-8) {
  DrivenGearsSetup out{.set = gearset::dynamics::test::reducer_dynamics(),
                       .operation = gearset::dynamics::test::reducer_operation(628.0),
                       .allowed_share = share};
  out.set.planet.coupled_bearing = true;
  return out;
}

// x, y, moment of each planet.
std::vector<InputPolynomial> spring_forces(const DrivenGears& gears, const SetParameters& set,
                                           double moment = 0.0) {
  std::vector<InputPolynomial> forces;
  for (const PlanetMotion& planet : gears.output().planets) {
    const Eigen::Vector2d force = -set.planet.bearing_stiffness * planet.displacement;
    for (const double value : {force.x(), force.y(), moment})
      forces.push_back(InputPolynomial::constant(value));
  }
  return forces;
}

double farthest(const DrivenGearsOutput& a, const DrivenGearsOutput& b) {
  double out = 0.0;  // [m]
  for (std::size_t i = 0; i < a.planets.size(); ++i)
    out = std::max(out, (a.planets[i].displacement - b.planets[i].displacement).norm());
  return out;
}

TEST(DrivenGears, SaveAdvanceRestoreAdvanceGivesTheSameBits) {
  DrivenGears gears(setup(1e-5)), other(setup(1e-5));
  gears.initialize(0.0);
  const auto forces = spring_forces(gears, setup().set, 3.0);
  gears.advance({0.0, 0.37 * kPeriod}, forces);
  SavedState saved, first, second, third;
  gears.save(saved);
  const Window window{0.37 * kPeriod, 1.61 * kPeriod};
  gears.advance(window, forces);
  gears.save(first);
  gears.restore(saved);
  gears.advance(window, forces);
  gears.save(second);
  other.restore(saved);  // never initialised
  other.advance(window, forces);
  other.save(third);
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, third);
  EXPECT_NE(first, saved);
}

// The end does not depend on where windows end, but for the error of the steps.
TEST(DrivenGears, AreAsGoodInShortWindows) {
  DrivenGears whole(setup()), parts(setup());
  whole.initialize(0.0);
  parts.initialize(0.0);
  const auto forces = spring_forces(whole, setup().set, 3.0);
  const double step = 0.043 * kPeriod;
  whole.advance({0.0, 50.0 * step}, forces);
  for (int k = 0; k < 50; ++k) parts.advance({k * step, (k + 1) * step}, forces);
  const double deflection = 1e-5;  // [m]  of a mesh under its mean load
  EXPECT_LT(farthest(whole.output(), parts.output()), 50.0 * 1e-7 * deflection);
}

// Forces of the springs themselves, which change within the window along their tangent, converge to the set
// on springs with the square of the window.
TEST(DrivenGears, FollowTheSetOnSpringsAtTheOrderOfTheInputs) {
  DrivenGearsSetup smooth = setup(1e-9);
  smooth.set.sun_mesh.stiffness = gearset::PeriodicCurve::constant(4e8);
  smooth.set.ring_mesh.stiffness = gearset::PeriodicCurve::constant(5e8);
  smooth.set.planet.bearing_damping = 0.0;
  smooth.set.pin_error.resize(2, 4);
  smooth.set.pin_error << 1e-6, -2e-6, 0.0, 1e-6, 2e-6, 0.0, 1e-6, -1e-6;
  SetParameters sprung = smooth.set;
  sprung.planet.coupled_bearing = false;
  const SetModel model = gearset::dynamics::set_model(sprung, smooth.operation);
  const gearset::dynamics::PlanetarySetEquations equations(model);
  Eigen::VectorXd x = gearset::dynamics::static_state(model);
  x[2] += 1e-6;  // the sun is let go twisted
  SavedState start{20001.0, 0.0, 1e-7};
  start.insert(start.end(), x.begin(), x.end());
  integration::IntegrationOptions options;
  options.allowed_error = integration::gear_allowed_errors(model, 1e-9);
  const double end = 1e-4;  // [s]
  integrate_pieces([&](double time, const Eigen::Ref<const Eigen::VectorXd>& at,
                       Eigen::Ref<Eigen::VectorXd> dx) { equations.derivative(time, at, dx); },
                   x, {0.0, end, 1}, {}, options, {});
  BearingPorts exact;
  equations.motion_at_ports(x, exact);
  const auto error = [&](int windows) {
    DrivenGears gears(smooth);
    gears.restore(start);
    for (int k = 0; k < windows; ++k) {
      auto forces = spring_forces(gears, smooth.set);
      const auto planets = gears.output().planets;
      for (std::size_t i = 0; i < planets.size(); ++i) {
        const Eigen::Vector2d slope = -smooth.set.planet.bearing_stiffness * planets[i].velocity;
        forces[3 * i].coefficient[1] = slope.x();
        forces[3 * i + 1].coefficient[1] = slope.y();
      }
      gears.advance({k * end / windows, (k + 1) * end / windows}, forces);
    }
    double worst = 0.0;
    for (Eigen::Index i = 0; i < 4; ++i)
      worst = std::max(worst, (gears.output().planets[static_cast<std::size_t>(i)].displacement -
                               exact.displacement.col(i))
                                  .norm());
    return worst;
  };
  const double coarse = error(50), fine = error(100);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.15);  // the next order at h w of about a fifth
}

// With bearings half as stiff again as stated, each round leaves minus a half of the error.
TEST(DrivenGears, BalanceWithBearingsThatAreNotTheStatedSprings) {
  DrivenGears gears(setup());
  gears.initialize(0.0);
  const Eigen::Vector2d before = gears.output().planets[0].displacement;
  const Eigen::Vector2d gap(2e-6, -5e-6);  // [m]
  for (int round = 0; round < 40; ++round) {
    std::vector<double> forces;
    for (const PlanetMotion& planet : gears.output().planets) {
      const Eigen::Vector2d force = -1.5 * setup().set.planet.bearing_stiffness * (planet.displacement - gap);
      forces.insert(forces.end(), {force.x(), force.y(), 0.0});
    }
    gears.balance(0.0, forces);
  }
  const Eigen::Vector2d after = gears.output().planets[0].displacement;
  // The shift by the gap itself changes the centrifugal load a little.
  const double speed = 628.0 * 37.0 / 116.0;  // [rad/s]
  const double yields = setup().set.planet.mass * speed * speed / setup().set.planet.bearing_stiffness;
  EXPECT_LT((after - gap - before / 1.5).norm(), yields * gap.norm());
}

TEST(DrivenGears, RefuseWhatMakesNoSense) {
  DrivenGearsSetup loose = setup();
  loose.set.planet.bearing_stiffness = 0.0;
  EXPECT_REFUSED(std::invalid_argument, "driven_gears 1", DrivenGears{loose});
  DrivenGears gears(setup());
  gears.initialize(0.0);
  EXPECT_REFUSED(std::invalid_argument, "driven_gears 2", gears.advance({0.0, 1e-6}, {}));
  EXPECT_REFUSED(std::invalid_argument, "driven_gears 3",
                 gears.advance({1e-6, 1e-6}, spring_forces(gears, setup().set)));
  SavedState saved;
  gears.save(saved);
  saved.pop_back();
  EXPECT_REFUSED(std::invalid_argument, "driven_gears 4", gears.restore(saved));
}

TEST(DrivenGears, KeepTheirStateWhereAWindowFails) {
  DrivenGears gears(setup());
  gears.initialize(0.0);
  SavedState before, after;
  gears.save(before);
  auto forces = spring_forces(gears, setup().set);
  forces[6] = InputPolynomial::constant(std::nan(""));
  EXPECT_REFUSED(std::runtime_error, "driven_gears 5", gears.advance({0.0, 1e-5}, forces));
  gears.save(after);
  EXPECT_EQ(before, after);
}

// Speeds of the planet: nominal, and what its own and the carrier's rotation add.
TEST(DrivenGears, TellThePlanetsSpeed) {
  DrivenGears gears(setup());
  gears.initialize(0.0);
  const double carrier = 628.0 * 37.0 / 116.0;
  EXPECT_NEAR(gears.output().carrier_speed, carrier, 1e-9 * carrier);
  EXPECT_NEAR(gears.output().planets[1].speed, -carrier * 79.0 / 22.0, 1e-9 * carrier);
  SavedState state;
  gears.save(state);
  const std::size_t head = 3, freedoms = 21;
  state[head + freedoms + 8] += 0.3;           // [m/s]  carrier u
  state[head + freedoms + 9 + 3 + 2] += -0.2;  // [m/s]  planet 2 u
  gears.restore(state);
  const SetParameters set = setup().set;
  EXPECT_NEAR(gears.output().planets[1].speed,
              -carrier * 79.0 / 22.0 - 0.3 / set.carrier.radius - 0.2 / set.planet.radius, 1e-9 * carrier);
}

}  // namespace
}  // namespace orbearing::system::driven_gears_test
