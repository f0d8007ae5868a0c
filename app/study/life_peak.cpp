#include "app/study/life_peak.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

#include "app/case/bearing_type.hpp"
#include "app/results/life_table.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/sweep_table.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/resonance_lines.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

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

using SpeedLine = std::vector<LivedSpeed>;  // ascending

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

std::size_t best_position(const SpeedLine& axis) {
  return static_cast<std::size_t>(std::ranges::max_element(axis, {}, &LivedSpeed::life_h) - axis.begin());
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
  const double best = axis[best_position(axis)].life_h;
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
  const std::size_t best = best_position(axis);
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

double peak_resolution(double rpm, bool in_motion) {
  return in_motion ? std::min(kMotionResolution, kMotionShare * rpm)
                   : std::min(kQuasiStaticResolution, kQuasiStaticShare * rpm);
}

std::vector<double> next_speeds(const std::vector<LivedSpeed>& done, const PeakSearch& search) {
  if (done.size() < 2 || !(done[best_position(done)].life_h > 0.0)) return {};
  std::vector<double> speeds;
  if (search.in_motion) speeds = unseen_resonances(done, search);
  if (search.in_motion && speeds.empty()) speeds = unseen_stretches(done, search);
  if (speeds.empty()) speeds = beside_hills(done, search);
  return speeds;
}

namespace {

constexpr const char* kRangeOfSpeeds = "sweep.input.speed: ";

void put_refined(const SpeedLine& line, std::size_t best, LifePeak& peak) {
  peak.refined_speed_rpm = line[best].rpm;
  peak.refined_life_h = line[best].life_h;
  if (best > 0) peak.lower_rpm = line[best - 1].rpm;
  if (best + 1 < line.size()) peak.upper_rpm = line[best + 1].rpm;
}

void warn_of_ends(const SpeedLine& line, std::size_t best, std::vector<std::string>& warnings) {
  if (best == 0)
    warnings.push_back(fmt::format(
        "{}life decreases from the lowest swept speed, {:g} rpm, on; sweep lower speeds to find the peak",
        kRangeOfSpeeds, line[best].rpm));
  else if (best + 1 == line.size())
    warnings.push_back(fmt::format(
        "{}life still increases at the highest swept speed, {:g} rpm; sweep higher speeds to find the peak",
        kRangeOfSpeeds, line[best].rpm));
}

void warn_of_neighbours(const SpeedLine& line, std::size_t best, bool in_motion,
                        std::vector<std::string>& warnings) {
  const double peak_rpm = line[best].rpm, resolution = peak_resolution(peak_rpm, in_motion);
  const auto look_at = [&](const LivedSpeed& neighbour) {
    if (!(neighbour.life_h > 0.0))
      warnings.push_back(fmt::format(
          "peak: the neighbouring point, at {:g} rpm, failed; life may rise further there", neighbour.rpm));
    // Speeds are requested in whole digits, so that halves may differ by one.
    if (std::abs(neighbour.rpm - peak_rpm) > 1.5 * resolution)
      warnings.push_back(
          fmt::format("peak: its speed, {:g} rpm, is known no better than to the next computed "
                      "point, {:g} rpm",
                      peak_rpm, neighbour.rpm));
  };
  if (best > 0) look_at(line[best - 1]);
  if (best + 1 < line.size()) look_at(line[best + 1]);
}

// Warning for a sweep with more axes than speed: the one line on which points were added.
void warn_of_other_lines(const SweepOutcome& outcome, const SweepRow& best,
                         std::vector<std::string>& warnings) {
  std::string position;
  for (std::size_t i = 0; i < outcome.header.axes.size(); ++i)
    position += fmt::format("{}{} = {:.10g}", position.empty() ? "" : ", ", outcome.header.axes[i].column,
                            best.axes[i]);
  if (!position.empty())
    warnings.push_back("peak: refined on the line of speeds through the grid's best point only, at " +
                       position);
}

// The rows that differ from `row` in speed alone, ascending in speed; those that failed have no life.
SpeedLine line_through(const ManifestHeader& header, const std::vector<SweepRow>& rows, const SweepRow& row) {
  SpeedLine line;
  for (const SweepRow& other : rows) {
    if (!on_one_line(row, other)) continue;
    const double life = governing_hours(header, other.point);
    line.push_back({speed_in_rpm(other.point.input_speed), life > 0.0 ? life : 0.0});
  }
  std::ranges::stable_sort(line, {}, &LivedSpeed::rpm);
  return line;
}

}  // namespace

FoundPeak find_peak(const SweepOutcome& outcome) {
  FoundPeak found{.peak = grid_peak(outcome.header, outcome.rows)};
  const ManifestHeader& header = outcome.header;
  // A shard's best point is not the sweep's.
  if (!(found.peak.life_h > 0.0) || header.shard) return found;
  const SweepRow& of_grid = *longest_lived(header, outcome.rows, true);
  const SpeedLine line = line_through(header, outcome.rows, of_grid);
  if (line.size() < 2) return found;
  const std::size_t best = best_position(line);
  warn_of_ends(line, best, found.warnings);
  if (header.continued)
    found.warnings.push_back("peak: from the grid points only; a continued sweep adds no points around it");
  if (!header.refined) return found;
  put_refined(line, best, found.peak);
  warn_of_neighbours(line, best, in_time(fidelity_of(header.fidelity)), found.warnings);
  warn_of_other_lines(outcome, of_grid, found.warnings);
  return found;
}

namespace {

LifeWords words_of(const ResolvedCase& in) {
  const bool balls = bearing_type_of(in) == bearing::PlanetBearingType::deep_groove_ball;
  return {balls ? bearing::rating::RollingElement::ball : bearing::rating::RollingElement::roller,
          in.has("life.reduction_factor") ? in.number("life.reduction_factor") : 0.0, governing_life(in)};
}

LifeTable table_at(const SweepOutcome& outcome, const SweepRow& row, const ResolvedCase& in) {
  return {[&](const std::string& name) { return number_named(outcome.header, row, name); }, words_of(in)};
}

// Result of the worst planet bearing, where the carrier is a body.
std::string carrier_text(const ManifestHeader& header, const std::optional<study::CarrierNumbers>& carrier) {
  if (!carrier) return "";
  return fmt::format(
      "worst planet bearing over a revolution of the carrier: {:.4g} of the load shared evenly, {} {:.6g} "
      "h\n",
      carrier->load_share, header.life, governing_hours(header, carrier->life_hours, carrier->rated_hours));
}

}  // namespace

std::string lives_text_of(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  const SweepRow* row = longest_lived(outcome.header, outcome.rows);
  if (row == nullptr) return "";
  const std::string of_set =
      row->point.limiting_set.empty() ? "" : fmt::format("set {}:\n", row->point.limiting_set);
  const std::string table = sets_table(outcome.header, *row) +
                            carrier_text(outcome.header, row->point.carrier) + of_set +
                            lives_text(table_at(outcome, *row, resolved));
  if (outcome.rows.size() == 1) return table + "\n";
  return fmt::format("at {:.6g} rpm, where {} is longest:\n{}\n", speed_in_rpm(row->point.input_speed),
                     outcome.header.life, table);
}

nlohmann::ordered_json lives_record_of(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  const SweepRow* row = longest_lived(outcome.header, outcome.rows);
  if (row == nullptr) return nullptr;
  Record record;
  describe(record, table_at(outcome, *row, resolved));
  record.value("speed_rpm", {}, "of the point", speed_in_rpm(row->point.input_speed));
  record.value("life_key", "life that results go by", outcome.header.life);
  return json_of(record);
}

namespace {

// With more added points than this a search is stopped; the result then states the resolution of the peak. No
// known curve needed a quarter of them.
constexpr std::size_t kMostAdded = 400;

PeakSearch search_on_line(bool in_motion, const std::vector<Resonance>& resonances) {
  PeakSearch search{.in_motion = in_motion};
  for (const Resonance& resonance : resonances)
    search.resonances_rpm.push_back(speed_in_rpm(resonance.speed));
  return search;
}

}  // namespace

void refine_peak_of(const ResolvedCase& resolved, SweepRequest& request) {
  const std::vector<double> speeds = speeds_rpm(resolved);
  const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
  if (*low == *high) return;
  const study::Fidelity fidelity = fidelity_of(request.header.fidelity);
  const bool dips = request.header.resonances;
  const ResonancesOfLine resonances = dips ? resonances_by_line(resolved) : nullptr;
  request.header.refined = true;
  request.refinement = Refinement{
      [resolved, resonances, fidelity, header = request.header](const std::vector<SweepRow>& rows) {
        std::vector<SweepPoint> added;
        const std::size_t points = header.grid();
        const SweepRow* best = longest_lived(header, std::span(rows).first(points));
        if (best == nullptr || rows.size() - points >= kMostAdded) return added;
        const std::vector<Setting> line = sweep_point(resolved, static_cast<std::size_t>(best - rows.data()));
        const PeakSearch search =
            search_on_line(in_time(fidelity), resonances ? resonances(line) : std::vector<Resonance>{});
        for (const double rpm : next_speeds(line_through(header, rows, *best), search))
          added.push_back(point_at_rpm(resolved, line, rpm));
        return added;
      },
      [resolved, fidelity](const SweepPoint& point) {
        return compute_point(resolved, point.settings, fidelity);
      }};
}

}  // namespace orbearing::app
