// A case changed in a named way, and what the changed case gives: how effects and assumptions are compared.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "coupling/analysis/multi_stage.hpp"

namespace orbearing::app {

/// A change to a case, by settings as with --set.
struct NamedChange {
  std::string name;   // for people
  std::string group;  // of changes that are shown together; of a reading: the key it reads otherwise
  std::vector<std::string> settings;  // path=value; none: the case unchanged
};

/// Results of one changed case over its speeds.
struct ChangeResult {
  NamedChange change;
  std::vector<double> speed;                  // [rad/s]  of the motor
  std::vector<analysis::PointResult> points;  // a point that failed holds its reason in `status`
};

/// Speeds and fidelity at which changes are compared.
struct ChangeStudy {
  std::vector<double> speed{};  // [rad/s]  of the motor; none: those of each changed case's own sweep
  analysis::Fidelity fidelity = analysis::Fidelity::quasi_static;
  int jobs = 0;  // threads; 0: one for each core
  /// Result for the sets with bearings at one speed; called from several threads.
  std::function<analysis::PointResult(const std::vector<analysis::NamedSet>&, analysis::Fidelity)> evaluate =
      [](const std::vector<analysis::NamedSet>& sets, analysis::Fidelity level) {
        return analysis::evaluate(sets, level);
      };
};

/// Called when one more change is done, in their order: the first `done` of `results` are whole.
using ChangesDone = std::function<void(const std::vector<ChangeResult>& results, std::size_t done)>;

/// `changes` after the unchanged case.
std::vector<NamedChange> with_reference(const std::vector<NamedChange>& changes);

/// The case with settings such as "pair.teeth=[30, 20]". Throws BadInput.
ResolvedCase with_settings(const ResolvedCase& resolved, const std::vector<std::string>& settings);

/// Whether the changed case is one that can be computed.
bool fits(const ResolvedCase& resolved, const NamedChange& change);

/// Computes the case under each change, all points of all changes in parallel. Throws BadInput where a
/// setting does not fit the case.
std::vector<ChangeResult> results_of(const ResolvedCase& resolved, const std::vector<NamedChange>& changes,
                                     const ChangeStudy& study, const ChangesDone& done = nullptr);

/// Life [h] of one bearing; NaN where the point failed.
double life_of(const analysis::PointResult& point);

/// Index of the speed of the longest life; failed points are skipped.
std::size_t best_point(const ChangeResult& result);

}  // namespace orbearing::app
