// orbearing_pace: one bearing's computing time on request, so that two versions of the program can be timed
// in turn. Compiled with the benchmarks of this version and with those of the base (over_base.cmake), by
// their own headers: only what both have is used.
//
// Requests on standard input, each with one line of answer on standard output:
//   bearing RPM CLEARANCE_UM constant|varying   settles it over three cage revolutions      "ready"
//   run                                         two cage revolutions from there, loads gathered, CPU time of
//   the
//                                               thread                                      "SECONDS
//                                               SIMULATED_SECONDS STEPS"
//   errors                                      of its means against RK4                    "RMS LARGEST
//   CAGE_SPEED" sweep CLEARANCE_UM                          twelve speeds on two threads "WALL_SECONDS"
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <string>

#include "benchmarks/accuracy.hpp"
#include "benchmarks/speed.hpp"

namespace {

using namespace orbearing::bench;

constexpr int kSettling = 3;         // [-]  cage revolutions
constexpr int kWatched = 2;          // [-]
constexpr double kShortest = 20e-3;  // [s]  of each
constexpr double per_micro = 1e-6;

// A settled bearing at the standard settings of its version.
class Paced {
 public:
  explicit Paced(const Duty& duty)
      : contest_(duty),
        start_(contest_.settled(std::max(kSettling * duty.cage_revolution(), kShortest))),
        span_{std::max(kWatched * duty.cage_revolution(), kShortest), 1} {}

  void run() {
    const Run done = contest_.run(Method::fast, start_, span_, contest_.duty().allowed_length_error);
    std::printf("%.9g %.9g %ld\n", done.cpu_seconds, span_.duration, done.steps);
  }
  const Duty& duty() const { return contest_.duty(); }

 private:
  Contest contest_;
  Eigen::VectorXd start_;
  Span span_;
};

void print_errors(const Duty& duty) {
  Trial trial(duty);
  const MeanErrors errors = trial.errors(Method::fast, duty.allowed_length_error);
  std::printf("%.6g %.6g %.6g\n", errors.rms, errors.load_max, errors.cage_speed);
}

int serve() {
  std::unique_ptr<Paced> paced;
  std::string request;
  while (std::cin >> request) {
    if (request == "bearing") {
      double rpm = 0.0, clearance = 0.0;
      std::string meshes;
      std::cin >> rpm >> clearance >> meshes;
      paced = std::make_unique<Paced>(duty_at(
          shipped_reducer(meshes == "varying" ? MeshForces::varying : MeshForces::constant), rpm, clearance));
      std::puts("ready");
    } else if (request == "sweep") {
      double clearance = 0.0;
      std::cin >> clearance;
      std::printf("%.9g\n", sweep_seconds(shipped_reducer(), clearance));
    } else if (request == "run" && paced) {
      paced->run();
    } else if (request == "errors" && paced) {
      print_errors(paced->duty());
    } else {
      std::fprintf(stderr, "orbearing_pace: \"%s\" is no request that can be answered here\n",
                   request.c_str());
      return 2;
    }
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

int main() {
  try {
    return serve();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "orbearing_pace: %s\n", error.what());
    return 1;
  }
}
