// `orbearing sweep`: all operating points.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct SweepOptions {
  static constexpr const char* command = "sweep";
  static constexpr const char* purpose = "compute all operating points of the case";
  Printing print;
  StatedCase stated;
  std::string output;  // folder; empty: nothing is written
  std::string fidelity;
  bool resume = false;
  std::string budget;      // processor time
  int jobs = 0;            // 0: one for each core
  bool grid_only = false;  // no points are added around the peak
  std::string shard;       // "i/n"; empty: all points
  std::string direction;   // "up" or "down", of points that follow from their neighbours; empty: none do
};
inline void describe(OptionList& list, SweepOptions& m) {
  described::members(
      list, m, described::part(m.print), described::part(m.stated), output_or_json_row(m.output),
      fidelity_row(m.fidelity), option(m.resume, "--resume", "continue in DIR with the missing points"),
      budget_row(m.budget), jobs_row(m.jobs), grid_only_row(m.grid_only),
      option(m.shard, "--shard", "compute part i of n; join the parts by merge", {.type = "i/n"}),
      option(m.direction, "--continue",
             "up or down: one point after the other, each from the final state of its neighbour in speed",
             {.choices = {"up", "down"}}));
}
std::vector<std::string> problems(const SweepOptions& options);

int execute(const SweepOptions& options);

}  // namespace orbearing::app
