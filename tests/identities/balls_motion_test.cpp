// Properties of every ball bearing in motion: power balance, slopes, equal results of all instruction sets,
// order of the steps, the static bearing as the limit of slow rotation.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "bearing/equilibrium/row_group.hpp"
#include "bearing/geometry.hpp"
#include "bearing/life/standard_life.hpp"
#include "coupling/integration/rosenbrock2.hpp"
#include "coupling/system/ball_run.hpp"
#include "coupling/system/balls_in_time.hpp"
#include "mechanics/linear_algebra.hpp"
#include "tests/random_balls.hpp"

namespace orbearing::bearing::balls::balls_motion_test {
namespace {

struct Started {
  DrawnBalls drawn;
  BallNumbers numbers;
  std::vector<double> x;
};

Started started(RandomBalls& random, double size) {
  Started s{random.next(), {}, {}};
  s.numbers = ball_numbers(s.drawn.bearing, s.drawn.parameters);
  const BallBearing model(s.numbers, s.drawn.duty);
  s.x = start_state(s.drawn.bearing, model, random.between(0.0, 6.0));
  random.disturb(s.numbers, size, s.x);
  return s;
}

// d(energy)/dt along the motion; rings turn on.
double growth_of_energy(BallBearing& model, const std::vector<double>& x) {
  std::vector<double> rate(x.size());
  model.derivative(0.0, x.data(), rate.data());
  const auto energy = [&](double time) {
    std::vector<double> then = x;
    for (std::size_t i = 0; i < x.size(); ++i) then[i] += time * rate[i];
    return model.energy(then.data(), time).total();
  };
  constexpr double h = 2e-9;  // [s]
  return (8.0 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12.0 * h);
}

// It is what comes in less what is lost: every force is the gradient of its energy, or does the work that is
// called a loss.
TEST(BallMotion, PowerBalances) {
  RandomBalls random;
  for (int draw = 0; draw < 300; ++draw) {
    SCOPED_TRACE(draw);
    const Started s = started(random, draw % 3 == 0 ? 0.2 : 1.5);
    BallBearing model(s.numbers, s.drawn.duty);
    const double growth = growth_of_energy(model, s.x);
    const BallSnapshot now = model.snapshot(0.0, s.x.data());
    const double balance = model.power_input(0.0, s.x.data()) - now.loss.total();
    const double scale =
        now.loss.total() + std::abs(model.power_input(0.0, s.x.data())) + std::abs(growth) + 1.0;
    EXPECT_NEAR(growth, balance, 3e-5 * scale);
    EXPECT_GE(now.loss.rolling, 0.0);
    EXPECT_GE(now.loss.damping, 0.0);
    EXPECT_GE(now.loss.cage, -1e-9);
    EXPECT_GE(now.loss.churning, 0.0);
    EXPECT_GE(now.loss.sliding + now.loss.differential + now.loss.spin, 0.0);
  }
}

// A scratch of each race under every ball, somewhere between its edges.
void scratch_under_balls(RandomBalls& random, const Started& s, GrooveNumbers& groove, double radius) {
  const int lanes = StateLayout{s.numbers.balls}.lanes();
  ScratchNumbers& scratch = groove.scratch;
  scratch.law.form = static_cast<ScratchForm>(static_cast<int>(random.between(0.0, 3.0)));
  scratch.law.width = random.between(0.02, 0.2) * s.numbers.radius;
  scratch.law.deepest = random.between(0.01, 0.1) * scratch.law.width;
  scratch.law.bottom = random.between(0.5, 3.0) * scratch.law.deepest;
  scratch.track_radius = radius;
  scratch.count = std::min(s.numbers.balls, ScratchNumbers::kMost);
  for (int j = 0; j < scratch.count; ++j)
    scratch.angle[j] =
        s.x[static_cast<std::size_t>(lanes + j)] + random.between(-0.45, 0.45) * scratch.law.width / radius;
}

// Scratches are turned about the bearing's axis: by a tilt times its rate they would lag.
void straighten(const StateLayout& layout, std::vector<double>& x) {
  for (const int ring : {layout.inner(), layout.outer()})
    for (const int i : {3, 4})
      x[static_cast<std::size_t>(ring + i)] = x[static_cast<std::size_t>(ring + kRingUnknowns + i)] = 0.0;
}

// Forces on a scratch are those of its energy, and a ring that moves a scratch along supplies its work by
// torque.
TEST(BallMotion, PowerBalancesOnScratches) {
  RandomBalls random(11);
  double felt = 0.0;
  for (int draw = 0; draw < 200; ++draw) {
    SCOPED_TRACE(draw);
    Started s = started(random, 1.5);
    straighten(StateLayout{s.numbers.balls}, s.x);
    BallBearing sound(s.numbers, s.drawn.duty);
    const double before = sound.snapshot(0.0, s.x.data()).inner_torque;
    scratch_under_balls(random, s, s.numbers.inner, s.numbers.pitch_radius - s.numbers.radius);
    scratch_under_balls(random, s, s.numbers.outer, s.numbers.pitch_radius + s.numbers.radius);
    BallBearing model(s.numbers, s.drawn.duty);
    const double growth = growth_of_energy(model, s.x);
    const BallSnapshot now = model.snapshot(0.0, s.x.data());
    const double input = model.power_input(0.0, s.x.data()), balance = input - now.loss.total();
    EXPECT_NEAR(growth, balance, 3e-5 * (now.loss.total() + std::abs(input) + std::abs(growth) + 1.0));
    felt = std::max(felt, std::abs(now.inner_torque - before) / (1.0 + std::abs(before)));
  }
  EXPECT_GT(felt, 1.0);
}

// A scratch on each of some balls, turned to about where the ball touches a race.
void scratch_balls(RandomBalls& random, Started& s) {
  SpotNumbers& spots = s.numbers.spots;
  const BallBearing sound(s.numbers, s.drawn.duty);
  const BallSnapshot now = sound.snapshot(0.0, s.x.data());
  const double width = random.between(0.05, 0.3) * s.numbers.radius;
  for (ScratchLaw* law : {&spots.on_inner, &spots.on_outer}) {
    law->form = random.between(0.0, 1.0) < 0.5 ? ScratchForm::raised_cosine : ScratchForm::edges;
    law->width = width;
    law->deepest = random.between(0.001, 0.05) * width;
    law->bottom = random.between(0.5, 3.0) * law->deepest;
  }
  spots.count = std::min(s.numbers.balls, SpotNumbers::kMost);
  const StateLayout layout{s.numbers.balls, spots.count};
  s.x.resize(static_cast<std::size_t>(layout.size()), 0.0);
  for (int i = 0; i < spots.count; ++i) {
    spots.ball[i] = i;
    const auto position = static_cast<std::size_t>(i);
    const bool outer = random.between(0.0, 1.0) < 0.5;
    const double leaning =
        outer ? now.outer[position].contact_angle : 3.141592653589793 - now.inner[position].contact_angle;
    const double ahead = random.between(-0.3, 0.3) * width / s.numbers.radius;
    const double aside = leaning + random.between(-0.3, 0.3) * width / s.numbers.radius;
    const double angle = s.x[static_cast<std::size_t>(layout.lanes() + i)];
    const double r = std::cos(aside), t = std::sin(ahead);
    double* into = s.x.data() + layout.spot(i);
    into[0] = r * std::cos(angle) - t * std::sin(angle);
    into[1] = r * std::sin(angle) + t * std::cos(angle);
    into[2] = std::sin(aside);
  }
}

// A scratch of a ball moves with the ball, whatever its rotation, and its forces and moments are those of the
// contacts' energy.
TEST(BallMotion, PowerBalancesOnScratchedBalls) {
  RandomBalls random(12);
  int struck = 0;
  for (int draw = 0; draw < 200; ++draw) {
    SCOPED_TRACE(draw);
    Started s = started(random, 1.5);
    BallBearing sound(s.numbers, s.drawn.duty);
    const double before = sound.energy(s.x.data()).races;
    scratch_balls(random, s);
    BallBearing model(s.numbers, s.drawn.duty);
    const double growth = growth_of_energy(model, s.x);
    const BallSnapshot now = model.snapshot(0.0, s.x.data());
    const double input = model.power_input(0.0, s.x.data()), balance = input - now.loss.total();
    EXPECT_NEAR(growth, balance, 3e-5 * (now.loss.total() + std::abs(input) + std::abs(growth) + 1.0));
    if (std::abs(model.energy(s.x.data()).races - before) > 1e-3 * before) ++struck;
  }
  EXPECT_GT(struck, 50);
}

// A cage that leans on both of its lands at once meets the stated stiffness: half of it on each.
TEST(BallMotion, BothLandsTogetherAreAsStiffAsStated) {
  RandomBalls random;
  int guided = 0;
  for (int draw = 0; draw < 20; ++draw) {
    const DrawnBalls drawn = random.next();
    const BallNumbers numbers = ball_numbers(drawn.bearing, drawn.parameters);
    if (!numbers.land.present) continue;
    ++guided;
    EXPECT_DOUBLE_EQ(2.0 * numbers.land.law.stiffness, drawn.parameters.cage.touch_down_stiffness);
  }
  EXPECT_GT(guided, 0);
}

TEST(BallMotion, StagesAreSolvedByTheStiffSlopes) {
  RandomBalls random(7);
  for (int draw = 0; draw < 12; ++draw) {
    SCOPED_TRACE(draw);
    const Started s = started(random, 1.0);
    BallBearing model(s.numbers, s.drawn.duty);
    const StateLayout layout = model.layout();
    const auto n = static_cast<Eigen::Index>(s.x.size());
    std::vector<double> rate(s.x.size()), above(s.x.size()), below(s.x.size()), k(s.x.size());
    Eigen::MatrixXd jacobian(n, n);
    const auto is_position = [&](int i) {
      const auto in = [&](int first, int unknowns) { return i >= first && i < first + unknowns; };
      return i < 3 * layout.lanes() || in(layout.cage(), kCageUnknowns) ||
             in(layout.inner(), kRingUnknowns) || in(layout.outer(), kRingUnknowns);
    };
    for (int i = 0; i < n; ++i) {
      const double step = is_position(i) ? 1e-10 : 1e-6;
      std::vector<double> x = s.x;
      x[static_cast<std::size_t>(i)] += step;
      model.derivative(0.0, x.data(), above.data());
      x[static_cast<std::size_t>(i)] -= 2.0 * step;
      model.derivative(0.0, x.data(), below.data());
      for (int m = 0; m < n; ++m)
        jacobian(m, i) =
            (above[static_cast<std::size_t>(m)] - below[static_cast<std::size_t>(m)]) / (2.0 * step);
    }
    model.linearise(0.0, s.x.data(), rate.data());
    constexpr double g = 1e-6;  // [s]
    ASSERT_TRUE(model.factor(g));
    model.solve(rate.data(), k.data());
    const Eigen::Map<Eigen::VectorXd> right(rate.data(), n), ours(k.data(), n);
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n) - g * jacobian;
    const Eigen::VectorXd exact = mechanics::solution(matrix, right);
    // By kinds: what is left out of the slopes is slow, so that it changes the stage by little.
    const auto expect_kind = [&](int first, int count, double share) {
      const double most = exact.segment(first, count).cwiseAbs().maxCoeff() +
                          1e-3 * right.segment(first, count).cwiseAbs().maxCoeff();
      EXPECT_LE((ours - exact).segment(first, count).cwiseAbs().maxCoeff(), share * most) << first;
    };
    expect_kind(3 * layout.lanes(), s.numbers.balls, 0.02);
    expect_kind(4 * layout.lanes(), s.numbers.balls, 0.1);
    expect_kind(layout.inner() + kRingUnknowns, 3, 0.02);
    expect_kind(layout.cage() + kCageUnknowns, 3, 0.05);
  }
}

TEST(BallMotion, InstructionSetsAgree) {
  RandomBalls random(11);
  for (int draw = 0; draw < 20; ++draw) {
    const Started s = started(random, 1.5);
    std::vector<double> first;
    for (const mechanics::InstructionSet set : mechanics::instruction_sets()) {
      BallBearing model(s.numbers, s.drawn.duty, set);
      std::vector<double> rate(s.x.size()), k(s.x.size());
      model.linearise(0.0, s.x.data(), rate.data());
      ASSERT_TRUE(model.factor(2e-6));
      model.solve(rate.data(), k.data());
      k.insert(k.end(), rate.begin(), rate.end());
      if (first.empty()) first = k;
      const double scale = *std::max_element(first.begin(), first.end());
      for (std::size_t i = 0; i < k.size(); ++i)
        EXPECT_NEAR(k[i], first[i], 1e-7 * std::abs(first[i]) + 1e-9 * scale);
    }
  }
}

// Fixed steps of the linearly implicit method: errors fall with the square of the step, although the matrix
// leaves slow terms out.
TEST(BallMotion, StepsAreOfSecondOrder) {
  RandomBalls random(5);
  DrawnBalls drawn = random.next();
  drawn.parameters.race.traction = TractionLaw::regularised_coulomb;
  drawn.parameters.cage.guide_diameter = 0.0;
  const BallNumbers numbers = ball_numbers(drawn.bearing, drawn.parameters);
  BallBearing model(numbers, drawn.duty);
  const std::vector<double> start = start_state(drawn.bearing, model, 0.2);
  const std::vector<double> loose = system::ball_allowed_errors(numbers, 1.0);
  const auto after = [&](int steps) {
    integration::Rosenbrock2 stepper(loose, 1.0);
    std::vector<double> x = start;
    constexpr double span = 4e-5;  // [s]  no pocket is touched
    for (int i = 0; i < steps; ++i) {
      const double h = span / steps, t = i * h;
      stepper.begin(model, x, t);
      stepper.attempt(model, x, t, h);
      stepper.accept(x);
    }
    return x;
  };
  const std::vector<double> exact = after(1600);
  const auto error = [&](int steps) {
    const std::vector<double> x = after(steps);
    double most = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (loose[i] > 0.0) most = std::max(most, std::abs(x[i] - exact[i]) / loose[i]);
    return most;
  };
  const double coarse = error(50), fine = error(100), finest = error(200);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.35);
  EXPECT_NEAR(std::log2(fine / finest), 2.0, 0.25);
}

// In slow rotation, the mean loads of the balls over their positions are those of the static bearing.
TEST(BallMotion, SlowTurningIsTheStaticBearing) {
  Bearing b;
  b.elements = Balls{8, 11.509e-3, 0.0};
  b.pitch_diameter = 48.5e-3;
  b.radial_clearance = 8e-6;
  b.width = 18e-3;
  b.inner.seat_diameter = 30e-3;
  b.outer.seat_diameter = 72e-3;
  b.cage = {46e-3, 51e-3, 15e-3, 1310.0, Race::outer};
  b.motions = {RaceMotion::rotating, RaceMotion::stationary};
  MotionParameters p;
  p.cage.pocket_clearance = 0.2e-3;
  p.race.friction = 0.01;
  p.drag.on = false;
  p.race.rolling_resistance = false;
  p.race.damping = 1.0;
  p.inner.mass = 0.3;
  p.inner.across = 5e-5;
  const BallDuty duty{RingDrive::steady(30.0), RingDrive::steady(0.0), {{1500.0, 0.0, 0.0, 0.0, 0.0}}, {}};
  system::BallRunOptions options;
  options.duration = 0.25;
  options.observed = 0.8;
  options.samples = 200;
  const rating::Ratings ratings = rating::ratings_of(b, {});
  const system::BallRunResult run = system::run_balls(b, p, duty, ratings.contacts, options);
  ASSERT_TRUE(run.completed) << run.message;
  double square = 0.0, most = 0.0;
  constexpr int positions = 90;
  for (int i = 0; i < positions; ++i) {
    Bearing turned = b;
    turned.first_element = 6.283185307179586 / 8.0 * i / positions;
    const equilibrium::RingState state = equilibrium::balance_bearing(turned, {.radial = 1500.0});
    square += state.contact_load.square().mean() / positions;
    most = std::max(most, state.contact_load.maxCoeff());
  }
  EXPECT_NEAR(run.means.inner_load_rms / std::sqrt(square), 1.0, 0.01);
  EXPECT_NEAR(run.means.inner_load_max / most, 1.0, 0.03);
  EXPECT_LT(std::abs(run.means.cage_slip), 0.02);
}

// At the start balls roll, where all of them meet the races at one angle.
TEST(BallMotion, StartsRolling) {
  RandomBalls random(3);
  for (int draw = 0; draw < 60; ++draw) {
    SCOPED_TRACE(draw);
    DrawnBalls drawn = random.next();
    drawn.duty.on_inner.by[drawn.bearing.contact_angle() > 0.0 ? 0 : 2] = 0.0;
    const BallNumbers numbers = ball_numbers(drawn.bearing, drawn.parameters);
    const BallBearing model(numbers, drawn.duty);
    const std::vector<double> x = start_state(drawn.bearing, model, 0.1);
    const BallSnapshot start = model.snapshot(0.0, x.data());
    for (const auto* race : {&start.inner, &start.outer})
      for (const ContactSnapshot& contact : *race) {
        if (!(contact.load > 1.0)) continue;
        EXPECT_LT(std::abs(contact.sliding), 0.02 * contact.entrainment);
      }
  }
}

// A moment in the plane of the radial load tilts the ring at the start as in the quasi-static state.
TEST(BallMotion, StartsTiltedByItsMoment) {
  Bearing b;
  b.elements = Balls{9, 10e-3, 0.4};
  b.pitch_diameter = 46e-3;
  b.width = 16e-3;
  b.inner.seat_diameter = 30e-3;
  b.outer.seat_diameter = 62e-3;
  b.cage = {44e-3, 49e-3, 14e-3, 1310.0, Race::outer};
  MotionParameters p;
  p.inner.mass = 0.3;
  p.inner.across = 5e-5;
  const BallDuty duty{RingDrive::steady(30.0), RingDrive::steady(0.0), {{800.0, 0.0, 2000.0, -4.0, 1.5}}, {}};
  const BallBearing model(ball_numbers(b, p), duty);
  const std::vector<double> x = start_state(b, model, 0.0);
  const double* ring = x.data() + model.layout().inner();
  const equilibrium::RingState state = equilibrium::balance_bearing(
      b, {.radial = 800.0, .axial = 2000.0, .moment = 4.0, .moment_across = -1.5});
  ASSERT_TRUE(state.report.converged);
  EXPECT_GT(std::abs(state.tilt), 1e-6);
  EXPECT_NEAR(ring[0], state.radial, 1e-9 * std::abs(state.radial));
  EXPECT_NEAR(ring[3], -state.tilt, 1e-9 * std::abs(state.tilt));
  EXPECT_NEAR(ring[4], -state.lateral_tilt, 1e-9 * std::abs(state.tilt));
}

}  // namespace
}  // namespace orbearing::bearing::balls::balls_motion_test
