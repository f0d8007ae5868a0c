#include "benchmarks/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "benchmarks/accuracy.hpp"
#include "benchmarks/balances.hpp"
#include "benchmarks/balls.hpp"
#include "benchmarks/clocks.hpp"
#include "benchmarks/frozen/constants.hpp"
#include "benchmarks/kernels.hpp"
#include "benchmarks/points.hpp"
#include "benchmarks/speed.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "mechanics/packs/instruction_set.hpp"

namespace orbearing::bench {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kMiddleSpeed = 6000.0;        // [1/min]
constexpr int kSpeeds = 12;                    // thousands of revolutions per minute
constexpr double kClearances[] = {0.0, 37.0};  // [um]
const std::vector<double> kTolerances{1e-7, 3e-8, 1e-8, 3e-9, 1e-9, 3e-10, 1e-10, 3e-11, 1e-11};  // [m]

constexpr int kStatesCompared = 200;
constexpr double kRoundOffs = 2.0;  // one of each of the two that are compared
constexpr double kOtherReferenceStep = 0.75 * kReferenceStep;
// Beside 6000 rpm without clearance [1/min], [um].
constexpr std::pair<double, double> kAccuracyPoints[] = {
    {1000.0, 0.0}, {1000.0, 37.0}, {6000.0, 37.0}, {12000.0, 0.0}, {12000.0, 37.0}};

void say(const std::string& what) {
  fmt::print(stderr, "bench: {}\n", what);
}

Json errors_json(const MeanErrors& errors) {
  return {{"rms_relative", errors.rms},
          {"max_relative", errors.load_max},
          {"cage_speed_relative", errors.cage_speed}};
}

void put_kernels(const KernelTimes& times, Json& out) {
  out["rhs_ns"] = times.rhs;
  out["jacobian_ns"] = times.jacobian;
  out["factor_ns"] = times.factor;
  out["solve_ns"] = times.solve;
  out["step_ns"] = times.step;
  out["frozen_rhs_ns"] = times.frozen_rhs;
  out["rollers_exponent"] = times.exponent;
  for (const auto& [rollers, step] : times.step_by_rollers)
    out["rollers_step_ns"][std::to_string(rollers)] = step;
  // Variants in lanes are not built (bearing/motion/vectorised/README.md): they could gain no more than a
  // bearing of so many rollers does by roller, whose scalar work serves eight packs.
  const auto &few = *times.step_by_rollers.begin(), &many = *times.step_by_rollers.rbegin();
  out["lanes_gain"] = nullptr;
  out["lanes_gain_bound"] = few.second / few.first / (many.second / many.first);
  out["static_points_per_s"] = 1e9 / times.fast_static;
  out["plain_static_points_per_s"] = 1e9 / times.plain_static;
  out["laminae_per_s"] = 1e9 / times.lamina;
  out["lamina_points_per_s"] = 1e9 / times.lamina_point;
}

// A reference that meets the accuracy at none of the tolerances has no ratio: null.
void put_speedup(Trial& trial, Trial& theirs, const std::string& name, Method searched, Method timed,
                 Json& out) {
  say("tolerance and time of " + name);
  const Fit fit = loosest(theirs, searched, kTolerances);
  const std::string key = "speedup_over_" + name;
  out[key] = nullptr;
  if (fit.found) {
    const Quartiles ratio = speedup(trial, theirs, timed, fit.tolerance);
    out[key] = ratio.median;
    out["spreads"][key] = {ratio.lower, ratio.upper};
  }
  out["references"][name] = {{"allowed_length_error_m", fit.found ? Json(fit.tolerance) : Json()},
                             {"errors", errors_json(fit.errors)}};
}

// Ratios against other physics would mean nothing.
void check_frozen(Trial& trial, Json& out) {
  const auto [difference, by_rounding] =
      frozen::largest_difference(trial.contest.duty().model(), trial.start, kStatesCompared);
  out["frozen_difference"] = difference;
  if (!(difference < kRoundOffs * by_rounding))
    throw std::runtime_error(
        fmt::format("frozen and present equations differ by {} of the largest rate; required: {}, twice what "
                    "the last bit of a state changes",
                    difference, kRoundOffs * by_rounding));
}

std::string point_name(double rpm, double clearance) {
  return fmt::format("{:.0f}/{:.0f}", rpm, clearance);
}

void put_real_time(const analysis::PlanetaryDrivetrain& drivetrain, Json& out) {
  say("real-time factors");
  double least = INFINITY;
  for (const double clearance : kClearances)
    for (int speed = 1; speed <= kSpeeds; ++speed) {
      const double rpm = 1000.0 * speed;
      const double factor = real_time(duty_at(drivetrain, rpm, clearance));
      out["real_time_factor"][point_name(rpm, clearance)] = factor;
      least = std::min(least, factor);
    }
  out["min_real_time_factor"] = least;
  const analysis::PlanetaryDrivetrain shaken = shipped_reducer(MeshForces::varying);
  for (const double clearance : kClearances) {
    const std::string name = point_name(kMiddleSpeed, clearance);
    out["real_time_factor_real_meshes"][name] = real_time(duty_at(shaken, kMiddleSpeed, clearance));
    out["real_time_factor_32_laminae"][name] =
        real_time(with_laminae(duty_at(drivetrain, kMiddleSpeed, clearance), 32));
  }
}

void put_errors(const analysis::PlanetaryDrivetrain& drivetrain, Trial& main_trial, Json& out) {
  say("accuracy of the fast path");
  out["errors"] = errors_json(main_trial.errors(Method::fast, drivetrain.steady_state.allowed_length_error));
  out["fast_allowed_length_error_m"] =
      system::kLinearlyImplicitErrorFactor * drivetrain.steady_state.allowed_length_error;
  // Effect of chance on the means: RK4 at another step follows another trajectory.
  out["reference_spread"] = errors_json(main_trial.errors(Method::rk4, kOtherReferenceStep));
  for (const auto& [rpm, clearance] : kAccuracyPoints) {
    Trial trial(duty_at(drivetrain, rpm, clearance));
    const std::string name = point_name(rpm, clearance);
    out["errors_at"][name] =
        errors_json(trial.errors(Method::fast, drivetrain.steady_state.allowed_length_error));
    if (rpm > 1000.0 && clearance > 0.0)
      out["reference_spread_at"][name] = errors_json(trial.errors(Method::rk4, kOtherReferenceStep));
  }
}

}  // namespace

Json measure() {
  const Stopwatch watch;
  const analysis::PlanetaryDrivetrain drivetrain = shipped_reducer();
  Json out;
  out["instruction_set"] = mechanics::name_of(mechanics::best_instruction_set());
  say("kernels");
  put_kernels(time_kernels(drivetrain), out);
  say("reference of 6000 rpm");
  Trial trial(duty_at(drivetrain, kMiddleSpeed, 0.0));
  // The frozen equations have no squeeze film.
  Trial frozen_trial(duty_at(shipped_reducer(MeshForces::constant, Squeeze::off), kMiddleSpeed, 0.0));
  check_frozen(frozen_trial, out);
  // The search needs no clock, and both equations agree to round-off: the faster ones serve it.
  put_speedup(trial, frozen_trial, "dopri5", Method::fast_dopri5, Method::plain_dopri5, out);
  put_speedup(trial, trial, "cvode", Method::cvode, Method::cvode, out);
  put_speedup(trial, trial, "cvode_order2", Method::cvode_order2, Method::cvode_order2, out);
  put_real_time(drivetrain, out);
  say("balances and films");
  put_balances(out);
  say("balls");
  put_balls(out["real_time_factor"][point_name(kMiddleSpeed, 0.0)], drivetrain.bearing.rollers().count, out);
  say("operating points");
  put_points(out);
  say("laminae");
  put_laminae(out);
  say("sweeps");
  out["sweep12_s"] = sweep_seconds(drivetrain, 0.0);
  out["sweep12_37um_s"] = sweep_seconds(drivetrain, 37.0);
  put_errors(drivetrain, trial, out);
  out["bench_s"] = watch.wall();
  return out;
}

std::string table(const Json& figures) {
  std::string text;
  const Json flat = figures.flatten();
  for (const auto& [path, value] : flat.items()) {
    const std::string name = path.substr(1);
    text += value.is_number() ? fmt::format("{:<48} {:>12.4g}\n", name, value.get<double>())
                              : fmt::format("{:<48} {:>12}\n", name, value.dump());
  }
  return text;
}

}  // namespace orbearing::bench
