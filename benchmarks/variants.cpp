#include "benchmarks/variants.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmarks/clocks.hpp"
#include "benchmarks/runs.hpp"
#include "benchmarks/speed.hpp"
#include "coupling/integration/rosenbrock2.hpp"
#include "coupling/system/bearing_steps.hpp"

namespace orbearing::bench {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kVariants = 8;          // doubles in a register of 512 bits
constexpr double kSettled = 10e-3;    // [s]  from the quasi-static start
constexpr double kWatched = 20e-3;    // [s]
constexpr double kFirstTrial = 1e-6;  // [s]
constexpr int kPackFactors[] = {1, 2, 4, 8};
constexpr int kTimings = 9;
constexpr long kTimedSteps = 400;

// Attempts and accepted steps of one run.
struct Count {
  long attempts = 0;
  long steps = 0;
  long refused() const { return attempts - steps; }
};

// A bearing and its stepper, as coupling/system/free_bearing.cpp joins them.
struct Variant {
  explicit Variant(const Duty& duty)
      : contest(std::make_unique<Contest>(duty)),
        state(contest->fast().padded(contest->settled(kSettled))),
        longest(system::longest_step(contest->duty().model())),
        stepper(
            system::linearly_implicit_errors(contest->fast(), contest->allowed(duty.allowed_length_error)),
            longest) {}

  std::unique_ptr<Contest> contest;
  std::vector<double> state;
  double longest;  // [s]
  integration::Rosenbrock2 stepper;
};

std::vector<Variant> variants_of(const std::vector<Duty>& duties) {
  std::vector<Variant> variants;
  for (const Duty& duty : duties) variants.emplace_back(duty);
  return variants;
}

Count run_alone(Variant& variant) {
  Count count;
  double time = 0.0, step = kFirstTrial;
  std::vector<double> x = variant.state;
  while (time < kWatched) {
    ++count.attempts;
    if (variant.stepper.try_step(variant.contest->fast(), x, time, step) == integration::kAccepted)
      ++count.steps;
  }
  return count;
}

// The first `lanes` variants with one step for all: the largest of their errors decides.
Count run_together(std::vector<Variant>& variants, int lanes) {
  Count count;
  double time = 0.0, step = kFirstTrial, longest = INFINITY;
  std::vector<std::vector<double>> x;
  for (int i = 0; i < lanes; ++i) {
    const Variant& one = variants[static_cast<std::size_t>(i)];
    x.push_back(one.state);
    longest = std::min(longest, one.longest);
  }
  integration::StepControl control(longest);
  while (time < kWatched) {
    for (int i = 0; i < lanes; ++i) {
      Variant& one = variants[static_cast<std::size_t>(i)];
      one.stepper.begin(one.contest->fast(), x[static_cast<std::size_t>(i)], time);
    }
    while (true) {
      ++count.attempts;
      double error = 0.0;
      for (int i = 0; i < lanes; ++i) {
        Variant& one = variants[static_cast<std::size_t>(i)];
        const double own =
            one.stepper.attempt(one.contest->fast(), x[static_cast<std::size_t>(i)], time, step);
        error = own <= error ? error : own;  // one that is not a number counts
      }
      const double taken = step;
      if (error <= 1.0) {
        time += taken;
        step = control.after_acceptance(taken, error);
        break;
      }
      step = control.after_refusal(taken, error);
    }
    ++count.steps;
    for (int i = 0; i < lanes; ++i)
      variants[static_cast<std::size_t>(i)].stepper.accept(x[static_cast<std::size_t>(i)]);
  }
  return count;
}

Json to_json(const Count& count) {
  return {{"steps", count.steps}, {"refused", count.refused()}};
}

// The cost of a common step is comparable only if the steps are the same.
void check_lockstep(std::vector<Variant>& variants, const Count& alone) {
  const Count together = run_together(variants, 1);
  if (together.steps != alone.steps || together.attempts != alone.attempts)
    throw std::runtime_error(
        fmt::format("one variant in lockstep takes {} of {} attempts; required: {} of {} as alone",
                    together.steps, together.attempts, alone.steps, alone.attempts));
}

// Attempts of `lanes` variants in one lockstep over the mean of those that each needs singly, with a common
// step, and with steps of their own where lanes wait for the last one (`waiting`); lanes that are refilled
// wait for none.
Json neighbours(const std::vector<Duty>& duties) {
  std::vector<Variant> variants = variants_of(duties);
  std::vector<double> attempts;
  Json out;
  check_lockstep(variants, run_alone(variants.front()));
  for (Variant& one : variants) {
    const Count count = run_alone(one);
    attempts.push_back(static_cast<double>(count.attempts));
    out["alone"].push_back(to_json(count));
  }
  for (const int lanes : {2, 4, kVariants}) {
    const double mean = std::accumulate(attempts.begin(), attempts.begin() + lanes, 0.0) / lanes;
    const Count common = run_together(variants, lanes);
    out[fmt::format("{}_lanes", lanes)] = {
        {"common", to_json(common)},
        {"common_over_alone", static_cast<double>(common.attempts) / mean},
        {"waiting_over_alone", *std::max_element(attempts.begin(), attempts.begin() + lanes) / mean}};
  }
  return out;
}

Json step_sequences(Squeeze squeeze) {
  Json out;
  for (const bool shaken : {false, true}) {
    const analysis::PlanetaryDrivetrain drivetrain =
        shipped_reducer(shaken ? MeshForces::varying : MeshForces::constant, squeeze);
    for (const auto& [rpm, clearance] : {std::pair{6000.0, 0.0}, std::pair{12000.0, 37.0}}) {
      std::vector<Duty> speeds, clearances;
      for (int i = 0; i < kVariants; ++i) {
        speeds.push_back(duty_at(drivetrain, rpm * (1.0 + 2e-3 * i), clearance));
        clearances.push_back(duty_at(drivetrain, rpm, clearance + 0.5 * i));
      }
      const std::string name = fmt::format("{:.0f}/{:.0f}{}", rpm, clearance, shaken ? "/real meshes" : "");
      fmt::print(stderr, "bench: steps of neighbours at {}\n", name);
      out[name]["speeds"] = neighbours(speeds);
      out[name]["clearances"] = neighbours(clearances);
    }
  }
  return out;
}

// Medians [ns] of a step with one, two, four and eight packs of rollers: fixed + pack * packs.
Json step_shares(const analysis::PlanetaryDrivetrain& drivetrain) {
  const Duty duty = duty_at(drivetrain, 6000.0, 0.0);
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  Json out;
  for (const int packs : kPackFactors) {
    Variant one(with_more_rollers(duty, packs));
    std::vector<double> times;
    for (int i = 0; i < kTimings; ++i) {
      std::vector<double> state = one.state;
      double time = 0.0;
      const Stopwatch watch;
      for (long k = 0; k < kTimedSteps; ++k) {
        double step = kFirstTrial;  // so short that none is refused
        one.stepper.try_step(one.contest->fast(), state, time, step);
      }
      times.push_back(1e9 * watch.cpu() / kTimedSteps);
    }
    const double ns = median(times);
    out["step_ns"].push_back(ns);
    n += 1.0, x += packs, y += ns, xx += packs * packs, xy += packs * ns;
  }
  const double pack = (n * xy - x * y) / (n * xx - x * x), fixed = (y - pack * x) / n;
  out["packs"] = kPackFactors;
  out["pack_ns"] = pack;
  out["fixed_ns"] = fixed;
  return out;
}

}  // namespace

Json measure_variants() {
  Json out;
  fmt::print(stderr, "bench: cost of a step over packs of rollers\n");
  out["step"] = step_shares(shipped_reducer(MeshForces::constant, Squeeze::races));
  out["neighbours"] = step_sequences(Squeeze::races);
  out["neighbours_without_squeeze"] = step_sequences(Squeeze::off);
  return out;
}

}  // namespace orbearing::bench
