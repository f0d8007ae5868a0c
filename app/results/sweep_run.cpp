#include "app/results/sweep_run.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <exception>
#include <nlohmann/json.hpp>

#include "app/errors.hpp"
#include "app/results/point_file.hpp"
#include "app/results/progress.hpp"
#include "app/results/record_writers.hpp"
#include "coupling/analysis/parallel.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing::app {

std::vector<std::vector<std::size_t>> continuation_paths(const std::vector<SweepPoint>& points,
                                                         Direction direction) {
  std::vector<std::vector<std::size_t>> paths;
  for (std::size_t point = 0; point < points.size(); ++point) {
    const auto same = std::find_if(paths.begin(), paths.end(), [&](const std::vector<std::size_t>& path) {
      return points[path.front()].axis_values == points[point].axis_values;
    });
    if (same == paths.end())
      paths.push_back({point});
    else
      same->push_back(point);
  }
  for (std::vector<std::size_t>& path : paths)
    std::stable_sort(path.begin(), path.end(), [&](std::size_t one, std::size_t other) {
      const double step = points[other].input_speed - points[one].input_speed;
      return direction == Direction::up ? step > 0.0 : step < 0.0;
    });
  return paths;
}

namespace {

std::vector<std::size_t> missing_points(const SweepRequest& request, const ResultFolder& folder) {
  std::vector<std::size_t> missing;
  for (std::size_t point = 0; point < request.points.size(); ++point)
    if (request.header.holds(point) && !folder.finished().contains(point)) missing.push_back(point);
  return missing;
}

/// A failed point keeps the speed that was requested and nothing else. A cancelled point has not failed.
analysis::PointResult evaluate_with_speed(const SweepPoint& point,
                                          const std::function<analysis::PointResult()>& evaluate) {
  analysis::PointResult result;
  try {
    result = evaluate();
  } catch (const std::exception& error) {
    result.status = error.what();
  }
  if (!is_computed(result.status)) result.input_speed = point.input_speed;
  return result;
}

FinishedPoint finished_point(const SweepRequest& request, const SweepPoint& asked,
                             analysis::ComputedPoint computed) {
  const bool refined = request.header.adds(computed.index);
  std::optional<Resonance> resonance;
  if (request.header.resonances) resonance = request.resonance_of(asked);
  FinishedPoint point{
      computed.index, {}, sweep_row(computed.result, request.header, asked.axis_values, resonance)};
  point.row.refined = refined;
  computed.result.status = point.row.point.status;
  // A file that is not kept costs more than a quasi-static point.
  if (request.folder.empty() || !request.point_files) return point;
  PointContent content = point_content(request.header, computed.index, asked.axis_values, computed.result);
  add_location_in_sweep(refined, resonance, content);
  point.content = netcdf_bytes(content);
  return point;
}

void keep(const SweepRequest& request, std::vector<FinishedPoint> points, ResultFolder& folder) {
  std::vector<SweepRow> rows;
  if (request.take_row)
    for (const FinishedPoint& point : points) rows.push_back(point.row);
  folder.keep(std::move(points));
  for (const SweepRow& row : rows) request.take_row(folder.header(), row);
}

/// Points to be computed, and how.
struct Work {
  std::vector<std::size_t> missing;                        // their numbers
  std::function<const SweepPoint&(std::size_t)> point_of;  // by number
  std::function<analysis::PointResult(std::size_t, const SweepPoint&)> evaluate;
  std::string doing;  // begins the line of progress; empty: the grid
};

double work_of(const SweepRequest& request, const std::vector<std::size_t>& points) {
  double seconds = 0.0;
  for (const std::size_t point : points)
    if (point < request.work.size()) seconds += request.work[point];
  return seconds;
}

/// If cancelled, the points finished so far remain in the folder.
void compute(const SweepRequest& request, const Work& work, ResultFolder& folder) {
  const std::size_t before = folder.finished().size();
  Progress progress(before, before + work.missing.size(), !request.quiet, work.doing);
  const double all = work_of(request, work.missing);  // [s]
  double done = 0.0;                                  // [s]
  const auto deliver = [&](std::vector<analysis::ComputedPoint> computed) {
    std::vector<FinishedPoint> points;
    for (analysis::ComputedPoint& point : computed) {
      done += work_of(request, {point.index});
      points.push_back(finished_point(request, work.point_of(point.index), std::move(point)));
    }
    keep(request, std::move(points), folder);
    progress.show(folder.finished().size(), all > 0.0 ? done / all : -1.0);
  };
  const auto evaluate = [&](std::size_t index) {
    const SweepPoint& point = work.point_of(index);
    return evaluate_with_speed(point, [&] { return work.evaluate(index, point); });
  };
  try {
    analysis::compute_points(work.missing, request.jobs, evaluate, deliver);
  } catch (const Cancelled&) {
    // run_sweep() then reports missing points.
  }
}

void compute_missing(const SweepRequest& request, ResultFolder& folder) {
  compute(request,
          {missing_points(request, folder),
           [&](std::size_t point) -> const SweepPoint& { return request.points[point]; },
           [&](std::size_t point, const SweepPoint&) { return request.evaluate(point); },
           {}},
          folder);
}

[[noreturn]] void refuse_other_refinement(const ResultFolder& folder, std::size_t point) {
  throw BadInput(
      fmt::format("{}: --resume: point {}, which refines the sweep, was found at another speed than the "
                  "points before it ask for; use another folder",
                  folder.path().string(), point));
}

/// One round of refinement: the requested points, numbered from `first`. False where it was interrupted.
bool compute_round(const SweepRequest& request, const std::vector<SweepPoint>& points, std::size_t first,
                   const std::string& doing, ResultFolder& folder) {
  Work work{{},
            [&](std::size_t index) -> const SweepPoint& { return points[index - first]; },
            [&](std::size_t, const SweepPoint& point) { return request.refinement->evaluate(point); },
            doing};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto found = folder.finished().find(first + i);
    if (found == folder.finished().end())
      work.missing.push_back(first + i);
    else if (speed_in_rpm(found->second.row.point.input_speed) != speed_in_rpm(points[i].input_speed))
      refuse_other_refinement(folder, first + i);
  }
  compute(request, work, folder);
  return std::all_of(work.missing.begin(), work.missing.end(),
                     [&](std::size_t index) { return folder.finished().contains(index); });
}

/// Adds points until the peak is known. Rounds that are in the folder are repeated without computation, so
/// that each follows from the same rows as in an undisturbed sweep. False where it was interrupted.
bool refine_peak(const SweepRequest& request, ResultFolder& folder) {
  std::vector<SweepRow> rows;
  // Points of the spectrum are numbered between those of the grid and those that are added.
  const std::size_t grid = request.header.grid(), of_spectrum = request.header.points - grid;
  const auto take_up_to = [&](std::size_t end) {
    while (rows.size() < end)
      rows.push_back(folder.finished().at(rows.size() + (rows.size() < grid ? 0 : of_spectrum)).row);
  };
  take_up_to(grid);
  for (int round = 1;; ++round) {
    const std::vector<SweepPoint> points = request.refinement->next(rows);
    if (points.empty()) break;
    const std::size_t first = rows.size() + of_spectrum;
    if (!compute_round(request, points, first, fmt::format("{}, round {}: ", request.refinement->of, round),
                       folder))
      return false;
    take_up_to(rows.size() + points.size());
  }
  const std::size_t known = rows.size() + of_spectrum;
  if (folder.finished().size() > known) refuse_other_refinement(folder, known);
  return true;
}

/// A path in progress: where the next point starts.
class ContinuationPath {
 public:
  ContinuationPath(const SweepRequest& request, ResultFolder& folder) : request_(request), folder_(folder) {}

  void take(std::size_t point) {
    const auto finished = folder_.finished().find(point);
    if (finished == folder_.finished().end()) return compute(point);
    if (finished->second.row.ok()) last_ = folder_.path() / finished->second.file;
  }

 private:
  void compute(std::size_t point) {
    if (!last_.empty()) state_ = stored_state(std::exchange(last_, {}));
    const SweepPoint& asked = request_.points[point];
    analysis::PointResult result =
        evaluate_with_speed(asked, [&] { return request_.evaluate_from(point, state_); });
    // A failed point has no state to continue from: the next one starts where the failed one did.
    if (is_computed(result.status) && result.dynamic) state_ = result.dynamic->final_state;
    std::vector<FinishedPoint> kept;
    kept.push_back(finished_point(request_, asked, {point, std::move(result)}));
    keep(request_, std::move(kept), folder_);
  }

  static Eigen::VectorXd stored_state(const std::filesystem::path& file) {
    const std::vector<double> state = read_final_state(file);
    if (state.empty())
      throw BadInput(
          fmt::format("{}: holds no final state to continue from; the file as its sweep wrote it is "
                      "required: remove it and sweep with --resume",
                      file.string()));
    return Eigen::Map<const Eigen::VectorXd>(state.data(), static_cast<Eigen::Index>(state.size()));
  }

  const SweepRequest& request_;
  ResultFolder& folder_;
  std::filesystem::path last_;  // file whose final state is the next start, where not yet read
  Eigen::VectorXd state_;       // empty: the next point starts from its own quasi-static state
};

void compute_paths(const SweepRequest& request, ResultFolder& folder) {
  Progress progress(folder.finished().size(), request.header.own_points(), !request.quiet);
  for (const std::vector<std::size_t>& points :
       continuation_paths(request.points, *request.header.continued)) {
    ContinuationPath path(request, folder);
    for (const std::size_t point : points) try {
        throw_if_stopped();
        path.take(point);
        progress.show(folder.finished().size());
      } catch (const Cancelled&) {
        return;
      }
  }
}

std::string interrupted(const SweepRequest& request, const std::string& found) {
  if (request.folder.empty()) return found + "; nothing of it is kept without --output";
  return fmt::format("{}: {}; continue with --resume", request.folder.string(), found);
}

}  // namespace

SweepOutcome outcome_of(const ManifestHeader& header, const std::map<std::size_t, ManifestEntry>& entries,
                        std::size_t kept) {
  SweepOutcome outcome{header, rows_in_table_order(header, entries), spectrum_results(header, entries), kept};
  for (const auto& [point, entry] : entries)
    if (!entry.row.ok()) ++outcome.failed;
  return outcome;
}

namespace {

SweepOutcome swept(const SweepRequest& request) {
  ResultFolder folder =
      open_results(request.folder, request.header, request.resolved_case, request.resume, request.quiet);
  const std::size_t kept = folder.finished().size();
  if (request.take_row)
    for (const auto& [point, entry] : folder.finished()) request.take_row(folder.header(), entry.row);
  if (request.announce) {
    const std::vector<std::size_t> missing = missing_points(request, folder);
    request.announce(work_of(request, missing), missing.size());
  }
  if (request.header.continued)
    compute_paths(request, folder);
  else
    compute_missing(request, folder);
  if (const std::size_t missing = missing_points(request, folder).size(); missing > 0)
    throw Interrupted(interrupted(
        request, fmt::format("interrupted with {} of {} points done", request.header.own_points() - missing,
                             request.header.own_points())));
  if (request.refinement && request.header.refined && !request.header.shard && !refine_peak(request, folder))
    throw Interrupted(interrupted(
        request,
        fmt::format("interrupted while the sweep was refined, with {} points added to the {} of the grid",
                    folder.finished().size() - request.header.points, request.header.points)));
  folder.write_table();
  return outcome_of(request.header, folder.finished(), kept);
}

}  // namespace

SweepOutcome run_sweep(const SweepRequest& request) try {
  assert(request.header.points == request.points.size());
  return swept(request);
} catch (const WriteFailed& error) {
  throw ComputationFailed(error.cause + "; finished points are kept: " + error.remedy +
                          ", then continue with --resume");
}

namespace {

using Json = nlohmann::ordered_json;

// Units of the points, with swept values and sets, and of the peak.
Json units_of_sweep(const ManifestHeader& header, const LifePeak& peak) {
  Json units = units_of(sweep_form(peak));
  for (const SweptAxis& axis : header.axes) units[axis.column] = axis.units;
  const ManifestHeader of_sets{.sets = header.sets};
  units.update(units_of(record_of(of_sets, row_of_numbers({}, of_sets))));
  return units;
}

}  // namespace

void describe(Record& record, const LifePeak& peak) {
  using namespace described;
  record.value("speed_rpm", in_rpm, "of the best point of the grid", peak.speed_rpm);
  record.value("life_h", dimension::hours, "there", peak.life_h);
  record.value("refined_speed_rpm", in_rpm, "of the best of all points", peak.refined_speed_rpm);
  record.value("refined_life_h", dimension::hours, "there", peak.refined_life_h);
  record.value("life_key", "life whose peak it is", peak.life);
  record.array("between_rpm", in_rpm, "neighbours of the refined peak", {"side"},
               std::array{peak.lower_rpm, peak.upper_rpm});
}

Record sweep_form(const LifePeak& peak) {
  Record record;
  analysis::PointResult form;
  form.planets.resize(1);
  record.table("points", "point", "operating points", std::array{form},
               [](Record& row, const analysis::PointResult& point) {
                 analysis::describe_row(row, point);
                 row.value(refined_column, "whether it was added around the peak", false);
                 row.value(limiting_set_column, "of several sets, the one with the worst bearing",
                           point.limiting_set);
                 describe(row, Resonance{});
                 row.table("planets", "planet", "planets one by one, where they carry unlike loads",
                           point.planets, described::describe_listed<analysis::PlanetResult>);
               });
  record.child("peak", "longest life over speed", peak);
  return record;
}

LifePeak grid_peak(const ManifestHeader& header, const std::vector<SweepRow>& rows) {
  LifePeak peak{.life = header.life};
  if (const SweepRow* best = longest_lived(header, rows, true)) {
    peak.life_h = governing_hours(header, best->point);
    peak.speed_rpm = speed_in_rpm(best->point.input_speed);
  }
  return peak;
}

Json sweep_json(const SweepOutcome& outcome, const LifePeak& peak, const Json& assumptions,
                const Json& warnings, const Json& versions) {
  Json points = Json::array();
  for (const SweepRow& row : outcome.rows) points.push_back(row_json(outcome.header, row));
  Json object{{"points", std::move(points)}, {"peak", json_of(record_of(peak))}};
  if (!outcome.spectra.empty()) object["spectrum"] = spectrum_json(outcome.header, outcome.spectra);
  object["assumptions"] = assumptions;
  object["warnings"] = warnings;
  object["versions"] = versions;
  object["units"] = units_of_sweep(outcome.header, peak);
  return object;
}

}  // namespace orbearing::app
