#include "bearing/motion/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace orbearing::bearing::motion {

PowerLoss& operator+=(PowerLoss& sum, const PowerLoss& other) {
  sum.race_damping += other.race_damping;
  sum.inner_traction += other.inner_traction;
  sum.outer_traction += other.outer_traction;
  sum.rolling += other.rolling;
  sum.drag += other.drag;
  sum.pockets += other.pockets;
  sum.neighbours += other.neighbours;
  sum.guidance += other.guidance;
  sum.support += other.support;
  return sum;
}

PowerLoss operator/(const PowerLoss& loss, double by) {
  return {.race_damping = loss.race_damping / by,
          .inner_traction = loss.inner_traction / by,
          .outer_traction = loss.outer_traction / by,
          .rolling = loss.rolling / by,
          .drag = loss.drag / by,
          .pockets = loss.pockets / by,
          .neighbours = loss.neighbours / by,
          .guidance = loss.guidance / by,
          .support = loss.support / by};
}

StatisticsCollector::StatisticsCollector(Eigen::Index rollers, Eigen::Index bins, Eigen::Index laminae)
    : rollers_(rollers), bins_(bins), laminae_(laminae), damage_(bins, laminae) {}

void StatisticsCollector::begin(double time, const Snapshot& at_start) {
  for (RaceSums* sums : {&inner_, &outer_})
    *sums = {.roller_square = Eigen::ArrayXd::Zero(rollers_),
             .least_film = std::numeric_limits<double>::infinity()};
  damage_ = DamageSums(bins_, laminae_);
  weight_ = 0.0;
  bore_ = {};
  sums_ = {};
  begin_time_ = time;
  begin_orbit_angle_ = end_orbit_angle_ = at_start.orbit_angle;
}

void StatisticsCollector::add_loads(double weight, const RollerLoads& loads, DamageSums* other) {
  const auto add_race = [&](const double* load, RaceSums& sums) {
    for (Eigen::Index j = 0; j < rollers_; ++j) {
      sums.roller_square[j] += weight * load[j] * load[j];
      sums.largest = std::max(sums.largest, load[j]);
    }
  };
  add_race(loads.inner, inner_);
  add_race(loads.outer, outer_);
  damage_.add(weight, rollers_, loads, other);
  weight_ += weight;
}

void StatisticsCollector::add_state(const RaceSnapshot& race, RaceSums& sums) {
  Eigen::Index most_loaded = 0;
  race.load.maxCoeff(&most_loaded);
  sums.sliding += race.sliding.abs().mean();
  sums.least_film = std::min(sums.least_film, race.least_film[most_loaded]);
}

void StatisticsCollector::add_state(double time, const Snapshot& sample) {
  add_state(sample.inner, inner_);
  add_state(sample.outer, outer_);
  ++sums_.samples;
  sums_.duration = time - begin_time_;
  end_orbit_angle_ = sample.orbit_angle;
  sums_.mean_spin += sample.spin.mean();
  sums_.mean_cage_eccentricity += sample.cage_eccentricity;
  sums_.largest_cage_eccentricity = std::max(sums_.largest_cage_eccentricity, sample.cage_eccentricity);
  sums_.mean_cage_position += sample.cage_position;
  sums_.loss += sample.loss;
  if (sums_.mean_waves.size() == 0)
    sums_.mean_waves = sample.waves;
  else
    sums_.mean_waves += sample.waves;
}

void StatisticsCollector::add_bore(double weight, const BorePort& port) {
  bore_.weight += weight;
  bore_.speed += weight * port.speed;
  bore_.moment += weight * port.moment;
  bore_.power += weight * (port.moment * port.speed + port.travel);
}

void StatisticsCollector::add(double time, const Snapshot& sample) {
  add_loads(1.0, loads_of(sample));
  add_bore(1.0, sample.port);
  add_state(time, sample);
}

RaceStatistics StatisticsCollector::means(const RaceSums& sums, const RacePassages& passages) const {
  const double samples = static_cast<double>(sums_.samples);
  return {.roller_rms = (sums.roller_square / weight_).sqrt(),
          .load_rms = std::sqrt(sums.roller_square.mean() / weight_),
          .load_max = sums.largest,
          .mean_load = passages.mean_load(),
          .passages = passages.passages(),
          .damage = passages.damage(),
          .lamina_damage = passages.lamina_damage(),
          .lamina_load_max = passages.lamina_largest,
          .mean_sliding = sums.sliding / samples,
          .least_film = sums.least_film};
}

WindowStatistics StatisticsCollector::means() const {
  assert(sums_.samples > 0);
  const double samples = static_cast<double>(sums_.samples);
  WindowStatistics result = sums_;
  result.inner = means(inner_, damage_.inner);
  result.outer = means(outer_, damage_.outer);
  result.orbit_speed = (end_orbit_angle_ - begin_orbit_angle_) / sums_.duration;
  result.mean_spin /= samples;
  result.mean_cage_eccentricity /= samples;
  result.mean_cage_position /= samples;
  if (bore_.weight > 0.0) {
    result.bore_friction_moment = bore_.moment / bore_.weight;
    result.vibration_power =
        result.bore_friction_moment * bore_.speed / bore_.weight - bore_.power / bore_.weight;
  }
  result.loss = sums_.loss / samples;
  result.mean_waves /= samples;
  return result;
}

RaceDamageView damage_of(const RaceStatistics& race) {
  return {race.damage, race.lamina_damage};
}

}  // namespace orbearing::bearing::motion
