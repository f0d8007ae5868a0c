// Resonances of the gears along the lines of speeds of a sweep.
#pragma once

#include <map>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_run.hpp"
#include "app/study/resonance.hpp"

namespace orbearing::app {

/// Speeds [rpm] of the sweep; the case's own where none are swept.
std::vector<double> speeds_rpm(const ResolvedCase& resolved);

/// Resonances of each line of speeds, found when first asked for. One thread at a time.
class LinesOfResonances {
 public:
  explicit LinesOfResonances(const ResolvedCase& resolved);

  /// Of the line on which the point that `settings` make lies.
  const std::vector<Resonance>& of(const std::vector<Setting>& settings);

 private:
  std::vector<Resonance> computed(const std::vector<Setting>& line) const;

  ResolvedCase resolved_;
  double lowest_ = 0.0;   // [rpm]
  double highest_ = 0.0;  // [rpm]
  std::map<std::vector<Setting>, std::vector<Resonance>> lines_;
};

/// Makes the rows of `request` name their nearest resonance where the bearings' motion feels one.
void name_resonances(const ResolvedCase& resolved, SweepRequest& request);

}  // namespace orbearing::app
