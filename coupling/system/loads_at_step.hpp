// Loads of the state from which a step begins; they count for half the step before and half the one after.
#pragma once

#include <algorithm>
#include <vector>

#include "bearing/life/damage.hpp"
#include "bearing/motion/statistics.hpp"
#include "bearing/motion/vector_bearing.hpp"

namespace orbearing::system {

struct LoadsAtStep {
  std::vector<double> angle, orbital_speed, inner, outer;                // [rad], [rad/s], [N]  (rollers)
  std::vector<double> inner_approach, outer_approach, end_displacement;  // [m]  (rollers) or none
  const bearing::motion::LaminaRaces* laminae = nullptr;                 // where they are counted one by one
  bearing::motion::RaceSpeeds races;
  bearing::motion::BorePort port;
  double step_before = 0.0;                                   // [s]
  bearing::motion::StatisticsCollector* collector = nullptr;  // gets them, where there is one

  explicit LoadsAtStep(int rollers)
      : angle(static_cast<std::size_t>(rollers)), orbital_speed(angle), inner(angle), outer(angle) {}

  void take(const bearing::motion::RollerLoads& loads) {
    std::copy_n(loads.angle, angle.size(), angle.begin());
    std::copy_n(loads.orbital_speed, angle.size(), orbital_speed.begin());
    std::copy_n(loads.inner, inner.size(), inner.begin());
    std::copy_n(loads.outer, outer.size(), outer.begin());
    races = loads.races;
    laminae = uneven_laminae(loads.laminae) > 0 ? loads.laminae : nullptr;
    if (!laminae) return;
    inner_approach.assign(loads.inner_approach, loads.inner_approach + angle.size());
    outer_approach.assign(loads.outer_approach, loads.outer_approach + angle.size());
    end_displacement.assign(loads.end_displacement, loads.end_displacement + angle.size());
  }
  /// Those of the padded state `x`, at which `bearing` was evaluated last.
  void take(const bearing::vectorised::VectorBearing& bearing, const double* x) {
    const int lanes = bearing.layout().lanes();
    const bearing::vectorised::ContactLoads loads = bearing.loads();
    const bearing::vectorised::Surroundings& now = bearing.surroundings();
    const bearing::motion::RaceSpeeds speeds =
        bearing::motion::race_speeds(bearing.model().geometry, now.pin.speed, now.bore.speed);
    const double* velocity = x + bearing.layout().bore() + 2;
    port = bearing::motion::bore_port(bearing.reaction(), now.bore.speed, {velocity[0], velocity[1]});
    take({x + lanes, x + 3 * lanes, loads.inner, loads.outer, speeds, cut_races(bearing.model()),
          loads.inner_approach, loads.outer_approach, loads.end_displacement});
  }

  /// Valid until the next are taken.
  bearing::motion::RollerLoads loads() const {
    return {angle.data(), orbital_speed.data(),  inner.data(),          outer.data(),           races,
            laminae,      inner_approach.data(), outer_approach.data(), end_displacement.data()};
  }
  /// A step of `length` [s] begins: the loads go to the collector and into `sums`, where there are any.
  /// @return how long they count [s]
  double count(double length, bearing::motion::DamageSums* sums = nullptr) {
    const double time = 0.5 * (step_before + length);
    step_before = length;
    if (collector) {
      collector->add_loads(time, loads(), sums);
      collector->add_bore(time, port);
    } else if (sums) {
      sums->add(time, static_cast<Eigen::Index>(angle.size()), loads());
    }
    return time;
  }
};

}  // namespace orbearing::system
