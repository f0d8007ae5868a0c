// A sweep from its list of points to a folder of results: in parallel, resumable, in shards.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/case/settings.hpp"
#include "app/results/manifest.hpp"
#include "app/results/result_folder.hpp"
#include "app/results/spectrum_life.hpp"
#include "app/results/sweep_row.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// One point of a sweep before it is computed.
struct SweepPoint {
  std::string label;  // for messages: "input.speed = 6000 rpm"
  double input_speed =
      std::numeric_limits<double>::quiet_NaN();  // [rad/s]  kept in the row of a failed point
  std::vector<double> axis_values;               // one per header.axes, in the axis' unit
  std::vector<Setting> settings{};               // that make the case's operating point
};

/// The paths of a continued sweep: points that differ in speed alone, in the order in which they follow each
/// other. Numbers of the points, one path for each combination of the other axes' values, in the order of the
/// points that begin them; along a path the speed rises (up) or falls (down).
std::vector<std::vector<std::size_t>> continuation_paths(const std::vector<SweepPoint>& points,
                                                         Direction direction);

/// Points that a sweep adds to its first ones until its peak, or a table, is known.
struct Refinement {
  /// The points to be added when those of `rows` are done (the grid's in their order, without the spectrum's,
  /// then those added before, in the order in which they were requested); none: the peak is known. Depends
  /// only on the rows, so that a resumed sweep requests the same points.
  std::function<std::vector<SweepPoint>(const std::vector<SweepRow>& rows)> next;
  /// Computes one of them; as SweepRequest::evaluate.
  std::function<analysis::PointResult(const SweepPoint& point)> evaluate;
  std::string of{"peak"};  // what is refined, in the line of progress
};

struct SweepRequest {
  ManifestHeader header;           // header.points and header.axes must fit `points`
  std::string resolved_case;       // text of case.resolved.yaml
  std::vector<SweepPoint> points;  // all of the sweep, in order; the shard picks its own
  /// Computes a point. Called from several threads at once; an exception becomes the row's status.
  std::function<analysis::PointResult(std::size_t point)> evaluate;
  /// Computes a point of a continued sweep (header.continued) from the final state of its neighbour, or from
  /// its own start where `start` is empty. Called from one thread.
  std::function<analysis::PointResult(std::size_t point, const Eigen::VectorXd& start)> evaluate_from{};
  /// Nearest resonance of a point; called for every point where header.resonances, on one thread.
  std::function<std::optional<Resonance>(const SweepPoint& point)> resonance_of{};
  std::optional<Refinement> refinement{};  // there where header.refined; shards leave it to `merge`
  /// Receives each row as its point ends, first those that the folder holds; one call at a time.
  std::function<void(const ManifestHeader& header, const SweepRow& row)> take_row{};
  std::vector<double> work{};  // [s]  (points) estimated times, which weigh the time left; empty: equal
  /// Told once, before the first point: estimated time [s] and number of the points that the folder lacks.
  std::function<void(double seconds, std::size_t missing)> announce{};
  std::filesystem::path folder;  // empty: nothing is written
  bool point_files = true;       // else the rows of the manifest are all that is kept
  int jobs = 0;                  // threads; 0: as many as the machine has
  bool resume = false;
  bool quiet = false;  // no progress, even on a terminal
};

/// Rows in the order of the table.
struct SweepOutcome {
  ManifestHeader header;
  std::vector<SweepRow> rows;
  std::vector<SpectrumResult> spectra;  // one for each combination of the other swept values, if any
  std::size_t kept = 0;                 // found finished in the folder
  std::size_t failed = 0;  // rows whose status is not "ok"; the command's exit code is 1 where there are any
};

/// Computes the points that are missing in the folder, or damaged, then the points that refine the peak round
/// by round, and writes points/*.nc, manifest.jsonl, case.resolved.yaml and sweep.csv. A continued sweep
/// computes its paths one after the other; a point continues from the last one before it on its path that was
/// computed, and a resumed path from the state stored with that point, so that the results are those of an
/// undisturbed run to the last bit. Throws BadInput (folder not to be used, no state stored to continue from)
/// and ComputationFailed (disk full, or SIGINT or SIGTERM, after which the points computed so far are kept
/// and `resume` continues).
SweepOutcome run_sweep(const SweepRequest& request);

/// The rows of a folder; `kept` of its points were found finished.
SweepOutcome outcome_of(const ManifestHeader& header, const std::map<std::size_t, ManifestEntry>& entries,
                        std::size_t kept = 0);

/// Joins the shards of one sweep into `folder`, which must be missing or empty. Its table equals that of the
/// sweep run in one piece, byte for byte. Throws BadInput where shards are missing, unfinished, given twice,
/// of different cases, versions, fidelities or instruction sets, or with files missing or damaged, before
/// anything is written. Throws ComputationFailed where the result cannot be written, or on SIGINT or SIGTERM;
/// in each case it removes what it wrote. Where header.refined the folder lacks the points that refine the
/// peak: `run_sweep` with `resume` adds them. `grid_only`: the result is one without.
SweepOutcome merge_shards(const std::vector<std::filesystem::path>& shards,
                          const std::filesystem::path& folder, bool grid_only = false);

// The sweep as one JSON object, and the peak of its life.

/// Longest life over speed: the best point of the grid, and the best of all where points were added around
/// it. Every number is that of a point that was computed; NaN where there is none.
struct LifePeak {
  double speed_rpm = std::numeric_limits<double>::quiet_NaN();
  double life_h = std::numeric_limits<double>::quiet_NaN();
  double refined_speed_rpm = std::numeric_limits<double>::quiet_NaN();
  double refined_life_h = std::numeric_limits<double>::quiet_NaN();
  double lower_rpm = std::numeric_limits<double>::quiet_NaN();  // neighbours of the refined peak, which live
  double upper_rpm = std::numeric_limits<double>::quiet_NaN();  // shorter; NaN beyond an end of the range
  std::string life{"life_h"};                                   // column of the life whose peak it is
};

void describe(described::Record& record, const LifePeak& peak);

/// Best row of the grid, those added to it left out; the refined values are left for the caller. NaN where no
/// point has a life.
LifePeak grid_peak(const ManifestHeader& header, const std::vector<SweepRow>& rows);

/// The peak and one point as a form for all: rows hold numbers alone.
described::Record sweep_form(const LifePeak& peak);

/// Object with `points`, `peak`, `spectrum` where the case states one, `assumptions`, `warnings`, `versions`
/// and `units`, in this order; no number where a value is missing, but null. Assumptions, warnings and
/// versions are taken as they are.
nlohmann::ordered_json sweep_json(const SweepOutcome& outcome, const LifePeak& peak,
                                  const nlohmann::ordered_json& assumptions,
                                  const nlohmann::ordered_json& warnings,
                                  const nlohmann::ordered_json& versions);

}  // namespace orbearing::app
