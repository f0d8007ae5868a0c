#include "app/results/sweep_run.hpp"

#include <fmt/format.h>

#include <cassert>
#include <exception>
#include <utility>

#include "app/errors.hpp"
#include "app/results/interruption.hpp"
#include "app/results/point_file.hpp"
#include "app/results/progress.hpp"
#include "coupling/study/parallel.hpp"

namespace orbearing::app {
namespace {

std::vector<std::size_t> missing_points(const SweepRequest& request, const ResultFolder& folder) {
  std::vector<std::size_t> missing;
  for (std::size_t point = 0; point < request.points.size(); ++point)
    if (request.header.holds(point) && !folder.finished().contains(point)) missing.push_back(point);
  return missing;
}

/// A failed point keeps the speed it was asked for and nothing else.
study::PointResult evaluate_with_speed(const SweepRequest& request, std::size_t point) {
  study::PointResult result;
  try {
    result = request.evaluate(point);
  } catch (const std::exception& error) {
    result.status = error.what();
  }
  if (result.status != "ok") result.input_speed = request.points[point].input_speed;
  return result;
}

FinishedPoint finished_point(const SweepRequest& request, study::ComputedPoint computed) {
  const std::vector<double>& axes = request.points[computed.index].axis_values;
  FinishedPoint point{computed.index, {}, result_row(computed.result, axes, request.header.sets)};
  computed.result.status = point.row.status;
  point.content = netcdf_bytes(point_content(request.header, computed.index, axes, computed.result));
  return point;
}

void compute_missing(const SweepRequest& request, ResultFolder& folder) {
  Progress progress(folder.finished().size(), request.header.own_points(), !request.quiet);
  const auto deliver = [&](std::vector<study::ComputedPoint> computed) {
    std::vector<FinishedPoint> points;
    for (study::ComputedPoint& point : computed) points.push_back(finished_point(request, std::move(point)));
    folder.keep(std::move(points));
    progress.show(folder.finished().size());
  };
  study::compute_points(
      missing_points(request, folder), request.jobs,
      [&](std::size_t point) { return evaluate_with_speed(request, point); }, deliver,
      [] { return Interruption::requested(); });
}

}  // namespace

SweepOutcome outcome_of(const ManifestHeader& header, const ResultFolder& folder, std::size_t kept) {
  SweepOutcome outcome{header, folder.head(), {}, kept, 0};
  for (const auto& [point, entry] : folder.finished()) {
    outcome.rows.push_back(entry.row);
    if (!entry.row.ok()) ++outcome.failed;
  }
  return outcome;
}

SweepOutcome run_sweep(const SweepRequest& request) {
  assert(request.header.points == request.points.size());
  const Interruption interruption;
  ResultFolder folder(request.folder, request.header, request.resolved_case,
                      request.resume ? OpenMode::resume : OpenMode::fresh);
  const std::size_t kept = folder.finished().size();
  compute_missing(request, folder);
  const std::size_t done = folder.finished().size();
  if (done < request.header.own_points())
    throw ComputationFailed(fmt::format("{}: interrupted with {} of {} points done; go on with --resume",
                                        request.folder.string(), done, request.header.own_points()));
  folder.write_table();
  return outcome_of(request.header, folder, kept);
}

}  // namespace orbearing::app
