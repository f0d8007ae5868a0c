// Results of an analysis compared with the requirements that the case states.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/requirements_case.hpp"
#include "app/results/life_table.hpp"
#include "app/results/sweep_run.hpp"
#include "app/results/worst_bearing.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// One requirement with the worst result that it limits.
struct Verdict {
  Requirement requirement;
  double value = described::kAbsent;  // [requirement.unit]  infinite: a life without load
  std::optional<bool> passed;         // none: not computed
  std::string at;                     // operating point or bin of that value; empty: the only one
  std::string reason;                 // why there is no value, or none that is finite; else empty
  std::string result{};               // name of that value among those of one set: shortest_L10mrh
  std::string of_set{};               // of several sets, the one with that value
  std::size_t points = 1;             // that were judged
  std::size_t points_failed = 0;      // of them, those that do not meet the requirement
};

void describe(described::Record& record, const Verdict& verdict);
/// The table `verdicts`; nothing where there are none.
void describe_verdicts(described::Record& record, const std::vector<Verdict>& verdicts);
/// The same for terminals: a line for each.
std::string verdicts_text(const std::vector<Verdict>& verdicts);

/// Verdicts for a single bearing under one load.
std::vector<Verdict> verdicts_of(const std::vector<Requirement>& requirements, const LifeValue& value);

/// Verdicts for a run or sweep. Under a load spectrum: life of the whole spectrum, all else in its worst bin.
/// Without: all in the worst of the operating points. Each for the worst bearing of all sets.
std::vector<Verdict> verdicts_of(const std::vector<Requirement>& requirements, const SweepOutcome& outcome);

}  // namespace orbearing::app
