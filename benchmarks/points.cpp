#include "benchmarks/points.hpp"

#include <fmt/core.h>

#include <string>
#include <vector>

#include "benchmarks/clocks.hpp"
#include "benchmarks/speed.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bench {

namespace {

using Json = nlohmann::ordered_json;
using constants::two_pi;

constexpr double kMiddle = 6000.0;  // [1/min]
constexpr int kNeighbours = 9;
constexpr double kBetweenNeighbours = 2e-3;  // [-]  of the speed
constexpr int kSpeeds = 12;                  // thousands of revolutions per minute
constexpr int kLaminae[] = {1, 8, 32, 64};
constexpr int kRuns = 5;

// CPU time [s] of a point as a sweep computes it.
double point_seconds(analysis::PlanetaryDrivetrain drivetrain, double rpm) {
  drivetrain.drive.speed = rpm * two_pi / 60.0;
  const Stopwatch watch;
  analysis::evaluate(drivetrain, analysis::derive(drivetrain), analysis::Fidelity::dynamic);
  return watch.cpu();
}

// One lamina is the whole contact.
Duty cut(const Duty& duty, int laminae) {
  return laminae == 1 ? duty : with_laminae(duty, laminae);
}

}  // namespace

void put_points(Json& out) {
  const analysis::PlanetaryDrivetrain drivetrain = shipped_reducer(MeshForces::varying);
  std::vector<double> rates;
  for (int i = 0; i < kNeighbours; ++i)
    rates.push_back(1.0 / point_seconds(drivetrain, kMiddle * (1.0 + kBetweenNeighbours * i)));
  const Quartiles neighbours = quartiles(rates);
  out["dynamic_points_per_s_core"] = neighbours.median;
  out["spreads"]["dynamic_points_per_s_core"] = {neighbours.lower, neighbours.upper};
  double seconds = 0.0;
  for (int speed = 1; speed <= kSpeeds; ++speed) seconds += point_seconds(drivetrain, 1000.0 * speed);
  out["dynamic_points_per_s_core_sweep12"] = kSpeeds / seconds;
}

void put_laminae(Json& out) {
  const Duty duty = duty_at(shipped_reducer(), kMiddle, 0.0);
  for (const int laminae : kLaminae) {
    Contest contest(cut(duty, laminae));
    const double duration = duty.cage_revolution();
    const Eigen::VectorXd start = contest.settled(duration);
    std::vector<double> times;
    for (int run = 0; run < kRuns; ++run)
      times.push_back(contest.run(Method::fast, start, {duration, 1}, duty.allowed_length_error).cpu_seconds /
                      duration);
    const Quartiles found = quartiles(times);
    const std::string name = std::to_string(laminae);
    out["laminae_ms_per_ms"][name] = found.median;
    out["spreads"]["laminae_ms_per_ms"][name] = {found.lower, found.upper};
  }
}

}  // namespace orbearing::bench
