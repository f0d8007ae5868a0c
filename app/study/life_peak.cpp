#include "app/study/life_peak.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/study/drivetrain_case.hpp"
#include "app/units.hpp"
#include "coupling/study/peak.hpp"

namespace orbearing::app {

namespace {

// A point of the axis of speed that runs through the best point.
struct AxisPoint {
  std::size_t row = 0;
  double speed = 0.0;   // [rad/s]
  double life_h = 0.0;  // [h]
};

std::size_t point_of_row(const SweepOutcome& outcome, std::size_t row) {
  const auto& shard = outcome.header.shard;
  return shard ? row * shard->count + shard->index - 1 : row;
}

std::vector<Setting> without_speed(std::vector<Setting> settings) {
  std::erase_if(settings, [](const Setting& setting) { return setting.first == kSpeedPath; });
  return settings;
}

// Rows that differ from row `best` in speed alone and have a life, in ascending order of speed.
std::vector<AxisPoint> axis_through(const ResolvedCase& resolved, const SweepOutcome& outcome,
                                    std::size_t best) {
  const std::vector<Setting> others = without_speed(sweep_point(resolved, point_of_row(outcome, best)));
  std::vector<AxisPoint> axis;
  for (std::size_t row = 0; row < outcome.rows.size(); ++row) {
    const double life = value_of(outcome.head, outcome.rows[row], "life_h");
    if (!(life > 0.0) || without_speed(sweep_point(resolved, point_of_row(outcome, row))) != others) continue;
    const double rpm = value_of(outcome.head, outcome.rows[row], "input_speed_rpm");
    axis.push_back({row, rpm * kRadiansPerSecond, life});
  }
  std::sort(axis.begin(), axis.end(),
            [](const AxisPoint& a, const AxisPoint& b) { return a.speed < b.speed; });
  return axis;
}

// The best point and its neighbours.
std::vector<AxisPoint> around(const std::vector<AxisPoint>& axis, std::size_t best_row) {
  const auto best =
      std::find_if(axis.begin(), axis.end(), [&](const AxisPoint& p) { return p.row == best_row; });
  return {best == axis.begin() ? best : best - 1, best + 1 == axis.end() ? best + 1 : best + 2};
}

// Lagrange's polynomial through (x_i, y_i).
double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double weight = 1.0;
    for (std::size_t j = 0; j < x.size(); ++j)
      if (j != i) weight *= (at - x[j]) / (x[i] - x[j]);
    sum += weight * y[i];
  }
  return sum;
}

// Between grid points life follows the quasi-static model, lifted by the ratio of the rows to it: smooth
// where a dynamic life holds the scatter of its run, and the quasi-static life itself where the rows are
// quasi-static.
std::function<double(double)> continuous_life(const ResolvedCase& at_best,
                                              const std::vector<AxisPoint>& near) {
  const std::vector<study::NamedSet> sets = bearing_sets(at_best);
  const auto quasi_static = [sets](double speed) {
    return study::evaluate(study::at_speed(sets, speed)).life_hours;
  };
  std::vector<double> log_speed;
  std::vector<double> log_ratio;
  for (const AxisPoint& point : near) {
    log_speed.push_back(std::log(point.speed));
    log_ratio.push_back(std::log(point.life_h / quasi_static(point.speed)));
  }
  return [=](double speed) {
    return quasi_static(speed) * std::exp(interpolate(log_speed, log_ratio, std::log(speed)));
  };
}

void refine(const ResolvedCase& at_best, const std::vector<AxisPoint>& near, FoundPeak& found) {
  const study::Extremum best =
      study::largest(continuous_life(at_best, near), near.front().speed, near.back().speed);
  // At an end of the range, or where the search could not better the grid, the grid's own point stands.
  const bool better = best.inside && best.value > found.peak.life_h;
  found.peak.refined_speed_rpm = better ? best.speed / kRadiansPerSecond : found.peak.speed_rpm;
  found.peak.refined_life_h = better ? best.value : found.peak.life_h;
  if (!best.inside)
    found.warnings.push_back(
        "sweep.input.speed: life still rises at the end of the swept range; widen it to find the peak");
}

}  // namespace

FoundPeak find_peak(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  FoundPeak found{.peak = grid_peak(outcome.head, outcome.rows)};
  const bool speed_swept = std::any_of(resolved.axes().begin(), resolved.axes().end(),
                                       [](const SweepAxis& axis) { return axis.path == kSpeedPath; });
  if (!speed_swept || !(found.peak.life_h > 0.0)) return found;
  std::size_t best_row = 0;
  while (value_of(outcome.head, outcome.rows[best_row], "life_h") != found.peak.life_h) ++best_row;
  const ResolvedCase at_best = resolved.with(sweep_point(resolved, point_of_row(outcome, best_row)));
  const std::vector<AxisPoint> near = around(axis_through(resolved, outcome, best_row), best_row);
  if (near.size() > 1) refine(at_best, near, found);
  return found;
}

}  // namespace orbearing::app
