#include "app/study/peak_refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/study/fidelity.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/resonance_lines.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

// Beyond so many added points a search is given up; the result says how well the peak is known then. No curve
// that was seen needed a quarter of them.
constexpr std::size_t kMostAdded = 400;

// Number of the grid's point with the longest life; none where no point has one.
std::optional<std::size_t> best_of_grid(const TableHead& head, const std::vector<ResultRow>& rows,
                                        std::size_t points) {
  std::optional<std::size_t> best;
  double longest = 0.0;
  for (std::size_t point = 0; point < points; ++point) {
    const double life = life_to_go_by(head, rows[point]);
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

void refine_peak_of(const ResolvedCase& resolved, SweepRequest& request) {
  const std::vector<double> speeds = speeds_rpm(resolved);
  const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
  if (*low == *high) return;
  const study::Fidelity fidelity = fidelity_of(request.header.fidelity);
  const bool dips = request.header.resonances;
  const auto lines = dips ? std::make_shared<LinesOfResonances>(resolved) : nullptr;
  request.header.refined = true;
  request.refinement =
      Refinement{[resolved, lines, fidelity, points = request.header.grid()](
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
