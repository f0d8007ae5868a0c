// Each key and variable of a ball bearing in time holds its own number, in its own unit.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/results/record_writers.hpp"
#include "coupling/analysis/ball_run.hpp"

namespace orbearing::app::ball_output_test {
namespace {

// All numbers differ, so that none can be mistaken for another.
analysis::BallRun distinct_study() {
  analysis::BallRun study;
  study.life_hours = 1.0;
  study.rotating_speed = 21e6 * 6.283185307179586 / 3600.0;  // 21e6 revolutions in that hour
  study.life_with_balls_hours = 2.0;
  study.dynamic_capacity = 3.0;
  study.radial_clearance = 4e-6;
  study.run.slip_settling = 5.0;
  study.run.pocket_load_max = 6.0;
  system::BallMeans& m = study.run.means;
  m.cage_slip = 0.07;
  m.cage_speed = 8.0;
  m.inner_load_rms = 9.0;
  m.outer_load_rms = 10.0;
  m.inner_load_max = 11.0;
  m.outer_load_max = 12.0;
  m.friction_torque = 13.0;
  m.inner_angle = 0.15;
  m.outer_angle = 0.16;
  m.inner_film = 17e-6;
  m.outer_film = 18e-6;
  m.life = {19e6, 20e6, 21e6};
  m.balls_life = 22e6;
  m.loss.sliding = 23.0;
  m.loss.differential = 24.0;
  m.loss.spin = 25.0;
  m.loss.rolling = 26.0;
  m.loss.damping = 27.0;
  m.loss.cage = 28.0;
  m.loss.churning = 29.0;
  return study;
}

Record record_of(const analysis::BallRun& study) {
  Record record;
  describe(record, study);
  return record;
}

TEST(BallOutput, HoldsEachNumberUnderItsKey) {
  const nlohmann::ordered_json found = json_of(record_of(distinct_study()));
  constexpr double round_off = 1e-12;
  const auto expect = [&](const char* pointer, double value) {
    EXPECT_NEAR(found.at(nlohmann::ordered_json::json_pointer(pointer)).get<double>() / value, 1.0, round_off)
        << pointer;
  };
  constexpr double degree = 0.017453292519943295, rpm = 0.10471975511965977;
  expect("/life_h", 1.0);
  expect("/life_with_balls_h", 2.0);
  expect("/dynamic_capacity_N", 3.0);
  expect("/running_clearance_um", 4.0);
  expect("/slip_settling_s", 5.0);
  expect("/cage_impact_max_N", 6.0);
  expect("/cage_slip", 0.07);
  expect("/cage_speed_rpm", 8.0 / rpm);
  expect("/inner/load_rms_N", 9.0);
  expect("/outer/load_rms_N", 10.0);
  expect("/inner/load_max_N", 11.0);
  expect("/outer/load_max_N", 12.0);
  expect("/friction_torque_N_mm", 13e3);
  expect("/inner/contact_angle_deg", 0.15 / degree);
  expect("/outer/contact_angle_deg", 0.16 / degree);
  expect("/inner/central_film_um", 17.0);
  expect("/outer/central_film_um", 18.0);
  expect("/inner/life_Mrev", 19.0);
  expect("/outer/life_Mrev", 20.0);
  expect("/life_Mrev", 21.0);
  expect("/balls_life_Mrev", 22.0);
  expect("/heat_W/sliding", 23.0);
  expect("/heat_W/differential_slip", 24.0);
  expect("/heat_W/spin", 25.0);
  expect("/heat_W/rolling", 26.0);
  expect("/heat_W/contact_damping", 27.0);
  expect("/heat_W/cage", 28.0);
  expect("/heat_W/churning", 29.0);
  expect("/heat_W/total", 23.0 + 24.0 + 25.0 + 26.0 + 27.0 + 28.0 + 29.0);
}

TEST(BallOutput, HoldsEachNumberUnderItsVariable) {
  analysis::BallRun study = distinct_study();
  system::BallSeries& s = study.run.series;
  using Values = std::vector<double>;
  s.time = {0.0, 1.0};
  s.cage_slip = {0.2, 0.3};
  s.cage_speed = {4.0, 5.0};
  s.inner_speed = {6.0, 7.0};
  s.cage_x = {8.0, 9.0};
  s.cage_y = {10.0, 11.0};
  s.pocket_load = {12.0, 13.0};
  s.torque = {14.0, 15.0};
  s.inner_x = {16.0, 17.0};
  s.inner_y = {18.0, 19.0};
  s.inner_z = {20.0, 21.0};
  s.first_angle = {22.0, 23.0};
  s.first_inner = {24.0, 25.0};
  s.first_outer = {26.0, 27.0};
  s.loss.resize(2);
  s.loss[1].cage = 28.0;
  s.loss[1].churning = 29.0;
  const PointContent content = content_of(record_of(study));
  const auto of = [&](const std::string& name) -> Values {
    for (const NamedArray& one : content.arrays)
      if (one.name == name) return one.values;
    ADD_FAILURE() << name << " is missing";
    return {};
  };
  EXPECT_EQ(of("cage_slip"), s.cage_slip);
  EXPECT_EQ(of("cage_speed"), s.cage_speed);
  EXPECT_EQ(of("inner_speed"), s.inner_speed);
  EXPECT_EQ(of("cage_x"), s.cage_x);
  EXPECT_EQ(of("cage_y"), s.cage_y);
  EXPECT_EQ(of("pocket_load"), s.pocket_load);
  EXPECT_EQ(of("friction_torque"), s.torque);
  EXPECT_EQ(of("inner_x"), s.inner_x);
  EXPECT_EQ(of("inner_y"), s.inner_y);
  EXPECT_EQ(of("inner_z"), s.inner_z);
  EXPECT_EQ(of("first_ball_angle"), s.first_angle);
  EXPECT_EQ(of("first_ball_inner_load"), s.first_inner);
  EXPECT_EQ(of("first_ball_outer_load"), s.first_outer);
  EXPECT_EQ(of("heat_cage"), (Values{0.0, 28.0}));
  EXPECT_EQ(of("heat_churning"), (Values{0.0, 29.0}));
  EXPECT_DOUBLE_EQ(of("life").at(0), 1.0);
  EXPECT_EQ(of("life_with_balls"), (Values{2.0}));
  EXPECT_EQ(of("mean_cage_slip"), (Values{0.07}));
  EXPECT_EQ(of("slip_settling"), (Values{5.0}));
  EXPECT_EQ(of("cage_impact_max"), (Values{6.0}));
}

}  // namespace
}  // namespace orbearing::app::ball_output_test
