#include "app/study/peak_refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "app/study/fidelity.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/resonance.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

// Beyond so many added points a search is given up; the result says how well the peak is known then. No curve
// that was seen needed a quarter of them.
constexpr std::size_t kMostAdded = 400;

std::vector<Setting> other_settings(std::vector<Setting> settings) {
  std::erase_if(settings, [](const Setting& setting) { return setting.first == kSpeedPath; });
  return settings;
}

// Speeds [rpm] of the sweep; the case's own where none are swept.
std::vector<double> speeds_rpm(const ResolvedCase& resolved) {
  std::vector<double> speeds;
  for (const SweepAxis& axis : resolved.axes())
    if (axis.path == kSpeedPath)
      for (const std::string& value : axis.values)
        speeds.push_back(speed_in_rpm(resolved.with(axis.path, value).quantity(axis.path)));
  if (speeds.empty()) speeds.push_back(speed_in_rpm(resolved.quantity(kSpeedPath)));
  return speeds;
}

// Resonances of each line of speeds, found when first asked for. One thread at a time.
class LinesOfResonances {
 public:
  explicit LinesOfResonances(const ResolvedCase& resolved) : resolved_(resolved.without_sweep()) {
    const std::vector<double> speeds = speeds_rpm(resolved);
    const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
    lowest_ = *low;
    highest_ = *high;
  }

  const std::vector<Resonance>& of(const std::vector<Setting>& settings) {
    const std::vector<Setting> line = other_settings(settings);
    const auto [place, is_new] = lines_.try_emplace(line);
    if (is_new) place->second = computed(line);
    return place->second;
  }

 private:
  // A line on which the gears cannot be computed has points that say why.
  std::vector<Resonance> computed(const std::vector<Setting>& line) const try {
    return resonances(line.empty() ? resolved_ : resolved_.with(line), lowest_, highest_);
  } catch (const std::exception&) {
    return {};
  }

  ResolvedCase resolved_;
  double lowest_ = 0.0;   // [rpm]
  double highest_ = 0.0;  // [rpm]
  std::map<std::vector<Setting>, std::vector<Resonance>> lines_;
};

// Number of the grid's point with the longest life; none where no point has one.
std::optional<std::size_t> best_of_grid(const TableHead& head, const std::vector<ResultRow>& rows,
                                        std::size_t points) {
  std::optional<std::size_t> best;
  double longest = 0.0;
  for (std::size_t point = 0; point < points; ++point) {
    const double life = value_of(head, rows[point], "life_h");
    if (!(life > longest)) continue;
    longest = life;
    best = point;
  }
  return best;
}

PeakSearch search_on_line(bool in_motion, const std::vector<Resonance>& resonances) {
  PeakSearch search{.in_motion = in_motion};
  for (const Resonance& resonance : resonances)
    search.resonances_rpm.push_back(speed_in_rpm(resonance.speed));
  return search;
}

}  // namespace

void name_resonances(const ResolvedCase& resolved, SweepRequest& request) {
  if (!in_time(fidelity_of(request.header.fidelity)) || !has_resonances(resolved)) return;
  request.header.resonances = true;
  request.resonance_of = [lines = std::make_shared<LinesOfResonances>(resolved)](const SweepPoint& point) {
    return nearest(lines->of(point.settings), point.input_speed);
  };
}

void refine_peak_of(const ResolvedCase& resolved, SweepRequest& request) {
  const std::vector<double> speeds = speeds_rpm(resolved);
  const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
  if (*low == *high) return;
  const study::Fidelity fidelity = fidelity_of(request.header.fidelity);
  const bool dips = request.header.resonances;
  const auto lines = dips ? std::make_shared<LinesOfResonances>(resolved) : nullptr;
  request.header.refined = true;
  request.refinement =
      Refinement{[resolved, lines, fidelity, points = request.header.points](
                     const TableHead& head, const std::vector<ResultRow>& rows) {
                   std::vector<SweepPoint> added;
                   const std::optional<std::size_t> best = best_of_grid(head, rows, points);
                   if (!best || rows.size() - points >= kMostAdded) return added;
                   const std::vector<Setting> line = sweep_point(resolved, *best);
                   const PeakSearch search =
                       search_on_line(in_time(fidelity), lines ? lines->of(line) : std::vector<Resonance>{});
                   for (const double rpm : next_speeds(line_through(head, rows, rows[*best]), search))
                     added.push_back(point_at_rpm(resolved, line, rpm));
                   return added;
                 },
                 [resolved, fidelity](const SweepPoint& point) {
                   return compute_point(resolved, point.settings, fidelity);
                 }};
}

}  // namespace orbearing::app
