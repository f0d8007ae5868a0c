#include "coupling/analysis/peak_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbearing::analysis {

namespace {

constexpr double kMotionResolution = 10.0;      // [rpm]
constexpr double kQuasiStaticResolution = 2.0;  // [rpm]
constexpr double kMotionShare = 1.0 / 200.0;    // of the speed, below 2000 rpm
constexpr double kQuasiStaticShare = 1.0 / 1000.0;
// A resonance of damping ratio 0.02 or more reduces the life over at least 4 % of its speed: steps of a
// fortieth of the speed cannot miss a maximum between two such dips.
constexpr double kScanStep = 1.0 / 40.0;
// Between two computed speeds life rises by no more than this power of speed: L10 in hours grows with v^(7/3)
// where the load falls as 1 / v; the flanks of dips are steeper, but short.
constexpr double kSteepestRise = 3.5;
// A resonance this near to a computed point [of its speed] is resolved already.
constexpr double kSeen = 1.0 / 80.0;
// A hill whose parabola would top the best point by less is no rival: single points in motion scatter by
// more.
constexpr double kRival = 1e-3;
// Nor is one, in motion, whose neighbours are nearer than this [of its speed]: the points resolve no
// parabola.
constexpr double kRivalStep = 1.0 / 160.0;

struct SpeedGap {
  const LivedSpeed& low;
  const LivedSpeed& high;
  double width() const { return high.rpm - low.rpm; }
  double middle() const { return 0.5 * (low.rpm + high.rpm); }
};

SpeedGap gap_above(const SpeedLine& axis, std::size_t i) {
  return {axis[i], axis[i + 1]};
}

// Speeds have few digits, so that a case with the speed as printed is exactly that point.
double short_speed(double rpm, double resolution) {
  const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(0.5 * resolution))));
  const double parts = std::pow(10.0, digits);  // whole: the quotient is the double nearest to the few digits
  return std::round(rpm * parts) / parts;
}

// Splits a gap unless rounding leaves it no middle.
void halve(const SpeedGap& gap, const PeakSearch& search, std::vector<double>& speeds) {
  const double middle = short_speed(gap.middle(), peak_resolution(gap.middle(), search.in_motion));
  if (middle > gap.low.rpm && middle < gap.high.rpm) speeds.push_back(middle);
}

std::vector<double> unseen_resonances(const SpeedLine& axis, const PeakSearch& search) {
  std::vector<double> speeds;
  std::vector<double> resonances = search.resonances_rpm;
  std::sort(resonances.begin(), resonances.end());
  const auto seen = [&](double rpm) {
    const auto near = [&](double other) { return std::abs(other - rpm) <= kSeen * rpm; };
    return std::any_of(axis.begin(), axis.end(), [&](const LivedSpeed& point) { return near(point.rpm); }) ||
           std::any_of(speeds.begin(), speeds.end(), near);
  };
  for (const double rpm : resonances)
    if (rpm > axis.front().rpm && rpm < axis.back().rpm && !seen(rpm))
      speeds.push_back(short_speed(rpm, peak_resolution(rpm, true)));
  return speeds;
}

// Gaps in which life could rise above the best: as far as the steepest rise from their higher end goes.
std::vector<double> unseen_stretches(const SpeedLine& axis, const PeakSearch& search) {
  std::vector<double> speeds;
  const double best = axis[position_of_longest_life(axis)].life_h;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const SpeedGap gap = gap_above(axis, i);
    const double share = gap.width() / gap.middle();
    const double higher = std::max(gap.low.life_h, gap.high.life_h);
    if (share > kScanStep && higher * (1.0 + kSteepestRise * share) >= best) halve(gap, search, speeds);
  }
  return speeds;
}

// Logarithm of the life at the top of the parabola through a point and its neighbours.
double log_top(const LivedSpeed& low, const LivedSpeed& middle, const LivedSpeed& high) {
  const double left = low.rpm - middle.rpm, right = high.rpm - middle.rpm;
  const double fall_left = std::log(low.life_h / middle.life_h),
               fall_right = std::log(high.life_h / middle.life_h);
  const double curvature = (fall_right / right - fall_left / left) / (right - left);
  const double slope = fall_left / left - curvature * left;
  const double rise = curvature < 0.0 ? -slope * slope / (4.0 * curvature) : 0.0;
  return std::log(middle.life_h) + rise;
}

bool is_rival(const SpeedLine& axis, std::size_t i, double best) {
  const LivedSpeed &low = axis[i - 1], &middle = axis[i], &high = axis[i + 1];
  if (!(low.life_h > 0.0 && high.life_h > 0.0)) return false;
  if (middle.life_h < low.life_h || middle.life_h < high.life_h) return false;
  return log_top(low, middle, high) > std::log(best) + kRival;
}

// Both gaps beside the best point, and beside each other hill whose top may be higher.
std::vector<double> beside_hills(const SpeedLine& axis, const PeakSearch& search) {
  const std::size_t best = position_of_longest_life(axis);
  // Widths [rpm] to which the gaps are to be brought.
  std::vector<double> wanted(axis.size() - 1, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const bool inside = i > 0 && i + 1 < axis.size();
    if (i != best && !(inside && is_rival(axis, i, axis[best].life_h))) continue;
    const double resolution = peak_resolution(axis[i].rpm, search.in_motion);
    const double width =
        i != best && search.in_motion ? std::max(resolution, kRivalStep * axis[i].rpm) : resolution;
    if (i > 0) wanted[i - 1] = std::min(wanted[i - 1], width);
    if (inside || i == 0) wanted[i] = std::min(wanted[i], width);
  }
  std::vector<double> speeds;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (gap_above(axis, i).width() > wanted[i]) halve(gap_above(axis, i), search, speeds);
  return speeds;
}

}  // namespace

std::size_t position_of_longest_life(const SpeedLine& axis) {
  return static_cast<std::size_t>(std::ranges::max_element(axis, {}, &LivedSpeed::life_h) - axis.begin());
}

double peak_resolution(double rpm, bool in_motion) {
  return in_motion ? std::min(kMotionResolution, kMotionShare * rpm)
                   : std::min(kQuasiStaticResolution, kQuasiStaticShare * rpm);
}

std::vector<double> next_speeds(const std::vector<LivedSpeed>& done, const PeakSearch& search) {
  if (done.size() < 2 || !(done[position_of_longest_life(done)].life_h > 0.0)) return {};
  std::vector<double> speeds;
  if (search.in_motion) speeds = unseen_resonances(done, search);
  if (search.in_motion && speeds.empty()) speeds = unseen_stretches(done, search);
  if (speeds.empty()) speeds = beside_hills(done, search);
  return speeds;
}

}  // namespace orbearing::analysis
