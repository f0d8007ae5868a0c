#include "bearing/dynamics/statistics.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cassert>
#include <cmath>
#include <limits>

namespace orbearing::bearing::dynamics {

using boost::math::double_constants::two_pi;

Eigen::Index place_of(double angle, Eigen::Index places) {
  const double turns = angle / two_pi + 0.5 / static_cast<double>(places);
  const auto place = static_cast<Eigen::Index>((turns - std::floor(turns)) * static_cast<double>(places));
  return std::min(place, places - 1);
}

PowerLoss& operator+=(PowerLoss& sum, const PowerLoss& other) {
  sum.race_damping += other.race_damping;
  sum.inner_traction += other.inner_traction;
  sum.outer_traction += other.outer_traction;
  sum.rolling += other.rolling;
  sum.drag += other.drag;
  sum.pockets += other.pockets;
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
          .guidance = loss.guidance / by,
          .support = loss.support / by};
}

StatisticsCollector::StatisticsCollector(Eigen::Index rollers, Eigen::Index places)
    : rollers_(rollers), places_(places) {}

void StatisticsCollector::begin(double time, const Snapshot& at_start) {
  for (RaceSums* sums : {&inner_, &outer_})
    *sums = {.roller_square = Eigen::ArrayXd::Zero(rollers_),
             .load = Eigen::ArrayXd::Zero(places_),
             .fourth_power = Eigen::ArrayXd::Zero(places_),
             .least_film = std::numeric_limits<double>::infinity()};
  passages_ = Eigen::ArrayXd::Zero(places_);
  weight_ = 0.0;
  sums_ = {};
  begin_time_ = time;
  begin_cage_angle_ = end_cage_angle_ = at_start.cage_angle;
}

void StatisticsCollector::add_loads(double weight, const double* angle, const double* inner,
                                    const double* outer) {
  for (Eigen::Index j = 0; j < rollers_; ++j) {
    const Eigen::Index place = place_of(angle[j], places_);
    passages_[place] += weight;
    const auto add_race = [&](double load, RaceSums& sums) {
      const double square = load * load;
      sums.roller_square[j] += weight * square;
      sums.load[place] += weight * load;
      sums.fourth_power[place] += weight * square * square;
      sums.largest = std::max(sums.largest, load);
    };
    add_race(inner[j], inner_);
    add_race(outer[j], outer_);
  }
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
  end_cage_angle_ = sample.cage_angle;
  sums_.mean_spin += sample.spin.mean();
  sums_.mean_cage_eccentricity += sample.cage_eccentricity;
  sums_.largest_cage_eccentricity = std::max(sums_.largest_cage_eccentricity, sample.cage_eccentricity);
  sums_.mean_cage_position += sample.cage_position;
  sums_.bore_friction_moment += sample.bore_friction_moment;
  sums_.loss += sample.loss;
}

void StatisticsCollector::add(double time, const Snapshot& sample) {
  add_loads(1.0, sample.angle.data(), sample.inner.load.data(), sample.outer.load.data());
  add_state(time, sample);
}

RaceStatistics StatisticsCollector::means(const RaceSums& sums) const {
  const double samples = static_cast<double>(sums_.samples);
  // A place without a passage has no load: zero over anything.
  const Eigen::ArrayXd passages = (passages_ > 0.0).select(passages_, 1.0);
  return {.roller_rms = (sums.roller_square / weight_).sqrt(),
          .load_rms = std::sqrt(sums.roller_square.mean() / weight_),
          .load_max = sums.largest,
          .mean_load = sums.load / passages,
          .mean_fourth_power = sums.fourth_power / passages,
          .mean_sliding = sums.sliding / samples,
          .least_film = sums.least_film};
}

WindowStatistics StatisticsCollector::means() const {
  assert(sums_.samples > 0);
  const double samples = static_cast<double>(sums_.samples);
  WindowStatistics result = sums_;
  result.inner = means(inner_);
  result.outer = means(outer_);
  result.cage_speed = (end_cage_angle_ - begin_cage_angle_) / sums_.duration;
  result.mean_spin /= samples;
  result.mean_cage_eccentricity /= samples;
  result.mean_cage_position /= samples;
  result.bore_friction_moment /= samples;
  result.loss = sums_.loss / samples;
  return result;
}

double equivalent_load(const RaceStatistics& race, RaceMotion motion) {
  const double largest = race.mean_fourth_power.maxCoeff();
  if (largest <= 0.0) return 0.0;
  const double exponent = motion == RaceMotion::turning ? 4.0 : 4.5;
  const double mean = (race.mean_fourth_power / largest).pow(exponent / 4.0).mean();
  return std::pow(largest, 0.25) * std::pow(mean, 1.0 / exponent);
}

BearingLife dynamic_life(const CylindricalRollerBearing& bearing, double lambda, Race standing,
                         const WindowStatistics& statistics) {
  const auto life_of = [&](Race race, const RaceStatistics& loads) {
    const RaceMotion motion = race == standing ? RaceMotion::standing : RaceMotion::turning;
    return race_life(contact_capacity(bearing, race, lambda), equivalent_load(loads, motion));
  };
  const double inner = life_of(Race::inner, statistics.inner);
  const double outer = life_of(Race::outer, statistics.outer);
  return {inner, outer, combined_life(inner, outer)};
}

}  // namespace orbearing::bearing::dynamics
