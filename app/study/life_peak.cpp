#include "app/study/life_peak.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/study/fidelity.hpp"

namespace orbearing::app {

namespace {

constexpr const char* kRangeOfSpeeds = "sweep.input.speed: ";

using SpeedLine = std::vector<LivedSpeed>;

SpeedLine::const_iterator longest_lived(const SpeedLine& line) {
  return std::max_element(line.begin(), line.end(), [](const LivedSpeed& one, const LivedSpeed& other) {
    return one.life_h < other.life_h;
  });
}

void put_refined(const SpeedLine& line, LifePeak& peak) {
  const auto best = longest_lived(line);
  peak.refined_speed_rpm = best->rpm;
  peak.refined_life_h = best->life_h;
  if (best != line.begin()) peak.lower_rpm = (best - 1)->rpm;
  if (best + 1 != line.end()) peak.upper_rpm = (best + 1)->rpm;
}

void warn_of_ends(const SpeedLine& line, std::vector<std::string>& warnings) {
  const auto best = longest_lived(line);
  if (best == line.begin())
    warnings.push_back(fmt::format(
        "{}life falls from the lowest swept speed, {:g} rpm, on; sweep lower speeds to find where "
        "it peaks",
        kRangeOfSpeeds, best->rpm));
  else if (best + 1 == line.end())
    warnings.push_back(
        fmt::format("{}life still rises at the highest swept speed, {:g} rpm; sweep higher speeds to find "
                    "where it peaks",
                    kRangeOfSpeeds, best->rpm));
}

void warn_of_neighbours(const SpeedLine& line, bool in_motion, std::vector<std::string>& warnings) {
  const auto best = longest_lived(line);
  const double resolution = peak_resolution(best->rpm, in_motion);
  const auto look_at = [&](const LivedSpeed& neighbour) {
    if (!(neighbour.life_h > 0.0))
      warnings.push_back(fmt::format(
          "peak: the point beside it, at {:g} rpm, failed; life may rise further there", neighbour.rpm));
    // Speeds are asked for in whole digits, so that halves may differ by one.
    if (std::abs(neighbour.rpm - best->rpm) > 1.5 * resolution)
      warnings.push_back(
          fmt::format("peak: its speed, {:g} rpm, is known no better than to the next computed "
                      "point, {:g} rpm",
                      best->rpm, neighbour.rpm));
  };
  if (best != line.begin()) look_at(*(best - 1));
  if (best + 1 != line.end()) look_at(*(best + 1));
}

// Of a sweep with more axes than speed, the one line on which points were added.
void warn_of_other_lines(const SweepOutcome& outcome, const ResultRow& best,
                         std::vector<std::string>& warnings) {
  std::string position;
  for (std::size_t i = outcome.head.first_axis; i < outcome.head.first_axis + outcome.head.axes; ++i)
    position +=
        fmt::format("{}{} = {:.10g}", position.empty() ? "" : ", ", outcome.head.names[i], best.values[i]);
  if (!position.empty())
    warnings.push_back("peak: refined on the line of speeds through the grid's best point only, at " +
                       position);
}

}  // namespace

std::vector<LivedSpeed> line_through(const TableHead& head, const std::vector<ResultRow>& rows,
                                     const ResultRow& row) {
  SpeedLine line;
  for (const ResultRow& other : rows) {
    if (!on_one_line(head, row, other)) continue;
    const double life = life_to_go_by(head, other);
    line.push_back({value_of(head, other, "input_speed_rpm"), life > 0.0 ? life : 0.0});
  }
  std::stable_sort(line.begin(), line.end(),
                   [](const LivedSpeed& one, const LivedSpeed& other) { return one.rpm < other.rpm; });
  return line;
}

FoundPeak find_peak(const SweepOutcome& outcome) {
  FoundPeak found{.peak = grid_peak(outcome.head, outcome.rows)};
  const ManifestHeader& header = outcome.header;
  // A shard's best point is not the sweep's.
  if (!(found.peak.life_h > 0.0) || header.shard) return found;
  const auto best = std::find_if(outcome.rows.begin(), outcome.rows.end(), [&](const ResultRow& row) {
    return !row.refined && life_to_go_by(outcome.head, row) == found.peak.life_h;
  });
  const SpeedLine line = line_through(outcome.head, outcome.rows, *best);
  if (line.size() < 2) return found;
  warn_of_ends(line, found.warnings);
  if (header.continued)
    found.warnings.push_back("peak: of the grid's points; a continued sweep adds none around it");
  if (!header.refined) return found;
  put_refined(line, found.peak);
  warn_of_neighbours(line, in_time(fidelity_of(header.fidelity)), found.warnings);
  warn_of_other_lines(outcome, *best, found.warnings);
  return found;
}

}  // namespace orbearing::app
