// Ball bearings drawn at random under loads over four decades and speeds over two, RANDOM_BALLS of them: each
// run ends with sound numbers or a reason.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

#include "coupling/system/ball_run.hpp"
#include "tests/random_balls.hpp"

namespace orbearing::bearing::balls::balls_random_test {
namespace {

TEST(RandomBallBearings, EndWithSoundNumbersOrAReason) {
  const char* stated = std::getenv("RANDOM_BALLS");
  const int runs = stated ? std::atoi(stated) : 150;
  RandomBalls random(1);
  std::map<std::string, int> ends;
  for (int i = 0; i < runs; ++i) {
    SCOPED_TRACE(i);
    DrawnBalls drawn = random.next();
    drawn.parameters.outer.held = true;
    const double load = std::pow(10.0, random.between(-3.0, 1.0)), speed = std::pow(10.0, random.between(-1.0, 0.7));
    for (double& by : drawn.duty.on_inner.by) by *= load;
    for (RingDrive* drive : {&drawn.duty.inner, &drawn.duty.outer}) *drive = RingDrive::steady(speed * drive->speed);
    system::BallRunOptions options;
    options.duration = 0.004;
    options.observed = 0.5;
    options.samples = 20;
    options.start = i % 2 == 0 ? system::Start::rest : system::Start::rolling;
    const system::BallRunResult run = system::run_balls(
        drawn.bearing, drawn.parameters, drawn.duty, rating::ratings_of(drawn.bearing, {}).contacts, options);
    ++ends[run.completed ? "completed" : run.message];
    if (run.completed)
      EXPECT_TRUE(std::isfinite(run.means.loss.total()) && std::isfinite(run.means.cage_slip) &&
                  std::isfinite(run.means.inner_load_rms));
    else
      EXPECT_FALSE(run.message.empty());
  }
  for (const auto& [end, count] : ends) std::cout << count << " " << end << "\n";
  EXPECT_GE(ends["completed"], 0.95 * runs);
}

}  // namespace
}  // namespace orbearing::bearing::balls::balls_random_test
