#include "app/study/named_change.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "app/errors.hpp"
#include "app/results/sweep_row.hpp"
#include "app/study/planetary_case.hpp"
#include "coupling/analysis/parallel.hpp"

namespace orbearing::app {

namespace {

std::vector<Setting> split_settings(const std::vector<std::string>& settings) {
  std::vector<Setting> split;
  for (const std::string& text : settings) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw BadInput("expected.yaml: settings: found " + text + "; required: path=value");
    split.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return split;
}

}  // namespace

std::vector<NamedChange> with_reference(const std::vector<NamedChange>& changes) {
  std::vector<NamedChange> all{{.name = "the case as it stands", .group = "", .settings = {}}};
  all.insert(all.end(), changes.begin(), changes.end());
  return all;
}

ResolvedCase with_settings(const ResolvedCase& resolved, const std::vector<std::string>& settings) {
  return resolved.with(split_settings(settings));
}

bool fits(const ResolvedCase& resolved, const NamedChange& change) {
  std::vector<Mistake> mistakes;
  resolved.with(split_settings(change.settings), mistakes);
  return mistakes.empty();
}

std::vector<ChangeResult> results_of(const ResolvedCase& resolved, const std::vector<NamedChange>& changes,
                                     const ChangeStudy& study, const ChangesDone& done) {
  std::vector<ChangeResult> results;
  std::vector<std::vector<analysis::NamedSet>> sets;           // of each change
  std::vector<std::pair<std::size_t, std::size_t>> positions;  // of each point: its change, its speed
  std::vector<std::size_t> left;                               // points of each change
  for (const NamedChange& change : changes) {
    const ResolvedCase changed = with_settings(resolved, change.settings);
    const std::vector<double> speeds = study.speed.empty() ? swept_speeds(changed) : study.speed;
    for (std::size_t i = 0; i < speeds.size(); ++i) positions.emplace_back(results.size(), i);
    sets.push_back(bearing_sets(changed));
    for (analysis::NamedSet& set : sets.back())
      set.drivetrain.carrier_mounting.reset();  // none of it is shown
    left.push_back(speeds.size());
    results.push_back({change, speeds, std::vector<analysis::PointResult>(speeds.size())});
  }
  std::vector<std::size_t> indices(positions.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  std::size_t whole = 0;
  analysis::compute_points(
      indices, study.jobs,
      [&](std::size_t index) {
        const auto [change, at] = positions[index];
        return study.evaluate(analysis::at_speed(sets[change], results[change].speed[at]), study.fidelity);
      },
      [&](std::vector<analysis::ComputedPoint> points) {
        for (analysis::ComputedPoint& point : points) {
          const auto [change, at] = positions[point.index];
          results[change].points[at] = std::move(point.result);
          --left[change];
        }
        while (whole < results.size() && left[whole] == 0) {
          ++whole;
          if (done) done(results, whole);
        }
      });
  return results;
}

double life_of(const analysis::PointResult& point) {
  return is_computed(point.status) ? analysis::governing_hours(point)
                                   : std::numeric_limits<double>::quiet_NaN();
}

std::size_t best_point(const ChangeResult& result) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < result.points.size(); ++i)
    if (std::isnan(life_of(result.points[best])) || life_of(result.points[i]) > life_of(result.points[best]))
      best = i;
  return best;
}

}  // namespace orbearing::app
