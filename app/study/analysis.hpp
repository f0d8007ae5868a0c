// The table of analyses that give one result of a case: `run` carries them out, `check`, derivatives and
// signals read their rows. A drivetrain with planet bearings has none: its run is a sweep of one point.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/case/analysis_result.hpp"
#include "app/case/check_table.hpp"
#include "app/case/field_use.hpp"
#include "app/case/resolved_case.hpp"
#include "app/results/record_writers.hpp"

namespace orbearing::app {

/// Items of one list followed by those of the others, e.g. of warnings.
template <class Item, class... More>
std::vector<Item> joined(std::vector<Item> first, const More&... more) {
  (first.insert(first.end(), more.begin(), more.end()), ...);
  return first;
}

/// One row of the table.
struct Analysis {
  AnalysisId used;                     // its name for users, and which inputs it uses
  bool (*is_of)(const ResolvedCase&);  // whether it is what `run` does with the case; null: by `machine`
  Model machine = no_model;
  std::vector<std::string> fidelities;  // that --fidelity may name; the first is what it does without
  std::string required;                 // message for another fidelity
  ResultNames names;
  double scatter = scatter::in_motion;  // of its results
  const char* doing = nullptr;          // begins the line of its progress; null: it is done at once
  std::size_t parts = 0;                // of that line
  double (*simulated)(const ResolvedCase&) = nullptr;  // [s]  time of the motion whose shares these parts are
  /// Throws BadInput and ComputationFailed.
  std::function<AnalysisResult(const ResolvedCase&, const AnalysisOptions&)> compute;
  std::vector<Derived> (*derived)(const ResolvedCase&) = nullptr;  // derived quantities for `check`
};

/// The case's row for a fidelity that the user named (empty: none); null where its run is a sweep. Throws
/// BadInput where the case has no such fidelity.
const Analysis* analysis_of(const ResolvedCase& resolved, const std::string& fidelity = "");

/// The gears of a drivetrain without the dynamics of its bearings, whatever its row.
const Analysis& gears_alone();

}  // namespace orbearing::app
