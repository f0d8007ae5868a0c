// A ball bearing in motion against a model of it that shares no equation with the program's: inertial frame,
// Cartesian coordinates, attitudes as matrices (tests/reference/inertial_balls.hpp).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "bearing/motion/balls/ball_bearing.hpp"
#include "coupling/integration/rosenbrock2.hpp"
#include "tests/reference/inertial_balls.hpp"
#include "tests/shortest_turn.hpp"

namespace orbearing::bearing::balls::balls_inertial_frame_test {
namespace {

namespace oracle = reference::inertial_balls;
using oracle::Bodies;
using oracle::Body;
using oracle::Matrix;
using oracle::Vector;

constexpr double kTwoPi = 6.283185307179586476925286766559;

// State of the bodies from the program's state, and the rate of the state from the rates of the bodies.
class Seen {
 public:
  Seen(const BallBearing& model, double time)
      : layout_(model.layout()), numbers_(model.numbers()), now_(model.surroundings(time)) {}

  Bodies bodies(const double* x) const {
    Bodies seen;
    for (int j = 0; j < layout_.balls; ++j) {
      const Axes axes(at(x, 1, j));
      const double r = at(x, 0, j);
      Body ball;
      ball.position = axes.vector(r, 0.0, at(x, 2, j));
      ball.velocity = axes.vector(at(x, 3, j), r * at(x, 4, j), at(x, 5, j));
      ball.rotating = axes.vector(at(x, 6, j), at(x, 7, j), at(x, 8, j));
      seen.balls.push_back(ball);
    }
    const double* cage = x + layout_.cage();
    seen.cage = body(cage, cage + kCageUnknowns, cage[5], cage[kCageUnknowns + 5]);
    const double *inner = x + layout_.inner(), *outer = x + layout_.outer();
    seen.inner = body(inner, inner + kRingUnknowns, 0.0, now_.inner_spin);
    seen.outer = body(outer, outer + kRingUnknowns, 0.0, now_.outer_spin);
    return seen;
  }

  /// Rate of the program's state.
  std::vector<double> state_rate(const Bodies& bodies, const Bodies& rate) const {
    std::vector<double> dx(static_cast<std::size_t>(layout_.size()), 0.0);
    for (int j = 0; j < layout_.balls; ++j) {
      const Body &ball = bodies.balls[static_cast<std::size_t>(j)],
                 &by = rate.balls[static_cast<std::size_t>(j)];
      const Axes axes(std::atan2(ball.position.y(), ball.position.x()));
      const double r = std::hypot(ball.position.x(), ball.position.y());
      const Vector v = axes.components(ball.velocity), a = axes.components(by.velocity);
      const Vector rotating = axes.components(ball.rotating), turned = axes.components(by.rotating);
      const double orbital = v.y() / r;
      const double put[] = {v.x(),
                            orbital,
                            v.z(),
                            a.x() + r * orbital * orbital,
                            (a.y() - 2.0 * v.x() * orbital) / r,
                            a.z(),
                            turned.x() + orbital * rotating.y(),
                            turned.y() - orbital * rotating.x(),
                            turned.z()};
      for (int group = 0; group < StateLayout::kGroups; ++group)
        dx[static_cast<std::size_t>(group * layout_.lanes() + j)] = put[group];
    }
    put_body(bodies.cage, rate.cage, kCageUnknowns, &dx[static_cast<std::size_t>(layout_.cage())]);
    const Vector axis = bodies.cage.attitude.col(2), passing = bodies.cage.rotating.cross(axis);
    double* cage = &dx[static_cast<std::size_t>(layout_.cage())];
    // The shortest rotation that carries Z to the axis turns by itself about it.
    cage[5] =
        bodies.cage.rotating.dot(axis) + (axis.x() * passing.y() - axis.y() * passing.x()) / (1.0 + axis.z());
    cage[kCageUnknowns + 5] = rate.cage.rotating.dot(axis);
    put_body(bodies.inner, rate.inner, kRingUnknowns, &dx[static_cast<std::size_t>(layout_.inner())]);
    put_body(bodies.outer, rate.outer, kRingUnknowns, &dx[static_cast<std::size_t>(layout_.outer())]);
    return dx;
  }

  /// Rate of the bodies where that of the state is `dx`; the rings' spins are steady.
  Bodies rate(const double* x, const double* dx) const {
    Bodies seen;
    for (int j = 0; j < layout_.balls; ++j) {
      const Axes axes(at(x, 1, j));
      const double r = at(x, 0, j), w = at(x, 4, j);
      Body by;
      by.velocity =
          axes.vector(at(dx, 3, j) - r * w * w, r * at(dx, 4, j) + 2.0 * at(x, 3, j) * w, at(dx, 5, j));
      by.rotating = axes.vector(at(dx, 6, j) - w * at(x, 7, j), at(dx, 7, j) + w * at(x, 6, j), at(dx, 8, j));
      seen.balls.push_back(by);
    }
    const int cage = layout_.cage(), inner = layout_.inner(), outer = layout_.outer();
    seen.cage = body_rate(x + cage, dx + cage, kCageUnknowns, x[cage + kCageUnknowns + 5],
                          dx[cage + kCageUnknowns + 5]);
    seen.inner = body_rate(x + inner, dx + inner, kRingUnknowns, now_.inner_spin, 0.0);
    seen.outer = body_rate(x + outer, dx + outer, kRingUnknowns, now_.outer_spin, 0.0);
    return seen;
  }

  oracle::Surroundings surroundings(const BallDuty& duty, double time) const {
    const auto load = [](const RingLoad& given) {
      return oracle::Wrench{{given.by[0], given.by[1], given.by[2]}, {-given.by[4], given.by[3], 0.0}};
    };
    return {.inner_acceleration = duty.inner.acceleration_at(time),
            .outer_acceleration = duty.outer.acceleration_at(time),
            .on_inner = load(now_.on_inner),
            .on_outer = load(now_.on_outer)};
  }

 private:
  struct Axes {
    explicit Axes(double angle)
        : outward(std::cos(angle), std::sin(angle), 0.0), ahead(-outward.y(), outward.x(), 0.0) {}
    Vector vector(double r, double t, double z) const {
      return r * outward + t * ahead + z * Vector::UnitZ();
    }
    Vector components(const Vector& v) const { return {v.dot(outward), v.dot(ahead), v.z()}; }
    Vector outward, ahead;
  };

  double at(const double* x, int group, int ball) const { return x[group * layout_.lanes() + ball]; }

  static Vector axis(const double* position) {
    return {position[3], position[4], std::sqrt(1.0 - position[3] * position[3] - position[4] * position[4])};
  }
  // Rate of the axis whose components along x and y are given.
  static Vector axis_rate(const double* position, const double* rate) {
    const Vector a = axis(position);
    return {rate[3], rate[4], -(a.x() * rate[3] + a.y() * rate[4]) / a.z()};
  }

  static Body body(const double* position, const double* rate, double angle, double spin) {
    Body seen;
    seen.position = {position[0], position[1], position[2]};
    seen.velocity = {rate[0], rate[1], rate[2]};
    const Vector a = axis(position);
    seen.attitude =
        (shortest_turn(Vector::UnitZ(), a) * Eigen::AngleAxisd(angle, Vector::UnitZ())).toRotationMatrix();
    seen.attitude.col(2) = a;
    seen.rotating = a.cross(axis_rate(position, rate)) + spin * a;
    return seen;
  }

  static void put_body(const Body& body, const Body& by, int unknowns, double* dx) {
    const Vector a = body.attitude.col(2), passing = body.rotating.cross(a);
    const Vector bending = by.rotating.cross(a) + body.rotating.cross(passing);
    // A held ring does not move, whatever its state.
    for (int i = 0; i < 3; ++i) dx[i] = body.velocity[i], dx[unknowns + i] = by.velocity[i];
    for (int i = 0; i < 2; ++i) dx[3 + i] = passing[i], dx[unknowns + 3 + i] = bending[i];
  }

  static Body body_rate(const double* x, const double* dx, int unknowns, double spin, double spin_rate) {
    Body by;
    by.velocity = {dx[unknowns], dx[unknowns + 1], dx[unknowns + 2]};
    const Vector a = axis(x), passing = axis_rate(x, x + unknowns);
    const double bent_z =
        -(a.x() * dx[unknowns + 3] + a.y() * dx[unknowns + 4] + passing.squaredNorm()) / a.z();
    by.rotating =
        a.cross(Vector(dx[unknowns + 3], dx[unknowns + 4], bent_z)) + spin_rate * a + spin * passing;
    return by;
  }

  StateLayout layout_;
  BallNumbers numbers_;
  Surroundings now_;
};

// Bearings and states at random; each draw has a number of its own.
class RandomStates {
 public:
  explicit RandomStates(unsigned number) : seed_{20261122U, number}, engine_(seed_) {}

  struct Kind {
    bool drag = true, land = true, loads = true, held = true, steady = false;
  };

  Bearing bearing() {
    Bearing b;
    Balls balls;
    balls.count = whole(5, 20);
    balls.diameter = decades(3e-3, 40e-3);
    balls.contact_angle = chance(0.5) ? 0.0 : between(0.2, 0.75) * (chance(0.5) ? 1.0 : -1.0);
    b.elements = balls;
    b.pitch_diameter = balls.diameter / std::sin(0.5 * kTwoPi / balls.count) * between(1.1, 1.5);
    b.radial_clearance = between(-5e-6, 30e-6);
    b.inner.osculation = between(0.505, 0.53);
    b.outer.osculation = between(0.51, 0.54);
    b.inner.seat_diameter = 0.8 * (b.pitch_diameter - balls.diameter);
    b.outer.seat_diameter = 1.2 * (b.pitch_diameter + balls.diameter);
    b.width = 1.6 * balls.diameter;
    b.cage = {.inner_diameter = b.pitch_diameter - 0.3 * balls.diameter,
              .outer_diameter = b.pitch_diameter + 0.3 * balls.diameter,
              .width = 1.5 * balls.diameter,
              .density = chance(0.5) ? 1310.0 : 7850.0,
              .guidance = chance(0.5) ? Race::outer : Race::inner};
    return b;
  }

  MotionParameters parameters(const Bearing& b, const Kind& kind) {
    MotionParameters p;
    p.race.damping = chance(0.2) ? 0.0 : decades(0.01, 2.0);
    p.race.traction = std::array{TractionLaw::regularised_coulomb, TractionLaw::limiting_shear,
                                 TractionLaw::ree_eyring}[static_cast<std::size_t>(whole(0, 2))];
    p.race.friction = between(0.01, 0.12);
    p.race.rolling_resistance = chance(0.7);
    p.lubricant = {decades(0.002, 0.2), between(1e-8, 2.5e-8)};
    p.ellipse = {.eyring_stress = decades(2e6, 2e7), .slices = whole(1, 12), .rows = whole(1, 3)};
    p.pocket.straight = chance(0.5) ? 0.0 : decades(1e-5, 1e-3);
    p.cage.pocket_clearance = decades(3e-5, 5e-4);
    p.cage.pocket_damping = decades(0.01, 2.0);
    if (b.balls().count % 2 == 1) p.cage.pocket_film = motion::PocketFilm::hydrodynamic;
    if (kind.land && chance(0.7)) {
      const double clearance = decades(5e-5, 5e-4);
      p.cage.guide_diameter = b.cage.guidance == Race::outer ? b.cage.outer_diameter + 2.0 * clearance
                                                             : b.cage.inner_diameter - 2.0 * clearance;
    }
    p.drag.on = kind.drag && chance(0.7);
    const int held = kind.held ? whole(0, 2) : 2;
    p.inner.held = held == 1;
    p.outer.held = held == 0;
    return p;
  }

  BallDuty duty(const Bearing& b, const Kind& kind) {
    const auto drive = [&]() -> RingDrive {
      if (chance(0.3)) return {};
      const double speed = between(-30.0, 30.0) / (0.5 * b.pitch_diameter);
      if (!kind.steady && chance(0.3)) return {speed, 1e4, speed + 1e3};
      return RingDrive::steady(speed);
    };
    BallDuty d{.inner = drive(), .outer = drive()};
    if (!kind.loads) return d;
    for (RingLoad* load : {&d.on_inner, &d.on_outer})
      for (int i = 0; i < kRingUnknowns; ++i) load->by[i] = between(-1.0, 1.0) * (i < 3 ? 1e3 : 10.0);
    return d;
  }

  /// A bearing as a whole tilted, its parts displaced and tilted a little in it, balls about where they
  /// touch.
  std::vector<double> state(const BallBearing& model) {
    const BallNumbers& n = model.numbers();
    const StateLayout& layout = model.layout();
    std::vector<double> x(static_cast<std::size_t>(layout.size()), 0.0);
    const double tilt = chance(0.5) ? 0.0 : between(0.0, 0.2), way = between(0.0, kTwoPi);
    const Eigen::Quaterniond whole_tilt(Eigen::AngleAxisd(tilt, Vector(std::cos(way), std::sin(way), 0.0)));
    const double small = decades(1e-6, 3e-5);  // [m]
    const auto shaken = [&](double size) { return between(-size, size); };
    const auto body = [&](int begin, int unknowns, double shift, bool held) {
      double* at = &x[static_cast<std::size_t>(begin)];
      const double lean = shift / n.pitch_radius;
      const Vector axis = whole_tilt * Vector(shaken(lean), shaken(lean), 1.0).normalized();
      for (int i = 0; i < 3; ++i) at[i] = shaken(shift);
      at[3] = axis.x();
      at[4] = axis.y();
      if (held) return;
      for (int i = 0; i < 3; ++i) at[unknowns + i] = shaken(0.1);
      for (int i = 3; i < 5; ++i) at[unknowns + i] = shaken(3.0);
    };
    body(layout.inner(), kRingUnknowns, small, n.inner_ring.mass == 0.0);
    body(layout.outer(), kRingUnknowns, small, n.outer_ring.mass == 0.0);
    const double loose = n.land.present ? between(0.5, 1.6) * n.land.law.clearance : n.pocket.play;
    body(layout.cage(), kCageUnknowns, 0.8 * loose, false);

    const Surroundings now = model.surroundings(0.0);
    const double inner = now.inner_spin * (n.pitch_radius - n.radius),
                 outer = now.outer_spin * (n.pitch_radius + n.radius);
    const double orbit = 0.5 * (inner + outer) / n.pitch_radius, spin = 0.5 * (outer - inner) / n.radius;
    double* cage = &x[static_cast<std::size_t>(layout.cage())];
    cage[5] = between(-10.0, 10.0);
    cage[kCageUnknowns + 5] = orbit * between(0.9, 1.1);
    const Matrix pockets = (whole_tilt * Eigen::AngleAxisd(cage[5], Vector::UnitZ())).toRotationMatrix();
    for (int j = 0; j < n.balls; ++j) {
      const auto put = [&](int group, double value) {
        x[static_cast<std::size_t>(group * layout.lanes() + j)] = value;
      };
      const double angle =
          kTwoPi * j / n.balls + shaken(2.0) * (n.pocket.play + n.pocket.half_straight) / n.pitch_radius;
      const double r = n.pitch_radius + shaken(2.0 * small), z = shaken(2.0 * small);
      const Vector position = pockets * Vector(r * std::cos(angle), r * std::sin(angle), z);
      put(0, std::hypot(position.x(), position.y()));
      put(1, std::atan2(position.y(), position.x()) + kTwoPi * whole(-3, 3));
      put(2, position.z());
      put(3, shaken(0.2));
      put(4, orbit * between(0.9, 1.1) + shaken(1.0));
      put(5, shaken(0.2));
      put(6, shaken(0.2) * spin + shaken(10.0));
      put(7, shaken(0.2) * spin + shaken(10.0));
      put(8, spin * between(0.9, 1.1) + shaken(10.0));
    }
    return x;
  }

  int whole(int least, int most) { return std::uniform_int_distribution<int>(least, most)(engine_); }
  bool chance(double share) { return between(0.0, 1.0) < share; }

 private:
  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }
  double decades(double least, double most) {
    return std::pow(10.0, between(std::log10(least), std::log10(most)));
  }

  std::seed_seq seed_;
  std::mt19937_64 engine_;
};

// A bearing and a state of it, both drawn from one number.
struct Case {
  explicit Case(unsigned number, const RandomStates::Kind& kind = {}) : random(number) {
    const Bearing bearing = random.bearing();
    MotionParameters parameters = random.parameters(bearing, kind);
    parameters.race.squeeze = number % 3 == 1;  // squeeze film
    const auto sets = mechanics::instruction_sets();
    model = std::make_unique<BallBearing>(ball_numbers(bearing, parameters), random.duty(bearing, kind),
                                          sets[number % sets.size()]);
    x = random.state(*model);
    dx.resize(x.size());
    model->derivative(0.0, x.data(), dx.data());
    const Seen seen(*model, 0.0);
    bodies = seen.bodies(x.data());
    found = oracle::outcome(model->numbers(), seen.surroundings(model->duty(), 0.0), bodies);
    rate = seen.rate(x.data(), dx.data());
    expected = seen.state_rate(bodies, found.rate);
  }

  RandomStates random;
  std::unique_ptr<BallBearing> model;
  std::vector<double> x, dx, expected;
  Bodies bodies, rate;
  oracle::Outcome found;
};

double largest(const std::vector<oracle::Contact>& contacts) {
  double load = 0.0;
  for (const auto& contact : contacts) load = std::max(load, contact.load);
  return load;
}

constexpr unsigned kCases = 400;
constexpr double kAllowed = 1e-7;  // [-]  of the largest of the kind

TEST(BallsInertialFrame, SeesTheSameMotion) {
  struct Count {
    int open = 0, closed = 0;
  } inner, outer, pocket, land;
  for (unsigned number = 0; number < kCases; ++number) {
    SCOPED_TRACE(number);
    const Case c(number);
    const StateLayout& layout = c.model->layout();
    const auto compare = [&](int begin, int count, const char* what) {
      double scale = 0.0, error = 0.0;
      for (int i = begin; i < begin + count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        scale = std::max(scale, std::abs(c.expected[k]));
        error = std::max(error, std::abs(c.expected[k] - c.dx[k]));
      }
      EXPECT_LE(error, kAllowed * scale) << what << " of " << scale;
    };
    const char* groups[] = {"r", "theta", "z", "r'", "theta'", "z'", "spin r", "spin theta", "spin z"};
    for (int group = 0; group < StateLayout::kGroups; ++group)
      compare(group * layout.lanes(), layout.balls, groups[group]);
    const auto compare_body = [&](int begin, int unknowns, const char* what) {
      SCOPED_TRACE(what);
      compare(begin, 3, "velocity");
      compare(begin + 3, 2, "turning of the axis");
      compare(begin + unknowns, 3, "acceleration");
      compare(begin + unknowns + 3, 2, "bending of the axis");
    };
    compare_body(layout.cage(), kCageUnknowns, "cage");
    compare(layout.cage() + 5, 1, "angle of the cage");
    compare(layout.cage() + kCageUnknowns + 5, 1, "spin of the cage");
    const auto compare_ring = [&](int begin, bool held, const char* what) {
      const auto* rates = &c.dx[static_cast<std::size_t>(begin)];
      if (held)
        EXPECT_THAT(std::vector(rates, rates + 2 * kRingUnknowns), testing::Each(0.0)) << what;
      else
        compare_body(begin, kRingUnknowns, what);
    };
    compare_ring(layout.inner(), c.model->numbers().inner_ring.mass == 0.0, "inner ring");
    compare_ring(layout.outer(), c.model->numbers().outer_ring.mass == 0.0, "outer ring");

    if (c.model->numbers().land.present) {
      land.closed += c.found.touching_lands;
      land.open += 2 - c.found.touching_lands;
    }
    const auto loads = c.model->loads();
    const auto compare_loads = [&](const double* found, const std::vector<oracle::Contact>& expected,
                                   Count& count, const char* what) {
      for (std::size_t j = 0; j < expected.size(); ++j) {
        EXPECT_NEAR(found[j], expected[j].load, kAllowed * largest(expected)) << what;
        ++(expected[j].load > 0.0 ? count.closed : count.open);
      }
    };
    compare_loads(loads.inner, c.found.inner, inner, "inner");
    compare_loads(loads.outer, c.found.outer, outer, "outer");
    compare_loads(loads.pocket, c.found.pocket, pocket, "pocket");
  }
  for (const Count& count : {inner, outer, pocket, land}) {
    EXPECT_GT(count.open, 0.1 * (count.open + count.closed));
    EXPECT_GT(count.closed, 0.1 * (count.open + count.closed));
  }
}

TEST(BallsInertialFrame, SeesTheSamePowers) {
  for (unsigned number = 0; number < kCases; ++number) {
    SCOPED_TRACE(number);
    const Case c(number);
    const BallSnapshot seen = c.model->snapshot(0.0, c.x.data());
    const BallPowerLoss& loss = seen.loss;
    const auto& expected = c.found.loss;
    const double allowed = kAllowed * expected.total();
    EXPECT_NEAR(loss.total(), expected.total(), allowed);
    EXPECT_NEAR(loss.sliding + loss.differential + loss.spin, expected.friction, allowed);
    EXPECT_NEAR(loss.rolling, expected.rolling, allowed);
    EXPECT_NEAR(loss.damping, expected.damping, allowed);
    EXPECT_NEAR(loss.cage, expected.pockets + expected.lands, allowed);
    EXPECT_NEAR(loss.churning, expected.churning, allowed);
    EXPECT_NEAR(loss.sliding, expected.sliding, allowed);
    EXPECT_NEAR(loss.spin, expected.spin, allowed);
    const double torque =
        kAllowed * (std::abs(c.found.inner_torque) + std::abs(c.found.outer_torque)) + 1e-12;
    EXPECT_NEAR(seen.inner_torque, c.found.inner_torque, torque);
    EXPECT_NEAR(seen.outer_torque, c.found.outer_torque, torque);
    const auto compare = [&](const std::vector<ContactSnapshot>& found,
                             const std::vector<oracle::Contact>& contacts) {
      for (std::size_t j = 0; j < contacts.size(); ++j) {
        if (contacts[j].load == 0.0) continue;
        EXPECT_NEAR(found[j].load, contacts[j].load, kAllowed * largest(contacts));
        EXPECT_NEAR(found[j].contact_angle, contacts[j].contact_angle, kAllowed);
        EXPECT_NEAR(found[j].sliding, contacts[j].sliding, kAllowed * (1.0 + std::abs(contacts[j].sliding)));
        EXPECT_NEAR(found[j].spin, contacts[j].spin, kAllowed * (1.0 + std::abs(contacts[j].spin)));
        EXPECT_NEAR(found[j].entrainment, contacts[j].entrainment,
                    kAllowed * (1.0 + contacts[j].entrainment));
        EXPECT_NEAR(found[j].central_film, contacts[j].film, kAllowed * contacts[j].film);
      }
    };
    compare(seen.inner, c.found.inner);
    compare(seen.outer, c.found.outer);
    for (std::size_t j = 0; j < c.found.pocket.size(); ++j)
      EXPECT_NEAR(seen.pocket_load[j], c.found.pocket[j].load, kAllowed * largest(c.found.pocket));
  }
}

// Work of drives and loads goes into motion, springs and losses: by the reference, and by the program.
TEST(BallsInertialFrame, KeepsEnergy) {
  for (unsigned number = 0; number < kCases; ++number) {
    SCOPED_TRACE(number);
    const Case c(number, {.steady = true});
    const Seen seen(*c.model, 0.0);
    const auto around = seen.surroundings(c.model->duty(), 0.0);
    const Surroundings now = c.model->surroundings(0.0);
    const auto work = [](const oracle::Wrench& load, const Body& body) {
      return load.force.dot(body.velocity) +
             oracle::across(body.attitude.col(2), load.moment).dot(body.rotating);
    };
    const double input = work(around.on_inner, c.bodies.inner) + work(around.on_outer, c.bodies.outer) +
                         c.found.inner_torque * now.inner_spin + c.found.outer_torque * now.outer_spin;
    const double kinetic = oracle::kinetic_power(c.model->numbers(), c.bodies, c.found.rate);
    const double lost = c.found.loss.total(), springs = c.found.elastic_power;
    const double scale = lost + std::abs(input) + std::abs(springs);
    EXPECT_NEAR(kinetic + springs + lost, input, 1e-9 * scale);
    EXPECT_NEAR(c.model->power_input(0.0, c.x.data()), input, kAllowed * scale);
    const auto energy = [&](double time) {
      std::vector<double> x = c.x;
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += time * c.dx[i];
      return c.model->energy(x.data()).total();
    };
    constexpr double h = 2e-9;  // [s]
    const double growth =
        (8.0 * (energy(h) - energy(-h)) - (energy(2.0 * h) - energy(-2.0 * h))) / (12.0 * h);
    EXPECT_NEAR(growth, kinetic + springs, 3e-5 * scale);
    const double kinetic_of_program = oracle::kinetic_power(c.model->numbers(), c.bodies, c.rate);
    EXPECT_NEAR(kinetic_of_program + springs + lost, input, kAllowed * scale);
  }
}

// Two free rings, no oil around: moments of the drives alone change the angular momentum.
TEST(BallsInertialFrame, KeepsMomentum) {
  const RandomStates::Kind alone{.drag = false, .land = false, .loads = false, .held = false, .steady = true};
  for (unsigned number = 0; number < kCases / 2; ++number) {
    SCOPED_TRACE(number);
    const Case c(number, alone);
    const auto& numbers = c.model->numbers();
    const auto check = [&](const Bodies& rate, double inner_torque, double outer_torque, double allowed,
                           const char* whose) {
      const auto sum = oracle::momentum_rate(numbers, c.bodies, rate);
      const auto scale = oracle::momentum_scale(numbers, c.bodies, rate);
      const Vector drives =
          inner_torque * c.bodies.inner.attitude.col(2) + outer_torque * c.bodies.outer.attitude.col(2);
      EXPECT_LE(sum.linear.norm(), allowed * scale.linear.norm()) << whose;
      EXPECT_LE((sum.angular - drives).norm(), allowed * scale.angular.norm()) << whose;
    };
    check(c.found.rate, c.found.inner_torque, c.found.outer_torque, 1e-10, "reference");
    const BallSnapshot seen = c.model->snapshot(0.0, c.x.data());
    check(c.rate, seen.inner_torque, seen.outer_torque, kAllowed, "program");
  }
}

// The angle of the first pocket by its definition: the shortest rotation from Z to the axis is taken off.
TEST(BallsInertialFrame, CountsTheCagesAngleAsItTurns) {
  for (unsigned number = 0; number < 100; ++number) {
    const Case c(number);
    const Body& cage = c.bodies.cage;
    const auto angle_after = [&](double time) {
      const double speed = cage.rotating.norm();
      const Matrix turned = Eigen::AngleAxisd(time * speed, cage.rotating / speed) * cage.attitude;
      const Vector first = shortest_turn(turned.col(2), Vector::UnitZ()) * turned.col(0);
      return std::atan2(first.y(), first.x());
    };
    const double step = 1e-4 / cage.rotating.norm();
    const double rate = std::remainder(angle_after(step) - angle_after(-step), kTwoPi) / (2.0 * step);
    const auto k = static_cast<std::size_t>(c.model->layout().cage() + 5);
    EXPECT_NEAR(c.dx[k], rate, 1e-7 * cage.rotating.norm()) << number;
  }
}

// Means over a run.
struct Means {
  Eigen::VectorXd inner, outer;                                          // [N]  (balls)
  double pocket = 0.0;                                                   // [N]  of all balls
  double cage_speed = 0.0;                                               // [rad/s]
  Eigen::Array<double, 6, 1> loss = Eigen::Array<double, 6, 1>::Zero();  // [W]

  explicit Means(int balls) : inner(Eigen::VectorXd::Zero(balls)), outer(inner) {}
};

struct Steps {
  int count;
  double length;  // [s]
};

// Classical Runge-Kutta steps of the reference's equations.
Means explicit_run(const BallBearing& model, const std::vector<double>& start, const Steps& run) {
  const Seen seen(model, 0.0);
  const auto around = seen.surroundings(model.duty(), 0.0);
  const double h = run.length, share = 1.0 / run.count;
  Bodies now = seen.bodies(start.data());
  Means means(model.numbers().balls);
  for (int k = 0; k < run.count; ++k) {
    const auto at = [&](const Bodies& bodies) { return oracle::outcome(model.numbers(), around, bodies); };
    const oracle::Outcome first = at(now);
    const Bodies k2 = at(now.after(0.5 * h, first.rate)).rate, k3 = at(now.after(0.5 * h, k2)).rate;
    const Bodies k4 = at(now.after(h, k3)).rate;
    for (std::size_t j = 0; j < first.inner.size(); ++j) {
      means.inner[static_cast<Eigen::Index>(j)] += share * first.inner[j].load;
      means.outer[static_cast<Eigen::Index>(j)] += share * first.outer[j].load;
      means.pocket += share * first.pocket[j].load;
    }
    means.cage_speed += share * now.cage.rotating.dot(now.cage.attitude.col(2));
    const auto& loss = first.loss;
    means.loss += share * Eigen::Array<double, 6, 1>{loss.friction, loss.rolling,
                                                     loss.damping,  loss.pockets + loss.lands,
                                                     loss.churning, loss.total()};
    now = now.after(h / 6.0, first.rate).after(h / 3.0, k2).after(h / 3.0, k3).after(h / 6.0, k4);
  }
  return means;
}

// The program's linearly implicit steps.
Means implicit_run(BallBearing& model, std::vector<double> x, const Steps& run) {
  integration::Rosenbrock2 stepper(std::vector<double>(x.size(), 1.0), run.length);
  const double share = 1.0 / run.count;
  Means means(model.numbers().balls);
  for (int k = 0; k < run.count; ++k) {
    const double t = k * run.length;
    const BallSnapshot now = model.snapshot(t, x.data());
    for (std::size_t j = 0; j < now.inner.size(); ++j) {
      means.inner[static_cast<Eigen::Index>(j)] += share * now.inner[j].load;
      means.outer[static_cast<Eigen::Index>(j)] += share * now.outer[j].load;
      means.pocket += share * now.pocket_load[j];
    }
    means.cage_speed += share * now.cage_speed;
    const BallPowerLoss& loss = now.loss;
    means.loss += share * Eigen::Array<double, 6, 1>{loss.sliding + loss.differential + loss.spin,
                                                     loss.rolling,
                                                     loss.damping,
                                                     loss.cage,
                                                     loss.churning,
                                                     loss.total()};
    stepper.begin(model, x, t);
    stepper.attempt(model, x, t, run.length);
    stepper.accept(x);
  }
  return means;
}

struct RunCase {
  const char* name;
  double contact_angle;  // [rad]
  TractionLaw law;
  RingDrive inner, outer;
  Race guidance;
  motion::PocketFilm pockets;
};

void PrintTo(const RunCase& run, std::ostream* out) {
  *out << run.name;
}

class BallsInertialRun : public testing::TestWithParam<RunCase> {};

// Some turns of the balls under thrust and a radial load, the inner ring free. Sums over the same instants.
TEST_P(BallsInertialRun, RunsAlike) {
  Bearing bearing;
  bearing.elements = Balls{.count = 9, .diameter = 10e-3, .contact_angle = GetParam().contact_angle};
  bearing.pitch_diameter = 50e-3;
  bearing.inner.seat_diameter = 30e-3;
  bearing.outer.seat_diameter = 70e-3;
  bearing.width = 16e-3;
  bearing.cage = {.inner_diameter = 47e-3,
                  .outer_diameter = 53e-3,
                  .width = 16e-3,
                  .density = 1310.0,
                  .guidance = GetParam().guidance};
  MotionParameters parameters;
  parameters.race.traction = GetParam().law;
  parameters.lubricant = {0.02, 1.5e-8};
  parameters.cage.pocket_clearance = 0.2e-3;
  parameters.cage.pocket_film = GetParam().pockets;
  parameters.cage.guide_diameter = GetParam().guidance == Race::outer ? 53.4e-3 : 46.6e-3;
  BallDuty duty;
  duty.inner = GetParam().inner;
  duty.outer = GetParam().outer;
  duty.on_inner.by[0] = 300.0;
  duty.on_inner.by[2] = 1000.0;
  BallBearing model(ball_numbers(bearing, parameters), duty);
  const std::vector<double> start = start_state(bearing, model, 0.1);
  const Steps run{.count = 4000, .length = 1e-6};
  const Means expected = explicit_run(model, start, run), found = implicit_run(model, start, run);
  constexpr double kLoads = 1e-4, kParts = 1e-3;  // [-]
  for (Eigen::Index j = 0; j < expected.inner.size(); ++j) {
    EXPECT_NEAR(found.inner[j], expected.inner[j], kLoads * expected.inner.mean()) << j;
    EXPECT_NEAR(found.outer[j], expected.outer[j], kLoads * expected.outer.mean()) << j;
  }
  EXPECT_GT(expected.pocket, 0.0);
  EXPECT_NEAR(found.pocket, expected.pocket, kParts * expected.pocket);
  EXPECT_NEAR(found.cage_speed, expected.cage_speed, kLoads * std::abs(expected.cage_speed));
  const double all = expected.loss[5];
  EXPECT_NEAR(found.loss[5], all, kLoads * all);
  // Damping of the races is a hundred thousandth of the whole; errors of the steps are relative to the whole.
  for (Eigen::Index i = 0; i < 5; ++i)
    EXPECT_NEAR(found.loss[i], expected.loss[i], kParts * expected.loss[i] + 1e-6 * all) << i;
}

INSTANTIATE_TEST_SUITE_P(Courses, BallsInertialRun,
                         testing::Values(RunCase{"angular_contact",
                                                 0.4,
                                                 TractionLaw::regularised_coulomb,
                                                 RingDrive::steady(800.0),
                                                 {},
                                                 Race::outer,
                                                 motion::PocketFilm::none},
                                         RunCase{"deep_groove", 0.0, TractionLaw::ree_eyring,
                                                 RingDrive::steady(-200.0), RingDrive::steady(600.0),
                                                 Race::inner, motion::PocketFilm::hydrodynamic}),
                         [](const testing::TestParamInfo<RunCase>& run) { return run.param.name; });

}  // namespace
}  // namespace orbearing::bearing::balls::balls_inertial_frame_test
