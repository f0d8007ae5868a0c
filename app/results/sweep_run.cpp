#include "app/results/sweep_run.hpp"

#include <fmt/format.h>

#include <cassert>
#include <exception>
#include <utility>

#include "app/errors.hpp"
#include "app/results/chains.hpp"
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
study::PointResult evaluate_with_speed(const SweepRequest& request, std::size_t point,
                                       const std::function<study::PointResult()>& evaluate) {
  study::PointResult result;
  try {
    result = evaluate();
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
      [&](std::size_t point) {
        return evaluate_with_speed(request, point, [&] { return request.evaluate(point); });
      },
      deliver, [] { return Interruption::requested(); });
}

/// A chain in progress: where the next point starts.
class Chain {
 public:
  Chain(const SweepRequest& request, ResultFolder& folder) : request_(request), folder_(folder) {}

  void take(std::size_t point) {
    const auto finished = folder_.finished().find(point);
    if (finished == folder_.finished().end()) return compute(point);
    if (finished->second.row.ok()) last_ = folder_.path() / finished->second.file;
  }

 private:
  void compute(std::size_t point) {
    if (!last_.empty()) state_ = stored_state(std::exchange(last_, {}));
    study::PointResult result =
        evaluate_with_speed(request_, point, [&] { return request_.evaluate_from(point, state_); });
    // A failed point has no state to go on from: the next one starts where the failed one did.
    if (result.status == "ok" && result.dynamic) state_ = result.dynamic->final_state;
    std::vector<FinishedPoint> kept;
    kept.push_back(finished_point(request_, {point, std::move(result)}));
    folder_.keep(std::move(kept));
  }

  static Eigen::VectorXd stored_state(const std::filesystem::path& file) {
    const std::vector<double> state = read_final_state(file);
    if (state.empty())
      throw BadInput(
          fmt::format("{}: holds no final state to go on from; the file as its sweep wrote it is "
                      "required: remove it and sweep with --resume",
                      file.string()));
    return Eigen::Map<const Eigen::VectorXd>(state.data(), static_cast<Eigen::Index>(state.size()));
  }

  const SweepRequest& request_;
  ResultFolder& folder_;
  std::filesystem::path last_;  // file whose final state is the next start, where not yet read
  Eigen::VectorXd state_;       // empty: the next point starts from its own quasi-static state
};

void compute_chains(const SweepRequest& request, ResultFolder& folder) {
  Progress progress(folder.finished().size(), request.header.own_points(), !request.quiet);
  for (const std::vector<std::size_t>& points : chains_of(request.points, *request.header.continued)) {
    Chain chain(request, folder);
    for (const std::size_t point : points) {
      if (Interruption::requested()) return;
      chain.take(point);
      progress.show(folder.finished().size());
    }
  }
}

std::string interrupted(const SweepRequest& request, std::size_t done) {
  const std::string found =
      fmt::format("interrupted with {} of {} points done", done, request.header.own_points());
  if (request.folder.empty()) return found + "; nothing of it is kept without --output";
  return fmt::format("{}: {}; go on with --resume", request.folder.string(), found);
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
  ResultFolder folder =
      open_results(request.folder, request.header, request.resolved_case, request.resume, request.quiet);
  const std::size_t kept = folder.finished().size();
  if (request.header.continued)
    compute_chains(request, folder);
  else
    compute_missing(request, folder);
  const std::size_t done = folder.finished().size();
  if (done < request.header.own_points()) throw ComputationFailed(interrupted(request, done));
  folder.write_table();
  return outcome_of(request.header, folder, kept);
}

}  // namespace orbearing::app
