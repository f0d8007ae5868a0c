#include "benchmarks/kernels.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bearing/equilibrium/aligned_pitch.hpp"
#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "benchmarks/frozen/constants.hpp"
#include "benchmarks/runs.hpp"
#include "coupling/integration/rosenbrock2.hpp"

namespace orbearing::bench {

namespace {

constexpr double kStageShare = 0.29;   // g of 1 - g J over the step
constexpr double kTypicalStep = 5e-6;  // [s]
constexpr double kSettling = 5e-3;     // [s]
constexpr int kRepetitions = 5;
constexpr double kLeastTime = 0.02;  // [s]  of each repetition
constexpr int kStaticPoints = 64;
constexpr int kPlainStaticPoints = 32;
constexpr int kCagePositions = 16;
constexpr int kLaminae = 40;
constexpr int kLaminaContacts = 1000;
constexpr int kLaminaPoints = 40;
constexpr int kRollerFactors[] = {1, 2, 4, 8};

using Body = std::function<void()>;

// Keeps the median time of each benchmark; prints nothing.
class MedianKeeper : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.aggregate_name == "median") nanoseconds[run.run_name.function_name] = run.GetAdjustedCPUTime();
  }
  std::map<std::string, double> nanoseconds;
};

void add(const std::string& name, Body body) {
  const auto loop = [body = std::move(body)](benchmark::State& state) {
    for (auto _ : state) {
      body();
      benchmark::ClobberMemory();
    }
  };
  benchmark::RegisterBenchmark(name.c_str(), loop)
      ->Repetitions(kRepetitions)
      ->ReportAggregatesOnly()
      ->MinTime(kLeastTime)
      ->Unit(benchmark::kNanosecond);
}

// The frozen equations have no squeeze film.
Duty without_pressed_oil(Duty duty) {
  duty.parameters.race.squeeze = false;
  duty.parameters.cage.pocket_film = bearing::motion::PocketFilm::none;
  return duty;
}

// A settled bearing and the arrays its kernels write to.
struct Bench {
  Contest contest;
  frozen::Equations before;
  Eigen::VectorXd flat;
  Eigen::VectorXd flat_rate;
  std::vector<double> x, rate, k;
  integration::Rosenbrock2 stepper;

  explicit Bench(const Duty& duty)
      : contest(duty),
        before(frozen::constants_of(without_pressed_oil(duty).model())),
        flat(contest.settled(kSettling)),
        flat_rate(flat.size()),
        x(contest.fast().padded(flat)),
        rate(x.size()),
        k(x.size()),
        stepper(contest.fast().padded(contest.allowed(1.0)), kTypicalStep) {}

  void step() {
    std::vector<double>& state = k;
    state = x;
    double t = 0.0, dt = kTypicalStep;
    stepper.begin(contest.fast(), state, t);
    stepper.try_step(contest.fast(), state, t, dt);
  }
};

void add_kernels(const std::shared_ptr<Bench>& b) {
  bearing::vectorised::VectorBearing& fast = b->contest.fast();
  add("frozen_rhs", [b] { b->before.derivative(b->flat, b->flat_rate); });
  add("rhs", [b, &fast] { fast.derivative(0.0, b->x.data(), b->rate.data()); });
  add("jacobian", [b, &fast] { fast.linearise(0.0, b->x.data(), b->rate.data()); });
  add("factor", [b, &fast] {
    if (!fast.factor(kStageShare * kTypicalStep)) throw std::logic_error("singular at a settled state");
  });
  add("solve", [b, &fast] { fast.solve(b->rate.data(), b->k.data()); });
}

void add_step(const Duty& duty, int factor) {
  const auto bench = std::make_shared<Bench>(with_more_rollers(duty, factor));
  add("step_" + std::to_string(factor), [bench] { bench->step(); });
}

// Speeds at constant power, in no order that a solver could profit from.
std::vector<bearing::OperatingPoint> static_points(const analysis::PlanetaryDrivetrain& drivetrain) {
  std::vector<bearing::OperatingPoint> points;
  for (int i = 0; i < kStaticPoints; ++i)
    points.push_back(
        duty_at(drivetrain, 1000.0 + 11000.0 * std::fmod(0.618033988749895 * i, 1.0), 0.0).point);
  return points;
}

void add_static(const analysis::PlanetaryDrivetrain& drivetrain) {
  const auto points = static_points(drivetrain);
  const bearing::Bearing bearing = drivetrain.bearing;
  add("plain_static", [points, bearing] {
    for (int i = 0; i < kPlainStaticPoints; ++i)
      benchmark::DoNotOptimize(
          bearing::quasi_static_state(bearing, points[static_cast<std::size_t>(i)], {}, 0.37 * i));
  });
  const auto level = std::make_shared<bearing::vectorised::AlignedPitch>(
      *bearing::vectorised::AlignedPitch::of(bearing, {.cage_positions = kCagePositions}));
  const auto results = std::make_shared<bearing::vectorised::PitchResults>();
  add("fast_static", [points, level, results] {
    for (const bearing::OperatingPoint& point : points) level->solve(point, *results);
  });
}

// A combination as studies of profiles ask for it: profile, tilt and operating point are new each time.
void add_laminae(const analysis::PlanetaryDrivetrain& drivetrain) {
  using namespace bearing::laminae;
  bearing::Bearing bearing = drivetrain.bearing;
  bearing.rollers().laminae = kLaminae;
  bearing.rollers().profile =
      bearing::profile::Iso16281{bearing.rollers().length, bearing.rollers().diameter, 1.0};
  const auto cut = std::make_shared<LaminaBearing>(bearing);
  add("lamina_contacts", [cut] {
    for (int i = 0; i < kLaminaContacts; ++i)
      benchmark::DoNotOptimize(cut->contact(bearing::Race::inner).evaluate(6e-6 + 1e-9 * i, 2e-6));
  });
  add("lamina_points", [points = static_points(drivetrain), bearing]() mutable {
    for (int i = 0; i < kLaminaPoints; ++i) {
      bearing::OperatingPoint point = points[static_cast<std::size_t>(i)];
      point.bore_tilt = 0.5e-3 * (i % 5) * point.bore_load.normalized();
      bearing.rollers().profile = bearing::profile::CircularCrown{bearing.rollers().length, 1e-6 * (i % 8)};
      benchmark::DoNotOptimize(quasi_static_bearing(LaminaBearing(bearing), point, {}));
    }
  });
}

// Slope of the straight line through the logarithms.
double fitted_exponent(const std::map<std::string, double>& times) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const int factor : kRollerFactors) {
    const double a = std::log(factor), b = std::log(times.at("step_" + std::to_string(factor)));
    n += 1.0, x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

std::map<int, double> steps_by_rollers(const std::map<std::string, double>& times, int rollers) {
  std::map<int, double> steps;
  for (const int factor : kRollerFactors)
    steps[factor * rollers] = times.at("step_" + std::to_string(factor));
  return steps;
}

}  // namespace

KernelTimes time_kernels(const analysis::PlanetaryDrivetrain& drivetrain) {
  const Duty duty = duty_at(drivetrain, 6000.0, 0.0);
  add_kernels(std::make_shared<Bench>(duty));
  for (const int factor : kRollerFactors) add_step(duty, factor);
  add_static(drivetrain);
  add_laminae(drivetrain);
  int argc = 1;
  std::string program = "orbearing_bench";
  char* argv[] = {program.data(), nullptr};
  benchmark::Initialize(&argc, argv);
  MedianKeeper keeper;
  benchmark::RunSpecifiedBenchmarks(&keeper);
  benchmark::Shutdown();
  const std::map<std::string, double>& ns = keeper.nanoseconds;
  return {.frozen_rhs = ns.at("frozen_rhs"),
          .rhs = ns.at("rhs"),
          .jacobian = ns.at("jacobian"),
          .factor = ns.at("factor"),
          .solve = ns.at("solve"),
          .step = ns.at("step_1"),
          .exponent = fitted_exponent(ns),
          .step_by_rollers = steps_by_rollers(ns, duty.bearing.rollers().count),
          .plain_static = ns.at("plain_static") / kPlainStaticPoints,
          .fast_static = ns.at("fast_static") / (kStaticPoints * kCagePositions),
          .lamina = ns.at("lamina_contacts") / (kLaminaContacts * kLaminae),
          .lamina_point = ns.at("lamina_points") / kLaminaPoints};
}

}  // namespace orbearing::bench
