// A ball bearing run in time: slip, heat, impacts of the cage, life.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bearing/equilibrium/ring_axes.hpp"
#include "coupling/analysis/bearing_friction.hpp"
#include "coupling/analysis/life_table.hpp"
#include "coupling/analysis/single_bearing.hpp"
#include "coupling/system/heated_balls.hpp"

namespace orbearing::analysis {

/// Results of a run and what belongs to them.
struct BallRun {
  system::BallRunResult run;
  std::vector<system::WarmState> warming;  // from cold to steady; empty where temperatures are stated
  double life_hours = 0.0;                 // [h]      of the bearing at the speed of the end
  double life_with_balls_hours = 0.0;      // [h]   where its balls may fail too, Eq. (35) of [Chen2026]
  double dynamic_capacity = 0.0;           // [N]
  bearing::rating::RatingLives lives;      // by the standards, of loads averaged over time
  double rotating_speed = 0.0;             // [rad/s]  at the end, of the race that turns relative to the load
  double largest_pressure = 0.0;           // [Pa]
  double radial_clearance = 0.0;           // [m]      at the temperatures of the run
  std::optional<double> oil_share;         // [-]      in the free volume; none where nothing is stirred
  /// Stiffness of the equilibrium under the same load at the final speeds, as orbearing stiffness computes
  /// it; none where there is no equilibrium.
  std::optional<bearing::equilibrium::RingStiffness> stiffness;
  std::optional<FrictionByStandards> friction_by_standards;  // none without boundary dimensions
  bearing::rating::Life governing{};
  std::vector<std::string> warnings;

  BearingLives all_lives() const { return {lives, run.means.life.bearing, rotating_speed, largest_pressure}; }
  LifeTable life_table() const {
    return {value_by_name(all_lives()), {bearing::rating::RollingElement::ball, 0.0, governing}};
  }
};

/// Speeds of the rings, and the load on the inner one, its radial part along x. With an acceleration of the
/// shaft the inner ring starts from rest.
bearing::balls::BallDuty ball_duty(const BallsInTime& in);

void describe(described::Record& record, const BallRun& result);

/// `progress` gets the share done [-], if any. Throws NoResult where the run ends early.
BallRun run_of_balls(const BallsInTime& in, const std::function<void(double)>& progress = {});

}  // namespace orbearing::analysis
