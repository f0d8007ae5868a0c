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
#include "app/case/input_keys.hpp"
#include "app/results/life_table.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/sweep_table.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/resonance_lines.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

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
  const std::size_t best = position_of_longest_life(line);
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
          in.has(keys().reduction_factor) ? in.number(keys().reduction_factor) : 0.0, governing_life(in)};
}

LifeTable table_at(const SweepOutcome& outcome, const SweepRow& row, const ResolvedCase& in) {
  return {[&](const std::string& name) { return number_named(outcome.header, row, name); }, words_of(in)};
}

// Result of the worst planet bearing, where the carrier is a body.
std::string carrier_text(const ManifestHeader& header,
                         const std::optional<analysis::CarrierNumbers>& carrier) {
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
  const analysis::Fidelity fidelity = fidelity_of(request.header.fidelity);
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
